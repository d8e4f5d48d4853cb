# Counts in the zones: compare.awk LAMMPS-1 LAMMPS-2 OURS, all CSV. At every time that all three have, each of our counts must lie
# within the spread of the two LAMMPS runs: no farther from their mean than 3 times the largest difference between them so far,
# and no less than `floor` spheres are allowed, as two runs may agree by chance. Exit status 1 if one does not.
BEGIN {
    columns = split("m1_upper m2_upper m1_lower m2_lower", name, " ")
    floor = 12
}
FNR == 1 {
    file++
    for (k = 1; k <= NF; k++) {
        title = $k
        sub(/\[.*/, "", title)
        place[file, title] = k
    }
    next
}
{
    key = sprintf("%.3f", $1)
    if (file == 3)
        order[++rows] = key
    for (k = 1; k <= columns; k++)
        if ((file, name[k]) in place)
            count[file, key, k] = $(place[file, name[k]])
}
END {
    for (r = 1; r <= rows; r++) {
        key = order[r]
        if (!((1, key, 1) in count && (2, key, 1) in count))
            continue
        compared++
        for (k = 1; k <= columns; k++) {
            if (!((3, key, k) in count)) {
                print "no column " name[k]
                exit 2
            }
            spread = count[1, key, k] - count[2, key, k]
            spread = spread < 0 ? -spread : spread
            widest[k] = spread > widest[k] ? spread : widest[k]
            allowed = 3 * widest[k] > floor ? 3 * widest[k] : floor
            off = count[3, key, k] - (count[1, key, k] + count[2, key, k]) / 2
            off = off < 0 ? -off : off
            far[k] = off > far[k] ? off : far[k]
            if (off > allowed) {
                printf "%s s, %s: %d here, %d and %d by LAMMPS\n", key, name[k], count[3, key, k], count[1, key, k], count[2, key, k]
                bad++
            }
        }
    }
    for (k = 1; k <= columns; k++)
        printf "%s: at most %.1f spheres from the mean of two LAMMPS runs that differ by up to %d\n", name[k], far[k], widest[k]
    if (compared < 2) {
        print "only " compared + 0 " times in common"
        exit 2
    }
    print compared " times: " (bad ? "failed" : "passed")
    exit bad > 0
}
