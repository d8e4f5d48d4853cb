# From the grains of last.awk: Bond number, slope in degrees, grains above the floor. The surface is the top of the highest grain in strips of
# 1 mm over the floor, 20 mm long. The slope is that of a line fitted from the crest (the last strip within 1 mm of the highest) to the edge.
# Variable: number.
$2 < 20 && $3 > 0 {
    strip = int($2)
    if (!(strip in top) || $3 + $4 > top[strip])
        top[strip] = $3 + $4
    grains++
}
END {
    for (k = 0; k < 20; k++)
        if (top[k] > highest)
            highest = top[k]
    for (k = 0; k < 20; k++)
        if (top[k] > highest - 1)
            crest = k
    for (k = crest; k < 20; k++) {
        n++
        x += k
        z += top[k]
        xx += k * k
        xz += k * top[k]
    }
    printf "%s\t%.1f\t%d\n", number, 180 / atan2(0, -1) * atan2(-(n * xz - x * z), n * xx - x * x), grains
}
