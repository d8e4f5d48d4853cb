set xlabel "restitution asked for"
set ylabel "restitution found"
plot [0:1] x ls 1 title "as asked for", out . "oxide" using 2:3 ls 2 title "aluminium oxide", out . "iron" using 2:3 ls 4 title "cast iron"
