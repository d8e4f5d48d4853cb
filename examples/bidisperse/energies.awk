# Largest relative difference of the kinetic energies, translational and rotational, in two CSV files, reference first
function column(name) {
    if (!(name in place)) {
        print FILENAME ": no column " name >"/dev/stderr"
        exit bad = 2
    }
    return place[name]
}
FNR == 1 {
    file++
    split("", place)
    for (k = 1; k <= NF; k++)
        place[$k] = k
    time = column(file == 1 ? "time" : "time[1]")
    moving = column(file == 1 ? "kinetic" : "energy_kinetic[1]")
    turning = column(file == 1 ? "rotational" : "energy_rotational[1]")
    next
}
{
    key = sprintf("%.6f", $time)
}
file == 1 {
    translation[key] = $moving
    rotation[key] = $turning
    count++
}
file == 2 && key in translation {
    rows++
    d[1] = $moving / translation[key] - 1
    d[2] = $turning / rotation[key] - 1
    for (k = 1; k <= 2; k++) {
        d[k] = d[k] < 0 ? -d[k] : d[k]
        if (d[k] > most || d[k] != d[k])
            most = d[k]
    }
}
END {
    if (bad)
        exit bad
    if (rows != count || !count) {
        print "energies: " rows " of " count " times" >"/dev/stderr"
        exit 2
    }
    printf "kinetic %.3g\n", most
}
