# Velocity over time in each liquid, with the largest velocity measured; variable: out
set terminal pngcairo size 800,480 font "sans,11"
set output out . "settling.png"
set datafile separator ","
set xlabel "time [s]"
set ylabel "velocity of the sphere [mm/s]"
set yrange [0:140]
set xrange [0:0.9]
set key top left horizontal
array colours[4] = ["#264653", "#2a9d8f", "#e9c46a", "#e76f51"]
array names[4] = ["Re 1.5", "Re 4.1", "Re 11.6", "Re 31.9"]
array measured[4] = [36.0, 57.2, 87.3, 122.2]
plot for [k = 1:4] sprintf("%sliquid-%d/observables.csv", out, k) using 1:(-$2 * 1e3) skip 1 with lines lw 2 lc rgb colours[k] title names[k], \
    for [k = 1:4] measured[k] with lines dt 2 lc rgb colours[k] notitle
