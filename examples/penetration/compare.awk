# Ball against time in two CSV files, reference first: differences at four times; exit status 1 if one is too large.
BEGIN {
    surface = -0.0555472 # top of the bed, m
    radius = 0.01
    tolerance = 0.03
    times = split("22 24 26 28", ms, " ")
}
FNR == 1 {
    file++
    for (k = 1; k <= NF; k++)
        place[$k] = k
    if (!("time[s]" in place && "ball_z[m]" in place && "ball_vz[m/s]" in place)) {
        print FILENAME ": no columns time[s], ball_z[m], ball_vz[m/s]"
        exit bad = 2
    }
    next
}
{
    z = $place["ball_z[m]"]
    v = $place["ball_vz[m/s]"]
    if (file == 1 && (!low || z < low))
        low = z
    if (file == 1 && (!impact || v < impact))
        impact = v
    key = sprintf("%.2f", 1e3 * $1)
    height[file, key] = z
    speed[file, key] = v
}
END {
    if (bad)
        exit bad
    deepest = surface - (low - radius)
    printf "deepest penetration %.2f mm, impact speed %.3f m/s\n", 1e3 * deepest, -impact
    for (k = 1; k <= times; k++) {
        key = sprintf("%.2f", ms[k])
        if (!((1, key) in height && (2, key) in height)) {
            print "no row at " key " ms in both files"
            exit 2
        }
        dz = (height[2, key] - height[1, key]) / deepest
        dv = (speed[2, key] - speed[1, key]) / impact
        good = dz < tolerance && dz > -tolerance && dv < tolerance && dv > -tolerance
        printf "%s ms: z %.4f m, off by %.2f %% of the depth; v_z %.3f m/s, off by %.2f %% of the impact: %s\n", ms[k], \
            height[2, key], 100 * dz, speed[2, key], 100 * dv, good ? "passed" : "failed"
        bad += !good
    }
    exit bad > 0
}
