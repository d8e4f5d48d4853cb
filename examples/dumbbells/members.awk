# The last frame of a dump: a line `y x z radius body` a member. Bodies have the lower ids, members the others, two a body.
/^ITEM: TIMESTEP/ { n = 0 }
/^ITEM: NUMBER/ { getline; bodies = $1 / 3 }
/^ITEM: ATOMS/ { for (k = 3; k <= NF; k++) at[$k] = k - 2; reading = 1; next }
/^ITEM:/ { reading = 0 }
reading && $1 > bodies { line[++n] = $at["y"] " " $at["x"] " " $at["z"] " " $at["radius"] " " int(($1 - bodies - 3) / 2) }
END { for (k = 1; k <= n; k++) print line[k] }
