#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# What the guards that are on by default cost, in instructions: other work on the machine does not change these. Two packings of
# some 10,000 spheres, loose (radii 1 and 5) and dense (a power law from 1 to 5), 1,000 steps on one thread under valgrind's callgrind, with
# guards as they are by default and without, each less a run of one step. A line of JSON a packing.
#
#   guards.sh

here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
command -v valgrind >/dev/null || { echo 'no valgrind here: apt-get install valgrind' >&2; exit 1; }
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
cat >"$out/scene.yaml" <<'EOS'
units: none
box: {periodic: true}
threads: 1
step: {dt: 1e-3, count: 1000}
contact: {law: hooke}
index: hgrid
materials: [{name: small, density: 1}, {name: large, density: 1}]
material_pairs: [{restitution: 0.5, friction: 0.5, k_n: 10000}]
particles: {file: packing.data, format: lammps-data, types: [small, large]}
output: {checkpoint: {at_end: false}}
EOS
packing() {
    case $1 in
    loose) "$SCREE" pack bidisperse "$out/packing.data" ratio=5 box=52 numbers=recipe velocity=1 --overwrite --quiet ;;
    dense) "$SCREE" pack power "$out/packing.data" count=10000 min=1 max=5 fraction=0.63 overlap=0.01 velocity=1 --overwrite --quiet ;;
    esac
}
# cost FLAG...: instructions of 1,000 steps
cost() {
    local count total=0
    for count in 1 1001; do
        valgrind --tool=callgrind --callgrind-out-file=/dev/null "$SCREE" run "$out/scene.yaml" -o "$out/run" --overwrite --quiet \
            --set step.count=$count "${types[@]}" "$@" >"$out/said" 2>&1 || { cat "$out/said" >&2; exit 1; }
        total=$(($(sed -n 's/.*Collected : //p' "$out/said") - total))
    done
    echo $total
}
for name in loose dense; do
    packing $name || exit 1
    types=()
    [ $name = loose ] || types=(--set 'particles.types=[small]')
    all=$(cost --set guards.energy=off --set guards.step=off --set guards.overlap=off --set guards.speed=off) || exit 1
    echo "$(cost) $(cost --set guards.energy=off) $(cost --set guards.step=off) $all" |
        awk -v name=$name -v n="$(report_number "$out/run" particles)" -v contacts="$(report_number "$out/run" contacts)" 'NF == 4 {
            printf "{\"packing\": \"%s\", \"particles\": %d, \"contacts\": %d, \"instructions\": %.4g, \"all_guards\": %.4f, \"energy\": %.4f, \"step\": %.4f}\n",
                name, n, contacts, $4, ($1 - $4) / $4, ($1 - $2) / $4, ($1 - $3) / $4; good = 1 } END { exit !good }' || exit 1
done
