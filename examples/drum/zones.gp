# Numbers of spheres in two quarters of the drum; variables: ours, lammps, again (CSV), picture
set terminal svg size 900,640 font "sans,15" background "white"
set output picture
set datafile separator ","
set xlabel "time (s)"
set ylabel "spheres in the quarter"
set grid lc rgb "#dddddd"
set key outside bottom center horizontal
array names = ["m1_upper", "m2_upper", "m1_lower", "m2_lower"]
array titles = ["2 mm, x > 0, z > 0", "4 mm, x > 0, z > 0", "2 mm, x < 0, z < 0", "4 mm, x < 0, z < 0"]
array colours = ["#e76f51", "#f4a261", "#264653", "#2a9d8f"]
ours_column(k) = names[k] . "[1]"
plot for [k = 1:4] lammps using "time[s]":names[k] with points pt 6 lc rgb colours[k] notitle, \
    for [k = 1:4] again using "time[s]":names[k] with points pt 2 lc rgb colours[k] notitle, \
    for [k = 1:4] ours using "time[s]":ours_column(k) with lines lw 2 lc rgb colours[k] title titles[k], \
    NaN with points pt 6 lc rgb "black" title "LAMMPS, 1 rank", NaN with points pt 2 lc rgb "black" title "LAMMPS, 2 ranks"
