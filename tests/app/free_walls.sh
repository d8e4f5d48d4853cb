#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Free walls: weights on springs and floors, energy, momentum, layouts, resume, periodic sides, two dimensions, stages, bodies, rocks, messages.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

column() { # DIR NAME: its last value
    awk -F , -v name="$2" 'NR == 1 { for (k = 1; k <= NF; k++) { split($k, w, /[ (\[]/); if (w[1] == name) at = k } } END { print $at }' "$1/observables.csv"
}
rows() { # DIR: the last frame of the dump, by id
    tail -n "+$(grep -n '^ITEM: ATOMS' "$1/dump.lammpstrj" | tail -n 1 | cut -d : -f 1)" "$1/dump.lammpstrj" | grep -v '^ITEM' | sort -n
}

# A tray along z on a spring with a damper carries what falls on it: it sinks by the weight of both over the stiffness
cat >tray.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [4, 4, 4]}
gravity: [0, 0, -10]
step: {count: 16000, dt: 0.0003}
contact: {law: hooke}
materials: [{name: a, density: 1}]
material_pairs: [{k_n: 2e4, restitution: 0.3, friction: 0.5}]
walls: [{name: tray, shape: box, lower: [1, 1, 0.8], upper: [3, 3, 1], free: {mass: 3, freedom: along, direction: [0, 0, 1], spring: 500, damper: 60}}]
particles: {from: single, position: [2, 2, 1.6], radius: 0.5}
observables: {every: 16000, list: [{name: wall_offset, target: tray}, {name: wall_force, target: tray}, {name: energy_gravity}, {name: energy_walls}, {name: energy_balance}]}
output: {checkpoint: {at_end: false}}
YAML
sinks() { # MASS SETTING...: of what lies on the tray
    rm -rf sinks && run_scene 1 tray.yaml sinks "${@:2}" || return 1
    echo "  sinks by $(column sinks tray_z), pushed by $(column sinks tray_fz)"
    within "$(column sinks tray_z)" "$(awk -v m="$1" 'BEGIN { printf "%.9g", -(3 + m) * 10 / 500 }')" 1e-6 &&
        within "$(column sinks tray_fz)" "$(awk -v m="$1" 'BEGIN { print -10 * m }')" 1e-4
}
check 'a grain on a tray with a spring' sinks 0.523598776
balances() {
    awk -F , 'NR == 1 { for (k = 1; k <= NF; k++) if ($k ~ /^energy_balance/) at = k } { v[NR] = $at }
        END { d = (v[3] - v[2]) / v[2]; printf "  changes by %g of itself\n", d; exit !(d * d < 0.005 * 0.005) }' sinks/observables.csv
}
check 'the balance of energy: damper, spring and weights' balances
check 'a body' sinks 0.5 --set 'bodies={clumps: [{mass: 0.5, size: drawn, spheres: [{centre: [-0.2, 0, 0], radius: 0.2}, {centre: [0.2, 0.1, 0], radius: 0.2}, {centre: [0, -0.2, 0], radius: 0.2}]}]}'
check 'a rock' sinks 0.7 --set 'bodies={shapes: [{mass: 0.7, size: drawn, vertices: [0,0,0, 0.5,0,0, 0,0.5,0, 0.5,0.5,0, 0,0,0.4, 0.5,0,0.4, 0,0.5,0.4, 0.5,0.5,0.4], rounding: 0.05}]}' --set particles.position='[2, 2, 1.9]'

# A tray that is given back: two dimensions, a plane as the lid of three grains
cat >flat.yaml <<'YAML'
units: none
box: {dimension: 2, lower: [0, 0], upper: [4, 4]}
gravity: [0, -10]
step: {count: 8000, dt: 0.0005}
contact: {law: hooke}
materials: [{name: a, density: 1}]
material_pairs: [{k_n: 2e4, restitution: 0.3, friction: 0.5}]
walls:
  - {name: floor, shape: plane, point: [0, 0], normal: [0, 1]}
  - {name: lid, shape: plane, point: [0, 2], normal: [0, -1], free: {mass: 3, freedom: along, direction: [0, 1], force: -6}}
particles: {sources: [{from: single, position: [1, 0.5], radius: 0.5}, {from: single, position: [2.2, 0.5], radius: 0.5}, {from: single, position: [3.4, 0.5], radius: 0.5}]}
observables: {every: 8000, list: [{name: wall_force, target: floor}, {name: wall_force, target: lid}, {name: wall_offset, target: lid}]}
output: {checkpoint: {at_end: false}}
YAML
lid() {
    rm -rf lid && run_scene 1 flat.yaml lid && within "$(column lid lid_fy)" 36 1e-4 && within "$(column lid lid_y)" "$(awk -v f="$(column lid floor_fy)" 'BEGIN { printf "%.9g", -1 - 12 / 2e4 + f / 3 / 2e4 }')" 1e-6
}
check 'a lid in two dimensions, with a force' lid
door() { # a door in the plane turns about z alone
    rm -rf door && run_scene 1 flat.yaml door --set step.count=2000 --set observables.every=2000 \
        --set 'walls=[{name: floor, shape: plane, point: [0, 0], normal: [0, 1]}, {name: door, shape: box, lower: [1.9, 1.2, -1], upper: [2.1, 3, 1], free: {mass: 2, angular_velocity: [0, 0, 1]}}]' \
        --set 'observables.list=[{name: wall_rotation, target: door}, {name: wall_offset, target: door}]' &&
        within "$(column door door_phix)" 0 0 && within "$(column door door_z)" 0 0
}
check 'a box in two dimensions stays in the plane' door

# Elastic grains and three free walls in a closed room: energy, and momentum where nothing else pushes
cat >gas.yaml <<'YAML'
units: none
seed: 3
box: {lower: [0, 0, 0], upper: [4, 4, 4], periodic: [true, true, true]}
step: {count: 2500, dt: 2e-4}
contact: {law: hooke, tangential: none}
materials: [{name: a, density: 3}]
material_pairs: [{k_n: 1e4, restitution: 1}]
walls:
  - {name: block, shape: box, lower: [1, 1, 1], upper: [2, 1.6, 1.4], free: {density: 3, velocity: [1, 0, 0]}}
  - {name: plate, shape: rectangle, point: [2.5, 2.5, 2.5], along: [1, 0, 0], across: [0, 1, 0.5], free: {mass: 2, freedom: shift}}
particles: {sources: [{from: random, count: 120, sizes: {law: uniform, min: 0.12, max: 0.2}, velocity_sigma: 2}]}
skin: 0.05
observables: {every: 2500, list: [{name: energy_kinetic}, {name: energy_elastic_normal}, {name: energy_walls}, {name: energy_balance}, {name: momentum}, {name: wall_velocity}]}
output: {checkpoint: {at_end: false}}
YAML
keeps() { # RANKS
    rm -rf gas && run_scene "$1" gas.yaml gas && awk -F , 'NR == 1 { for (k = 1; k <= NF; k++) { split($k, w, /[ (\[]/); at[w[1]] = k } next }
        { e[NR] = $at["energy_balance"]; w[NR] = $at["energy_walls"]; for (d = 1; d <= 3; d++) { c = substr("xyz", d, 1); p[NR, d] = $at["momentum_" c] + 3 * 0.24 * $at["block_v" c] + 2 * $at["plate_v" c] } }
        END { printf "  energy changes by %.2g of itself, %g of it of walls; momentum", e[3] / e[2] - 1, w[3] / e[3]; bad = 0
            for (d = 1; d <= 3; d++) { q = p[3, d] - p[2, d]; printf " %.2g", q; bad = bad || q * q > 1e-18 }
            print ""; f = e[3] / e[2] - 1; exit bad || f * f > 1e-6 || w[3] == w[2] }' gas/observables.csv
}
check 'grains and free walls in a periodic box: energy, momentum' keeps 1
check 'the same on 3 ranks' keeps 3

# A sleeper falls on a bed, a paddle is struck, a lid presses: the same bits on any layout, and after a resume
cat >many.yaml <<'YAML'
units: none
seed: 5
box: {lower: [0, 0, 0], upper: [4, 3, 5], periodic: [true, true, false]}
gravity: [0, 0, -10]
step: {count: 1200, dt: 0.0005}
contact: {law: hooke}
materials: [{name: a, density: 20}]
material_pairs: [{k_n: 1e4, restitution: 0.5, friction: 0.5}]
walls:
  - {name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}
  - {name: sleeper, shape: box, lower: [3, 1, 2.6], upper: [4.6, 1.6, 3], free: {density: 30, velocity: [1, 0, -1]}}
  - {name: paddle, shape: rectangle, point: [0.5, 2, 0.2], along: [1.2, 0, 0], across: [0, 0.3, 0.8], free: {mass: 2, freedom: about, direction: [1, 0, 0], point: [0, 2.1, 0.6], damper: 0.1, torque: 2}}
  - {name: lid, shape: plane, point: [0, 0, 4], normal: [0, 0, -1], free: {mass: 20, freedom: along, direction: [0, 0, 1], spring: 10}}
particles: {sources: [{from: random, count: 150, sizes: {law: uniform, min: 0.1, max: 0.18}, velocity_sigma: 1, region: {shape: box, lower: [0, 0, 0], upper: [4, 3, 2.5]}}]}
skin: 0.05
reproducible: true
observables: {every: 600, list: [{name: wall_offset}, {name: wall_velocity}, {name: wall_rotation}, {name: wall_angular_velocity}, {name: wall_force}, {name: wall_torque}, {name: energy_walls}]}
output: {dump: {every: 600, fields: [id, position, velocity, angular_velocity]}, checkpoint: {every: 600}}
YAML
row() { tail -n 1 "$1/observables.csv"; }
layouts() {
    many_one || return 1
    echo "  the sleeper turned by $(column one sleeper_phix) $(column one sleeper_phiy), the paddle by $(column one paddle_phix)"
    [ "$(column one sleeper_phix)" != 0 ] && [ "$(column one paddle_phix)" != 0 ] || return 1
    many_layouts
}
check 'the same bits on any layout' layouts
check 'a resume gives the same bits' many_resumes 1
check 'a resume on 2 ranks gives the same bits' many_resumes 2
loads() {
    rm -rf one two && run_scene 1 many.yaml one --set output.walls.every=600 && run_scene 2 many.yaml two --set output.walls.every=600 &&
        cmp one/walls-600.vtp two/walls-600.vtp && cmp one/walls-1200.vtp two/walls-1200.vtp
}
check 'loads of triangles are the same bits on 2 ranks' loads
fast() { # without the mode: a resume on the same layout
    rm -rf one other && run_scene 2 many.yaml one --set reproducible=false && rows one >one.rows && tail -n 1 one/observables.csv >one.row &&
        run_scene 2 many.yaml other --set reproducible=false --resume one/checkpoint-600.h5 && many_same
}
check 'the fast mode: a resume on 2 ranks gives the same bits' fast

# A block that leaves through a periodic side meets the grain behind it as it would in the middle
cat >side.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [4, 4, 4], periodic: [true, true, true]}
step: {count: 2000, dt: 5e-4}
contact: {law: hooke}
materials: [{name: a, density: 1}]
material_pairs: [{k_n: 1e4, restitution: 0.8, friction: 0.3}]
walls: [{name: block, shape: box, lower: [3, 1.6, 1.6], upper: [3.6, 2.4, 2.4], free: {mass: 2, velocity: [2, 0.2, 0]}}]
particles: {from: single, position: [0.7, 2.2, 2.1], radius: 0.3}
observables: {every: 2000, list: [{name: velocity, id: 1}, {name: angular_velocity, id: 1}, {name: wall_velocity, target: block}, {name: wall_angular_velocity, target: block}, {name: wall_offset, target: block}]}
output: {checkpoint: {at_end: false}}
YAML
crosses() {
    rm -rf side middle && run_scene 1 side.yaml side && run_scene 1 side.yaml middle --set particles.position='[2.7, 2.2, 2.1]' \
        --set 'walls[block].lower=[1, 1.6, 1.6]' --set 'walls[block].upper=[1.6, 2.4, 2.4]' && rows_close side middle 1e-9 &&
        awk -v w="$(column side block_wy)" 'BEGIN { exit w == 0 }'
}
check 'a block through a periodic side' crosses

# A plate far lighter than the grains below it: the step that the program finds keeps the energy, one of the grains alone would not
cat >light.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [4, 4, 4]}
gravity: [0, 0, -10]
step: {count: 6000, fraction: 0.3}
contact: {law: hooke, tangential: none}
materials: [{name: a, density: 1}]
material_pairs: [{k_n: 2e4, restitution: 1}]
walls:
  - {name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}
  - {name: plate, shape: rectangle, point: [0.4, 0.4, 0.99], along: [3.2, 0, 0], across: [0, 3.2, 0], free: {mass: 0.01}}
particles: {from: lattice, lattice: sc, spacing: 0.98, sizes: 0.49, region: {shape: box, lower: [0.5, 0.5, 0], upper: [3.5, 3.5, 0.985]}}
observables: {every: 6000, list: [{name: energy_balance}, {name: energy_kinetic}]}
output: {checkpoint: {at_end: false}}
YAML
light() {
    rm -rf light && run_scene 1 light.yaml light && awk -F , 'NR == 2 { first = $2 } END { printf "  energy changes by %.2g of %.2g in play\n", $2 - first, $3; d = $2 - first; exit !(d * d < 1e-6) }' light/observables.csv &&
        "$scree" check light.yaml | grep -o 'of the stable [0-9.e-]*' >told && within "$(awk '{ print $4 }' told)" 2.8e-4 1e-5
}
check 'a light plate: the step' light

# A stage frees a plate, which then falls
falls() {
    { grep -v '^step:\|^walls:\|^observables:' tray.yaml
        echo 'walls: [{name: plate, shape: box, lower: [0.2, 0.2, 3], upper: [0.8, 0.8, 3.2], motion: [{kind: rotate, direction: [0, 0, 1], point: [0.5, 0.5, 0], rate: 1}]}]'
        echo 'observables: {every: 200, list: [{name: wall_offset, target: plate}, {name: wall_rotation, target: plate}, {name: position, id: 1}]}'
        echo 'step: {dt: 0.0005}'
        echo 'stages:'
        echo '  - {name: holds, duration: 0.2}'
        echo '  - {name: falls, duration: 0.4, set: {"walls[plate].motion": ~, "walls[plate].free": {density: 2}}}'
        echo '  - {name: throws, duration: 0.2, set: {"walls[plate].free.velocity": [0, 0, 4], "walls[plate].free.angular_velocity": [0, 0, 2]}}'
        echo '  - {name: flies, duration: 0.2, set: {step.dt: 0.00025}}'; } >falls.yaml
    rm -rf falls && run_scene 1 falls.yaml falls
}
at_time() { # TIME NAME VALUE: of the plate that falls, to rounding
    mkdir -p row && sed -n "1p; /^$1,/p" falls/observables.csv >row/observables.csv && within "$(column row "$2")" "$3" 1e-9
}
thrown() { at_time 0.8 plate_z -0.2 && at_time 0.8 plate_phiz 0.6; }
goes_on() { at_time 1 plate_z 0 && at_time 1 particle1_z -3.4; }
check 'stages free a plate and throw it' falls
check 'a stage frees a plate, which falls by g t^2 / 2' eval 'at_time 0.6 plate_z -0.8 && at_time 0.6 plate_phiz 0.2'
check 'a stage gives a free plate another velocity' thrown
check 'a stage with another step: plate and grain fly on' goes_on

tells() { "$scree" check many.yaml >told && grep -q "free about its axis, mass 2, inertia" told && grep -q "free along its direction, mass 20" told && grep -q 'free, mass 11.52' told; }
check 'check tells mass and inertia' tells

free() { echo "walls=[{name: w, $1, free: {$2}}]"; }
box='shape: box, lower: [1, 1, 0.8], upper: [3, 3, 1]'
check 'a motion beside it' scene_refused 'walls[0].motion|either moves by order or is free' tray.yaml --set "$(free "$box, motion: [{kind: translate, velocity: [0, 0, 1]}]" 'mass: 1')"
check 'no mass' scene_refused 'walls[0].free.mass|either a mass or a density' tray.yaml --set "$(free "$box" 'freedom: shift')"
check 'a plane that turns' scene_refused 'walls[0].free.freedom|no middle|allowed: along, shift' tray.yaml --set "$(free 'shape: plane, point: [0, 0, 0], normal: [0, 0, 1]' 'mass: 1')"
check 'a density without a volume' scene_refused 'encloses no volume|give its mass' tray.yaml --set "$(free 'shape: rectangle, point: [0, 0, 0], along: [1, 0, 0], across: [0, 1, 0]' 'density: 1')"
check 'an endless roller without inertia' scene_refused 'walls[0].free.inertia|is missing' tray.yaml --set "$(free 'shape: cylinder, point: [0, 0, 0], axis: [1, 0, 0], radius: 1' 'mass: 1, freedom: about, direction: [1, 0, 0], point: [0, 0, 0]')"
check 'an endless tube across a periodic side' scene_refused 'walls[0].free.freedom|across a periodic direction' tray.yaml --set box.periodic='[true, false, false]' \
    --set "$(free 'shape: cylinder, point: [2, 2, 2], axis: [0, 0, 1], radius: 1' 'mass: 1, freedom: shift')"
check 'a density in two dimensions' scene_refused 'walls[1].free.density|allowed: mass' flat.yaml --set 'walls[lid].free={density: 1, freedom: along, direction: [0, 1]}'
check 'a direction out of the plane' scene_refused 'walls[1].free.direction|two-dimensional' flat.yaml --set 'walls[lid].free.direction=[0, 1, 1]'
check 'a name that a checkpoint would cut' scene_refused 'walls[0].name|longer than 55 bytes' tray.yaml --set "walls[tray].name=$(printf 'a%.0s' {1..56})" --set 'observables.list=[{name: energy_walls}]'
check 'beside a solver of contacts' scene_refused 'walls[0].free|contact.solver' tray.yaml --set contact='{law: rigid, solver: gauss_seidel}' --set 'material_pairs=[{restitution: 0.3, friction: 0.5}]'
finish
