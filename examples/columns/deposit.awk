# A column's line from its table and its last frame. Variables: shape (round, plane), sizes, width of the channel (mm), radii (mm) of the largest grain
# and of the floor's, seconds, steps.
# The front is where grains cover less than `least` of the ground, seen from above, going outwards from the middle of the column: no longer a
# whole layer. The height is that of the highest grain in the inner quarter.
# Lengths over the column's radius or length, 20 mm.
BEGIN {
    pi = 3.14159265358979
    r0 = 0.02
    if (!least) least = 0.4
}
FNR == 1 {
    file++
    n = 0
}
file == 1 {
    n = split($0, part, ",")
    if (FNR > 1 && part[1] <= 0.05 + 1e-6) top = part[2]
    next
}
/^ITEM: TIMESTEP/ {
    atoms = 0
    m = 0
    next
}
/^ITEM: ATOMS/ {
    for (k = 3; k <= NF; k++) place[$k] = k - 2
    atoms = 1
    next
}
atoms && $place["z"] > 0 { # what lies above the floor's grains
    m++
    x = $place["x"]
    y = $place["y"]
    distance[m] = shape == "round" ? sqrt(x * x + y * y) : x
    z[m] = $place["z"]
    radius[m] = $place["radius"]
}
END {
    ring = r0 / 10 > 1.5e-3 * largest ? r0 / 10 : 1.5e-3 * largest
    for (k = 1; k <= m; k++)
        cover[int(distance[k] / ring)] += pi * radius[k] ^ 2
    for (k = 0; ; k++) {
        ground = shape == "round" ? pi * ring * ring * (2 * k + 1) : ring * width * 1e-3
        share = cover[k] / ground
        if (share < least) break
        before = share
    }
    # between the middles of the last covered ring and the next one
    front = ring * (k - 0.5 + (before > share ? (before - least) / (before - share) : 0))
    inner = r0 / 4 > 2e-3 * largest ? r0 / 4 : 2e-3 * largest
    for (k = 1; k <= m; k++)
        if (distance[k] < inner && z[k] + radius[k] > height) height = z[k] + radius[k]
    a = top / r0
    printf "{\"shape\": \"%s\", \"sizes\": %d, \"grains\": %d, \"aspect\": %.3f, \"run_out\": %.3f, \"height\": %.3f, \"grain\": %.4f, \"steps\": %d, \"seconds\": %.4g}\n",
        shape, sizes, m, a, (front - r0) / r0, height / r0, 2e-3 * glued / r0, steps, seconds
}
