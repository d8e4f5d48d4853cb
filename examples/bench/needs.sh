#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# What each term of a scene costs: bytes a particle and time of a step, from discs without friction to Hertz and Mindlin with rolling
# resistance. A line of JSON a variant: the processor's time of one thread, less that of a run of one step; the runs take turns, and the
# fastest of REPEAT (5) counts.
#
#   needs.sh [STEPS [VARIANT...]]

here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
steps=${1:-1000}
export OMP_NUM_THREADS=1
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

smooth='material_pairs=[{restitution: 0.9}]'
hooke='materials=[{name: a, density: 1}]'
discs=(--set 'box={dimension: 2, lower: [0, 0, -2], upper: [180, 180, 2], periodic: [true, true, false]}' --set particles.lattice=square)
names=(bodies bonds heat shear stress jkr dmt sjkr capillary van_der_waals luding eepa thornton thornton_jkr twisting marshall epsd full no_rolling no_friction no_walls hooke no_periodic discs)
[ $# -lt 2 ] || names=("${@:2}")
flags_of() {
    local rolling=(--set contact.rolling=none --set 'material_pairs=[{restitution: 0.9, friction: 0.5}]')
    local friction=(--set 'contact={law: hertz, tangential: none}' --set "$smooth") walls=(--set 'walls=[]')
    local spring=(--set 'contact={law: hooke, tangential: none}' --set "$hooke" --set 'material_pairs=[{restitution: 0.9, k_n: 1e5}]')
    local pair='restitution: 0.9, friction: 0.5' wound='restitution: 0.9, friction: 0.5, rolling_friction: 0.1'
    case $1 in
    bonds) flags=(--set 'bonds={gap: 0.01, laws: [{modulus: 1e5, stiffness_ratio: 2}]}') ;;
    bodies) flags=(--set 'bodies={clumps: [{spheres: [{centre: [-1, 0, 0], radius: 1}, {centre: [1, 0, 0], radius: 1}]}]}') ;;
    heat) flags=(--set 'heat={materials: [{conductivity: 1, capacity: 1}]}') ;;
    jkr) flags=(--set 'contact={law: hertz, cohesion: {law: jkr}}' --set "material_pairs=[{$pair, surface_energy: 10}]") ;;
    capillary) flags=(--set 'contact={law: hertz, cohesion: {law: capillary}}' --set "material_pairs=[{$pair, surface_tension: 10, contact_angle: 0.5, bridge_volume: 0.01}]") ;;
    luding) flags=(--set 'contact={law: luding}' --set "$hooke" --set "material_pairs=[{$pair, k_n: 1e5, k_2: 2e5, k_c: 5e4, plasticity_depth: 0.05}]") ;;
    eepa) flags=(--set 'contact={law: eepa}' --set "material_pairs=[{$pair, plasticity_ratio: 0.5, adhesion_energy: 10}]") ;;
    dmt) flags=(--set 'contact={law: hertz, cohesion: {law: dmt}}' --set "material_pairs=[{$pair, surface_energy: 10}]") ;;
    sjkr) flags=(--set 'contact={law: hertz, cohesion: {law: sjkr}}' --set "material_pairs=[{$pair, cohesion_density: 100}]") ;;
    van_der_waals) flags=(--set 'contact={law: hertz, cohesion: {law: van_der_waals}}' --set "material_pairs=[{$pair, hamaker: 0.1, gap_least: 0.01, cut_off: 0.2}]") ;;
    thornton) flags=(--set 'contact={law: thornton}' --set "material_pairs=[{$pair, yield_pressure: 1e4}]") ;;
    thornton_jkr) flags=(--set 'contact={law: thornton, cohesion: {law: jkr}}' --set "material_pairs=[{$pair, yield_pressure: 1e4, surface_energy: 10}]") ;;
    twisting) flags=(--set contact.twisting=sds --set "material_pairs=[{$wound, twisting_stiffness: 100, twisting_friction: 0.1}]") ;;
    marshall) flags=(--set contact.twisting=marshall) ;;
    epsd) flags=(--set contact.rolling=epsd) ;;
    shear) flags=("${walls[@]}" --set box.periodic=true --set 'box.shear={rate: 0.1}') ;;
    stress) flags=("${walls[@]}" --set box.periodic=true --set 'box.stress={pressure: 100, xy: -10}') ;;
    full) flags=() ;;
    no_rolling) flags=("${rolling[@]}") ;;
    no_friction) flags=("${friction[@]}") ;;
    no_walls) flags=("${friction[@]}" "${walls[@]}") ;;
    hooke) flags=("${spring[@]}" "${walls[@]}") ;;
    no_periodic) flags=("${spring[@]}" "${walls[@]}" --set box.periodic=false) ;;
    discs) flags=("${spring[@]}" "${walls[@]}" "${discs[@]}" --set box.periodic=false) ;;
    esac
}
declare -A best
TIMEFORMAT='%U %S'
least() { # NAME STEPS: the processor's seconds of a run with the flags at hand, where they are the least so far
    local spent
    spent=$({ time "$SCREE" run "$here/needs.yaml" -o "$out/$1" --overwrite --quiet --set step.count="$2" --set output.checkpoint.at_end=false "${flags[@]}" >"$out/said" 2>&1; } 2>&1) || {
        cat "$out/said" >&2
        exit 1
    }
    best[$1,$2]=$(awk -v spent="$spent" -v b="${best[$1,$2]:-1e9}" 'BEGIN { split(spent, a, " "); a[1] += a[2]; print a[1] < b ? a[1] : b }')
}
for ((r = 0; r < ${REPEAT:-5}; r++)); do
    for name in "${names[@]}"; do
        flags_of "$name"
        least "$name" 1
        least "$name" "$steps"
    done
done
for name in "${names[@]}"; do
    flags_of "$name"
    "$SCREE" check --all "$here/needs.yaml" "${flags[@]}" >"$out/needs.txt" || exit 1
    awk -v name="$name" -v seconds="$(awk "BEGIN { print ${best[$name,$steps]} - ${best[$name,1]} }")" -v steps="$((steps - 1))" -v n="$(report_number "$out/$name" particles)" -v contacts="$(report_number "$out/$name" contacts)" '
        /^  stored:/ { bytes = $2 }
        /^  history: [0-9]/ { history = $2 }
        /^passes of a step/ { counting = 1; next }
        counting && /^ fused/ { next }
        counting && (/^ at rebuilds/ || /^$/) { counting = 0 }
        counting { passes++ }
        END { printf "{\"variant\": \"%s\", \"particles\": %d, \"nanoseconds_a_particle_and_step\": %.1f, \"bytes_a_particle\": %d, \"history_bytes_a_pair\": %d, \"passes\": %d, \"contacts\": %d}\n",
            name, n, 1e9 * seconds / steps / n, bytes, history, passes, contacts }' "$out/needs.txt"
done
