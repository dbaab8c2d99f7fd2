# Speed-up against libode8 by the number of threads that a step may use: of the frame, and of the stage that the
# figure is about. Solid: ODE_MT as it is; dashed: "decluster", which runs every step in parallel. Thin lines are quartiles.
threads(name) = int(name[6:(strstrt(name, "/") > 0 ? strstrt(name, "/") - 1 : strlen(name))])
shift(world) = (worldIndex(world) - (words(worlds) - 1) / 2.0) * 0.05
isWanted(name, word) = name ne "stock" && (strstrt(name, "/") > 0) == (word eq "decluster")
kinds = "auto decluster"

set logscale y 2
set yrange [*<0.5:2<*]
set xrange [0.7:8.3]
set xtics (1, 2, 3, 4, 6, 8)
set ytics add ("libode8" 1)
set arrow from graph 0, first 1 to graph 1, first 1 nohead lc rgb reference lw 1.5 front

set multiplot layout 2,1 title title . "  (" . note . ")" font ",14"
do for [part in "frame " . stage] {
    set ylabel "speed-up: " . part
    set xlabel (part eq stage ? "threads" : "")
    if (part eq stage) { unset key }
    plot for [k=1:2] for [w=1:words(worlds)] data . ".csv" \
             using (strcol("world") eq word(worlds, w) && isWanted(strcol("engine"), word(kinds, k)) ? threads(strcol("engine")) + shift(word(worlds, w)) : 1/0):(speedUp(part, "median")) \
             with lines lc rgb colour[w] lw 2 dt k title (k == 1 ? word(worlds, w) : ""), \
         for [k=1:2] for [w=1:words(worlds)] data . ".csv" \
             using (strcol("world") eq word(worlds, w) && isWanted(strcol("engine"), word(kinds, k)) ? threads(strcol("engine")) + shift(word(worlds, w)) : 1/0):(speedUp(part, "median")):(speedUp(part, "q1")):(speedUp(part, "q3")) \
             with yerrorbars pt (k == 1 ? 7 : 6) ps 0.6 lc rgb colour[w] notitle
}
unset multiplot
