#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Bodies in boxes that move: sheared, strained, under a stress. Free flight across sheared sides, a body of one sphere beside the sphere, the
# stress of packings against the forces on walls and against its target; ranks, indexes and a resume.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

rows() { # DIR: the last frame of the dump, by id
    tail -n "+$(grep -n '^ITEM: ATOMS' "$1/dump.lammpstrj" | tail -n 1 | cut -d : -f 1)" "$1/dump.lammpstrj" | grep -v '^ITEM' | sort -n
}

cat >flow.yaml <<'YAML'
units: none
seed: 5
threads: 1
reproducible: true
box: {lower: [0, 0, 0], upper: [6, 6, 6], periodic: true, shear: {rate: 2, flow: x, gradient: y}, strain: {rate: [0, 0, -0.3]}}
step: {count: 600, dt: 0.0003}
contact: {law: hooke}
materials: [{name: a, density: 1}, {name: b, density: 2}]
material_pairs: [{k_n: 10000, restitution: 0.7, friction: 0.3}]
particles:
  sources:
    - {from: random, count: 20, sizes: {law: fixed, radius: 0.35}, velocity_sigma: 1, material: b}
    - {from: random, count: 70, sizes: {law: uniform, min: 0.4, max: 0.6}, velocity_sigma: 3, material: a}
bodies:
  clumps:
    - {name: triple, material: a, radius_above: 0.45, spheres: [{centre: [-1, 0, 0], radius: 1}, {centre: [1, 0, 0], radius: 1}, {centre: [0, 1, 0], radius: 0.7}]}
    - {name: dumbbell, material: a, spheres: [{centre: [-1, 0, 0], radius: 1}, {centre: [1, 0, 0], radius: 1}]}
observables: {every: 100, list: [{name: energy}, {name: momentum}, {name: stress}]}
output: {dump: {every: 300, fields: [id, position, velocity, angular_velocity]}, checkpoint: {every: 300}}
YAML
rock='bodies={shapes: [{name: rock, material: a, random: {corners: 14, variants: 5}, roundness: 0.2}]}'
squeezed='box={lower: [0, 0, 0], upper: [6, 6, 6], periodic: true, stress: {xx: 20, yy: 20, zz: 20, inertia: 0.1}}'

# everywhere WHAT SETTING...: the same bits on other layouts, and after a resume
everywhere() {
    rm -rf one other more
    run_scene 1 flow.yaml one --set index.name=hgrid "${@:2}" && rows one >one.rows && run_scene 2 flow.yaml other --set index.name=brute "${@:2}" && rows other | cmp - one.rows &&
        run_scene 4 flow.yaml other --overwrite --set index.name=linkcell "${@:2}" && rows other | cmp - one.rows &&
        run_scene 3 flow.yaml more --resume one/checkpoint-300.h5 "${@:2}" && rows more | cmp - one.rows
}
check 'clumps in a sheared and strained box: the same bits everywhere' everywhere clumps
check 'rocks' everywhere rocks --set "$rock"
check 'clumps under a stress' everywhere stress --set "$squeezed"
check 'rocks under a stress' everywhere stress --set "$squeezed" --set "$rock"

# A body of one sphere moves as the sphere
ball='bodies={clumps: [{name: ball, material: a, spheres: [{centre: [0, 0, 0], radius: 1}]}]}'
as_spheres() { # SETTING...
    run_scene 1 flow.yaml spheres --overwrite --set 'bodies=~' --set 'output={checkpoint: {at_end: false}}' "$@" && run_scene 1 flow.yaml balls --overwrite --set "$ball" --set 'output={checkpoint: {at_end: false}}' "$@" &&
        paste -d, spheres/observables.csv balls/observables.csv | awk -F, 'NR == 1 { for (k = 1; k <= NF / 2; k++) if ($k ~ /^energy_dissipated/) at = k }
            NR > 1 { n = NF / 2; for (k = 2; k <= n; k++) { d = $k - $(n + k); d = d < 0 ? -d : d; if (d > most) most = d } met = $at } END { printf "  largest difference %.2g, dissipated %g\n", most, met; exit !(NR > 6 && most < 1e-8 && met > 1) }'
}
check 'a body of one sphere moves as the sphere in shear and strain' as_spheres
check 'and under a stress' as_spheres --set "$squeezed"

# A dumbbell that crosses the sheared sides turns as if there were none, and its centre goes straight: as seen from the image in which it began
flight() { # RANKS
    run_scene "$1" flow.yaml flight --overwrite --set 'box.strain=~' --set step.dt=0.001 --set step.count=4000 --set skin=0.1 --set 'particles={from: single, position: [1, 4.1, 2], radius: 0.8, velocity: [0.5, 7, 0.3], material: a, omega: [3, 1, 2]}' \
        --set bodies.clumps='[{name: dumbbell, material: a, orientation: given, quaternion: [1, 0, 0, 0], spheres: [{centre: [-1, 0, 0], radius: 1}, {centre: [1, 0, 0], radius: 1}]}]' \
        --set 'observables={every: 400, list: [{name: energy_rotational}, {name: energy_fluctuation}, {name: position, id: 1}, {name: velocity, id: 1}]}' --set 'output={checkpoint: {at_end: false}}' &&
        awk -F, 'function off(a, b) { a -= b; a = a < 0 ? -a : a; if (a > most) most = a }
            NR == 2 { rotation = $2; v = $7; start = $5 } NR > 1 { turns = int(($1 * $8 + 4.1) / 6); off($2, rotation); off($8, 7); off($7, v - 12 * turns) }
            END { printf "  %d turns, largest difference %.2g\n", turns, most; exit !(turns == 5 && rotation > 0.4 && most < 1e-9) }' flight/observables.csv
}
check 'a dumbbell flies across sheared sides' flight 1
check 'on 2 ranks' flight 2

# A packing at rest between smooth walls: the stress is that of the forces on the walls, whatever holds the bodies together
cat >press.yaml <<'YAML'
units: none
seed: 5
threads: 1
box: {lower: [0, 0, 0], upper: [4, 4, 5]}
step: {count: 12000, dt: 0.00025}
contact: {law: hooke}
materials: [{name: a, density: 1}, {name: smooth, density: 1}]
material_pairs: [{between: [a, a], k_n: 4000, restitution: 0.4, friction: 0.3}, {between: [a, smooth], k_n: 4000, restitution: 0.4, friction: 0}]
walls:
  - {name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1], material: smooth}
  - {name: west, shape: plane, point: [0, 0, 0], normal: [1, 0, 0], material: smooth}
  - {name: east, shape: plane, point: [4, 0, 0], normal: [-1, 0, 0], material: smooth}
  - {name: south, shape: plane, point: [0, 0, 0], normal: [0, 1, 0], material: smooth}
  - {name: north, shape: plane, point: [0, 4, 0], normal: [0, -1, 0], material: smooth}
  - {name: lid, shape: plane, point: [0, 0, 5], normal: [0, 0, -1], material: smooth, motion: [{kind: servo, direction: [0, 0, 1], force: 400, speed_max: 6}]}
particles: {from: random, count: 38, material: a, sizes: {law: uniform, min: 0.45, max: 0.55}}
bodies: {clumps: [{name: dumbbell, material: a, spheres: [{centre: [-1, 0, 0], radius: 1}, {centre: [1, 0, 0], radius: 1}]}]}
observables: {every: 2000, list: [{name: stress}, {name: wall_force, target: lid}, {name: wall_offset, target: lid}, {name: wall_force, target: east}]}
output: {checkpoint: {at_end: false}}
YAML
walls() { # RANKS
    run_scene "$1" press.yaml press --overwrite && tail -n 1 press/observables.csv | awk -F, '{ zz = $4 * 80 / ($10 * (5 + $13)) - 1; xx = $2 * 80 / ($14 * 4) - 1; print "  off by " xx " and " zz "; east " $14
        exit !(xx < 0.015 && xx > -0.015 && zz < 0.015 && zz > -0.015 && $14 > 5) }'
}
check 'the stress of a packing is that of its walls' walls 1
check 'on 2 ranks' walls 2
compressed() { # SETTING...
    run_scene 1 flow.yaml target --overwrite --set reproducible=false --set "$squeezed" --set step.count=6000 --set observables.every=1000 --set 'output={checkpoint: {at_end: false}}' --set box.upper=[4.4,4.4,4.4] --set particles.sources[0].from=packed --set particles.sources[1].from=packed --set particles.sources[0].velocity_sigma=0 --set particles.sources[1].velocity_sigma=0 "$@" &&
        awk -F, 'NR == 1 { for (k = 1; k <= NF; k++) { sub(/\[.*/, "", $k); at[$k] = k } next } { for (k = 0; k < 3; k++) s[k] = $(at["stress_xx"] + k) }
            END { print "  stress " s[0] " " s[1] " " s[2]; for (k = 0; k < 3; k++) bad += s[k] < 19 || s[k] > 21; exit bad }' target/observables.csv
}
check 'a box of clumps comes to its stress' compressed
check 'one of rocks' compressed --set "$rock"
finish
