# The dumbbells from the side, those in front over those behind; variables: members (made by members.awk, sorted), picture
set terminal pngcairo size 900,900 background "#fbfaf7"
set output picture
set size ratio -1
unset key
unset border
unset tics
unset colorbox
set margins 0, 0, 0, 0
set xrange [-0.052:0.052]
set yrange [-0.052:0.052]
set palette defined (0 "#264653", 1 "#2a9d8f", 2 "#e9c46a", 3 "#f4a261", 4 "#e76f51")
set object 1 circle at 0, 0 size 0.05 fillstyle empty border lc rgb "#555555" lw 4
plot members using 2:3:4:(int($5 * 7) % 5) with circles fillstyle solid border rgb "#333333" lc palette
