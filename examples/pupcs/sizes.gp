# Particle updates against the radius of the largest particle; variables: data (start of the names), grids, picture
set terminal svg size 700,420 font "sans,13" background "white"
set output picture
set grid lc rgb "#dddddd"
set key outside bottom center horizontal
set xlabel "radius of the large sphere (small ones: 0.4)"
set ylabel "million particle updates per core and second"
set yrange [0:*]
colour(k) = word("#264653 #e76f51 #2a9d8f", k)
name(k, sync) = sprintf("%s%s-%s", data, word(grids, k), sync)
label(k, sync) = sprintf("%s, subdomains of edge %d", sync, 80 / word(grids, k))
there(k, sync) = system(sprintf("test -s '%s' && echo 1 || echo 0", name(k, sync))) + 0
plot for [k = 1:words(grids)] there(k, "neighbours") ? name(k, "neighbours") : "/dev/null" using 1:($2 / 1e6) with linespoints pt 6 \
    lw 2 dt 2 lc rgb colour(k) title label(k, "neighbours"), \
    for [k = 1:words(grids)] name(k, "shadow") using 1:($2 / 1e6) with linespoints pt 7 lw 2 lc rgb colour(k) title label(k, "shadow")
