# Residual over iterations and over time, a row for each scene. Given what bench/figures/style.gp is given.
set terminal svg size 900,1200 noenhanced font "sans-serif,13" background "white"
set output output
set logscale xy
set format y "%g"
kinds = "libode8 exact fast libode8_same fast_own"
titles = '"libode8" "exact (same residuals)" "fast, cold" "libode8 on the problems of fast" "fast"'
array tint[5] = ["#555555", "#e69f00", "#56b4e9", "#d55e00", "#0072b2"]
array dash[5] = [1, 2, 3, 4, 1]
rows(scene, kind) = "< grep '^" . scene . "," . kind . ",' " . data . "-residuals.csv"
unset datafile columnheaders

unset key
set multiplot layout words(worlds),2 title title . "  (" . note . ")" font ",14" margins 0.1,0.98,0.08,0.92 spacing 0.1,0.055
# A key for all plots, above them.
do for [e=1:5] {
    left = (e - 1) % 3 * 0.32 + 0.08
    height = e <= 3 ? 0.96 : 0.943
    set arrow e from screen left, screen height to screen left + 0.03, screen height nohead lc rgb tint[e] dt dash[e] lw 1.5
    set label e word(titles, e) at screen left + 0.035, screen height left font ",12"
}
do for [w=1:words(worlds)] {
    scene = word(worlds, w)
    do for [along=3:4] {
        set xlabel (w == words(worlds) ? (along == 3 ? "iterations" : "ms a step, one thread") : "")
        set ylabel (along == 3 ? scene : "")
        # What libode8 makes of the problems of fast has no time of its own.
        plot for [e=1:5] rows(scene, word(kinds, e)) using (along == 4 && e == 4 ? NaN : column(along)):6 with linespoints lc rgb tint[e] dt dash[e] lw 1.5 pt 7 ps 0.3
        if (w == 1 && along == 3) { do for [e=1:5] { unset arrow e; unset label e } }
    }
}
unset multiplot
