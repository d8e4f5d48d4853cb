# The slopes, and their angles over the Bond number; variables: out, numbers
set terminal pngcairo size 1500,380 background "#fbfaf7" font "sans,12"
set output out . "repose.png"
set multiplot layout 1,words(numbers) + 1
set size ratio -1
unset key
unset border
unset tics
set xrange [-0.5:24]
set yrange [-1.5:20]
set style fill solid border rgb "#444444"
do for [number in numbers] {
    set title "Bo = " . number
    plot out . number . ".txt" using 2:3:4:($3 < 0 ? 0x264653 : 0xe9c46a) with circles lc rgb variable
}
set title "angle of the slope"
set size noratio
set border 3
set xtics 1
set tics nomirror
set xrange [-0.3:*]
set yrange [0:*]
set xlabel "Bond number"
set ylabel "degrees"
plot out . "angles.tsv" using 1:2 with linespoints pt 7 lw 2 lc rgb "#e76f51"
unset multiplot
