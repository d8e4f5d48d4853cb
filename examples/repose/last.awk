# The last frame of a dump: a line `y x z radius` a grain, in mm.
/^ITEM: NUMBER/ { getline; n = 0 }
/^ITEM: ATOMS/ { for (k = 3; k <= NF; k++) at[$k] = k - 2; reading = 1; next }
/^ITEM:/ { reading = 0 }
reading { line[++n] = 1e3 * $at["y"] " " 1e3 * $at["x"] " " 1e3 * $at["z"] " " 1e3 * $at["radius"] }
END { for (k = 1; k <= n; k++) print line[k] }
