# Speed-up against libode8 by the number of cells on each axis of the grid: of the frame, and of the stage that the
# figure is about. On the left, apart: what is tuned while the program runs. Thin lines are quartiles.
tuned = 3.5
position(i) = (at = strstrt(word(engines, i), "cells=")) ? int(word(engines, i)[at + 6:*]) : tuned
shift(world) = (worldIndex(world) - (words(worlds) - 1) / 2.0) * 0.12
cells(name) = sum [i=1:count] (word(engines, i) eq name ? position(i) : 0)
isFixed(engine) = strstrt(engine, "cells=") > 0
isTuned(engine) = !isFixed(engine) && engine ne "stock"

set logscale y 2
set yrange [*<0.5:2<*]
set xrange [2.5:21]
set xtics ("tuned" tuned, 5, 6, 8, 10, 12, 14, 16, 18, 20)
set ytics add ("libode8" 1)
set arrow from graph 0, first 1 to graph 1, first 1 nohead lc rgb reference lw 1.5 front

set multiplot layout 2,1 title title . "  (" . note . ")" font ",14"
do for [part in "frame " . stage] {
    set ylabel "speed-up: " . part
    set xlabel (part eq stage ? "cells on each axis" : "")
    if (part eq stage) { unset key }
    plot for [w=1:words(worlds)] data . ".csv" \
             using (strcol("world") eq word(worlds, w) && isFixed(strcol("engine")) ? cells(strcol("engine")) + shift(word(worlds, w)) : 1/0):(speedUp(part, "median")) \
             with lines lc rgb colour[w] lw 2 notitle, \
         for [w=1:words(worlds)] data . ".csv" \
             using (strcol("world") eq word(worlds, w) && strcol("engine") ne "stock" ? cells(strcol("engine")) + shift(word(worlds, w)) : 1/0):(speedUp(part, "median")):(speedUp(part, "q1")):(speedUp(part, "q3")) \
             with yerrorbars pt 7 ps 0.6 lc rgb colour[w] title word(worlds, w)
}
unset multiplot
