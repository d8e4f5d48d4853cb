# PUpCS against ranks x threads; variables: data (folder, ends in /), picture
set terminal svg size 640,420 font "sans,13" background "white"
set output picture
set grid lc rgb "#dddddd"
set key outside bottom center horizontal
set xlabel "ranks x threads"
set ylabel "million particle updates per core and second"
set logscale x 2
set yrange [0:*]
set offsets graph 0.05, graph 0.12, graph 0.1, 0
plot data."weak" using 1:2 with points pt 7 ps 0.8 lc rgb "#264653" title "weak", \
    data."weak" using 1:2:3 with labels offset 3,0.4 tc rgb "#264653" notitle, \
    data."strong" using 1:2 with points pt 5 ps 0.8 lc rgb "#e76f51" title "strong", \
    data."strong" using 1:2:3 with labels offset 3,-0.4 tc rgb "#e76f51" notitle
