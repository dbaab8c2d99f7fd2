# How the real-time factor is distributed over the seconds of a minute: the normal distribution of its mean and
# deviation, as the thesis draws it, and below the line each sample.
samples = data . ".csv"
tint(e) = e == 1 ? "#d62728" : word(labels, e) eq "ODE_MT" ? ours : "#999999"  # the thesis's red and blue
normal(x, mean, deviation) = exp(-0.5 * ((x - mean) / deviation) ** 2) / (deviation * sqrt(2 * pi))

array mean[count]
array deviation[count]
set samples 120
unset ytics
set border 1
columns = words(worlds) > 4 ? 4 : 2
set multiplot layout (words(worlds) + columns - 1) / columns,columns title title . "  (" . note . ")" font ",14"
do for [w=1:words(worlds)] {
    world = word(worlds, w)
    set xrange [*:*]  # stats looks at what is in range only
    set yrange [*:*]
    highest = 0
    least = 1e300
    most = 0
    do for [e=1:count] {
        stats samples using (strcol("world") eq world && strcol("engine") eq word(engines, e) ? column("real_time_factor") : 1/0) nooutput
        mean[e] = STATS_mean
        deviation[e] = STATS_ssd > 0 ? STATS_ssd : 1e-9
        top = 1 / (deviation[e] * sqrt(2 * pi))
        highest = top > highest ? top : highest
        least = STATS_min < least ? STATS_min : least
        most = STATS_max > most ? STATS_max : most
    }
    margin = 0.08 * (most - least)
    set xrange [least - margin:most + margin]
    set yrange [-0.12 * highest:1.08 * highest]
    set title world
    set xlabel "times real time"
    if (w > 1) { unset key }
    plot for [e=1:count] normal(x, mean[e], deviation[e]) with lines lw 2 lc rgb tint(e) title word(labels, e), \
         for [e=1:count] samples using (strcol("world") eq world && strcol("engine") eq word(engines, e) ? column("real_time_factor") : 1/0):(-0.02 * highest - 0.025 * e * highest) \
             with points pt 7 ps 0.25 lc rgb tint(e) notitle
}
unset multiplot
