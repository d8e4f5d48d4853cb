#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# A sphere in a turning drum, through the whole program: the sphere slides, then rolls up and down on the rising side of the drum. The
# path and the spin of the sphere are compared with an independent integration of a rigid sphere.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

cat >drum.yaml <<'YAML'
units: none
box: {lower: [-4, -1, -4], upper: [4, 1, 4]}
gravity: [0, 0, -8]
step: {dt: 0.0001, count: 40000}
contact: {law: hooke}
materials: [{name: soft, density: 1}]
material_pairs: [{restitution: 0.3, friction: 0.7, k_n: 30000}]
walls:
  - {name: drum, shape: cylinder, point: [0, 0, 0], axis: [0, 1, 0], radius: 3, motion: [{kind: rotate, direction: [0, 1, 0], rate: 2}]}
particles: {from: single, position: [0, 0, -2.001], radius: 1}
observables: {every: 10000, list: [{name: position, id: 1}, {name: angular_velocity, id: 1, components: y}]}
YAML

# A rigid sphere of radius r in the drum of radius R. Its centre stands at the angle a from below on a circle of radius
# R - r, towards -x as the drum's lowest line goes, and has the angular velocity v about the axis; w is its spin, N and F are
# the normal and the tangential force of the wall over its mass. It slides until its surface is as fast as the drum's.
rigid() { # x z w after 0, 1, 2, 3 and 4
    awk 'BEGIN {
        g = 8; R = 3; r = 1; c = R - r; rate = 2; mu = 0.7; dt = 2e-5
        for (n = 0; n <= 200000; n++) {
            if (n % 50000 == 0) print -c * sin(a), -c * cos(a), w
            N = g * cos(a) + c * v * v
            rolls = rolls || rate * R <= w * r + c * v
            F = rolls ? 2 / 7 * g * sin(a) : mu * N
            if (F > mu * N) { print "it slides a second time"; exit }
            v += dt * (F - g * sin(a)) / c; w += dt * 2.5 * F / r; a += dt * v } }'
}

columns() { # FILE: x z w of each row
    awk -F, 'NR == 1 { for (k = 1; k <= NF; k++) { sub(/\[.*/, "", $k); at[$k] = k } next }
        { print $at["particle1_x"], $at["particle1_z"], $at["particle1_wy"] }' "$1"
}

follows() { # RANKS: within what the contact gives way
    run_scene "$1" drum.yaml drum$1 || return 1
    paste <(columns drum$1/observables.csv) <(rigid) | awk '
        { for (k = 1; k <= 3; k++) if ($k - $(k + 3) > 0.05 || $(k + 3) - $k > 0.05) { bad = 1; print "  row " NR ": " $0 } }
        END { exit bad || NR != 5 || NF != 6 }'
}
check 'a sphere in a turning drum slides, then rolls, as a rigid one' follows 1
check 'so on two ranks' follows 2
turns() { # the drum takes it along by its surface: at the speed of 2 at the centre of the sphere it would be 2.9
    within "$(columns drum1/observables.csv | awk 'END { print $3 }')" 4.3 0.05
}
check 'it turns at 4.3 in the end' turns

finish
