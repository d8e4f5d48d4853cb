#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Walls that stand while their surfaces move: a grain, and a body, on a belt against closed forms of motion, work and heat; the same as a wall
# that moves within itself; meshes, stages, layouts, resume, messages.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

# A grain set on a belt of the speed V = 2 slides for 2 V / (7 mu g), then rolls with 2/7 V. The belt has done the work 2/7 m V^2, half of which is heat
cat >belt.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [8, 2, 2]}
gravity: [0, 0, -10]
step: {count: 4000, dt: 0.0001}
contact: {law: hooke}
materials: [{name: a, density: 1}]
material_pairs: [{k_n: 2e4, restitution: 0.3, friction: 0.5}]
walls: [{name: belt, shape: rectangle, point: [0.5, 0.5, 0.5], along: [7, 0, 0], across: [0, 1, 0], motion: [{kind: translate, surface: true, velocity: [2, 0, 0]}]}]
particles: {from: single, position: [1, 1, 0.699983245], radius: 0.2}
heat: {temperature: 0, dissipation: 1, materials: [{conductivity: 1, capacity: 1}]}
observables: {every: 2000, list: [{name: energy_kinetic}, {name: energy_rotational}, {name: work_walls}, {name: energy_thermal}, {name: energy_balance}, {name: wall_offset, target: belt}]}
output: {dump: {every: 4000, fields: [id, position, velocity, angular_velocity]}, checkpoint: {every: 2000}}
YAML
rows() { # DIR: the last frame of the dump, by id
    tail -n "+$(grep -n '^ITEM: ATOMS' "$1/dump.lammpstrj" | tail -n 1 | cut -d : -f 1)" "$1/dump.lammpstrj" | grep -v '^ITEM' | sort -n
}
column() { # DIR NAME: its last value
    awk -F , -v name="$2" 'NR == 1 { for (k = 1; k <= NF; k++) { split($k, w, /[ (\[]/); if (w[1] == name) at = k } } END { print $at }' "$1/observables.csv"
}
rolls() { # RANKS SETTING...
    rm -rf rolls && run_scene "$1" belt.yaml rolls "${@:2}" && rows rolls >last &&
        echo "$(column rolls energy_kinetic) $(column rolls energy_rotational) $(column rolls work_walls) $(column rolls energy_thermal) $(awk -F , 'NR == 2 { print $6 }' rolls/observables.csv) $(column rolls energy_balance) $(column rolls belt_x)" | cat last - | awk '
        function off(a, b) { a = a / b - 1; return a < 0 ? -a : a }
        NR == 1 { v = $6; w = -0.2 * sqrt($9^2 + $10^2 + $11^2) }
        NR == 2 { m = 4 / 3 * atan2(0, -1) * 0.008; e = m * 4 # m V^2
            printf "  velocity %.9g of 2/7 V, spin %.9g of 5/7 V, kinetic energy %.6g, work %.6g, heat %.6g of 1/7, 2/7, 1/7 m V^2, balance %.2g\n", v * 7 / 4, w * 7 / 10, ($1 + $2) / e * 7, $3 / e * 7 / 2, $4 / e * 7, ($6 - $5) / e
            exit !(NF == 7 && off(v, 4 / 7) < 2e-3 && off(w, -10 / 7) < 2e-3 && off($1 + $2, e / 7) < 4e-3 && off($3, 2 / 7 * e) < 4e-3 && off($4, e / 7) < 4e-3 && $6 - $5 < 1e-4 * e && $5 - $6 < 1e-4 * e && $7 == 0) }'
}
check 'a grain on a belt: 2/7 of its speed, work, heat, balance' rolls 1
check 'the same on 3 ranks' rolls 3
cat >slab.txt <<'TXT'
0.5 0.5 0.5 7.5 0.5 0.5 7.5 1.5 0.5
0.5 0.5 0.5 7.5 1.5 0.5 0.5 1.5 0.5
TXT
check 'a mesh, and a velocity that is not along it' rolls 1 --set 'walls=[{name: belt, shape: mesh, file: slab.txt, motion: [{kind: translate, surface: true, velocity: [2, 0, 7]}]}]'
check 'a plane' rolls 1 --set 'walls=[{name: belt, shape: plane, point: [0, 0, 0.5], normal: [0, 0, 1], motion: [{kind: translate, surface: true, velocity: [2, 0, 0]}]}]'
check 'two dimensions' rolls 1 --set box='{dimension: 2, lower: [0, 0], upper: [8, 2]}' --set gravity='[0, -10]' --set particles.position='[1, 0.699983245]' \
    --set 'walls=[{name: belt, shape: plane, point: [0, 0.5], normal: [0, 1], motion: [{kind: translate, surface: true, velocity: [2, 0]}]}]' --set 'output.dump.fields=[id, position, velocity, angular_velocity]'

# A body that cannot roll, of three balls, ends with exactly the speed of the belt
rides() { # RANKS
    rm -rf rides && run_scene "$1" belt.yaml rides --set 'heat=~' --set 'observables.list=[{name: energy_kinetic}]' --set contact.end=force --set particles.position='[1, 1, 0.69998]' \
        --set bodies='{clumps: [{size: drawn, orientation: given, quaternion: [1, 0, 0, 0], spheres: [{centre: [-0.3, -0.2, 0], radius: 0.2}, {centre: [0.3, -0.2, 0], radius: 0.2}, {centre: [0, 0.3, 0], radius: 0.2}]}]}' \
        --set step.count=20000 --set output.dump.every=20000 --set observables.every=20000 && rows rides | awk '$1 == 1 { printf "  velocity %.12g\n", $6; exit !($6 - 2 < 1e-9 && 2 - $6 < 1e-9) }'
}
check 'a body that cannot roll: the speed of the belt' rides 1
check 'the same on 2 ranks' rides 2

# The belt stops: the grain, whose angular momentum about the line of contact is 0, comes to rest
stops() {
    { grep -v '^step:' belt.yaml; echo 'step: {dt: 0.0001}'; echo 'stages: [{name: runs, duration: 0.3}, {name: stands, duration: 0.3, set: {"walls[belt].motion": ~}}]'; } >stops.yaml
    rm -rf stops && run_scene 1 stops.yaml stops --set output.dump.every=6000 --set observables.every=6000 && rows stops | awk '{ printf "  velocity %.3g, spin %.3g\n", $6, $10; exit !($6 < 1e-3 && $6 > -1e-3) }' &&
        awk -v w="$(column stops work_walls)" 'BEGIN { e = 4 / 3 * atan2(0, -1) * 0.008 * 4 * 2 / 7; exit !(w / e < 1.004 && w / e > 0.996) }'
}
check 'a stage stops the belt' stops

# A drum whose surface alone turns acts as one that turns; so does a plane that slides within itself
cat >drum.yaml <<'YAML'
units: none
box: {lower: [-3, -3, 0], upper: [3, 3, 2], periodic: [false, false, true]}
gravity: [0, -10, 0]
step: {count: 3000, dt: 0.0005}
contact: {law: hooke, rolling: spring}
materials: [{name: a, density: 20}]
material_pairs: [{k_n: 2e4, restitution: 0.5, friction: 0.5, rolling_friction: 0.1}]
walls: [{name: drum, shape: cylinder, point: [0, 0, 1], axis: [0, 0, 1], radius: 2, motion: [{kind: rotate, direction: [0, 0, 1], rate: 3}]}]
particles: {from: single, position: [0.5, -1.5, 1], radius: 0.3}
observables: {every: 3000, list: [{name: work_walls}, {name: energy_balance}, {name: wall_torque, target: drum}]}
output: {dump: {every: 3000, fields: [id, position, velocity, angular_velocity]}}
YAML
drum() {
    rm -rf turns stays && run_scene 1 drum.yaml turns && run_scene 1 drum.yaml stays --set 'walls[0].motion[0].surface=true' &&
        { rows turns; rows stays; tail -n 1 turns/observables.csv | tr , ' '; tail -n 1 stays/observables.csv | tr , ' '; } | awk '
        { for (k = 1; k <= NF; k++) v[NR, k] = $k; n[NR] = NF }
        END { for (r = 1; r <= 3; r += 2) for (k = 1; k <= n[r]; k++) { d = v[r, k] - v[r + 1, k]; d = d < 0 ? -d : d; if (d > most) most = d }
            printf "  largest difference %.2g, work %g\n", most, v[3, 2]; exit !(most < 1e-9 && v[3, 2] > 0.01) }'
}
check 'a drum whose surface turns, with rolling resistance: as a drum that turns' drum

# Many grains on two belts, one of them of finite length on a wall that shakes, with a surface that swings: layouts, resume
cat >many.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [6, 3, 3], periodic: [true, true, false]}
gravity: [0, 0, -10]
step: {count: 1200, dt: 0.0005}
contact: {law: hooke}
materials: [{name: a, density: 20}]
material_pairs: [{k_n: 1e4, restitution: 0.5, friction: 0.5}]
walls:
  - {name: belt, shape: rectangle, point: [1, 0.5, 0.5], along: [3, 0, 0], across: [0, 2, 0], motion: [{kind: oscillate, surface: true, direction: [1, 0.3, 0.2], amplitude: 0.2, frequency: 5}, {kind: oscillate, direction: [0, 0, 1], amplitude: 0.02, frequency: 10}]}
  - {name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1], motion: [{kind: translate, surface: true, velocity: [-1, 0, 0]}]}
particles: {sources: [{from: random, count: 150, sizes: {law: uniform, min: 0.1, max: 0.15}, velocity_sigma: 1}]}
skin: 0.05
reproducible: true
observables: {every: 600, list: [{name: work_walls}, {name: energy_balance}, {name: wall_force, target: belt}]}
output: {dump: {every: 600, fields: [id, position, velocity, angular_velocity]}, checkpoint: {every: 600}}
YAML
row() { tail -n 1 "$1/observables.csv" | cut -d , -f 1,2,4-; } # the balance is no part of the mode
layouts() { many_one && many_layouts; }
check 'the same bits on any layout, work included' layouts
check 'a resume gives the same bits' many_resumes 1
check 'a resume on 2 ranks gives the same bits' many_resumes 2
change() { awk -F , 'NR == 2 { first = $3 } END { print ($3 - first) / $2 }' "$1/observables.csv"; }
balance() { # its change, over the work, is an error of the step: of first order
    rm -rf fine && run_scene 1 many.yaml fine --set reproducible=false --set step.dt=0.00025 --set step.count=2400 --set output.dump.every=2400 &&
        echo "$(change one) $(change fine)" | awk '{ printf "  %g, with half of the step %g\n", $1, $2; exit !($1 / $2 > 1.8 && $1 / $2 < 2.2) }'
}
check 'the balance of energy, of first order in the step' balance

refused() { # TEXT SETTING...
    ! "$scree" check belt.yaml "${@:2}" >told 2>&1 && grep -qF -- "$1" told || { cat told; return 1; }
}
check 'a surface that follows a force' refused 'walls[0].motion[0].surface' --set 'walls[0].motion=[{kind: servo, surface: true, direction: [0, 0, 1], force: 1, speed_max: 1}]'
finish
