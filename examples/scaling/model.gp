# Parts of a step against the number of ranks, as modelled; variables: data (folder, ends in /), picture
set terminal svg size 900,420 font "sans,13" background "white"
set output picture
set grid lc rgb "#dddddd"
set key outside bottom center horizontal
set logscale xy
set xlabel "ranks"
set ylabel "milliseconds a step"
set format x "10^{%L}"
set multiplot layout 1,2
array names = ["work", "messages", "bytes", "reductions", "sorting by rank"]
array colours = ["#264653", "#2a9d8f", "#e9c46a", "#f4a261", "#e76f51"]
do for [share in "10000 100000"] {
    set title sprintf("%s spheres a rank", share)
    plot for [k = 1:5] data."model-".share using 1:(column(k + 1)) with linespoints pt 7 ps 0.5 lw 2 lc rgb colours[k] title names[k]
}
unset multiplot
