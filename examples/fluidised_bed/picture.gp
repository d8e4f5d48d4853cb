# Pressure drop and porosity over the velocity, and three states; variable: out
set terminal pngcairo size 1100,440 font "sans,11"
set output out . "fluidised-bed.png"
set multiplot
set size 0.46,1
set origin 0,0
set datafile separator ","
set xlabel "superficial velocity [m/s]"
set ylabel "pressure drop over the weight of the bed"
set y2label "mean porosity"
set yrange [0:1.4]
set y2range [0.3:0.8]
set y2tics
set ytics nomirror
set xrange [0.3:1]
set key top left
plot out . "observables.csv" using 2:3 skip 1 with lines lw 2 lc rgb "#264653" title "pressure drop", \
    1 with lines dt 2 lc rgb "#888888" notitle, \
    out . "observables.csv" using 2:4 skip 1 axes x1y2 with lines lw 2 lc rgb "#e76f51" title "porosity"
unset y2tics
unset y2label
unset key
set datafile separator
set size ratio -1
set xrange [0:24.6]
set yrange [0:60]
set xlabel "x [mm]"
set ylabel "z [mm]"
set palette defined (0.38 "#264653", 0.5 "#2a9d8f", 0.65 "#e9c46a", 0.9 "#e76f51")
set cbrange [0.38:0.9]
unset colorbox
array steps[3] = [6250, 12500, 18750]
array titles[3] = ["0.45 m/s", "0.7 m/s", "0.95 m/s"]
do for [k = 1:3] {
    set origin 0, 0
    set size 1, 1
    set lmargin at screen 0.55 + 0.13 * (k - 1)
    set rmargin at screen 0.66 + 0.13 * (k - 1)
    set tmargin at screen 0.9
    set bmargin at screen 0.15
    set xtics 10
    if (k == 3) { set colorbox; set cblabel "porosity" }
    if (k > 1) { unset ylabel; set format y "" }
    set title titles[k]
    plot sprintf("%sstate-%d.txt", out, steps[k]) using 1:2:3:4 with circles fs solid lc palette
}
