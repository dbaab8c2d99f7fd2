# Speed-up of each engine against libode8 in each world: of the frame, and of the stage that the figure is about.
# Bars begin at 1, where libode8 is; thin lines are quartiles.
width = 0.8 / (count - 1)
place(e) = worldIndex(strcol("world")) + (e - 1 - count / 2.0) * width
tint(e) = word(labels, e) eq "ODE_MT" ? ours : colour[e - 1]

set style fill solid 1 noborder
set logscale y 2
set yrange [*<0.5:2<*]
set xrange [-0.6:words(worlds) - 0.4]
set xtics scale 0 ()
do for [i=1:words(worlds)] { set xtics add (word(worlds, i) i - 1) }
set ytics add ("libode8" 1)
set arrow from graph 0, first 1 to graph 1, first 1 nohead lc rgb reference lw 1.5 front

set multiplot layout 2,1 title title . "  (" . note . ")" font ",14"
do for [part in "frame " . stage] {
    set ylabel "speed-up: " . part
    if (part eq stage) { unset key }
    plot for [e=2:count] data . ".csv" \
             using (strcol("engine") eq word(engines, e) ? place(e) : NaN):(1):(place(e) - width / 2):(place(e) + width / 2):(1 < speedUp(part, "median") ? 1 : speedUp(part, "median")):(1 > speedUp(part, "median") ? 1 : speedUp(part, "median")) \
             with boxxyerror lc rgb tint(e) title word(labels, e), \
         for [e=2:count] data . ".csv" \
             using (strcol("engine") eq word(engines, e) ? place(e) : NaN):(speedUp(part, "q1")):(0):(speedUp(part, "q3") - speedUp(part, "q1")) \
             with vectors nohead lc rgb "#222222" notitle
}
unset multiplot
