# How many times as fast a frame is with islands on other machines, over their number, a curve for each network. Given what bench/figures/style.gp is given.
set terminal svg size 900,900 noenhanced font "sans-serif,12" background "white"
set output output
networks = "100M 1GbE 10GbE 25GbE infiniband none"
titles = '"100 Mbit/s" "1 Gbit/s" "10 Gbit/s" "25 Gbit/s" "InfiniBand" "this machine"'
set xtics (1, 2, 4, 8, 16, 32, 64)
set multiplot layout (words(worlds) + 1) / 2,2 title title . "  (" . note . ")" font ",14" margins 0.09,0.98,0.06,0.9 spacing 0.11,0.07
unset key
do for [e=1:words(networks)] {
    left = 0.06 + (e - 1) * 0.155
    set arrow e from screen left, screen 0.95 to screen left + 0.03, screen 0.95 nohead lc rgb colour[e] lw 2
    set label e word(titles, e) at screen left + 0.035, screen 0.95 left
}
do for [w=1:words(worlds)] {
    world = word(worlds, w)
    set title world offset 0,-0.6
    set xlabel (w > words(worlds) - 2 ? "machines" : "")
    set ylabel (w % 2 == 1 ? "times as fast" : "")
    unset logscale x
    set xrange [*:*]  # stats looks at what is in range only
    set yrange [*:*]
    stats data using (strcol("world") eq world ? column("home_ms") / column("frame_ms") : 1/0) nooutput
    set logscale x 2
    set xrange [0.95:68]
    set yrange [0:(STATS_max > 1.8 ? STATS_max * 1.1 : 2)]
    plot 1 lc rgb "#999999" dt 3, \
         for [e=1:words(networks)] data using (strcol("world") eq world && strcol("network") eq word(networks, e) ? column("workers") : NaN):(column("home_ms") / column("frame_ms")) \
             with linespoints lc rgb colour[e] lw 1.5 pt 7 ps 0.4
    if (w == 1) { do for [e=1:words(networks)] { unset arrow e; unset label e } }
}
unset multiplot
