# SPDX-License-Identifier: BSD-3-Clause
# A run under callgrind, from the profiles of its threads: awk -f counts.awk FILE...
# Prints parallel regions, barriers inside of these, collective calls and messages of the first thread, its instructions without those of MPI and of
# the C library, which wait, those in parallel regions, and the instructions of each thread.
function name_of(text, names,    id, at) { # "(12) name" defines, "(12)" repeats
    at = index(text, ")")
    id = substr(text, 1, at)
    if (length(text) > at) names[id] = substr(text, at + 2)
    return names[id]
}
function waits(object) { return object ~ /lib(mpi|open-|pmix|event|fabric|uc[pst]|psm|hwloc|c|pthread)[-.0-9]|\/mca_|\/ld-|^$|\?\?\?/ }
FNR == 1 { thread = 0; split("", names); split("", functions); called = ""; object = "" }
/^thread: / { thread = $2 }
/^ob=/ { object = name_of(substr($0, 4), names); next }
/^cob=/ { name_of(substr($0, 5), names); next }
/^fn=/ { name_of(substr($0, 4), functions); next }
/^cfn=/ { called = name_of(substr($0, 5), functions); next }
/^calls=/ {
    times = substr($1, 7) + 0
    getline
    if (thread == 1 && called == "GOMP_parallel") { regions += times; inside += $2 }
    if (thread == 1 && called ~ /^GOMP_(barrier|loop_end)$/) barriers += times
    if (thread == 1 && called ~ /^P?MPI_I?(allreduce|Allreduce|reduce|Reduce|bcast|Bcast|barrier|Barrier|all[gt][ao]|All[gt][ao]|gather|Gather|scan|Scan|exscan|Exscan|scatter|Scatter)/)
        collectives += times
    if (thread == 1 && called ~ /^P?MPI_(I?[srb]?send|I?[SRB]?send|Send|Isend|Start$)/) messages += times
    next
}
/^[-+*0-9]/ && NF == 2 {
    sum[thread] += $2
    if (thread == 1 && !waits(object)) own += $2
}
END {
    printf "%d %d %d %d %.0f %.0f", regions, barriers, collectives, messages, own, inside
    for (t in sum) if (t > threads) threads = t + 0
    for (t = 1; t <= threads; t++) printf " %.0f", sum[t]
    print ""
}
