set xlabel "restitution asked for"
set ylabel "found less asked for"
plot [0.05:1.05] 0 ls 1 title "as asked for", out . "by-overlap" using 2:($3 - $2) ls 2 title "end: overlap", out . "by-force" using 2:($3 - $2) ls 4 title "end: force"
