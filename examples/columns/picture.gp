# Run-out against aspect ratio beside the laws; variables: out (folder with points-SERIES), picture
set terminal svg size 900,460 font "sans,14" background "white"
set output picture
set logscale xy
set grid lc rgb "#dddddd"
set key bottom right
set xlabel "height over radius, or over length"
set ylabel "run-out over the same"
set xrange [0.4:10]
set yrange [0.3:12]
set multiplot layout 1,2
set title "round columns"
plot x < 1.7 ? 1.24 * x : 1.6 * sqrt(x) lw 2 lc rgb "#2a9d8f" title "Lube 2004", x < 3 ? x : sqrt(3 * x) lw 2 dt 2 lc rgb "#e76f51" title "Lajeunesse 2004", \
    out . "/points-round-1" using 1:2 with points pt 7 lc rgb "#264653" title "one size", out . "/points-round-10" using 1:2 with points pt 6 lc rgb "#264653" title "sizes 1 to 10"
set title "columns in a channel"
plot x < 2.3 ? 1.2 * x : 1.9 * x ** (2. / 3) lw 2 lc rgb "#2a9d8f" title "Lube 2005", x < 3 ? x : (3 * x * x) ** (1. / 3) lw 2 dt 2 lc rgb "#e76f51" title "Lajeunesse 2005", \
    out . "/points-plane-1" using 1:2 with points pt 7 lc rgb "#264653" title "one size", out . "/points-plane-10" using 1:2 with points pt 6 lc rgb "#264653" title "sizes 1 to 10"
unset multiplot
