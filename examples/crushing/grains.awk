# The grains of a ball: a jittered close packing of touching grains of radius 0.475 to 0.5 mm, cut to a ball whose lowest point is at
# z = 0. Prints radius x y z in metres, the highest point last (its line begins with #). Variable: across, grains along a diameter.
function random() { # the same sequence with every awk: minimal standard generator
    state = (16807 * state) % 2147483647
    return state / 2147483647
}
BEGIN {
    state = 20041329
    r = 0.0005
    ball = across * r
    n = int(across / 2) + 2
    for (k = -n; k <= n; k++)
        for (j = -n; j <= n; j++)
            for (i = -n; i <= n; i++) {
                odd = ((k % 2) + 2) % 2
                x = r * (2 * i + (j + k + 2 * n) % 2)
                y = r * sqrt(3) * (j + odd / 3)
                z = r * 2 * sqrt(6) / 3 * k
                radius = r * (0.95 + 0.05 * random())
                if (sqrt(x * x + y * y + z * z) > ball - r)
                    continue
                row[++count] = sprintf("%.9f %.9f %.9f", radius, x, y)
                height[count] = z
                low = z - radius < low ? z - radius : low
                high = z + radius > high ? z + radius : high
            }
    for (k = 1; k <= count; k++)
        printf "%s %.9f\n", row[k], height[k] - low
    printf "# top %.9f\n", high - low
}
