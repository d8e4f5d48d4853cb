# From a dump: the grains of the first or the last frame as shaded discs, those behind the middle plane, red where bonds have broken. Prints
# y, number, layer of shade, x, z, radius, colour: to be sorted from back to front. Variable: which.
function colour(red, green, blue, light) {
    red = red * light > 255 ? 255 : red * light
    green = green * light > 255 ? 255 : green * light
    blue = blue * light > 255 ? 255 : blue * light
    return int(red) * 65536 + int(green) * 256 + int(blue)
}
/^ITEM: NUMBER/ {
    getline
    count = $1
}
/^ITEM: ATOMS/ {
    frame++
    for (k = 3; k <= NF; k++)
        place[$k] = k - 2
    for (n = 1; n <= count; n++) {
        getline
        i = $place["id"]
        if (frame == 1)
            most[i] = $place["bonds"]
        if (frame == 1 || which == "last")
            row[n] = i " " $place["radius"] " " 1000 * $place["x"] " " 1000 * $place["y"] " " 1000 * $place["z"] " " $place["bonds"]
    }
}
END {
    for (n = 1; n <= count; n++) {
        split(row[n], p, " ")
        if (p[4] < 0 && which == "first")
            continue
        left = most[p[1]] > 0 ? p[6] / most[p[1]] : 1
        for (s = 0; s < 4; s++)
            print -p[4], p[1], s, p[3] - 0.06 * s * 1000 * p[2], p[5] + 0.08 * s * 1000 * p[2], 1000 * p[2] * (1 - s / 4),
                colour(220 - 10 * left, 80 + 120 * left, 70 + 90 * left, 0.62 + 0.2 * s)
    }
}
