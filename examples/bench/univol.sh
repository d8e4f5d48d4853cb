#!/bin/sh
# Levels of the hierarchical grid: univol.sh NU [--quick]
#
# 125,001 spheres of size ratio 50 whose sizes each hold the same volume (number density ~ r^-3), at volume fraction NU in
# a periodic cube: the systems of Ogarko and Luding's study of the packing fraction (Figures 2 and 3), placed at random.
# Times a complete detection (order + build + search with the exact test) for 1 ... 32 levels of equal occupancy with cells
# of the cut-off, and as `auto` chooses; then fits K of T ~ N L (m + K), equation 3, by the slowdown factors.
#
# One JSON line a measurement, the last line the summary: best levels, speed-up over one level, K, and auto's time. --quick:
# 30,000 spheres, fewer levels. Needs `make tests/index/bench_index`; BENCH (that program), THREADS (1), RUNS (5) may be set.
set -eu
usage() {
    echo "usage: univol.sh NU [--quick]" >&2
    exit 2
}
nu=${1:-}
quick=
test "${2:-}" != --quick || quick=yes
test $# = 1 || test -n "$quick" || usage
case $nu in
0.[0-9]*) ;;
*) usage ;;
esac
bench=${BENCH:-tests/index/bench_index}
command -v "$bench" >/dev/null || { echo "no $bench here: make tests/index/bench_index, or set BENCH" >&2; exit 1; }
threads=${THREADS:-1}
export OMP_WAIT_POLICY=passive
levels="1 2 3 4 5 6 7 8 10 12 16 20 24 28 32"
set -- particles=125001 repetitions="${RUNS:-5}"
if [ -n "$quick" ]; then
    levels="1 2 3 4 6 8"
    set -- particles=30000 repetitions=3
fi
rows=$(mktemp)
trap 'rm -f "$rows"' EXIT
for l in $levels; do
    "$bench" law=power exponent=-3 ratio=50 fraction="$nu" threads="$threads" "$@" levels="$l" factor=1
done | tee "$rows"
"$bench" law=power exponent=-3 ratio=50 fraction="$nu" threads="$threads" "$@" levels=0 index=auto | tee -a "$rows"
awk -v nu="$nu" -v threads="$threads" '
function value(key) {
    match($0, "\"" key "\": [^,}]*")
    return substr($0, RSTART + length(key) + 4, RLENGTH - length(key) - 4) + 0
}
function worth(K, k, least, sum, d) { # squared differences of the logarithms of the slowdown factors
    least = 1e300
    for (k = 1; k <= n; k++) least = L[k] * (m[k] + K) < least ? L[k] * (m[k] + K) : least
    sum = 0
    for (k = 1; k <= n; k++) { d = log(L[k] * (m[k] + K) / least) - log(t[k] / fastest); sum += d * d }
    return sum
}
/"index": "auto"/ { auto = value("seconds"); chosen = value("levels"); particles = value("particles"); next }
{ n++; L[n] = value("levels"); m[n] = value("occupancy"); t[n] = value("seconds")
  if (n == 1 || t[n] < fastest) { fastest = t[n]; best = L[n] } }
END {
    fit = 1e300
    for (K = 0.01; K < 1000; K *= 1.05) if (worth(K) < fit) { fit = worth(K); fitted = K }
    printf "{\"summary\": true, \"fraction\": %s, \"threads\": %d, \"particles\": %d, \"seconds\": %g, \"ns_per_particle\": %.1f, ", nu, threads, particles, auto, 1e9 * auto / particles
    printf "\"auto_levels\": %d, \"best_levels\": %d, \"best_seconds\": %g, \"one_level_seconds\": %g, \"speed_up\": %.3g, \"K\": %.3g, \"K_error\": %.2g}\n", chosen, best, fastest, t[1], t[1] / fastest, fitted, sqrt(fit / n)
}' "$rows"
