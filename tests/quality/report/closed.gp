# What closed-loop experiments measure, divided by the worst that libode8 has with 18 to 22 iterations, with the slack that no user notices
# added: left of 1 is better. Lines are ranges of these iterations, dots medians; grey: libode8, blue: fast.
set terminal svg size 900,1240 noenhanced font "sans-serif,12" background "white"
set output output
set logscale x
set xlabel "error / largest of libode8; grey: libode8, blue: fast"
unset grid
set grid xtics lc "#dddddd" lw 0.5
stats data . "-closed.csv" using 0 nooutput
set yrange [STATS_records:-1]
set ytics scale 0 font ",10"
set arrow from 1, graph 0 to 1, graph 1 nohead lc rgb reference lw 1.5 front
unset key
set title title . "  (" . note . ")" font ",14"
label(i) = strcol("experiment") . ": " . strcol("quantity")
# Of counts there is no slack.
slack(x) = column("slack") > 0 ? column("slack") : 0.5
ratio(name) = (column(name) + slack(0)) / (column("most") + slack(0))
set lmargin 42
plot data . "-closed.csv" using (ratio("least")):($0 - 0.15):(1 - ratio("least")):(0):ytic(label(0)) with vectors nohead lc rgb "#999999" lw 1.5, \
     "" using (ratio("libode8")):($0 - 0.15) with points pt 7 ps 0.4 lc rgb "#999999", \
     "" using (ratio("fast_least")):($0 + 0.15):(ratio("fast_most") - ratio("fast_least")):(0) with vectors nohead lc rgb ours lw 1.5, \
     "" using (ratio("fast")):($0 + 0.15) with points pt 7 ps 0.5 lc rgb ours
