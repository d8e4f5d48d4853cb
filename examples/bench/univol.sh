#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Levels of the hierarchical grid: univol.sh NU [--quick]
#
# 125,001 spheres of size ratio 50 whose sizes each hold the same volume (number density ~ r^-3), at volume fraction NU between
# hard walls: the systems of Ogarko and Luding's study of the packing fraction (Figures 2 and 3), made by scree pack.
#
# detection: a complete detection (order + build + search with the exact test; radii 1 % larger, no skin), CPU time over threads, for 1 ... 32 levels
#   of equal occupancy with cells of the cut-off (32 size classes are the most; the paper goes to 50), and as `auto` chooses, on one
#   thread and on all cores. Lines have slowdown (over the fastest), prediction (equation 3, T ~ N L (m + K), with K fitted) and
#   model (the cost model of docs/indexes.md).
# step: whole steps of soft frictionless spheres whose smallest overlap by about 1 % of their radius when they meet, as in the
#   paper, with a search in every step (search) or when the skin is used up (skin), for some of the levels and for `auto`; wall clock.
#
# One JSON line a measurement (seconds is one detection, or one step), the last line the summary: best levels and speed-up over
# one level of both, K, and auto's times. --quick: 20,000 spheres, fewer levels, shorter runs.
#
# Needs `make tests/index/bench_index`; BENCH (that program), SCREE, CORES (all), THREADS (1; of steps and levels), RUNS (5; quick: 3),
# COUNT (particles), WORK may be set.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/packing.sh"
quick_after 1 "univol.sh NU [--quick]" "$@"
nu=$1
case $nu in
0.[0-9]*) ;;
*) wrong_call ;;
esac
bench=$(built BENCH "${BENCH:-}" tests/index/bench_index)
threads=${THREADS:-1}
runs=${RUNS:-$(by_mode 3 5)}
levels="1 2 3 4 5 6 7 8 9 10 12 14 16 18 20 22 24 26 28 30 32"
step_levels="1 2 3 4 5 6 8 10 16 32"
count=125001
steps=100
if [ -n "$quick" ]; then
    levels="1 2 3 4 6 8 16"
    step_levels="1 2 4 8"
    count=20000
    steps=30
fi
count=${COUNT:-$count}
packed univol count=$count fraction="$nu" velocity=0.123
rows=$work/univol.rows
: >"$rows"

detect() {
    "$bench" file="$packing.data" open=1 inflate=1.01 repetitions="$runs" "$@" | sed 's/^{/{"kind": "detection", /' | tee -a "$rows"
}
for l in $levels; do
    detect threads="$threads" levels="$l" factor=1
done
detect threads="$threads" levels=0 index=auto
test "$cores" = "$threads" || detect threads="$cores" levels=0 index=auto

# Two spheres of radius 1 and density 1 that meet at the mean speed of collisions, sqrt(pi) times the deviation of one
# component, overlap by 1 % of their radius with this stiffness; 50 steps a contact.
edge=$(awk '/ xlo xhi/ { print $2; exit }' "$packing.data")
walls='['
for side in '0, 0, 0|1, 0, 0' '0, 0, 0|0, 1, 0' '0, 0, 0|0, 0, 1' "$edge, 0, 0|-1, 0, 0" "0, $edge, 0|0, -1, 0" "0, 0, $edge|0, 0, -1"; do
    walls="$walls{shape: plane, point: [${side%|*}], normal: [${side#*|}]}, "
done
walls="${walls%, }]"
# whole KIND INDEX LEVELS CLASSES
whole() {
    every=1
    skin=0.01
    moves=$steps
    if [ "$1" = skin ]; then # some hundred steps use it up
        every=0
        skin=0.3
        moves=$((steps * 6))
    fi
    : >"$work/univol.runs"
    run=0
    while [ $run -lt $((runs < 3 ? runs : 3)) ]; do
        packing_run threads="$threads" index="$2" "$4" "skin={relative: $skin}" box.periodic=false "walls=$walls" step.dt=0.0028 \
            step.count=$moves step.rebuild_every=$every observables.every=$moves "contact={law: hooke, tangential: none}" \
            'material_pairs=[{restitution: 1, k_n: 1000}]'
        echo "$(report seconds) $(stages $rebuild_stages) $(report rebuilds) $(report contacts)" >>"$work/univol.runs"
        run=$((run + 1))
    done
    reached=$(grep -c '"cell_size"' "$work/run/report.json")
    test "$2" = auto || reached=$3
    sort -g "$work/univol.runs" | head -n 1 | awk -v kind="$1" -v nu="$nu" -v index_name="$2" -v levels="$reached" -v threads="$threads" \
        -v n="$particles" -v steps=$moves '{
        printf "{\"kind\": \"%s\", \"fraction\": %s, \"index\": \"%s\", \"levels\": %d, \"threads\": %d, \"seconds\": %.6g, \"particles\": %d, \"ns_per_particle\": %.6g, \"rebuild_seconds\": %.6g, \"rebuilds\": %d, \"contacts\": %d}\n",
            kind, nu, index_name, levels, threads, $1 / steps, n, 1e9 * $1 / steps / n, $3 ? $2 / $3 : 0, $3, $4 }' | tee -a "$rows"
}
for kind in search skin; do
    for l in $step_levels; do
        whole $kind hgrid "$l" "$(classes_at "$(cuts "$l" 0 "$packing.sizes")")"
    done
    whole $kind auto 0 classes.method=auto
done

awk -v nu="$nu" -v threads="$threads" -v cores="$cores" '
function value(key) {
    if (!match($0, "\"" key "\": [^,}]*")) return 0
    return substr($0, RSTART + length(key) + 4, RLENGTH - length(key) - 4)
}
function worth(K, k, least, sum, d) { # squared differences of the logarithms of the slowdown factors
    least = 1e300
    for (k = 1; k <= n; k++) least = L[k] * (m[k] + K) < least ? L[k] * (m[k] + K) : least
    sum = 0
    for (k = 1; k <= n; k++) { d = log(L[k] * (m[k] + K) / least) - log(t[k] / fastest); sum += d * d }
    return sum
}
{ kind = value("kind"); gsub(/"/, "", kind); is_auto = /"index": "auto"/; s = value("seconds") + 0; l = value("levels") + 0 }
kind == "detection" && is_auto {
    automatic[value("threads")] = s; chosen = l; particles = value("particles"); next
}
kind == "detection" { # fewer bins than levels: the same plan again
    if (n && L[n] == l) next
    n++; L[n] = l; m[n] = value("occupancy") + 0; t[n] = s; model[n] = value("predicted") + 0
    if (n == 1 || s < fastest) { fastest = s; best = l }
    if (n == 1 || model[n] < cheapest) { cheapest = model[n]; foreseen = l }
    next
}
is_auto { step_auto[kind] = s; next }
l == 1 { step_one[kind] = s }
!(kind in step_least) || s < step_least[kind] { step_least[kind] = s; step_best[kind] = l }
END {
    fit = 1e300
    for (K = 0.01; K < 1000; K *= 1.02) if (worth(K) < fit) { fit = worth(K); fitted = K }
    least = 1e300
    for (k = 1; k <= n; k++) least = L[k] * (m[k] + fitted) < least ? L[k] * (m[k] + fitted) : least
    for (k = 1; k <= n; k++)
        printf "{\"kind\": \"slowdown\", \"fraction\": %s, \"levels\": %d, \"threads\": %d, \"seconds\": %.6g, \"particles\": %d, \"ns_per_particle\": %.5g, \"occupancy\": %.5g, \"slowdown\": %.4g, \"prediction\": %.4g, \"model\": %.4g}\n",
            nu, L[k], threads, t[k], particles, 1e9 * t[k] / particles, m[k], t[k] / fastest, L[k] * (m[k] + fitted) / least, model[k] / cheapest
    printf "{\"summary\": true, \"fraction\": %s, \"threads\": %d, \"particles\": %d, \"seconds\": %.6g, \"ns_per_particle\": %.5g, ", nu, threads, particles,
        automatic[threads], 1e9 * automatic[threads] / particles
    if (cores != threads) printf "\"threads_all\": %d, \"seconds_all\": %.6g, \"ns_per_particle_all\": %.5g, ", cores, automatic[cores], 1e9 * automatic[cores] / particles
    printf "\"auto_levels\": %d, \"best_levels\": %d, \"best_seconds\": %.6g, \"one_level_seconds\": %.6g, \"speed_up\": %.3g, ", chosen, best, fastest,
        t[1], t[1] / fastest
    printf "\"K\": %.3g, \"K_error\": %.2g, \"model_levels\": %d", fitted, sqrt(fit / n), foreseen
    for (kind in step_least)
        printf ", \"%s\": {\"best_levels\": %d, \"step_seconds\": %.6g, \"step_speed_up\": %.3g, \"auto_step_seconds\": %.6g}", kind, step_best[kind],
            step_least[kind], step_one[kind] / step_least[kind], step_auto[kind]
    print "}"
}' "$rows"
