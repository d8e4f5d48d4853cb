# Messages and bytes of a rank and step against the number of ranks; variables: data (folder, ends in /), picture
set terminal svg size 900,420 font "sans,13" background "white"
set output picture
set grid lc rgb "#dddddd"
set key outside bottom center horizontal
set multiplot layout 1,2
set xlabel "ranks"
set xrange [0:*]
set yrange [0:*]
name(k) = word("scene-brick scene-bisection boulders-brick", k)
shown(k) = word("bricks bisection boulders", k)
colour(k) = word("#264653 #2a9d8f #e76f51", k)
there = ""
do for [k = 1:3] {
    if (system(sprintf("test -s '%s%s' && echo yes", data, name(k))) eq "yes") { there = there.sprintf(" %d", k) }
}
set ylabel "messages of a rank and step"
plot for [k in there] data.name(k + 0) using 1:2 with linespoints pt 7 ps 0.6 lw 2 lc rgb colour(k + 0) title shown(k + 0)
set ylabel "kB of a rank and step"
plot for [k in there] data.name(k + 0) using 1:3 with linespoints pt 7 ps 0.6 lw 2 lc rgb colour(k + 0) title shown(k + 0)
unset multiplot
