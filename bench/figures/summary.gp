# The same curves as samples.gp, for many worlds.
set terminal svg size 1200,1700 noenhanced font "sans-serif,11" background "white"
set output output
load "bench/figures/samples.gp"
