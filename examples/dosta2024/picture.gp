# A case of Dosta et al. 2024 beside the other codes; variables: name, ours (observables.csv), curves (folder), picture
set terminal svg size 900,560 font "sans,15" background "white"
set output picture
set datafile separator ","
set grid lc rgb "#dddddd"
set key outside bottom center horizontal
set xlabel "time (s)"
codes = "musen liggghts peclet"
titles = "MUSEN LIGGGHTS peclet"
shown = ""
there(k) = int(system("test -f '" . file(k) . "' && echo 1 || echo 0"))
m2 = strstrt(name, "-m2") > 0 # for M2 the curves with M1 are drawn
base = m2 ? name[1:strlen(name) - 2] . "m1" : name
mark = m2 ? ", M1" : ""
file(k) = curves . "/" . base . "-" . word(codes, k) . ".csv"
do for [k = 1:3] { if (there(k)) { shown = shown . " " . k } }
array colours = ["#e76f51", "#2a9d8f", "#f4a261"]
if (name[1:6] eq "impact") {
    set ylabel "displacement of the ball (mm)"
    start = real(system("sed -n 2p '" . ours . "' | cut -d , -f 2"))
    set xrange [0:0.1]
    plot for [w in shown] file(int(w)) using "t":(1e3 * column("displacement")) with points pt 4 + 2 * int(w) ps 0.6 lc rgb colours[int(w)] title word(titles, int(w)), \
        ours using "time[s]":(1e3 * (column("ball_z[m]") - start)) with lines lw 2.5 lc rgb "#264653" title "scree"
}
if (name[1:4] eq "silo") {
    set ylabel "grains above the orifice"
    plot for [w in shown] file(int(w)) using "t":"left" with points pt 4 + 2 * int(w) ps 0.6 lc rgb colours[int(w)] title word(titles, int(w)) . mark, \
        ours using "time[s]":"left[1]" with lines lw 2.5 lc rgb "#264653" title "scree"
}
if (name eq "drum") {
    set ylabel "small grains in the lower quarter"
    plot for [w in shown] file(int(w)) using "t":"z2_m1" with points pt 4 + 2 * int(w) ps 0.8 lc rgb colours[int(w)] title word(titles, int(w)), \
        ours using "time[s]":"m1_lower[1]" with lines lw 2.5 lc rgb "#264653" title "scree"
}
