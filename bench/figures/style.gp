# What all figures have in common. Given: data (file without its ending), output, title, note (the machine),
# stage, worlds, engines, labels (lists of words).
set terminal svg size 900,560 noenhanced font "sans-serif,13" background "white"
set output output
set datafile separator comma
set datafile columnheaders
set border 3 lc "#666666"
set tics nomirror tc "#333333"
set grid ytics lc "#dddddd" lw 0.5
set key outside top center horizontal samplen 1.5
# Okabe and Ito's colours, which do not depend on telling red from green.
array colour[8] = ["#56b4e9", "#e69f00", "#009e73", "#cc79a7", "#d55e00", "#0072b2", "#f0e442", "#000000"]
ours = "#0072b2"
reference = "#555555"

count = words(engines)
isRow(world, engine) = strcol("world") eq world && strcol("engine") eq engine
worldIndex(name) = sum [i=1:words(worlds)] (word(worlds, i) eq name ? i - 1 : 0)
# What libode8 takes divided by what the engine takes, median and quartiles of the rounds.
speedUp(part, figure) = column(part . "_speedup_" . figure)
