# SPDX-License-Identifier: BSD-3-Clause
# A line of JSON from the counts and reports of a short and of a long run: awk -v scheme= -v folder= -f counts.awk SHORT.counts LONG.counts
# Per step of a transient flow, per iteration of a steady one.
function of(text, key) {
    if (!match(text, "\"" key "\": [-+.0-9e]+")) return 0
    return substr(text, RSTART + length(key) + 4, RLENGTH - length(key) - 4) + 0
}
function read(name,    line, text) {
    while ((getline line <(folder "/" name "/report.json")) > 0) text = text line
    close(folder "/" name "/report.json")
    return text
}
function solver(text, name) { return index(text, "\"name\": \"" name "\"") ? substr(text, index(text, "\"name\": \"" name "\"")) : "" }
FNR == 1 { run++; ranks = $1; messages[run] = $2; messages_most[run] = $3; bytes[run] = $4; bytes_most[run] = $5; collectives[run] = $6 }
END {
    if (run != 2) exit 1
    short = read("short")
    long = read("long")
    if (scheme == "transient") {
        part = solver(long, "pressure")
        units = 10
        iterations = (of(part, "iterations") - of(solver(short, "pressure"), "iterations")) / (of(part, "solves") - of(solver(short, "pressure"), "solves"))
        velocity = (of(solver(long, "velocity"), "iterations") - of(solver(short, "velocity"), "iterations")) / \
            (of(solver(long, "velocity"), "solves") - of(solver(short, "velocity"), "solves"))
        rows = of(part, "rows")
    } else {
        part = solver(long, "steady")
        iterations = of(part, "iterations")
        units = iterations - of(solver(short, "steady"), "iterations")
        velocity = 0
        rows = of(part, "rows") / 4
    }
    sent = (messages[2] - messages[1]) / ranks / units
    volume = (bytes[2] - bytes[1]) / ranks / units
    calls = (collectives[2] - collectives[1]) / units
    first = scheme == "transient" ? 1 : of(solver(short, "steady"), "iterations") # what the short run has beside its set-up
    printf "{\"scheme\": \"%s\", \"ranks\": %d, \"fluid_particles\": %d, \"share\": %d, \"iterations\": %.4g, \"iterations_velocity\": %.3g, \"units\": %d, " \
        "\"messages\": %.5g, \"messages_most\": %.5g, \"bytes\": %.6g, \"bytes_most\": %.6g, \"collectives\": %.4g, \"setup_messages\": %.5g, \"setup_bytes\": %.6g, \"setup_collectives\": %d, \"memory\": %.4g}\n",
        scheme, ranks, rows, rows / ranks, iterations, velocity, units, sent, (messages_most[2] - messages_most[1]) / units, volume, (bytes_most[2] - bytes_most[1]) / units, \
        calls, messages[1] / ranks - first * sent, bytes[1] / ranks - first * volume, collectives[1] - first * calls, of(long, "memory_peak")
}
