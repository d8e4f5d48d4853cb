# SPDX-License-Identifier: BSD-3-Clause
# Tables from the lines of run.sh, and a model of more ranks: awk -v latency=SECONDS -v bandwidth=BYTES_A_SECOND -f section.awk RESULTS
function of(key,    value) {
    if (!match($0, "\"" key "\": ")) return ""
    value = substr($0, RSTART + RLENGTH)
    sub(/[,}].*/, "", value)
    return value + 0
}
function log2(x) { return log(x) / log(2) }
# Line of least squares of the iterations of a scheme over log2 of the ranks, at the small share
function fit(name,    k, x, n, sx, sy, sxx, sxy) {
    for (k = 1; k <= lines; k++)
        if (scheme[k] == name && share[k] < 10000) {
            x = log2(ranks[k]); n++; sx += x; sy += iterations[k]; sxx += x * x; sxy += x * iterations[k]
            if (!(name in last) || ranks[k] > ranks[last[name]]) last[name] = k
            if (ranks[k] == 1) alone[name] = iterations[k]
        }
    slope[name] = n > 1 ? (n * sxy - sx * sy) / (n * sxx - sx * sx) : 0
    start[name] = (sy - slope[name] * sx) / n
}
function model(count, n,    k, i, grown, levels, shell, work, messages_, bytes_, calls, step, one) {
    k = last["transient"]
    i = start["transient"] + slope["transient"] * log2(count)
    grown = i / iterations[k]
    levels = log(count * n) / log(fluid[k])
    shell = (n / share[k]) ^ (2 / 3)
    one = n * work_of
    work = one * i / alone["transient"]
    messages_ = messages[k] * grown * levels
    bytes_ = bytes[k] * grown * levels * shell
    calls = calls_of[k] * grown
    step = work + messages_ * latency + bytes_ / bandwidth + calls * 2 * int(log2(count) + 0.999) * latency
    printf "| %d | %d | %.3g | %.1f | %.1f | %.1f | %.1f | %.1f | %.1f | %.2f |\n", n, count, count * n, i, 1e3 * work, 1e3 * messages_ * latency, 1e3 * bytes_ / bandwidth, \
        1e3 * calls * 2 * int(log2(count) + 0.999) * latency, 1e3 * step, one / step
}
/"scheme"/ {
    lines++
    scheme[lines] = $0 ~ /"transient"/ ? "transient" : "steady"
    ranks[lines] = of("ranks"); fluid[lines] = of("fluid_particles"); share[lines] = of("share"); iterations[lines] = of("iterations"); velocity[lines] = of("iterations_velocity")
    messages[lines] = of("messages"); most[lines] = of("messages_most"); bytes[lines] = of("bytes"); calls_of[lines] = of("collectives")
    first[lines] = of("setup_messages"); first_bytes[lines] = of("setup_bytes"); memory[lines] = of("memory")
}
END {
    work_of = 5e-6 # seconds of one fluid particle and transient step on one core (docs/fluid-method.md, Cost: velocity, pressure and the rest)
    print "\n## Many ranks\n"
    print "[examples/fluid_scaling](../examples/fluid_scaling/README.md), `run.sh`: slow flow through an array of spheres, a share of it on each rank, on more ranks than there are cores: counts,"
    print "not times. All messages are counted, those of PETSc and hypre too, by a library between the program and MPI. Means over ranks.\n"
    print "| flow | fluid particles a rank | ranks | iterations of a solve | messages sent by a rank (most) | kB sent by a rank | reductions | messages of the set-up | MB of the set-up | MB resident a rank |"
    print "|---|---|---|---|---|---|---|---|---|---|"
    for (k = 1; k <= lines; k++)
        printf "| %s | %d | %d | %s | %.0f (%.0f) | %.0f | %.1f | %.0f | %.1f | %.0f |\n", scheme[k] == "transient" ? "transient, a step" : "steady, an iteration", share[k], ranks[k], \
            scheme[k] == "transient" ? sprintf("%.1f pressure, %.1f velocity", iterations[k], velocity[k]) : sprintf("%d", iterations[k]), messages[k], most[k], bytes[k] / 1e3, calls_of[k], \
            first[k], first_bytes[k] / 1e6, memory[k] / 1e6
    print "\nThe transient flow solves to the default tolerances, the steady one until a cycle of iterations (16) changes the flow by less than 10^-4. Two ranks have one neighbour, four have three, eight"
    print "seven, 27 and more 26. Copies of the flow travel in one message a neighbour and product; nearly all other messages are those of the levels of multigrid, whose coarse levels have more neighbours than"
    print "the lattice."
    fit("transient")
    if (!("transient" in last)) exit
    print "\nA model of more ranks follows from these counts, for a transient step:\n"
    print "    T(P) = n w i(P)/i(1) + m g a + b g s / B + c i(P)/i(P0) 2 ceil(log2 P) a,   g = i(P)/i(P0) log(n P)/log(n0 P0),   s = (n/n0)^(2/3)\n"
    printf "Here n are the fluid particles of a rank, w = %g us is the work for each particle and step. m messages, b bytes and c reductions of a step are counted on P0 = %d ranks with n0 = %d particles each. i = %.2f + %.2f log2 P\n", \
        1e6 * work_of, ranks[last["transient"]], share[last["transient"]], start["transient"], slope["transient"]
    printf "are the iterations for the pressure, a straight line through those of the small share. Levels of multigrid grow with the logarithm of all particles. The latency a = %g us a message and the bandwidth B = %g GB/s a rank are\n", 1e6 * latency, bandwidth / 1e9
    print "assumed. Nothing overlaps, no rank waits for a slower one. 32,768 ranks with 4,029 particles each are the 132 million particles of the largest published run of implicit SPH (134 million on 32,768 cores).\n"
    print "| particles a rank | ranks | particles | iterations | work, ms | messages, ms | bytes, ms | reductions, ms | step, ms | efficiency |"
    print "|---|---|---|---|---|---|---|---|---|---|"
    for (s = 1; s <= 2; s++)
        for (p = 64; p <= 32768; p *= 8) model(p, s == 1 ? share[last["transient"]] : 32232)
    print "\nTwo things are not in the model. One is the set-up from the sources of a scene, where each rank goes through all grains ([scaling.md](scaling.md)). The other is matrices beyond 2^31 rows or"
    print "unknowns, which PETSc as Debian builds PETSc does not number: 536 million fluid particles in a steady flow."
}
