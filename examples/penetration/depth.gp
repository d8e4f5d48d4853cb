# Depth of the ball over time; variables: ours (observables.csv), lammps (CSV), start (ms of the throw at which ours begins), picture
surface = -0.0555472 # top of the bed, m
radius = 0.01
depth(z) = 1e3 * (surface - (z - radius))

set terminal svg size 900,560 font "sans,15" background "white"
set output picture
set datafile separator ","
set xlabel "time since the throw (ms)"
set ylabel "depth of the ball's lowest point (mm)"
set xrange [20:33.2]
set yrange [36:-3]
set grid lc rgb "#dddddd"
set key bottom left reverse Left
set arrow from graph 0, first 0 to graph 1, first 0 nohead dt 2 lc rgb "#888888"
set label "surface of the bed" at graph 0.99, first -0.8 right tc rgb "#888888"
plot lammps using (1e3 * column("time[s]")):(depth(column("ball_z[m]"))) with points pt 6 ps 1.1 lw 1.5 lc rgb "#e76f51" \
        title "LAMMPS, its integrator and damping", \
    ours using (1e3 * column("time[s]") + start):(depth(column("ball_z[m]"))) with lines lw 2.5 lc rgb "#264653" title "scree"
