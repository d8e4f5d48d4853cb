# The grains of the last frame by their temperature, and the temperatures in time; variable: out
set terminal pngcairo size 1000,440 font "sans,11"
set output out . "heated-drum.png"
set multiplot layout 1,2
set size ratio -1
set xrange [-52:52]
set yrange [-52:52]
set xlabel "x [mm]"
set ylabel "y [mm]"
set cblabel "temperature [K]"
set palette defined (300 "#264653", 340 "#2a9d8f", 370 "#e9c46a", 400 "#e76f51")
set object 1 circle at 0, 0 size 50 fs empty border lc rgb "#888888"
plot out . "last.txt" using 1:2:3:4 with circles fs solid lc palette notitle
unset object 1
set size noratio
set autoscale xy
set datafile separator ","
set xlabel "time [s]"
set ylabel "temperature [K]"
set key bottom right
plot out . "observables.csv" using 1:4 skip 1 with lines lw 2 lc rgb "#e76f51" title "highest", \
    out . "observables.csv" using 1:3 skip 1 with lines lw 2 lc rgb "#2a9d8f" title "mean", \
    out . "observables.csv" using 1:2 skip 1 with lines lw 2 lc rgb "#264653" title "lowest"
