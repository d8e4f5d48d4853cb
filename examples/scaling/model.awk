# The model of the cost of a step on 10^3 ... 10^6 ranks, after lines.awk; variables: latency (seconds a message), bandwidth (bytes a
# second and rank), table (inputs, step, memory, setup), share (spheres a rank; 0: a few), form (page, plot)
function find_inputs(k, kind, text, most) {
    for (k = 1; k <= kinds; k++) {
        kind = kind_name[k]
        text = pick(kind)
        if (kind ~ /^weak\|/ && value(text, "ranks") * value(text, "threads") == value(text, "cores")) {
            if (value(text, "ns_per_particle") * value(text, "cores") > work)
                work = value(text, "ns_per_particle") * value(text, "cores")
            interval = value(text, "rebuilds") ? value(text, "steps") / value(text, "rebuilds") : interval
        }
        if (kind ~ /^weak\|/ && value(text, "ranks") > 1)
            each = value(text, "memory") / (value(text, "particles") / value(text, "ranks") + value(text, "ghosts"))
        if (kind ~ /^ranks\|scene\|brick\|10\|/ && value(text, "ranks") > most) {
            most = value(text, "ranks")
            messages = a_step(text, "messages")
            bytes = a_step(text, "bytes")
            rebuild_messages = a_rebuild(text, "messages")
            rebuild_bytes = a_rebuild(text, "bytes")
        }
    }
    one = pick("strong|1x1")
    walk = (2 * value(pick("strong|2x1"), "setup_seconds") - value(one, "setup_seconds")) / value(one, "particles")
}
function depth(ranks, n) { # levels of a binary tree
    for (n = 0; 2 ^ n < ranks; n++)
        continue
    return n
}
# Seconds of a step's parts: part["work"], ...; returns the sum
function step_cost(line, n, ranks, side) {
    ranks = value(line, "ranks")
    side = (n / density()) ^ (1 / 3)
    part["work"] = 1e-9 * work * n
    part["messages"] = (messages + rebuild_messages / interval) * latency
    part["bytes"] = (bytes + rebuild_bytes / interval) * shell(side) / shell(10) / bandwidth
    part["reductions"] = (1 + 3 / interval) * 2 * depth(ranks) * latency
    part["lengths"] = 4 * value(line, "groups") / interval
    return part["work"] + part["messages"] + part["bytes"] + part["reductions"] + part["lengths"]
}
function step_rows(n, k, line, all) {
    for (k = 1; k <= lengths; k++) {
        line = length_line[k]
        all = step_cost(line, n)
        if (form == "plot")
            printf "%d %.5g %.5g %.5g %.5g %.5g %.5g\n", value(line, "ranks"), 1e3 * part["work"], 1e3 * part["messages"],
                1e3 * part["bytes"], 1e3 * part["reductions"], 1e3 * part["lengths"], part["work"] / all
        else
            printf "| %s | %s | %.3g | %.3g | %.3g | %.3g | %.3g | %.3g | %.3f |\n", grouped(n), grouped(value(line, "ranks")),
                1e3 * part["work"], 1e3 * part["messages"], 1e3 * part["bytes"], 1e3 * part["reductions"], 1e3 * part["lengths"], 1e3 * all,
                part["work"] / all
    }
}
function memory_rows(n, k, line, ranks) {
    for (k = 1; k <= lengths; k++) {
        line = length_line[k]
        ranks = value(line, "ranks")
        printf "| %s | %s | %.4g | %.3g | %.3g | %.3g |\n", grouped(n), grouped(ranks), each * (n + shell((n / density()) ^ (1 / 3))) / 1e6,
            value(line, "groups_bytes") / 1e6, value(line, "tree_bytes") / 1e6, 24 * ranks / 1e6
    }
}
function setup_rows(n, k, ranks) {
    for (k = 1; k <= lengths; k++) {
        ranks = value(length_line[k], "ranks")
        printf "| %s | %s | %.3g | %.3g | %.3g |\n", grouped(n), grouped(ranks), n * ranks, walk * n * ranks, 32 * n * ranks / 1e9
    }
}
function input_rows() {
    printf "| work | %.3g ns a sphere and step | `weak`, the slowest layout that fills the cores; rebuilds included |\n", work
    printf "| steps between rebuilds | %.3g | `weak` |\n", interval
    printf "| messages a rank | %.3g a step, %.3g a rebuild | `ranks`, the most ranks |\n", messages, rebuild_messages
    printf "| bytes a rank, a share of 10 x 10 x 10 | %.3g a step, %.3g a rebuild | `ranks`, the most ranks |\n", bytes, rebuild_bytes
    printf "| memory | %.3g bytes a sphere or copy | `weak`, several ranks |\n", each
    printf "| walk through the scene's spheres | %.3g ns a sphere | `strong`, set-up on 1 and 2 ranks; placed at random, which costs more than a lattice or a file |\n", 1e9 * walk
    printf "| latency | %.3g us a message | assumed |\n", 1e6 * latency
    printf "| bandwidth | %.3g GB/s a rank | assumed |\n", bandwidth / 1e9
}
END {
    find_inputs()
    if (table == "inputs") {
        input_rows()
        exit
    }
    n = split(share ? share : "10000 100000", list_of_shares, " ")
    for (s = 1; s <= n; s++)
        if (table == "step")
            step_rows(list_of_shares[s])
        else if (table == "memory")
            memory_rows(list_of_shares[s])
        else if (table == "setup")
            setup_rows(list_of_shares[s])
}
