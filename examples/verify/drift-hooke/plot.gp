set xlabel "time step"
set ylabel "deviation of the energy"
set logscale xy
plot out . "curve" using 1:2 with lines ls 1 title "second order", out . "curve" using 1:3 ls 2 title "scree"
