set xlabel "time / sqrt(radius / gravity)"
set ylabel "angle from the top (rad)"
plot out . "reference-100" with lines ls 1 title "rolls, R = 100", out . "synchronised_verlet-100.path" every 20 ls 2 title "synchronised_verlet", \
    out . "velocity_verlet-100.path" every 20 ls 4 title "velocity_verlet", \
    out . "reference-3" with lines ls 3 title "rolls, R = 3", out . "synchronised_verlet-3.path" every 20 ls 5 title "synchronised_verlet", \
    out . "velocity_verlet-3.path" every 20 with points pt 8 lc rgb "#888888" title "velocity_verlet"
