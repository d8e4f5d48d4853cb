#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The same forces on every layout: indexes, newton on and off, reduced ghosts, 1, 2, 3, 4 and 8 ranks (27 with
# SCREE_LONG). After at least three rebuilds with migration all forces must agree with those of brute on one rank within
# max(1e-12, 8 eps L / largest overlap) of the largest force, where eps L is the rounding of a coordinate; the numbers of pairs and
# contacts must be equal; without external forces momentum must stay constant.
set -u
. "$top_srcdir/tests/app/common.sh"
. "$top_srcdir/tests/app/forces.sh"
cd "$out" || exit 1

common='units: none
guards: {overlap_bound: 1.5}
materials: [{name: soft, density: 1}, {name: hard, density: 3}]
material_pairs: [{restitution: 0.7, friction: 0.4, k_n: 1000}]
contact: {law: hooke}
output: {dump: {every: 40}, checkpoint: {at_end: false}}
observables: {every: 40, list: [{name: momentum}, {name: overlap_max}]}
'
# Rebuilds at steps 10, 20, 30, 40, so that all layouts end with the pairs of the same step; particles are fast, so that some
# migrate at each
{
    echo "$common"
    cat <<'EOF'
box: {lower: [0, 0, 0], upper: [8, 8, 8], periodic: true}
step: {dt: 0.0005, count: 40, rebuild_every: 10}
skin: {length: 0.6}
particles:
  sources:
    - {from: random, count: 20, material: hard, sizes: 0.9, velocity_sigma: 6}
    - {from: random, count: 700, material: soft, sizes: {law: uniform, min: 0.12, max: 0.2}, velocity_sigma: 6}
EOF
} >periodic.yaml
{
    echo "$common"
    cat <<'EOF'
box: {lower: [-1, 0, 0], upper: [9, 8, 8], periodic: [false, true, false]}
gravity: [0, 0, -10]
step: {dt: 0.0005, count: 40, rebuild_every: 10}
skin: {length: 0.6}
walls:
  - {name: floor, shape: plane, material: hard, point: [0, 0, 0.4], normal: [0, 0, 1]}
  - {name: left, shape: plane, material: soft, point: [-0.4, 0, 0], normal: [1, 0, 0],
     motion: [{kind: translate, velocity: [2, 0, 0]}]}
particles:
  sources:
    - {from: random, count: 15, material: hard, sizes: 0.8, velocity_sigma: 6, region: {shape: box, lower: [0, 0, 0.4], upper: [9, 8, 5]}}
    - {from: random, count: 600, material: soft, sizes: {law: uniform, min: 0.12, max: 0.2}, velocity_sigma: 6, region: {shape: box, lower: [0, 0, 0.4], upper: [9, 8, 5]}}
EOF
} >open.yaml
{
    echo "$common"
    cat <<'EOF'
box: {dimension: 2, lower: [0, 0, 0], upper: [12, 12, 1], periodic: [true, false, false]}
gravity: [0, -5, 0]
step: {dt: 0.0005, count: 40, rebuild_every: 10}
skin: {length: 0.6}
walls: [{shape: plane, material: hard, point: [0, 0.2, 0], normal: [0, 1, 0]}]
particles:
  sources:
    - {from: random, count: 12, material: hard, sizes: 0.8, velocity_sigma: 6, region: {shape: box, lower: [0, 0.3, 0], upper: [12, 8, 1]}}
    - {from: random, count: 400, material: soft, sizes: {law: uniform, min: 0.1, max: 0.16}, velocity_sigma: 6, region: {shape: box, lower: [0, 0.3, 0], upper: [12, 8, 1]}}
EOF
} >plane.yaml
{
    echo "$common"
    cat <<'EOF'
box: {lower: [0, 0, 0], upper: [8, 8, 8], periodic: true}
step: {dt: 0.00045, count: 40, rebuild_every: 10}
skin: {length: 0.6}
particles:
  sources:
    - {from: single, position: [3, 4, 4.5], radius: 2, material: hard, velocity: [5, 3, 1]}
    - {from: random, count: 900, material: soft, sizes: {law: uniform, min: 0.08, max: 0.15}, velocity_sigma: 8}
EOF
} >boulder.yaml

# reference CASE: brute on one rank
reference() {
    run_scene 1 "$1.yaml" "$1-first" --set index=brute --set threads=1 && last_frame "$1-first" || return 1
    local rebuilds contacts
    rebuilds=$(number "$1-first/report.json" rebuilds)
    contacts=$(number "$1-first/report.json" contacts)
    echo "  $rebuilds rebuilds, $contacts contacts, bound $(bound_of "$1" 12)"
    [ "$rebuilds" = 4 ] && [ "$contacts" -ge 10 ]
}

# layout CASE RANKS INDEX NEWTON GHOSTS [SKIN]; with a skin rebuilds come when it is used up, on each layout at other steps
layout() {
    local dir=$1-other keys='particles contacts pairs rebuilds'
    run_scene "$2" "$1.yaml" "$dir" --overwrite --set threads=1 --set index="$3" --set newton="$4" --set ghosts="$5" \
        ${6:+--set skin.length="$6" --set step.rebuild_every=0} || return 1
    if [ -n "${6:-}" ]; then
        keys='particles contacts'
        [ "$(number "$dir/report.json" rebuilds)" -ge 4 ] || { echo '  few rebuilds'; return 1; }
    fi
    # shellcheck disable=SC2086
    same_forces "$1" "$dir" 12 $keys || return 1
    case $1 in
    periodic | boulder) momentum_kept "$dir" ;;
    esac
}

for case in periodic open plane boulder; do
    check "$case: the reference moves enough" reference $case
    in_turns '1 linkcell on full' '1 multi off full' '1 bytype on full' '1 hgrid off full' \
        '2 hgrid on full' '3 bytype on reduced' '4 hgrid off full' '8 hgrid on reduced' '4 hgrid on reduced 0.04' \
        '2 bytype off full 0.04'
    for setting in "${some[@]}"; do
        check "$case: ranks, index, newton, ghosts (, skin): $setting" layout $case $setting
    done
done
# what is left of the product, on the case with everything
for setting in '2 brute on full' '2 linkcell off full' '3 multi on reduced' '4 bytype on full' '4 linkcell on reduced' '8 multi off full'; do
    check "open: ranks, index, newton, ghosts: $setting" layout open $setting
done
quantiles() { # RANKS INDEX: four classes of about as many particles each, 720 in all
    local classes
    run_scene "$1" periodic.yaml quantiles --overwrite --set threads=1 --set index="$2" --set 'classes={method: quantiles, count: 4}' || return 1
    classes=$(grep -c '"particles": 1[6-9][0-9], "ghosts"' quantiles/report.json)
    [ "$classes" = 4 ] || { echo "  $classes classes of a quarter"; return 1; }
    same_forces periodic quantiles 12 particles contacts pairs rebuilds
}
for setting in '1 bytype' '1 hgrid' '2 multi'; do
    check "periodic: classes by quantiles: ranks, index: $setting" quantiles $setting
done
# orders CASE RANKS THREADS [SETTING...]: fused steps and plain ones give the same bits
orders() {
    local case=$1 ranks=$2 threads=$3 order setting settings
    shift 3
    for order in fused plain; do
        settings=(--overwrite --set threads="$threads" --set step.rebuild_every=16)
        for setting; do settings+=(--set "$setting"); done
        test $order != plain || settings+=(--set step.fused=false)
        run_scene "$ranks" "$case.yaml" "order-$order" "${settings[@]}" && last_frame "order-$order" || return 1
        cmp order-fused/last "order-$order/last" && cmp order-fused/observables.csv "order-$order/observables.csv" || return 1
    done
}
for case in periodic open plane boulder; do
    in_turns '1 1' '2 2' '1 3' '4 1'
    for setting in "${some[@]}"; do
        check "$case: orders of the step: ranks, threads: $setting" orders $case $setting
    done
done
# grains fall so fast that a fused step finds out that a rebuild is due, and computes its forces again
for setting in '1 2' '2 1'; do
    check "open: orders of the step, unexpected rebuilds: ranks, threads: $setting" orders open $setting 'gravity=[0, 0, -5000]' \
        step.rebuild_every=0 skin.length=0.1 step.count=60 output.dump.every=60 guards.overlap=off guards.speed=off \
        'particles.sources[0].velocity_sigma=0' 'particles.sources[1].velocity_sigma=0'
done
if [ -n "${SCREE_LONG:-}" ]; then
    for case in periodic open plane boulder; do
        for index in brute linkcell multi bytype hgrid; do
            for setting in 'on full' 'on reduced' 'off full'; do
                for ranks in 1 2 3 4 8 27; do
                    check "$case: ranks, index, newton, ghosts: $ranks $index $setting" layout $case $ranks $index $setting
                done
            done
        done
    done
fi

finish
