#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# reproducible: true gives the same bits on any index, ranks x threads, domain and sync (all combinations with SCREE_LONG). The test
# runs each scene to a checkpoint, after at least three rebuilds with migration. All data of the checkpoint (state, forces, springs,
# poses), and the sums over particles in observables.csv, must equal those of brute on one rank and thread to the last bit.
set -u
. "$top_srcdir/tests/app/common.sh"
find_bisection
. "$top_srcdir/tests/app/scenes.sh"
cd "$out" || exit 1

common='units: none
reproducible: true
output: {checkpoint: {at_end: true}}
guards: {overlap_bound: 1.5, speed: off}
domain: {name: brick}
observables: {every: 10, list: [{name: momentum}, {name: angular_momentum}, {name: energy_kinetic}, {name: centre}, {name: contacts}]}
'
{
    echo "$common"
    echo 'step: {dt: 0.001, count: 100}'
    bed
} >bed.yaml
# Radii 10 : 1, Hertz's law; the run chooses its skin
{
    echo "$common"
    cat <<'END'
box: {lower: [0, 0, 0], upper: [8, 8, 8], periodic: true}
step: {dt: 0.0002, count: 60, force: true}
materials: [{name: soft, density: 1, young: 10000, poisson: 0.3}, {name: hard, density: 2, young: 30000, poisson: 0.2}]
contact: {law: hertz}
material_pairs: [{restitution: 0.7, friction: 0.4}]
skin: {length: 0.05, auto: true}
particles:
  sources:
    - {from: random, count: 20, material: hard, sizes: 0.9, velocity_sigma: 12}
    - {from: random, count: 900, material: soft, sizes: 0.09, velocity_sigma: 12}
END
} >ten.yaml
# A ball of half the box, so many contacts that its class is busy
{
    echo "$common"
    cat <<'END'
box: {lower: [0, 0, 0], upper: [8, 8, 8], periodic: true}
step: {dt: 0.00045, count: 40}
materials: [{name: soft, density: 1}, {name: hard, density: 2}]
contact: {law: hooke}
material_pairs: [{restitution: 0.7, friction: 0.4, k_n: 1000}]
skin: {length: 0.1}
particles:
  sources:
    - {from: single, position: [3, 4, 4.5], radius: 2, material: hard, velocity: [5, 3, 1]}
    - {from: random, count: 1500, material: soft, sizes: {law: uniform, min: 0.08, max: 0.25}, velocity_sigma: 8}
END
} >boulder.yaml
# Thinner than two cut-offs: the same two particles meet through two images, with a spring in each
{
    echo "$common"
    cat <<'END'
box: {lower: [0, 0, 0], upper: [2.5, 6, 6], periodic: true}
step: {dt: 0.0005, count: 60}
materials: [{name: soft, density: 1}, {name: hard, density: 2}]
contact: {law: hooke, rolling: spring}
material_pairs: [{restitution: 0.7, friction: 0.4, rolling_friction: 0.1, k_n: 500}]
skin: {length: 0.1}
particles:
  sources:
    - {from: single, position: [0.3, 2, 3], radius: 1.1, material: hard, velocity: [3, 1, 0]}
    - {from: single, position: [1.5, 2.9, 4.2], radius: 1.0, material: hard, velocity: [0, -4, -4]}
    - {from: random, count: 200, material: soft, sizes: {law: uniform, min: 0.15, max: 0.25}, velocity_sigma: 6}
END
} >thin.yaml
# A disc of nearly the box, and others that leap by many times their size in a step, with springs
{
    echo "${common/speed: off/speed: off, overlap: off}"
    cat <<'END'
seed: 56
box: {dimension: 2, lower: [-1, 0, 2], upper: [8.196, 7.290, 3], periodic: [true, true, false]}
step: {dt: 0.001, count: 20, force: true}
materials: [{name: soft, density: 1}, {name: hard, density: 3}]
contact: {law: hooke}
material_pairs: [{restitution: 0.7, friction: 0.4, k_n: 601.332}]
particles:
  sources:
    - {from: random, count: 1, material: hard, velocity_sigma: 364.5, sizes: 3.0618}
    - {from: random, count: 129, material: soft, velocity_sigma: 364.5, sizes: 0.15309}
END
} >leap.yaml
# Particles that come, go and leave; 2D; a blade that turns
{
    echo "$common"
    cat <<'END'
box: {dimension: 2, lower: [0, 0, 0], upper: [12, 12, 1], periodic: [true, false, false], leave: delete}
gravity: [0, -5, 0]
step: {dt: 0.0005, count: 400}
materials: [{name: soft, density: 1}, {name: hard, density: 2}]
contact: {law: hooke}
material_pairs: [{restitution: 0.7, friction: 0.4, k_n: 3000}]
walls:
  - {name: slope, shape: plane, material: hard, point: [0, -1, 0], normal: [0, 1, 0], motion: [{kind: rotate, direction: [0, 0, 1], point: [6, -1, 0], rate: 0.4}]}
particles:
  sources:
    - {from: random, count: 12, material: hard, sizes: 0.8, velocity_sigma: 6, region: {shape: box, lower: [0, 0.3, 0], upper: [12, 8, 1]}}
    - {from: random, count: 400, material: soft, sizes: {law: uniform, min: 0.1, max: 0.16}, velocity_sigma: 6, region: {shape: box, lower: [0, 0.3, 0], upper: [12, 8, 1]}}
insertions: [{rate: 500, material: soft, sizes: 0.15, region: {shape: box, lower: [1, 9, 0], upper: [11, 11, 1]}}]
END
} >flow.yaml

# Strained, and sheared fast enough that copies across the gradient come from other ranks at each rebuild; ratio 8, springs
{
    echo "$common"
    cat <<'END'
box: {lower: [0, 0, 0], upper: [8, 6, 5], periodic: true, shear: {rate: -20, flow: z, gradient: x}, strain: {rate: [0.5, -1.5, 0.8]}}
step: {dt: 0.0004, count: 120}
materials: [{name: soft, density: 1}, {name: hard, density: 2}]
contact: {law: hooke, rolling: spring}
material_pairs: [{restitution: 0.7, friction: 0.4, rolling_friction: 0.1, k_n: 500}]
skin: {length: 0.05}
particles:
  sources:
    - {from: random, count: 8, material: hard, sizes: 0.8, velocity_sigma: 6}
    - {from: random, count: 700, material: soft, sizes: {law: uniform, min: 0.1, max: 0.18}, velocity_sigma: 6}
END
} >sheared.yaml
# Edges and shear that follow the stress: what the forces sum up to decides how the box goes on
{
    echo "$common"
    cat <<'END'
box: {lower: [0, 0, 0], upper: [6, 6, 5], periodic: true, shear: {rate: 2, flow: z, gradient: x}, stress: {xx: 20, yy: 30, zz: 10, xz: -8, inertia: 1}}
step: {dt: 0.0015, count: 120}
materials: [{name: soft, density: 1}]
contact: {law: hooke, rolling: spring}
material_pairs: [{restitution: 0.7, friction: 0.4, rolling_friction: 0.1, k_n: 500}]
skin: {length: 0.05}
particles: {from: lattice, lattice: fcc, spacing: 1, sizes: {law: uniform, min: 0.3, max: 0.4}, jitter: 0.3, velocity_sigma: 1}
END
} >pressed.yaml

# contents DIR FILE: the last checkpoint in lines, sorted
contents() {
    checkpoint_lines "$1/checkpoint-$(newest "$1").h5" >"$2" && [ -s "$2" ]
}

reference() {
    run_scene 1 "$1.yaml" "$1-first" --set index=brute --set threads=1 && contents "$1-first" "$1.lines" || return 1
    echo "  $(grep -c '^particle' "$1.lines") particles, $(grep -c contact "$1.lines") sides with springs," \
        "$(number "$1-first/report.json" rebuilds) rebuilds"
    [ "$(number "$1-first/report.json" rebuilds)" -ge 4 ] && [ "$(grep -c contact "$1.lines")" -ge 12 ]
}

# layout CASE RANKS THREADS INDEX DOMAIN SYNC [SETTING...]
layout() {
    local case=$1 ranks=$2 threads=$3 index=$4 domain=${5/bisection/$bisection} sync=$6 setting flags=()
    shift 6
    for setting in "$@"; do flags+=(--set "$setting"); done
    run_scene "$ranks" "$case.yaml" "$case-other" --overwrite --set threads="$threads" --set index="$index" \
        --set domain="$domain" --set sync="$sync" "${flags[@]}" && contents "$case-other" other.lines || return 1
    cmp "$case.lines" other.lines && cmp "$case-first/observables.csv" "$case-other/observables.csv"
}

chosen() {
    [ "$(number ten-first/report.json skin_changes)" -gt 0 ]
}

twice() {
    awk '$1 == "contact" { print $2, $3 }' thin.lines | sort | uniq -d | grep -q .
}

# Two layouts of the fast mode differ: what is compared does see the last bit
differs() {
    run_scene 1 bed.yaml fast --set reproducible=false --set threads=1 && contents fast fast.lines &&
        run_scene 4 bed.yaml fast --overwrite --set reproducible=false --set threads=1 && contents fast fast-4.lines || return 1
    grep '^particle' fast.lines >particles && grep '^particle' fast-4.lines >particles-4 || return 1
    [ "$(wc -l <particles)" = "$(wc -l <particles-4)" ] && ! cmp -s particles particles-4
}

# whole CASE STEPS: the run that the next ones are compared with, with a checkpoint half-way
whole() {
    run_scene 1 "$1.yaml" "$1-whole" --set output.checkpoint.every=$(($2 / 2)) && contents "$1-whole" whole.lines
}

# goes_on CASE STEPS FROM TO: what one layout wrote half-way another goes on with
goes_on() {
    local half=$(($2 / 2)) key
    run_scene "$3" "$1.yaml" half --overwrite --set threads=2 --set index=multi --set output.checkpoint.every=$half --set step.count=$half &&
        run_scene "$4" "$1.yaml" half --overwrite --resume half/checkpoint-$half.h5 --set threads=1 --set step.count="$2" &&
        contents half half.lines || return 1
    cmp whole.lines half.lines && cmp "$1-whole/observables.csv" half/observables.csv || return 1
    for key in inserted deleted; do
        [ "$(number half/report.json $key)" = "$(number "$1-whole/report.json" $key)" ] || { echo "  $key: $(number half/report.json $key)"; return 1; }
    done
}

# Particles come and leave in both halves of the flow
comes_and_goes() {
    local first last key
    run_scene 1 flow.yaml flow-half --set step.count=200 || return 1
    for key in inserted deleted; do
        first=$(number flow-half/report.json $key) last=$(number flow-whole/report.json $key)
        echo "  $key: $first, then $last"
        [ "$first" -gt 0 ] && [ "$last" -gt "$first" ] || return 1
    done
}

# `make check-long` tries each case in each of these layouts, `make check` in every second, the even and the odd ones in turns
settings=('1 2 linkcell brick auto' '2 1 multi bisection auto' '4 2 hgrid brick shadow' '8 1 bytype bisection shadow'
    '4 1 auto brick auto' '2 2 hgrid bisection auto domain.threshold=1.001'
    '1 1 bytype brick auto step.fused=false' '3 1 brute bisection auto newton=true ghosts=reduced')
turn=0
for case in bed ten boulder thin flow sheared pressed; do
    check "$case: the reference moves enough" reference $case
    for ((k = ${SCREE_LONG:+0 *} turn++ % 2; k < ${#settings[@]}; k += ${SCREE_LONG:+-1} + 2)); do
        setting=${settings[k]}
        case $setting$bisection in
        *threshold*brick) setting='2 2 hgrid brick auto' ;;
        esac
        check "$case: ranks, threads, index, domain, sync: $setting" layout $case $setting
    done
done
check 'ten: the run chose its skin' chosen
for case in flow bed; do
    check "$case: with next neighbours alone" layout $case 2 2 linkcell brick neighbours
done
check 'leap: the reference moves enough' reference leap
check 'leap: springs of contacts across ranks' layout leap 2 1 brute brick auto
check 'leap: on 5 ranks' layout leap 5 1 multi brick shadow
check 'thin: two particles meet through two images' twice
check 'thin: ranks across the thin direction' layout thin 4 1 hgrid brick auto domain.x=2
check 'thin: four of them' layout thin 4 2 linkcell brick auto domain.x=4
check 'in the fast mode the layout shows in the last bits' differs
for setting in 'bed 100' 'flow 400' 'sheared 120' 'pressed 120'; do
    check "${setting% *}: the whole of it" whole $setting
    check "${setting% *}: 4 ranks go on with what 1 x 2 wrote" goes_on $setting 1 4
    check "${setting% *}: 1 rank goes on with what 3 x 2 wrote" goes_on $setting 3 1
done
check 'flow: particles come and leave in both halves' comes_and_goes

for case in bed ${SCREE_LONG:+ten boulder thin} flow; do
    check "$case: choices by the clock" \
        layout $case 2 2 auto $bisection auto index.measure=true domain.weights=time domain.threshold=1.001
done

if [ -n "${SCREE_LONG:-}" ]; then
    for case in bed ten boulder thin flow; do
        for index in $(indexes); do
            for place in 'brick shadow' 'brick auto' 'bisection shadow' 'bisection auto'; do
                for ranks in 1 2 4 8; do
                    for threads in 1 2; do
                        check "$case: ranks, threads, index, domain, sync: $ranks $threads $index $place" \
                            layout $case $ranks $threads $index $place
                    done
                done
            done
        done
    done
fi

finish
