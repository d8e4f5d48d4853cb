# From a dump of several frames: the last but one as shaded discs, the half of the bed behind the ball's middle plane.
# Beads have the colour of the layer in which they lay in the first frame. Prints y, number, layer of shade, x, z, radius, colour:
# to be sorted from back to front (y falling).
function colour(red, green, blue, light) {
    red = red * light > 255 ? 255 : red * light
    green = green * light > 255 ? 255 : green * light
    blue = blue * light > 255 ? 255 : blue * light
    return int(red) * 65536 + int(green) * 256 + int(blue)
}
BEGIN {
    layers = split("231 111 81,244 162 97,233 196 106,42 157 143,38 110 123,38 70 83", paint, ",")
    top = -0.0556 # m
    thickness = 0.0058
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
            height[i] = $place["z"]
        else
            row[frame, n] = i " " $place["radius"] " " $place["x"] " " $place["y"] " " $place["z"]
    }
    rows[frame] = count
}
END {
    shown = frame > 2 ? frame - 1 : frame
    for (n = 1; n <= rows[shown]; n++) {
        split(row[shown, n], p, " ")
        ball = p[2] > 0.005
        if (!ball && p[4] < 0)
            continue
        layer = int((top - height[p[1]]) / thickness) + 1
        layer = layer < 1 ? 1 : layer > layers ? layers : layer
        split(ball ? "150 155 165" : paint[layer], c, " ")
        near = ball ? 1 : 1 - 0.55 * p[4] / 0.03
        shades = ball ? 40 : 4
        for (s = 0; s < shades; s++) {
            t = s / shades
            print ball ? -1 : p[4], p[1], s, p[3] - 0.25 * t * p[2], p[5] + 0.35 * t * p[2], p[2] * (1 - t), \
                colour(c[1], c[2], c[3], near * (0.62 + 0.8 * t))
        }
    }
}
