#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Rocks and walls that are no planes: energy among boxes, cylinders, rectangles and cones; a box beside six planes; rest on surfaces; corners that
# cross a surface; a lid with a force; a drum that turns, on ranks and after a resume.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

cat >room.yaml <<'YAML'
units: none
seed: 7
box: {lower: [-6, -6, -6], upper: [6, 6, 6]}
step: {dt: 2e-4, count: 3000}
contact: {law: hooke, tangential: none}
materials: [{name: rock, density: 1}]
material_pairs: [{k_n: 3e4, restitution: 1}]
walls:
  - {name: room, shape: box, lower: [-5, -5, -5], upper: [5, 5, 5]}
  - {name: post, shape: cylinder, point: [-3, -3, 0], axis: [0, 0, 1], radius: 0.7, inside: false}
  - {name: peg, shape: cylinder, point: [3, 3, 0], axis: [0, 1, 0.3], radius: 0.9, length: 3, inside: false}
  - {name: shelf, shape: rectangle, point: [-1, 1, -2], along: [2.5, 0, 0.5], across: [0, 3, 0]}
  - {name: peak, shape: cone, point: [2, -3, -3], axis: [0, 0, 1], radius: 1.5, radius_end: 0.4, length: 2}
particles: {from: random, count: 30, sizes: {law: uniform, min: 0.5, max: 0.7}, velocity_sigma: 4}
bodies:
  shapes: [{name: rock, random: {corners: 12, variants: 4}, roundness: 0.25}]
observables: {every: 3000, list: [{name: energy_kinetic}, {name: energy_rotational}, {name: energy_elastic_normal}, {name: wall_force, target: post}, {name: wall_force, target: peak}]}
output: {checkpoint: {at_end: false}}
YAML
keeps() { # NAME BOUND RANKS SETTING...: the change of the energy
    run_scene "$3" room.yaml "$1" "${@:4}" && awk -F, -v bound="$2" 'NR == 2 { e = $2 + $3 + $4 } NR == 3 { e = ($2 + $3 + $4) / e - 1
        printf "  energy %.2g, of rotation %g\n", e, $3; exit !(e * e < bound * bound && $3 > 10) }' "$1/observables.csv"
}
check 'energy in a room with a post, a peg, a shelf and a peak' keeps room 2e-3 1
check 'on 3 ranks, too' keeps room3 2e-3 3

# One rock in six planes, or in a box: the same impacts of corners
cat >one.yaml <<'YAML'
units: none
box: {lower: [-3, -3, -3], upper: [3, 3, 3]}
step: {dt: 1e-4, count: 16000}
contact: {law: hooke}
materials: [{name: rock, density: 1}]
material_pairs: [{k_n: 1e5, restitution: 0.9, friction: 0.3}]
walls:
  - {name: a, shape: plane, point: [-2, 0, 0], normal: [1, 0, 0]}
  - {name: b, shape: plane, point: [2, 0, 0], normal: [-1, 0, 0]}
  - {name: c, shape: plane, point: [0, -2, 0], normal: [0, 1, 0]}
  - {name: d, shape: plane, point: [0, 2, 0], normal: [0, -1, 0]}
  - {name: e, shape: plane, point: [0, 0, -2], normal: [0, 0, 1]}
  - {name: f, shape: plane, point: [0, 0, 2], normal: [0, 0, -1]}
particles: {from: single, position: [0, 0, 0], radius: 1, velocity: [3, 2, 4]}
bodies:
  shapes: [{name: cube, vertices: [0,0,0, 1,0,0, 0,1,0, 1,1,0, 0,0,1, 1,0,1, 0,1,1, 1,1,1], rounding: 0.1, angular_velocity: [1, 2, 3]}]
observables: {every: 16000, list: [{name: position, id: 1}, {name: velocity, id: 1}, {name: angular_velocity, id: 1}, {name: energy_dissipated}]}
output: {checkpoint: {at_end: false}}
YAML
alike() { # SETTING...: the last row beside that of the planes
    rm -rf other && run_scene 1 one.yaml other "$@" && paste -d, <(tail -n 1 planes/observables.csv) <(tail -n 1 other/observables.csv) | awk -F, '{ n = NF / 2
        for (k = 1; k <= n; k++) { d = $k - $(k + n); d = d < 0 ? -d : d; if (d > most) most = d }
        printf "  taken %g, largest difference %.2g\n", $n, most; exit !(most < 1e-6 && $n > 1) }'
}
check 'one rock in six planes' run_scene 1 one.yaml planes
check 'the same in a box of triangles' alike --set walls='[{name: room, shape: box, lower: [-2, -2, -2], upper: [2, 2, 2]}]'
check 'the same in a box that a motion carries' alike --set walls='[{name: room, shape: box, lower: [-2, -2, -3], upper: [2, 2, 1], motion: [{kind: translate, velocity: [0, 0, 1e6], stop: 1e-6}]}]'

# A cube at rest: on four corners, each with a spring of its own; on a tube, in a tube
cat >rest.yaml <<'YAML'
units: none
box: {lower: [-5, -5, -5], upper: [5, 5, 5]}
gravity: [0, 0, -10]
step: {dt: 1e-4, count: 30000}
contact: {law: hooke}
materials: [{name: rock, density: 1}]
material_pairs: [{k_n: 1e5, restitution: 0.3, friction: 0.5}]
walls: [{name: floor, shape: rectangle, point: [-3, -3, 0], along: [6, 0, 0], across: [0, 6, 0]}]
particles: {from: single, position: [0.1, 0.2, 0.51], radius: 1}
bodies:
  shapes: [{name: cube, vertices: [0,0,0, 1,0,0, 0,1,0, 1,1,0, 0,0,1, 1,0,1, 0,1,1, 1,1,1], rounding: 0.05, size: drawn, orientation: given, quaternion: [1, 0, 0, 0]}]
observables: {every: 30000, list: [{name: position, id: 1, components: z}, {name: energy_kinetic}, {name: energy_rotational}, {name: wall_force, target: floor}]}
output: {checkpoint: {at_end: false}}
YAML
rests() { # HEIGHT SETTING...
    rm -rf rest && run_scene 1 rest.yaml rest "${@:2}" && tail -n 1 rest/observables.csv | awk -F, -v z="$1" '{ print "  z " $2 " (" z "), energies " $3 " " $4 ", force " $7
        exit !(($2 - z) ^ 2 < 1e-12 && $3 < 1e-12 && $4 < 1e-12 && ($7 + 10) ^ 2 < 1e-8) }'
}
check 'a cube rests on a rectangle' rests "$(awk 'BEGIN { print 0.5 - 1e-4 / 4 }')"
check 'and on a shelf that is narrower than it' rests "$(awk 'BEGIN { printf "%.9f", 0.5 - 1e-4 / 4 }')" --set 'walls[0]={name: floor, shape: rectangle, point: [-0.2, -3, 0], along: [0.6, 0, 0], across: [0, 6, 0]}'
# in a tube along y the lower edges of the core, at -0.45 and 0.45, touch it: 0.45^2 + h^2 = (2 - 0.05)^2
tube() { awk 'BEGIN { w = 0.45; R = 1.95; h = sqrt(R * R - w * w); c = h / R; k = 1e5 * 4 ^ (1 / 3); d = 10 / (k * c * c) * 1; printf "%.9f", 0.45 - h - 10 / (k * c * c) }'; }
lies() { rm -rf rest && run_scene 1 rest.yaml rest "$@" && tail -n 1 rest/observables.csv | awk -F, -v z="$(tube)" '{ print "  z " $2 " (" z "), energies " $3 " " $4 ", force " $7
        exit !(($2 - z) ^ 2 < 1e-9 && $3 < 1e-9 && $4 < 1e-9 && ($7 + 10) ^ 2 < 1e-6) }'; }
check 'a cube lies in a tube' lies --set 'walls[0]={name: floor, shape: cylinder, point: [0, 0, 0], axis: [0, 1, 0], radius: 2}' --set particles.position='[0, 0.2, -1.44]'

# Soft corners that go deeper than the rounding come back on the side from where they came
deep() { run_scene 1 rest.yaml deep --set 'material_pairs=[{k_n: 2000, restitution: 1}]' --set contact.tangential=none --set gravity='[0, 0, 0]' --set particles.velocity='[0, 0, -9]' \
    --set step='{dt: 2e-5, count: 10000}' --set observables.every=10000 --set guards.overlap=off \
    --set 'observables.list=[{name: position, id: 1, components: z}, {name: velocity, id: 1, components: z}]' && tail -n 1 deep/observables.csv | awk -F, '{ print "  z " $2 ", speed " $3; exit !($2 > 0.5 && ($3 - 9) ^ 2 < 1e-4) }'; }
check 'corners come back from behind a surface' deep

# A lid that presses on a cube finds how stiff its contacts are, as with spheres, and comes to its target
presses() { # SHAPE [RANKS]
    local lid="{name: lid, $1, motion: [{kind: servo, direction: [0, 0, 1], force: 50, speed_max: 2}]}"
    rm -rf pressed && run_scene "${2:-1}" rest.yaml pressed --set walls="[{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}, $lid]" --set step.count=10000 --set observables.every=10000 \
        --set 'observables.list=[{name: wall_force, target: lid, components: z}, {name: wall_velocity, target: lid, components: z}]' &&
        tail -n 1 pressed/observables.csv | awk -F, '{ print "  force " $2 ", speed " $3; exit !(($2 - 50) ^ 2 < 1e-8 && $3 ^ 2 < 1e-12) }'
}
check 'a plane presses on a cube with its force' presses 'shape: plane, point: [0, 0, 1.1], normal: [0, 0, -1]'
check 'a rectangle, too, on 2 ranks' presses 'shape: rectangle, point: [-3, -3, 1.1], along: [6, 0, 0], across: [0, 6, 0]' 2

# A drum that turns
cat >drum.yaml <<'YAML'
units: none
box: {lower: [-3, 0, -3], upper: [3, 3, 3], periodic: [false, true, false]}
gravity: [0, 0, -10]
step: {dt: 1e-4, count: 4000}
contact: {law: hooke}
materials: [{name: rock, density: 1}]
material_pairs: [{k_n: 3e4, restitution: 0.5, friction: 0.5}]
walls:
  - {name: drum, shape: cylinder, point: [0, 0, 0], axis: [0, 1, 0], radius: 2.6, motion: [{kind: rotate, direction: [0, 1, 0], point: [0, 0, 0], rate: 2}]}
  - {name: lifter, shape: rectangle, point: [-2.6, 0, 0], along: [0.8, 0, 0], across: [0, 3, 0], motion: [{kind: rotate, direction: [0, 1, 0], point: [0, 0, 0], rate: 2}]}
particles: {from: random, count: 25, sizes: {law: uniform, min: 0.3, max: 0.5}, velocity_sigma: 2}
bodies:
  shapes: [{name: cube, vertices: [0,0,0, 1,0,0, 0,1,0, 1,1,0, 0,0,1, 1,0,1, 0,1,1, 1,1,1], rounding: 0.08}]
observables: {every: 500, list: [{name: energy_dissipated}, {name: wall_torque, target: drum}]}
output: {trajectory: {every: 4000}, dump: {every: 4000, fields: [id, position, velocity, angular_velocity, rock_shape, rock_orientation]}, checkpoint: {every: 3000}}
reproducible: true
YAML
rows() { tail -n "+$(grep -n '^ITEM: ATOMS' "$1/dump.lammpstrj" | tail -n 1 | cut -d : -f 1)" "$1/dump.lammpstrj" | grep -v '^ITEM' | sort -n; }
turns() { run_scene 1 drum.yaml drum --set threads=1 && rows drum >drum.rows && awk -F, 'NR > 1 && $4 != 0 { n++ } END { print "  taken " $2 ", rows with a torque " n; exit !($2 > 1 && n > 2) }' drum/observables.csv; }
check 'cubes in a drum with a lifter' turns
same() { rm -rf other && run_scene "$1" drum.yaml other "${@:2}" && rows other | cmp - drum.rows; }
check 'the same bits on 3 ranks, hgrid' same 3 --set index.name=hgrid
check 'the same bits after a resume on 2 ranks' same 2 --resume drum/checkpoint-3000.h5

# Pictures: the faces of each cube, and no ball; of clumps the members alone
facets() { "$scree" picture drum -o drum.pov && [ "$(grep -c '^object{R0 matrix' drum.pov)" = 25 ] && ! grep -q '^sphere.*texture' drum.pov && [ "$(grep -c '^triangle' drum.pov)" -ge 12 ]; }
check 'a picture has the facets' facets
turned() { grep -q 'quatw quati quatj quatk rock_shape' drum/dump.lammpstrj && awk 'NF == 16 && $16 == 0 { d = $12 ^ 2 + $13 ^ 2 + $14 ^ 2 + $15 ^ 2 - 1; n++; if (d * d > 1e-24) bad = 1 } END { exit bad || n < 25 }' drum/dump.lammpstrj; }
check 'a dump has shapes and orientations' turned
members() { run_scene 1 drum.yaml clumps --set step.count=1 --set output='{trajectory: {every: 1}}' --set bodies='{clumps: [{spheres: [{centre: [0, 0, 0], radius: 1}, {centre: [1, 0, 0], radius: 1}]}]}' &&
    "$scree" picture clumps -o clumps.pov && [ "$(grep -c '^sphere.*texture' clumps.pov)" = 50 ]; }
check 'a picture of clumps has their members' members
finish
