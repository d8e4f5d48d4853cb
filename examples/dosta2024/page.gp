# Updates a second of a core, or of a graphics card, by case and code; variables: work (folder with points-CODE), cases, picture
set terminal svg size 900,480 font "sans,14" background "white"
set output picture
set datafile separator "\t"
set grid y lc rgb "#dddddd"
set key outside bottom center horizontal
set logscale y
set ylabel "million updates a second"
at(name) = 0 + sum [k = 1:words(cases)] (word(cases, k) eq name ? k : 0)
set xrange [0.5:words(cases) + 0.5]
set yrange [0.05:2000]
set xtics rotate by -25 left
set for [k = 1:words(cases)] xtics add (word(cases, k) k)
codes = "scree LAMMPS LIGGGHTS MUSEN peclet"
titles = "'scree, a core' 'LAMMPS, a core' 'LIGGGHTS, a core' 'MUSEN, a card' 'peclet, a card'"
array colours = ["#264653", "#457b9d", "#2a9d8f", "#e76f51", "#f4a261"]
array points = [7, 9, 5, 6, 4]
file(k) = work . "/points-" . word(codes, k)
there(k) = int(system("test -s '" . file(k) . "' && echo 1 || echo 0"))
shown = ""
do for [k = 1:words(codes)] { if (there(k)) { shown = shown . " " . k } }
plot for [w in shown] file(int(w)) using (at(strcol(1)) + 0.12 * (int(w) - 3)):2 with points pt points[int(w)] ps 1.3 lc rgb colours[int(w)] title word(titles, int(w))
