#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Resuming into a scene that has changed, and the files on disk after the early end of a run: the step by rule, walls by name,
# groups set free, rows that wait for a frame, states at which a guard has stopped a run.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

# The step follows from the fastest particle at the start, which loses speed
cat >gas.yaml <<'EOF'
units: none
box: {lower: [0, 0, 0], upper: [6, 6, 6], periodic: true}
materials: [{name: glass, density: 1, young: 1e6, poisson: 0.2}]
material_pairs: [{restitution: 0.3, friction: 0.4}]
particles: {sources: [{from: random, count: 200, sizes: 0.3, velocity_sigma: 3}]}
step: {count: 400}
output: {checkpoint: {every: 200, keep: 9}}
EOF
keeps_step() {
    run_scene 1 gas.yaml gas && run_scene 1 gas.yaml gas-again --resume gas/checkpoint-200.h5 || return 1
    contents gas/checkpoint-400.h5 >whole.txt && contents gas-again/checkpoint-400.h5 >again.txt || return 1
    diff whole.txt again.txt
}
check 'a resume by the same rule keeps the time step, and the bits' keeps_step
# Between checkpoints most rebuilds leave the particles in their order; a checkpoint sorts them, as the resume does
cat >order.yaml <<'EOF'
units: none
box: {lower: [0, 0, 0], upper: [12, 12, 12], periodic: true}
materials: [{name: glass, density: 1, young: 1e6, poisson: 0.2}]
material_pairs: [{restitution: 0.9, friction: 0.4}]
particles: {sources: [{from: random, count: 2000, sizes: 0.3, velocity_sigma: 3}]}
step: {count: 200, rebuild_every: 4}
output: {checkpoint: {every: 100, keep: 9}}
EOF
keeps_order() {
    run_scene 1 order.yaml order && run_scene 1 order.yaml order-again --resume order/checkpoint-100.h5 || return 1
    contents order/checkpoint-200.h5 >whole.txt && contents order-again/checkpoint-200.h5 >again.txt || return 1
    diff whole.txt again.txt
}
check 'a resume sorts the particles as the run that went on did, and keeps the bits' keeps_order
step_of() {
    "$scree" info "$1" | sed -n 's/.*time step //p'
}
takes_new_step() {
    run_scene 1 gas.yaml gas-slower --resume gas/checkpoint-200.h5 --set step.fraction=0.03 --set step.count=210 || return 1
    [ "$(step_of gas-slower/checkpoint-210.h5)" != "$(step_of gas/checkpoint-400.h5)" ]
}
check 'another fraction of the stable step is taken up' takes_new_step

# A sphere leans on a rough wall and a rough floor; a gate that nobody touches comes first in the list
cat >walls.yaml <<'EOF'
units: none
box: {lower: [0, 0, 0], upper: [10, 10, 10], periodic: false}
gravity: [-3, 0, -10]
contact: {law: hooke}
materials: [{name: glass, density: 1}]
material_pairs: [{restitution: 0.3, friction: 0.5, k_n: 20000}]
walls:
  - {name: gate, shape: plane, material: glass, point: [9, 0, 0], normal: [-1, 0, 0]}
  - {name: side, shape: plane, material: glass, point: [1, 0, 0], normal: [1, 0, 0]}
  - {name: floor, shape: plane, material: glass, point: [0, 0, 1], normal: [0, 0, 1]}
particles: {sources: [{from: single, position: [1.995, 5, 1.99], radius: 1, velocity: [0, 0.05, 0]}]}
step: {dt: 0.0005, count: 2000}
observables: {every: 10, list: [{name: wall_force, target: floor}, {name: wall_force, target: side}]}
output: {checkpoint: {every: 1000, keep: 9}}
EOF
sed -e '/name: gate/d' walls.yaml >open.yaml
sed -e '/name: side/{h;d}' -e '/name: floor/{G}' walls.yaml >turned.yaml
# forces DIR: of the floor and the side on the last line, some digits
forces() {
    awk -F, 'NR == 1 { next } { line = ""; for (k = 2; k <= NF; k++) line = line sprintf(" %.9g", $k) } END { print line }' "$1/observables.csv"
}
# same_forces SCENE: resumed with other walls, the forces are those of the run that went on
same_forces() {
    run_scene 1 "$1.yaml" "$1-again" --resume walls/checkpoint-1000.h5 || return 1
    [ "$(forces walls)" = "$(forces "$1-again")" ] || { echo "  $(forces walls) and $(forces "$1-again")"; return 1; }
}
check 'a run with walls to go on from' run_scene 1 walls.yaml walls
check 'a wall less: springs stay with the walls of their names' same_forces open
check 'walls in another order: springs stay with the walls of their names' same_forces turned

# A sphere is held until the checkpoint, then set free above a floor
cat >held.yaml <<'EOF'
units: none
box: {lower: [0, 0, 0], upper: [10, 10, 10], periodic: false}
gravity: [0, 0, -10]
contact: {law: hooke}
materials: [{name: glass, density: 1}]
material_pairs: [{restitution: 0.1, k_n: 20000}]
walls: [{name: floor, shape: plane, material: glass, point: [0, 0, 4], normal: [0, 0, 1]}]
groups: [{name: stone, motion: frozen, select: {ids: [1]}}]
particles: {sources: [{from: single, position: [5, 5, 5.5], radius: 1}]}
step: {dt: 0.0005, count: 100}
observables: {every: 100, list: [{name: position, id: 1}]}
output: {checkpoint: {every: 100, keep: 9}}
EOF
set_free() {
    run_scene 1 held.yaml held || return 1
    sed -e 's/motion: frozen/motion: free/' -e 's/count: 100}/count: 8000}/' held.yaml >free.yaml
    run_scene 1 free.yaml free --resume held/checkpoint-100.h5 || return 1
    within "$(awk -F, 'END { print $4 }' free/observables.csv)" 4.998 0.002
}
check 'a sphere that was frozen and is set free rests on the floor' set_free

# Three materials, of which pairs feel different stiffness; the first and the last of them collide
cat >kinds.yaml <<'EOF'
units: none
box: {lower: [0, 0, 0], upper: [10, 10, 10]}
step: {dt: 0.001, count: 20}
contact: {law: hooke}
guards: {overlap: warn}
materials: [{name: a, density: 1}, {name: b, density: 1}, {name: c, density: 2}]
material_pairs: [{restitution: 1, friction: 0, k_n: 1000}, {between: [a, b], restitution: 0.5, friction: 0, k_n: 500}]
groups: [{name: first, select: {ids: [1]}}, {name: second, select: {ids: [2]}}]
particles: {sources: [{from: single, position: [3.1, 5, 5], radius: 1, material: a, velocity: [1, 0, 0]}, {from: single, position: [5.09, 5, 5], radius: 1, material: c}]}
output: {checkpoint: {every: 10, keep: 9}, dump: {every: 10, fields: [id, material, mass, velocity]}, trajectory: {every: 10}}
EOF
# column DIR NAME ID: of the last frame of its dump
column() {
    awk -v name="$2" -v id="$3" '/^ITEM: ATOMS/ { for (k = 3; k <= NF; k++) at[$k] = k - 2; next } /^ITEM/ { next }
        $at["id"] == id && NF > 3 { value = $at[name] } END { print value }' "$1/dump.lammpstrj"
}
check 'a run of three materials' run_scene 1 kinds.yaml kinds
# refused WORDS FLAG...: such a resume, with a message of all words (separated by |)
refused() {
    local words=$1 word
    local -a list
    shift
    rm -rf refused
    "$scree" run kinds.yaml -o refused --quiet --resume kinds/checkpoint-10.h5 "$@" >said 2>&1
    [ $? = 2 ] && [ "$(wc -l <said)" = 1 ] && [ ! -e refused ] || { cat said; return 1; }
    IFS='|' read -ra list <<<"$words"
    for word in "${list[@]}"; do
        holds said "$word" || return 1
    done
}
one='particles={from: single, position: [3, 5, 5], radius: 1, material: a}'
check 'fewer materials are refused' refused "1 particles are made of 'c'|no material of this name" \
    --set 'materials=[{name: a, density: 1}, {name: b, density: 1}]' --set "$one"
check 'one material is refused' refused 'no material of this name' --set 'materials=[{name: a, density: 1}]' \
    --set 'material_pairs=[{restitution: 1, friction: 0, k_n: 1000}]' --set "$one"
check 'fewer groups are refused' refused "1 particles are in group 'second'" --set 'groups=[{name: first, select: {ids: [1]}}]'
check 'another dimension is refused' refused 'in 3 dimensions, the scene has 2|box.dimension must stay' --set box.dimension=2
elastic='young: 1000, poisson: 0.2'
check 'another law is refused' refused 'contact.law hooke, the scene has hertz|contact.law must stay' --set contact.law=hertz \
    --set "materials=[{name: a, density: 1, $elastic}, {name: b, density: 1, $elastic}, {name: c, density: 2, $elastic}]" \
    --set 'material_pairs=[{restitution: 1, friction: 0}]'
check 'other units are refused' refused 'units must stay' --set units=si
by_name() { # FLAG...: the scene says the same in another order
    local id
    rm -rf by-name
    run_scene 1 kinds.yaml by-name --resume kinds/checkpoint-10.h5 "$@" || return 1
    for id in 1 2; do
        [ -n "$(column kinds vx $id)" ] && [ "$(column by-name vx $id)" = "$(column kinds vx $id)" ] ||
            { echo "  vx of $id: $(column by-name vx $id) and $(column kinds vx $id)"; return 1; }
    done
}
check 'they touch' within "$(column kinds vx 2)" 0.1 0.0999
check 'materials are known by their names' by_name --set 'materials=[{name: c, density: 2}, {name: b, density: 1}, {name: a, density: 1}]'
check 'groups are known by their names' by_name \
    --set 'groups=[{name: second, select: {ids: [2]}}, {name: first, select: {ids: [1]}}]'
check 'a material that nothing is made of may go' by_name --set 'materials=[{name: a, density: 1}, {name: c, density: 2}]' \
    --set 'material_pairs=[{restitution: 1, friction: 0, k_n: 1000}]'

# Densities become masses, and the terminal shows what has changed
denser() {
    "$scree" run kinds.yaml -o denser --resume kinds/checkpoint-10.h5 --set materials[2].density=6 --set material_pairs[0].k_n=900 \
        --set particles.sources[0].radius=0.5 "$@" >said 2>&1 || { cat said; return 1; }
    within "$(column denser mass 2)" "$(awk 'BEGIN { print 8 * atan2(0, -1) }')" 1e-4 &&
        [ "$(column denser mass 1)" = "$(column kinds mass 1)" ]
}
check 'a density that has changed gives other masses' denser
for line in 'materials[c].density: 2 -> 6' 'material_pairs[0].k_n: 1000 -> 900' 'masses of 1 particles follow' \
    'particles.sources[0].radius: 1 -> 0.5 (no effect: particles come from the checkpoint)'; do
    check "the list of changes: $line" holds said "$line"
done
runs_known() { # the files name the scenes of both runs
    [ "$("$scree" info denser/checkpoint-20.h5 | grep -c '^  run        from step')" = 2 ] &&
        "$scree" info denser/checkpoint-20.h5 | grep -q 'from step 10, scree' &&
        [ "$(grep -ac 'k_n: 900' denser/trajectory.h5)" -ge 1 ] && [ "$(grep -ac 'k_n: 1000' denser/trajectory.h5)" -ge 1 ]
}
check 'checkpoint and trajectory hold the scenes of both runs' runs_known

# Rows of observables are in the trajectory by every checkpoint, and after a stop
rows_of() {
    "$scree" info "$1/trajectory.h5" | awk '$1 == "observable" && $2 == "energy_kinetic" { print $3 }'
}
flushed() {
    run_scene 1 gas.yaml rows --set step.count=200 --set output.trajectory.every=1000 --set observables.every=10 \
        --set 'observables.list=[{name: energy_kinetic}]' --set output.checkpoint.every=100 || return 1
    [ "$(rows_of rows)" = 21 ] || { echo "  $(rows_of rows) rows"; return 1; }
}
check 'observables are in the trajectory to the end' flushed

# condemned RANKS: a particle that flies out of the box stops the run; no checkpoint of that step, one marked as stopped
cat >leaves.yaml <<'EOF'
units: none
box: {lower: [0, 0, 0], upper: [10, 10, 10], periodic: false, leave: error}
contact: {law: hooke}
materials: [{name: glass, density: 1}]
material_pairs: [{restitution: 0.3, k_n: 100}]
particles: {sources: [{from: single, position: [9.5, 5, 5.5], radius: 0.2, velocity: [10, 0, 0]}, {from: single, position: [2, 5, 5.5], radius: 0.2}]}
step: {dt: 0.001, count: 200}
observables: {every: 10, list: [{name: energy_kinetic}]}
output: {checkpoint: {every: 1, keep: 2}, trajectory: {every: 1000}}
EOF
condemned() {
    local last stopped
    on "$1" "$scree" run leaves.yaml -o "leaves-$1" --quiet >said 2>&1
    [ $? = 3 ] || { echo '  no stop by a guard'; cat said; return 1; }
    last=$(ls "leaves-$1" | sed -n 's/^checkpoint-\([0-9]*\)\.h5$/\1/p' | sort -n | tail -n 1)
    stopped=$(ls "leaves-$1" | sed -n 's/^checkpoint-\([0-9]*\)-stopped\.h5$/\1/p')
    [ "$last" -lt "$stopped" ] || { echo "  the last checkpoint is of step $last, the stop of $stopped"; return 1; }
    [ "$(rows_of "leaves-$1")" = $((stopped / 10 + 1)) ] || { echo "  $(rows_of "leaves-$1") rows at step $stopped"; return 1; }
}
check 'what a guard has condemned is no checkpoint; observables are whole' condemned 1
check 'the same on two ranks' condemned 2
# A folder that has the files of another scene, or other columns: nothing in it changes
cat >guest.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [4, 4, 4]}
step: {count: 8, dt: 0.001}
contact: {law: hooke}
materials: [{name: a, density: 1}]
material_pairs: [{k_n: 1000, restitution: 0.9}]
particles: {from: single, position: [2, 2, 2], radius: 0.5}
observables: {every: 2, list: [{name: energy}]}
output: {checkpoint: {every: 2, keep: 9}}
YAML
sums() { find host -type f -exec cksum {} + | sort; }
untouched() { # WORDS FLAG...: a run into the folder is refused
    local words=$1
    shift
    sums >before
    ! run_scene 1 guest.yaml host --set step.count=10 "$@" >told && holds told "$words" && sums | diff before -
}
run_scene 1 guest.yaml guest && run_scene 1 guest.yaml host --set gravity='[0, 0, -1]'
check "the folder of another scene" untouched 'host/checkpoint-8.h5: is of a run that began with another scene' --resume guest/checkpoint-4.h5 --overwrite
check "the folder of another scene, without --overwrite" untouched 'is of a run that began with another scene' --resume guest/checkpoint-4.h5
check "a folder with other columns" untouched 'host/observables.csv: has other columns' --resume host/checkpoint-4.h5 --overwrite \
    --set gravity='[0, 0, -1]' --set 'observables.list=[{name: momentum}]'

finish
