# Seconds of each stage on one core, by threads and by ranks; variables: data (folder, ends in /), picture
set terminal svg size 900,420 font "sans,13" background "white"
set output picture
set grid y lc rgb "#dddddd"
set key outside bottom center horizontal
set style data histograms
set style histogram clustered gap 1
set style fill solid border -1
set ylabel "seconds"
set yrange [0:*]
plot data."hybrid" using 2:xtic(1) lc rgb "#264653" title "1x1", "" using 3 lc rgb "#2a9d8f" title "threads", \
    "" using 4 lc rgb "#e76f51" title "ranks"
