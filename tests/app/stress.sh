#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The stress of regions through the whole program: a region that is the whole box has the stress of the box, on any number
# of ranks and in two dimensions; a stack at rest carries its weight.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

# same DIR: stress and stress_all agree in all rows to 1e-5 of the largest, which is not 0: a contact list evaluates contacts
# again, with its normal at the moment shown where the step takes one of half a step before
same() {
    awk -F, 'NR == 1 { for (k = 1; k <= NF; k++) { if ($k ~ /^stress_all_/) all = all ? all : k; else if ($k ~ /^stress_/) box = box ? box : k } next }
        { for (k = 0; k < 6; k++) { d = $(box + k) - $(all + k); d = d < 0 ? -d : d; if (d > most) most = d
            s = $(box + k) < 0 ? -$(box + k) : $(box + k); if (s > size) size = s } }
        END { printf "  %d rows, difference %.2g of %.3g\n", NR - 1, most, size; exit !(NR > 5 && size > 0 && most <= 1e-5 * size) }' \
        "$1/observables.csv"
}

cat >bed.yaml <<'EOF'
gravity: [0, 0, -9.81]
duration: 20 ms
box: {lower: [-1 cm, 1 cm, 0], upper: [0, 2 cm, 2 cm], periodic: [true, true, false]}
materials: [{name: glass, density: 2500, young: 1 MPa, poisson: 0.2}]
material_pairs: [{restitution: 0.5, friction: 0.5}]
walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}]
particles:
  from: random
  region: {shape: box, lower: [-1 cm, 1 cm, 0], upper: [0, 2 cm, 1 cm]}
  sizes: {law: uniform, min: 0.6 mm, max: 1.2 mm}
  volume_fraction: 0.35
  velocity: [5 cm/s, 0, -20 cm/s]
observables:
  every: {time: 2 ms}
  regions: [{name: all, shape: box}]
  list: [{name: stress}, {name: stress, target: all}]
output: {checkpoint: {at_end: false}}
EOF
bed() { run_scene "$1" bed.yaml bed$1 && same bed$1; }
check 'the whole box is a region like others' bed 1
check 'on two ranks' bed 2

sed -e 's/^gravity.*/gravity: [0, -9.81]/' -e 's/^box:.*/box: {dimension: 2, lower: [0, 0], upper: [2 cm, 2 cm], periodic: [true, false]}/' \
    -e 's/ point: .*/ point: [0, 0, 0], normal: [0, 1, 0]}]/' -e 's/region: .*/region: {shape: box, lower: [0, 0], upper: [2 cm, 2 cm]}/' \
    -e 's/velocity: .*/velocity: [5 cm\/s, -20 cm\/s]/' bed.yaml >flat.yaml
flat() {
    run_scene 2 flat.yaml flat && same flat && holds flat/observables.csv 'stress_xx[N/m]' &&
        holds flat/observables.csv 'stress_all_xy[N/m]'
}
check 'in two dimensions, as a force over a length' flat

# Two spheres of radius 1 and mass 1 at rest on a floor: contacts l = 2 and 1 with the forces g and 2 g
cat >stack.yaml <<'EOF'
units: none
gravity: [0, 0, -1]
step: {dt: 0.002, count: 20000}
box: {lower: [-2, -2, 0], upper: [2, 2, 8]}
contact: {law: hooke, tangential: none}
materials: [{name: stone, density: 0.238732414637843}]
material_pairs: [{k_n: 10000, restitution: 0.2}]
walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}]
particles: {sources: [{from: single, position: [0, 0, 1], radius: 1}, {from: single, position: [0, 0, 3], radius: 1}]}
observables:
  every: 20000
  regions: [{name: low, shape: box, upper: [.inf, .inf, 2]}, {name: high, shape: cylinder, centre: [0, 0, 3], axis: [0, 0, 1], radius: 1, length: 2}]
  list: [{name: stress, target: low}, {name: stress, target: high}]
output: {checkpoint: {at_end: false}}
EOF
# zz REGION: the last value
zz() {
    awk -F, -v name="stress_$1_zz[1]" 'NR == 1 { for (k = 1; k <= NF; k++) if ($k == name) at = k } END { print at ? $at : "none" }' stack/observables.csv
}
stack() {
    run_scene 1 stack.yaml stack && within "$(zz low)" "$(awk 'BEGIN { print (2 / 2 + 1 * 2) / 32 }')" 1e-4 &&
        within "$(zz high)" "$(awk 'BEGIN { print 2 / 2 / (2 * 3.141592653589793) }')" 1e-4
}
check 'a stack at rest carries its weight' stack

finish
