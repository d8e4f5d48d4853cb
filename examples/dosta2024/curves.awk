# Read before the program of a case: the curves of other codes, and how a verdict is printed. Variables: name (the case), count,
# step, folder (of the curves), costs (a file of two lines: steps seconds cores updates_a_core_second time_reached; revision dt cpu).

# curve CODE: reads folder/FILE-CODE.csv; its columns are seen as curve[code, column, row], its times as curve[code, 1, row], its rows as rows[code]
function curve_read(file, code, line, part, k, n, path) {
    path = folder "/" file "-" code ".csv"
    rows[code] = 0
    while ((getline line < path) > 0) {
        if (line ~ /^(#|t,)/)
            continue
        rows[code]++
        n = split(line, part, ",")
        for (k = 1; k <= n; k++)
            curve[code, k, rows[code]] = part[k] + 0
    }
    close(path)
    return rows[code] > 0
}

# The codes of a case
function curves_read(file, k) {
    codes = split("musen liggghts peclet", code, " ")
    for (k = 1; k <= codes; k++)
        if (!curve_read(file, code[k]))
            code[k--] = code[codes--]
}

# The value of a code at a time, between its rows
function curve_at(c, column, t, k, lo, hi) {
    lo = 1
    hi = rows[c]
    if (t <= curve[c, 1, lo]) return curve[c, column, lo]
    if (t >= curve[c, 1, hi]) return curve[c, column, hi]
    while (hi - lo > 1) {
        k = int((lo + hi) / 2)
        if (curve[c, 1, k] <= t) lo = k; else hi = k
    }
    return curve[c, column, lo] + (curve[c, column, hi] - curve[c, column, lo]) * (t - curve[c, 1, lo]) / (curve[c, 1, hi] - curve[c, 1, lo])
}

# low, high and mean of the codes at a time
function codes_at(column, t, k, v) {
    mean = 0
    for (k = 1; k <= codes; k++) {
        v = curve_at(code[k], column, t)
        if (k == 1 || v < low) low = v
        if (k == 1 || v > high) high = v
        mean += v / codes
    }
}

# How far a value lies outside of the codes, in units of the room that is left on both sides of them: their own spread, or `least` if that is more
function outside(value, least, room) {
    room = high - low > least ? high - low : least
    return value > high ? (value - high) / room : value < low ? (low - value) / room : 0
}

function columns_find(k) {
    for (k = 1; k <= NF; k++) {
        label = $k
        sub(/\[.*/, "", label)
        place[label] = k
    }
}

# The last line of a case, with the share of its time that was timed if a run was killed between; result and reference are numbers or null, more is text with further members, or empty
function verdict_print(result, reference, more, passed, line, cost, what) {
    getline line < costs
    split(line, cost, " ")
    getline what < costs
    split(what, machine, " ")
    sub(/^[^ ]+ [^ ]+ /, "", what)
    printf "{\"case\": \"%s\", \"particles\": %d, \"steps\": %d, \"seconds\": %.6g, \"cores\": %d, \"updates_per_core_second\": %.4g, ", name, count + (name ~ /^impact/),
        cost[1], cost[2], cost[3], cost[4]
    if (cost[1] * machine[2] < 0.999 * cost[5]) printf "\"timed\": %.3f, ", cost[1] * machine[2] / cost[5]
    printf "\"result\": %s, \"reference\": %s, %s\"step\": \"%s\", \"dt\": %.4g, \"revision\": \"%s\", \"cpu\": \"%s\", \"passed\": %s}\n", result, reference,
        more == "" ? "" : more ", ", step, machine[2], machine[1], what, passed ? "true" : "false"
}

NR == 1 {
    columns_find()
    next
}
