# Read before the plot.gp of a case; variables: out (folder with the data, ends in /), picture
set terminal svg size 640,420 font "sans,13" background "white"
set output picture
set grid lc rgb "#dddddd"
set key outside bottom center horizontal
set samples 400
set style line 1 lc rgb "#264653" lw 2
set style line 2 lc rgb "#e76f51" pt 7 ps 0.5 lw 1.5
set style line 3 lc rgb "#2a9d8f" lw 2 dt 2
set style line 4 lc rgb "#f4a261" pt 6 ps 0.6 lw 1.5
set style line 5 lc rgb "#e9c46a" pt 5 ps 0.5 lw 1.5
