#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Walls that touch walls: a plate on a floor at rest, tilted, elastic and on a slope, a cylinder that rolls, a sleeper across a rail, a drum on rollers;
# layouts and resumes with grains; messages.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

column() { # DIR NAME: its last value
    awk -F , -v name="$2" 'NR == 1 { for (k = 1; k <= NF; k++) { split($k, w, /[ (\[]/); if (w[1] == name) at = k } } END { print $at }' "$1/observables.csv"
}
rows() { # DIR: the last frame of the dump, by id
    tail -n "+$(grep -n '^ITEM: ATOMS' "$1/dump.lammpstrj" | tail -n 1 | cut -d : -f 1)" "$1/dump.lammpstrj" | grep -v '^ITEM' | sort -n
}
row() { tail -n 1 "$1/observables.csv"; }

# A plate of 4 falls on a floor. Four corners that overlap alike carry 4^(1/3) k x overlap
cat >plate.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [10, 4, 6]}
gravity: [0, 0, -10]
step: {count: 8000, dt: 2.5e-4}
contact: {law: hooke}
materials: [{name: a, density: 1}]
material_pairs: [{k_n: 2e4, restitution: 0.3, friction: 0.4}]
walls:
  - {name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}
  - {name: plate, shape: box, lower: [1, 1, 0.02], upper: [3, 2, 0.22], free: {mass: 4}}
wall_contacts: {rounding: 0.05, pairs: [{walls: [plate, floor]}]}
groups: [{name: held, motion: frozen}]
particles: {from: single, position: [9, 3, 5], radius: 0.1, group: held}
observables: {every: 8000, list: [{name: wall_offset, target: plate}, {name: wall_rotation, target: plate}, {name: wall_velocity, target: plate}, {name: wall_force, target: plate}, {name: wall_angular_velocity, target: plate}, {name: energy_walls}, {name: energy_balance}, {name: wall_contacts}]}
output: {checkpoint: {at_end: false}}
YAML
sunk=$(awk 'BEGIN { printf "%.9g", 40 / (2e4 * 4 ^ (1 / 3)) }')
rests() { # HEIGHT SETTING...: of the plate above the floor at the start
    rm -rf plate && run_scene 1 plate.yaml plate "${@:2}" || return 1
    echo "  sinks by $(column plate plate_z), carried by $(column plate plate_fz)"
    within "$(column plate plate_z)" "$(awk -v h="$1" -v s="$sunk" 'BEGIN { printf "%.9g", -h - s }')" 2e-6 && within "$(column plate plate_fz)" 40 1e-2 &&
        within "$(column plate plate_phix)" 0 1e-5 && within "$(column plate plate_phiy)" 0 1e-5 && within "$(column plate wall_contacts)" 1 0
}
check 'a plate on a floor' rests 0.02
tilted=(--set 'walls[plate].lower=[1, 1, 0.5]' --set 'walls[plate].upper=[3, 2, 0.7]' --set 'walls[plate].free.angular_velocity=[0.5, 0.3, 0.2]' --set step.count=24000 --set observables.every=24000)
check 'a plate that falls tilted, with spin' rests 0.5 "${tilted[@]}"
balance() { # BOUND DIR: of the energy in play, 20 here
    awk -F , -v bound="$1" 'NR == 1 { for (k = 1; k <= NF; k++) if ($k ~ /^energy_balance/) at = k } { v[NR] = $at }
        END { d = v[NR] - v[2]; printf "  energy changes by %g of 20\n", d; exit !(d * d < bound * bound) }' "$2/observables.csv"
}
fine() { run_scene 1 plate.yaml fine "${tilted[@]}" --set step.count=48000 --set step.dt=6.25e-5 && balance 0.12 fine; }
check 'the balance of energy: 0.5 % of what a fall with impacts took, at a fourth of the step' fine
elastic() {
    rm -rf elastic && run_scene 1 plate.yaml elastic "${tilted[@]}" --set step.count=40000 --set step.dt=5e-5 --set contact.tangential=none --set 'material_pairs=[{k_n: 2e4, restitution: 1}]' &&
        balance 0.01 elastic
}
check 'an elastic plate keeps its energy over impacts' elastic
slope() { # ANGLE: gravity as seen on a slope
    awk -v a="$1" 'BEGIN { a *= atan2(0, -1) / 180; printf "[%.12g, 0, %.12g]", 10 * sin(a), -10 * cos(a) }'
}
slides() {
    rm -rf slide && run_scene 1 plate.yaml slide --set gravity="$(slope 30)" --set 'walls[plate].lower=[1, 1, -0.0011]' --set 'walls[plate].upper=[3, 2, 0.1989]' --set step.count=4000 --set observables.every=2000 || return 1
    local v=$(column slide plate_vx) # after 1 s; springs of friction took a part of the first half
    sed -i '$d' slide/observables.csv
    within "$(awk -v v="$v" -v u="$(column slide plate_vx)" 'BEGIN { printf "%.9g", 2 * (v - u) }')" "$(awk 'BEGIN { a = atan2(0, -1) / 6; printf "%.9g", 10 * (sin(a) - 0.4 * cos(a)) }')" 2e-3
}
check 'a plate slides down a slope by g (sin - mu cos)' slides
sticks() {
    rm -rf stick && run_scene 1 plate.yaml stick --set gravity="$(slope 15)" --set 'walls[plate].lower=[1, 1, -0.00122]' --set 'walls[plate].upper=[3, 2, 0.19878]' && within "$(column stick plate_vx)" 0 1e-6 && within "$(column stick plate_x)" 0 2e-3
}
check 'a plate sticks on a gentler slope' sticks

# A solid cylinder rolls down by 2/3 g sin
rolls() {
    rm -rf roll && run_scene 1 plate.yaml roll --set gravity="$(slope 20)" --set 'walls[plate]={name: plate, shape: cylinder, point: [1, 2, 0.2985], axis: [0, 1, 0], radius: 0.3, length: 1, inside: false, free: {mass: 4}}' \
        --set wall_contacts='{pairs: [{walls: [floor, plate]}]}' --set step.count=4000 --set observables.every=4000 || return 1
    local v=$(column roll plate_vx)
    echo "  speed $v, rate $(column roll plate_wy)"
    within "$v" "$(awk 'BEGIN { printf "%.9g", 2 / 3 * 10 * sin(atan2(0, -1) / 9) }')" 1e-2 && within "$(column roll plate_wy)" "$(awk -v v="$v" 'BEGIN { printf "%.9g", v / 0.3 }')" 2e-2
}
check 'a cylinder rolls down a slope' rolls

# Its ends are flat rims: tilted, it bounces on them without loss
rims() {
    rm -rf rims && run_scene 1 plate.yaml rims --set 'walls[plate]={name: plate, shape: cylinder, point: [2, 2, 1.2], axis: [0.4, 1, 0.5], radius: 0.3, length: 1, inside: false, free: {mass: 4, angular_velocity: [1, 2, 0.5]}}' \
        --set wall_contacts='{pairs: [{walls: [floor, plate]}]}' --set step.count=40000 --set step.dt=5e-5 --set observables.every=40000 --set contact.tangential=none --set 'material_pairs=[{k_n: 2e4, restitution: 1}]' && balance 0.02 rims
}
check 'an elastic cylinder that falls tilted keeps its energy' rims

# A prism of six sides as a mesh: six corners below
awk 'BEGIN { pi = atan2(0, -1); for (k = 0; k < 6; k++) { a = pi * k / 3; b = pi * ((k + 1) % 6) / 3; x = cos(a); y = sin(a); u = cos(b); v = sin(b)
    printf "0 0 0 %.9g %.9g 0 %.9g %.9g 0\n0 0 1 %.9g %.9g 1 %.9g %.9g 1\n%.9g %.9g 0 %.9g %.9g 0 %.9g %.9g 1\n%.9g %.9g 0 %.9g %.9g 1 %.9g %.9g 1\n", u, v, x, y, x, y, u, v, x, y, u, v, u, v, x, y, u, v, x, y } }' >prism.txt
prism() {
    rm -rf prism && run_scene 1 plate.yaml prism --set 'walls[plate]={name: plate, shape: mesh, format: table, file: prism.txt, scale: 0.5, offset: [2, 2, 0.02], free: {mass: 4}}' || return 1
    within "$(column prism plate_z)" "$(awk 'BEGIN { printf "%.9g", -0.02 - 40 / (2e4 * 6 ^ (1 / 3)) }')" 2e-6
}
check 'a prism of six corners, a mesh, at rest' prism

# Two blocks in empty space, one at the side of the other across a periodic side: momentum, and the same as in the middle
cat >pair.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [6, 4, 4], periodic: [true, true, true]}
step: {count: 3000, dt: 2e-4}
contact: {law: hooke}
materials: [{name: a, density: 1}]
material_pairs: [{k_n: 2e4, restitution: 0.6, friction: 0.4}]
walls:
  - {name: one, shape: box, lower: [1, 1, 1], upper: [2, 2, 2], free: {mass: 2, velocity: [2, 0, 0], angular_velocity: [0.3, 0.2, 0.4]}}
  - {name: two, shape: box, lower: [2.2, 1.4, 1.3], upper: [3, 2.2, 2.5], free: {mass: 3}}
wall_contacts: {rounding: 0.05, pairs: [{walls: [one, two]}]}
groups: [{name: held, motion: frozen}]
particles: {from: single, position: [4.5, 3.5, 3.5], radius: 0.1, group: held}
observables: {every: 3000, list: [{name: wall_velocity}, {name: wall_angular_velocity}, {name: wall_offset}, {name: wall_rotation}]}
output: {checkpoint: {at_end: false}}
YAML
meets() {
    rm -rf middle side && run_scene 1 pair.yaml middle &&
        run_scene 2 pair.yaml side --set 'walls[one].lower=[4.4, 1, 1]' --set 'walls[one].upper=[5.4, 2, 2]' --set 'walls[two].lower=[-0.4, 1.4, 1.3]' --set 'walls[two].upper=[0.4, 2.2, 2.5]' && rows_close middle side 1e-8 || return 1
    echo "  velocities $(column middle one_vx) and $(column middle two_vx)"
    [ "$(column middle two_vx)" != 0 ] || return 1
    for d in x y z; do within "$(awk -v a="$(column middle one_v$d)" -v b="$(column middle two_v$d)" 'BEGIN { printf "%.15g", 2 * a + 3 * b }')" "$([ $d = x ] && echo 4 || echo 0)" 1e-11 || return 1; done
}
check 'two free blocks meet, across a periodic side, too: momentum' meets

# A sleeper lies across a rail on four pairs of edges
crosses() {
    rm -rf cross && run_scene 1 plate.yaml cross --set 'walls=[{name: rail, shape: box, lower: [1.9, 0.5, 0.5], upper: [2.1, 3.5, 0.7]}, {name: plate, shape: box, lower: [1, 1.9, 0.71], upper: [3, 2.1, 0.91], free: {mass: 4}}]' \
        --set wall_contacts.pairs='[{walls: [rail, plate]}]' || return 1
    within "$(column cross plate_z)" "$(awk -v s="$sunk" 'BEGIN { printf "%.9g", -0.01 - s }')" 2e-6 && within "$(column cross plate_fz)" 40 1e-2
}
check 'a sleeper across a rail' crosses

# A drum on a driven roller and a free one: no slip, and each carries half of the weight
cat >drum.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [4, 4, 4]}
gravity: [0, 0, -10]
step: {count: 12000, dt: 2.5e-4}
contact: {law: hooke}
materials: [{name: a, density: 1}]
material_pairs: [{k_n: 2e4, restitution: 0.3, friction: 0.4}]
walls:
  - {name: driven, shape: cylinder, point: [1.6, 2, 0.5], axis: [0, 1, 0], radius: 0.2, length: 2, inside: false, motion: [{kind: rotate, direction: [0, 1, 0], point: [1.6, 2, 0.5], rate: 5}]}
  - {name: idler, shape: cylinder, point: [2.4, 2, 0.5], axis: [0, 1, 0], radius: 0.2, length: 2, inside: false, free: {mass: 1, freedom: about, direction: [0, 1, 0], point: [2.4, 2, 0.5]}}
  - {name: drum, shape: cylinder, point: [2, 2, 1.0745], axis: [0, 1, 0], radius: 0.5, length: 1, inside: true, free: {mass: 3}}
wall_contacts: {pairs: [{walls: [drum, driven]}, {walls: [drum, idler]}]}
groups: [{name: held, motion: frozen}]
particles: {from: single, position: [3.5, 3.5, 3.5], radius: 0.1, group: held}
observables: {every: 12000, list: [{name: wall_angular_velocity, target: drum}, {name: wall_angular_velocity, target: idler}, {name: wall_force, target: driven}, {name: wall_force, target: idler}, {name: wall_torque, target: driven}, {name: wall_offset, target: drum}]}
output: {checkpoint: {at_end: false}}
YAML
drum() {
    rm -rf drum && run_scene 1 drum.yaml drum || return 1
    echo "  the drum turns by $(column drum drum_wy), the idler by $(column drum idler_wy)"
    within "$(column drum drum_wy)" -2 3e-3 && within "$(column drum idler_wy)" 5 5e-3 && within "$(column drum driven_fz)" -15 1e-2 && within "$(column drum idler_fz)" -15 1e-2 &&
        within "$(column drum driven_ty)" 0 1e-2 && within "$(column drum drum_y)" 0 1e-6
}
check 'a drum on rollers' drum

# A sleeper with a rail on it, and a drum, in falling grains: the same bits on any layout, and after a resume
cat >many.yaml <<'YAML'
units: none
seed: 5
box: {lower: [0, 0, 0], upper: [4, 3, 5], periodic: [true, true, false]}
gravity: [0, 0, -10]
step: {count: 1200, dt: 0.0002}
contact: {law: hooke}
materials: [{name: a, density: 20}]
material_pairs: [{k_n: 1e4, restitution: 0.5, friction: 0.5}]
walls:
  - {name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}
  - {name: sleeper, shape: box, lower: [3, 1, 0.05], upper: [4.6, 1.6, 0.35], free: {density: 30, velocity: [1, 0, -1]}}
  - {name: rail, shape: box, lower: [3.5, 0.4, 0.4], upper: [3.7, 2.4, 0.6], free: {density: 30}}
  - {name: drum, shape: cylinder, point: [1.2, 1.5, 0.42], axis: [0.2, 1, 0], radius: 0.4, length: 1, inside: false, free: {density: 10, velocity: [-3, 0, 0]}}
wall_contacts: {rounding: 0.05, pairs: [{walls: [sleeper, floor]}, {walls: [sleeper, rail]}, {walls: [drum, floor]}, {walls: [drum, sleeper]}, {walls: [drum, rail]}, {walls: [rail, floor]}]}
particles: {sources: [{from: random, count: 100, sizes: {law: uniform, min: 0.1, max: 0.18}, velocity_sigma: 1, region: {shape: box, lower: [0, 0, 0.85], upper: [4, 3, 2.5]}}]}
skin: 0.05
reproducible: true
observables: {every: 600, list: [{name: wall_offset}, {name: wall_velocity}, {name: wall_rotation}, {name: wall_angular_velocity}, {name: wall_force}, {name: wall_torque}, {name: energy_walls}, {name: wall_contacts}]}
output: {dump: {every: 600, fields: [id, position, velocity, angular_velocity]}, checkpoint: {every: 600}}
YAML
layouts() {
    many_one || return 1
    echo "  $(column one wall_contacts) pairs touch; the drum turned by $(column one drum_phiy), the sleeper moved by $(column one sleeper_x)"
    [ "$(column one wall_contacts)" -ge 1 ] && [ "$(column one drum_phiy)" != 0 ] && many_layouts
}
check 'the same bits on any layout' layouts
check 'a resume gives the same bits' many_resumes 1
check 'a resume on 2 ranks gives the same bits' many_resumes 2

# A stage lets a free plate fall on a floor through which it goes before
caught() {
    sed 's/^step: .*/step: {dt: 2.5e-4}/; /^wall_contacts/d; s/every: 8000/every: 400/' plate.yaml >caught.yaml
    echo 'stages: [{name: goes, duration: 0.1}, {name: caught, duration: 1.9, set: {"walls[floor].point": [0, 0, -0.5], wall_contacts: {rounding: 0.05, pairs: [{walls: [plate, floor]}]}}}, {name: rests, duration: 0.1, set: {wall_contacts.pairs: [{walls: [floor, plate]}]}}]' >>caught.yaml
    rm -rf caught && run_scene 1 caught.yaml caught && within "$(column caught plate_z)" "$(awk -v s="$sunk" 'BEGIN { printf "%.9g", -0.52 - s }')" 2e-6
}
check 'a stage lets walls touch' caught

pairs() { echo "wall_contacts={rounding: 0.05, pairs: [$1]}"; }
more() { echo "walls=[{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}, {name: plate, shape: box, lower: [1, 1, 0.02], upper: [3, 2, 0.22], free: {mass: 4}}, $1]"; }
check 'one wall alone' scene_refused 'wall_contacts.pairs[0].walls|names of two walls' plate.yaml --set "$(pairs '{walls: [plate]}')"
check 'a pair twice' scene_refused 'wall_contacts.pairs[1].walls|pairs[0] again' plate.yaml --set "$(pairs '{walls: [plate, floor]}, {walls: [floor, plate]}')"
check 'no rounding' scene_refused "wall_contacts.rounding|is missing|wall 'plate'" plate.yaml --set wall_contacts='{pairs: [{walls: [plate, floor]}]}'
check 'a rounding that leaves nothing' scene_refused 'leaves no core|smaller wall_contacts.rounding' plate.yaml --set wall_contacts.rounding=0.1
check 'two planes' scene_refused "is a plane, and so is the other" plate.yaml --set "$(more '{name: side, shape: plane, point: [0, 0, 0], normal: [1, 0, 0]}')" --set "$(pairs '{walls: [side, floor]}')"
check 'an open surface' scene_refused "wall 'sheet' has an open surface|allowed: planes, boxes" plate.yaml --set "$(more '{name: sheet, shape: rectangle, point: [0, 0, 1], along: [1, 0, 0], across: [0, 1, 0]}')" --set "$(pairs '{walls: [plate, sheet]}')"
awk 'BEGIN { n = 6; pi = atan2(0, -1); for (k = 0; k < n; k++) { a = 2 * pi * k / n; b = 2 * pi * ((k + 1) % n) / n; r = k % 2 ? 0.4 : 1; s = k % 2 ? 1 : 0.4
    printf "0 0 0 %.9g %.9g 0 %.9g %.9g 0\n0 0 1 %.9g %.9g 1 %.9g %.9g 1\n", s * cos(b), s * sin(b), r * cos(a), r * sin(a), r * cos(a), r * sin(a), s * cos(b), s * sin(b)
    printf "%.9g %.9g 0 %.9g %.9g 0 %.9g %.9g 1\n%.9g %.9g 0 %.9g %.9g 1 %.9g %.9g 1\n", r * cos(a), r * sin(a), s * cos(b), s * sin(b), s * cos(b), s * sin(b), r * cos(a), r * sin(a), s * cos(b), s * sin(b), r * cos(a), r * sin(a) } }' >star.txt
check 'a star' scene_refused "wall 'star' is not convex: it fills" plate.yaml --set "$(more '{name: star, shape: mesh, format: table, file: star.txt, offset: [5, 2, 1]}')" --set "$(pairs '{walls: [plate, star]}')"
check 'a wall that is none' scene_refused 'wall_contacts.pairs[0].walls|lid' plate.yaml --set "$(pairs '{walls: [plate, lid]}')"
check 'cohesion' scene_refused 'wall_contacts|is for spheres' plate.yaml --set contact.cohesion=sjkr --set 'material_pairs=[{k_n: 2e4, restitution: 0.3, friction: 0.4, cohesion_density: 1}]'
told() { "$scree" check many.yaml >told && grep -q "walls 'drum' and 'sleeper' touch, with the radius 0.0444" told; }
check 'check tells the pairs' told
finish
