#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# What grains cost that the fluid moves, with `coupling: rigid` and with `coupling: mirror`: water.sh [--quick] [--counts | --ranks | --large]
#
# Spheres of eight spacings fall in a periodic box of 16 spacings a sphere (a fifteenth of the volume), eight of them in 32,768 nodes of the fluid's lattice. Both couplings run in turns,
# PAIRS (5) times, rigid first in one pair and mirror in the next, so that other work on the machine meets both. One JSON line a run:
#
#   particles             fluid particles
#   ns_per_particle       of a step, by phase: neighbours (sorting, copies, index, pairs), operators (weights and mirrors), matrices (assembly, preconditioner), velocity and
#                         pressure (solves), rest (flow, grains and what is left), sum
#   velocity, pressure    iterations a solve; solves: solves for the pressure a step
#   bytes_per_particle    resident memory
#
# and at the end one line with the median of mirror's sum over rigid's, and the least and the largest of the pairs.
#
# --counts   instructions a particle and step, by valgrind, from runs of two and of four steps: other work on the machine does not change these
# --ranks    iterations, solves and the bytes that the first rank sent, of `rigid`, on 1, 2, 4 and 8 ranks (RANKS)
# --large    `rigid` alone, on two ranks (RANKS): 2,016 spheres of six spacings, 0.22 of the volume, in 1,032,192 nodes; three steps (STEPS); wants 6 GB. One more number: seconds a step
# --quick    one sphere, 4,096 nodes, two pairs. STEPS (8), SCREE, WORK may be set.
set -eu -o pipefail
here=$(cd "$(dirname "$0")" && pwd)
. "$here/bench.sh"
export LC_ALL=C OMP_WAIT_POLICY=passive OMP_NUM_THREADS=1
usage='water.sh [--quick] [--counts | --ranks | --large]'
quick= mode=turns
for argument; do
    case $argument in
    --quick) quick=yes ;;
    --counts) mode=counts ;;
    --ranks) mode=ranks ;;
    --large) mode=large ;;
    *) wrong_call ;;
    esac
done
cells=$(by_mode 1 2)
steps=${STEPS:-8}
side=$((16 * cells))
edges="$side, $side, $side" apart=16 size=4 force=0.0019635 # of the box; of the spheres; what holds them

# run COUPLING RANKS STEPS [COMMAND...]: into WORK/water.COUPLING; the command stands before the program
run() {
    local coupling=$1 ranks=$2 count=$3 motion=fixed
    shift 3
    [ "$coupling" = rigid ] || motion=lagrangian
    cat >"$work/water.yaml" <<YAML
units: none
threads: 1
box: {lower: [0, 0, 0], upper: [$edges], periodic: true}
gravity: [0, 0, -0.02]
contact: {law: hertz}
materials: [{name: glass, density: 2.5, young: 100, poisson: 0.3}]
material_pairs: [{restitution: 0.5, friction: 0.3}]
particles: {from: lattice, lattice: sc, spacing: $apart, sizes: $size}
fluid:
  spacing: 1
  density: 1
  viscosity: 0.2
  motion: $motion
  grains: {motion: free, coupling: $coupling}
  drive: {body_force: [0, 0, $force]}
step: {dt: 0.5, count: $count}
observables: {every: 1000000, list: [{name: fluid_speed}]}
output: {checkpoint: {at_end: false}}
YAML
    quietly on_ranks "$ranks" "$@" "$SCREE" run "$work/water.yaml" -o "$work/water.$coupling" --overwrite --quiet
}

# line COUPLING RANKS STEPS: the last run as a line of JSON
line() {
    tr -d '\n' <"$work/water.$1/report.json" | awk -v coupling="$1" -v ranks="$2" -v steps="$3" -v sums="$(report_stages "$work/water.$1" reorder ghosts index pairs) $(report_stages "$work/water.$1" operators) $(
        report_stages "$work/water.$1" assembly preconditioner) $(report_stages "$work/water.$1" solve)" '
        function number(text, key) { return match(text, "\"" key "\": [-+.0-9e]+") ? substr(text, RSTART + length(key) + 4, RLENGTH - length(key) - 4) + 0 : 0 }
        function solver(name, at, text) { text = substr($0, index($0, "\"solvers\"")); at = index(text, "{\"name\": \"" name "\""); return substr(text, at, index(substr(text, at), "}")) }
        function ns(seconds) { return 1e9 * seconds * ranks / particles / steps }
        { u = solver("velocity"); p = solver("pressure"); particles = number(p, "rows"); split(sums, s, " ")
          velocity = number(u, "seconds_solve"); pressure = number(p, "seconds_solve"); all = number($0, "seconds") - number($0, "seconds_setup")
          matrices = s[3] + (s[4] - velocity - pressure > 0 ? s[4] - velocity - pressure : 0)
          printf "{\"coupling\": \"%s\", \"ranks\": %d, \"particles\": %d, \"ns_per_particle\": {\"neighbours\": %.0f, \"operators\": %.0f, \"matrices\": %.0f, \"velocity\": %.0f, \"pressure\": %.0f, \"rest\": %.0f, \"sum\": %.0f}, ",
              coupling, ranks, particles, ns(s[1]), ns(s[2]), ns(matrices), ns(velocity), ns(pressure), ns(all - s[1] - s[2] - matrices - velocity - pressure), ns(all)
          printf "\"velocity\": %.3g, \"pressure\": %.3g, \"solves\": %.3g, \"bytes_per_particle\": %.0f}\n", number(u, "iterations") / number(u, "solves"),
              number(p, "iterations") / number(p, "solves"), number(p, "solves") / steps, number($0, "memory_peak") * ranks / particles }'
}

turns() {
    local pair first second
    : >"$work/water.rows"
    for pair in $(seq "${PAIRS:-$(by_mode 2 5)}"); do
        first=rigid second=mirror
        [ $((pair % 2)) = 1 ] || { first=mirror; second=rigid; }
        for coupling in $first $second; do
            run "$coupling" 1 "$steps"
            line "$coupling" 1 "$steps" | tee -a "$work/water.rows"
        done
    done
    awk '{ match($0, /"sum": [0-9]+/); sum[$0 ~ /"rigid"/ ? "rigid" : "mirror"] = substr($0, RSTART + 7, RLENGTH - 7) }
        NR % 2 == 0 { print sum["mirror"] / sum["rigid"] }' "$work/water.rows" | sort -g |
        awk '{ v[NR] = $1 } END { printf "{\"mirror_over_rigid\": %.3g, \"least\": %.3g, \"largest\": %.3g, \"pairs\": %d}\n", NR % 2 ? v[(NR + 1) / 2] : (v[NR / 2] + v[NR / 2 + 1]) / 2, v[1], v[NR], NR }'
}

counts() {
    local coupling count
    command -v valgrind >/dev/null || { echo "no valgrind here: apt-get install valgrind" >&2; exit 1; }
    for coupling in rigid mirror; do
        for count in 2 4; do
            run "$coupling" 1 "$count" valgrind --tool=callgrind --callgrind-out-file=/dev/null
            sed -n 's/.*Collected : //p' "$work/output"
        done | awk -v coupling="$coupling" -v n=$((side * side * side)) '{ v[NR] = $1 }
            END { printf "{\"coupling\": \"%s\", \"instructions_per_particle\": %.0f}\n", coupling, (v[2] - v[1]) / 2 / n }'
    done
}

case $mode in
turns) turns ;;
large)
    edges='96, 96, 112' apart=8 size=3 force=0.0066268 steps=${STEPS:-3} ranks=${RANKS:-2}
    [ -z "$quick" ] || edges='32, 32, 32'
    run rigid "$ranks" "$steps"
    line rigid "$ranks" "$steps" | awk -v ranks="$ranks" '{ match($0, /"particles": [0-9]+/); n = substr($0, RSTART + 13, RLENGTH - 13); match($0, /"sum": [0-9]+/); ns = substr($0, RSTART + 7, RLENGTH - 7)
        sub(/}$/, sprintf(", \"seconds_per_step\": %.3g}", 1e-9 * ns * n / ranks)); print }'
    ;;
counts) counts ;;
ranks)
    for ranks in ${RANKS:-$(by_mode "1 2" "1 2 4 8")}; do
        run rigid "$ranks" "$steps"
        line rigid "$ranks" "$steps" | sed "s/}\$/, \"bytes_sent\": $(sed -n 's/^ *"bytes": \[\([0-9]*\).*/\1/p' "$work/water.rigid/report.json")}/"
    done
    ;;
esac
