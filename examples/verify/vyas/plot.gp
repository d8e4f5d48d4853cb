set xlabel "time (s)"
set ylabel "distance from the axis, over that of touch"
set yrange [0.9:3]
set key left
plot for [ratio in "3 20 100"] out . "synchronised_verlet-" . ratio . ".path" using 1:3 with lines lw 2 title "synchronised_verlet, R = " . ratio noenhanced, \
    for [ratio in "3 20 100"] out . "velocity_verlet-" . ratio . ".path" using 1:3 with lines dt 2 lw 2 title "velocity_verlet, R = " . ratio noenhanced
