# The tables of docs/scaling.md, after lines.awk; variables: table (weak, strong, hybrid, ranks, copies, lengths), form (page: rows
# of Markdown; plot: columns)
function layout(text) {
    return value(text, "ranks") "x" value(text, "threads")
}
function over(text) { # more threads than cores
    return value(text, "ranks") * value(text, "threads") > value(text, "cores")
}
function speed(k, text, first) {
    for (k = 1; k <= kinds; k++) {
        if (kind_name[k] !~ "^" table "\\|")
            continue
        text = pick(kind_name[k])
        if (layout(text) == "1x1")
            first = value(text, "pupcs")
        if (form == "plot")
            printf "%d %.4g %s\n", value(text, "ranks") * value(text, "threads"), value(text, "pupcs") / 1e6, layout(text)
        else
            printf "| %s%s | %d | %.3g | %.3g | %.3g | %s | %.3g | %.1f %% |\n", layout(text), over(text) ? " (oversubscribed)" : "",
                value(text, "particles"), value(text, "seconds"),
                value(text, "ns_per_particle") * value(text, "cores"), value(text, "pupcs") / 1e6,
                first ? sprintf("%.3f", value(text, "pupcs") / first) : "", value(text, "imbalance"), 100 * value(text, "sync_share")
    }
}
function hybrid_time(kind, what, k, list) { # median of a stage, or of all; stages are given as "a b c"
    for (k = 1; k <= counts[kind]; k++)
        list[k] = hybrid_sum(lines[kind, k], what)
    return counts[kind] ? middle(list, counts[kind]) : 0
}
function hybrid_sum(text, what, k, n, part, sum) {
    if (what == "loop")
        return value(text, "seconds")
    n = split(what, part, " ")
    for (k = 1; k <= n; k++)
        sum += stage(text, part[k])
    return sum
}
function hybrid_row(name, what, one, threads, ranks) {
    one = hybrid_time(hybrid_one, what)
    threads = hybrid_time(hybrid_threads, what)
    ranks = hybrid_time(hybrid_ranks, what)
    if (one + threads + ranks < 1e-3 * hybrid_time(hybrid_one, "loop"))
        return
    if (form == "plot")
        printf "%s %.5g %.5g %.5g\n", name, one, threads, ranks
    else
        printf "| %s | %.4g | %.4g | %.4g | %s | %s | %s |\n", name, one, threads, ranks, threads ? sprintf("%.2f", one / threads) : "",
            ranks ? sprintf("%.2f", one / ranks) : "", threads && ranks ? sprintf("%.2f", threads / ranks) : ""
}
function hybrid(k, n, name) {
    for (k = 1; k <= kinds; k++) {
        if (kind_name[k] !~ /^hybrid\|/)
            continue
        if (kind_name[k] ~ /\|1x1$/)
            hybrid_one = kind_name[k]
        else if (kind_name[k] ~ /\|1x/)
            hybrid_threads = kind_name[k]
        else
            hybrid_ranks = kind_name[k]
    }
    n = split("advance sweep contact wall comm decide migrate reorder ghosts index pairs history output other", name, " ")
    for (k = 1; k <= n; k++)
        hybrid_row(name[k], name[k])
    if (form == "plot")
        return
    hybrid_row("**steps**", "advance sweep contact wall comm decide")
    hybrid_row("**rebuilds**", "migrate reorder ghosts index pairs history")
    hybrid_row("**loop**", "loop")
}
function ranks(k, text) {
    for (k = 1; k <= kinds; k++) {
        if (kind_name[k] !~ "^ranks\\|" scene "\\|" domain "\\|" share "\\|")
            continue
        text = pick(kind_name[k])
        if (form == "plot")
            printf "%d %.5g %.5g %.5g\n", value(text, "ranks"), a_step(text, "messages"), a_step(text, "bytes") / 1e3,
                value(text, "memory") / 1e6
        else
            printf "| %d | %.4g | %.4g (%d) | %.4g | %.4g | %.4g | %.4g | %.3f | %.3f | %.1f |\n", value(text, "ranks"),
                value(text, "particles") / value(text, "ranks"), value(text, "ghosts"), value(text, "ghosts_most"),
                a_step(text, "messages"), a_step(text, "bytes") / 1e3, a_rebuild(text, "messages"), a_rebuild(text, "bytes") / 1e3,
                value(text, "memory") / 1e6, value(text, "memory_most") / 1e6, value(text, "memory_peak") / 1e6
    }
}
function copies(k, kind, text, side) {
    for (k = 1; k <= kinds; k++) {
        kind = kind_name[k]
        if (kind !~ /^ranks\|scene\|brick\|[0-9]+\|27$/)
            continue
        text = pick(kind)
        side = value(text, "share")
        printf "| %d | %.5g | %.5g | %.5g | %.1f %% |\n", side, value(text, "particles") / 27, value(text, "ghosts"),
            shell(side), 100 * (value(text, "ghosts") / shell(side) - 1)
    }
}
function length_rows(k, text) {
    for (k = 1; k <= lengths; k++) {
        text = length_line[k]
        printf "| %s | %.3g | %.3g | %.3g | %.3g | %.3g | %.3g | %.3g | %.3g |\n", grouped(value(text, "ranks")), 1e3 * value(text, "brick"),
            value(text, "brick_bytes") / 1e3, 1e3 * value(text, "bisection"), value(text, "tree_bytes") / 1e3, value(text, "divide"),
            value(text, "owner_brick"), value(text, "owner_bisection"), 1e3 * value(text, "groups")
    }
}
END {
    if (table == "weak" || table == "strong")
        speed()
    else if (table == "hybrid")
        hybrid()
    else if (table == "ranks")
        ranks()
    else if (table == "copies")
        copies()
    else if (table == "lengths")
        length_rows()
}
