# Read before tables.awk and model.awk: the lines of all runs, and of each kind the one with the median seconds.
function value(text, key) { # a number; "" if there is none
    if (!match(text, "\"" key "\": [-+.0-9e]+"))
        return ""
    return substr(text, RSTART + length(key) + 4, RLENGTH - length(key) - 4) + 0
}
function word(text, key) {
    if (!match(text, "\"" key "\": \"[^\"]*\""))
        return ""
    return substr(text, RSTART + length(key) + 5, RLENGTH - length(key) - 6)
}
function stage(text, key) { # seconds; 0 if there is none
    return value(substr(text, index(text, "\"stages\": ")), key) + 0
}
function middle(list, n, a, b, swap) { # the median of list[1 ... n], which is sorted
    for (a = 2; a <= n; a++)
        for (b = a; b > 1 && list[b - 1] > list[b]; b--) {
            swap = list[b]
            list[b] = list[b - 1]
            list[b - 1] = swap
        }
    return n % 2 ? list[(n + 1) / 2] : (list[n / 2] + list[n / 2 + 1]) / 2
}
function pick(kind, k, n, list) { # the line of a kind whose seconds come next to the median; "" if there is none
    n = counts[kind]
    for (k = 1; k <= n; k++)
        list[k] = value(lines[kind, k], "seconds")
    if (n == 0)
        return ""
    middle(list, n)
    for (k = 1; k <= n; k++)
        if (value(lines[kind, k], "seconds") == list[int((n + 1) / 2)])
            return lines[kind, k]
}
function a_step(text, key) { # messages or bytes of a rank in a step, without rebuilds
    return value(text, key) - value(text, "rebuild_" key)
}
function a_rebuild(text, key) {
    return value(text, "rebuilds") ? value(text, "rebuild_" key) * value(text, "steps") / value(text, "rebuilds") : 0
}
function grouped(n, text, tail) { # 1,000,000
    text = sprintf("%.0f", n)
    for (; length(text) > 3; text = substr(text, 1, length(text) - 3))
        tail = "," substr(text, length(text) - 2) tail
    return text tail
}
# Copies of a rank whose share is a cube of the gas: what lies within reach of the cube, outside of it (Steiner's formula). The reach is
# the mean radius, and the largest, and the skin of 0.3 smallest radii.
function shell(side, reach) {
    reach = 0.46 + 0.5 + 0.3 * 0.42
    return density() * (6 * side ^ 2 * reach + atan2(0, -1) * (3 * side * reach ^ 2 + 4 / 3 * reach ^ 3))
}
function density() { # spheres a unit of volume
    return 0.2 / (4 / 3 * atan2(0, -1) * (0.5 ^ 4 - 0.42 ^ 4) / 4 / 0.08)
}
/"series": "lengths"/ {
    lengths++
    length_line[lengths] = $0
    next
}
/"series": / {
    series = word($0, "series")
    kind = series "|" value($0, "ranks") "x" value($0, "threads")
    if (series == "ranks")
        kind = "ranks|" word($0, "scene") "|" word($0, "domain") "|" value($0, "share") "|" value($0, "ranks")
    if (!(kind in counts)) {
        kinds++
        kind_name[kinds] = kind
    }
    lines[kind, ++counts[kind]] = $0
}
