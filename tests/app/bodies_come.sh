#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Bodies that come and go during a run: clumps and rocks from insertions, whole bodies deleted by regions and open sides. Masses, momentum, a
# body of one sphere beside the sphere; ranks, indexes and a resume; messages.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

rows() { # DIR: the last frame of the dump, by id
    tail -n "+$(grep -n '^ITEM: ATOMS' "$1/dump.lammpstrj" | tail -n 1 | cut -d : -f 1)" "$1/dump.lammpstrj" | grep -v '^ITEM' | sort -n
}

# A floor with a hole in it: below is an open side; and a region that deletes
cat >hopper.yaml <<'YAML'
units: none
seed: 5
threads: 1
reproducible: true
box: {lower: [0, 0, 0], upper: [6, 6, 8], periodic: [true, true, false], leave: {z_lower: delete}}
gravity: [0, 0, -10]
step: {count: 2000, dt: 0.0002}
contact: {law: hooke}
materials: [{name: a, density: 1}, {name: b, density: 2}]
material_pairs: [{k_n: 10000, restitution: 0.6, friction: 0.3}]
groups: [{name: moves, motion: moving, velocity: [0.5, 0, 0], omega: [0, 0, 2]}]
walls:
  - {name: floor, shape: rectangle, point: [3, 0, 4], along: [3, 0, 0], across: [0, 6, 0], material: a}
  - {name: lid, shape: plane, point: [0, 0, 8], normal: [0, 0, -1], material: a}
particles:
  sources:
    - {from: random, count: 20, sizes: {law: fixed, radius: 0.35}, velocity: [0, 0, -8], material: b, region: {shape: box, lower: [0, 0, 0.5], upper: [3, 6, 3.5]}}
    - {from: random, count: 9, sizes: {law: fixed, radius: 0.45}, velocity: [0, 0, -8], material: a, region: {shape: box, lower: [0, 0, 0.5], upper: [3, 6, 3.5]}}
bodies:
  clumps:
    - {name: triple, material: a, radius_above: 0.4, spheres: [{centre: [-1, 0, 0], radius: 1}, {centre: [1, 0, 0], radius: 1}, {centre: [0, 1, 0], radius: 0.7}]}
    - {name: dumbbell, material: a, spheres: [{centre: [-1, 0, 0], radius: 1}, {centre: [1, 0, 0], radius: 1}]}
insertions:
  - {name: feed, material: a, rate: 300, sizes: {law: uniform, min: 0.3, max: 0.45}, velocity: [0, 0, -6], velocity_sigma: 0.5, omega: [0, 1, 0], region: {shape: box, lower: [0, 0, 5.5], upper: [6, 6, 7.9]}}
  - {name: fines, material: b, rate: 60, sizes: 0.2, velocity: [0, 0, -6], region: {shape: box, lower: [0, 0, 5.5], upper: [6, 6, 7.9]}}
  - {name: led, material: a, rate: 10, sizes: 0.4, count: 2, group: moves, region: {shape: box, lower: [0, 0, 4.5], upper: [6, 6, 5.4]}}
deletions:
  - {name: hole, region: {shape: box, lower: [4, 4, 4], upper: [6, 6, 5]}, every: 50}
observables: {every: 500, list: [{name: particles}, {name: bodies}, {name: turnover}, {name: sum, of: mass, label: mass}]}
output: {dump: {every: 1000, fields: [id, kind, body, body_part, position, velocity, angular_velocity]}, checkpoint: {every: 1000}}
YAML
sed -e 's|dt: 0.0002|dt: 0.00016|' -e '/^box/s/z_lower/z_upper/' -e 's/shape: rectangle, .*, material/shape: plane, point: [0, 0, 0], normal: [0, 0, 1], material/' \
    -e '/clumps:/,/dumbbell/d' -e 's/^bodies:/&\n  shapes:\n    - {name: rock, material: a, random: {corners: 14, variants: 5}, roundness: 0.2}/' \
    -e 's/lower: \[4, 4, 4\], upper: \[6, 6, 5\]/lower: [0, 0, 0], upper: [6, 3, 1]/' hopper.yaml >rocks.yaml

# whole DIR: in the last frame each body has all its members, each member a body; the masses that came and went make the difference
whole() {
    awk '/^ITEM: ATOMS/ { for (k = 3; k <= NF; k++) at[$k] = k - 2; rows = 1; split("", body); split("", members); split("", seen); next } /^ITEM/ { rows = 0 } !rows { next }
        { id = $at["id"]; of = $at["body"]; part = $at["body_part"] }
        $at["kind"] == 3 { body[id] = 1 } $at["kind"] == 0 && of >= 0 { bad += (of, part) in seen; seen[of, part] = 1; members[of]++ }
        END { for (id in members) bad += !(id in body)
            for (id in body) { bad += !(id in members); for (k = 0; k < members[id]; k++) bad += !((id, k) in seen); size[members[id]]++; bodies++ }
            for (n in size) printf "  %d bodies of %d\n", size[n], n; exit bad || !bodies }' "$1/dump.lammpstrj" &&
        awk -F, 'NR == 1 { for (k = 1; k <= NF; k++) { sub(/\[.*/, "", $k); at[$k] = k } next }
            NR == 2 { first = $at["mass"] }
            { off = $at["mass"] - first - $at["inserted_mass"] + $at["deleted_mass"]; off = off < 0 ? -off : off; if (off > most) most = off }
            END { printf "  inserted %d, deleted %d; masses within %.2g\n", $at["inserted"], $at["deleted"], most
                exit !(NR > 3 && most < 1e-11 && $at["inserted"] > 60 && $at["deleted"] > 10) }' "$1/observables.csv"
}
alike() { # SCENE RANKS INDEX
    rm -rf other && run_scene "$2" "$1.yaml" other --set index.name="$3" && rows other | cmp - "$1.rows"
}
resumed() { # SCENE
    rm -rf more && run_scene 3 "$1.yaml" more --resume "$1/checkpoint-1000.h5" && rows more | cmp - "$1.rows"
}
for scene in hopper rocks; do
    check "$scene" run_scene 1 $scene.yaml $scene --set index.name=hgrid
    rows $scene >$scene.rows
    check "$scene: whole bodies, masses" whole $scene
    check "$scene: the same bits: 2 ranks, brute" alike $scene 2 brute
    check "$scene: the same bits: 4 ranks, linkcell" alike $scene 4 linkcell
    check "$scene: a resume on 3 ranks gives the same bits" resumed $scene
done

# In a closed box the momentum is what came: mass x velocity, and of a mass rate as much as is due
closed() { # RANKS SETTING...
    run_scene "$1" hopper.yaml closed --overwrite --set reproducible=false --set 'box={lower: [0, 0, 0], upper: [6, 6, 8], periodic: true}' --set gravity=[0,0,0] --set walls='[]' --set deletions='[]' --set groups='[]' \
        --set 'particles=~' --set 'insertions=[{name: feed, material: a, mass_rate: 15, sizes: {law: uniform, min: 0.3, max: 0.5}, velocity: [1, 0, -10], region: {shape: box, lower: [0, 0, 4], upper: [6, 6, 8]}},
            {name: against, material: a, mass_rate: 15, sizes: {law: uniform, min: 0.3, max: 0.5}, velocity: [1, 0, 10], region: {shape: box, lower: [0, 0, 0], upper: [6, 6, 3]}}]' \
        --set 'observables.list=[{name: momentum}, {name: inserted_mass}, {name: energy_dissipated}]' --set 'output={checkpoint: {at_end: false}}' "${@:2}" &&
        tail -n 1 closed/observables.csv | awk -F, '{ off = $2 - $5; off = off < 0 ? -off : off; print "  mass " $5 ", due 12, momentum off by " off ", dissipated " $6; exit !(off < 1e-11 && $5 > 11 && $5 < 12.5 && $6 > 0.1) }'
}
rock='bodies={shapes: [{name: rock, material: a, random: {corners: 12, variants: 4}, roundness: 0.2}]}'
check 'momentum and a mass rate of clumps' closed 1
check 'on 2 ranks' closed 2
check 'of rocks' closed 1 --set "$rock" --set step='{count: 2500, dt: 0.00016}'

# A body of one sphere moves as the sphere
single='bodies={clumps: [{name: ball, material: a, spheres: [{centre: [0, 0, 0], radius: 1}]}]}'
one() { # DIR SETTING...
    run_scene 1 hopper.yaml "$1" --set deletions='[]' --set 'bodies={clumps: [{name: none, material: b, radius_above: 9, spheres: [{centre: [0, 0, 0], radius: 1}]}]}' --set step.count=1200 --set observables.every=100 \
        --set 'observables.list=[{name: energy}, {name: turnover}, {name: momentum}]' "${@:2}"
}
as_spheres() {
    one spheres && one balls --set "$single" && paste -d, spheres/observables.csv balls/observables.csv | awk -F, 'NR > 1 { n = NF / 2
        for (k = 2; k <= n; k++) { d = $k - $(n + k); d = d < 0 ? -d : d; if (d > most) most = d } met = $7 } END { printf "  largest difference %.2g, dissipated %g\n", most, met; exit !(NR > 9 && most < 1e-8 && met > 0.1) }'
}
check 'a body of one sphere moves as the sphere, from an insertion to its end' as_spheres

# The stable step knows the members that will come
stable() {
    scene_refused 'step.dt: the time step 0.0004 is above the stable one' hopper.yaml --set step.dt=0.0004 --set 'particles=~' && "$scree" check hopper.yaml --set step.dt=0.0004 --set 'particles=~' --set "$single" >said
}
check 'the stable step knows the members that will come' stable
check 'refused: a body as drawn that is larger than its grain' scene_refused "insertions[0].sizes: the body 'big' as drawn has a ball of radius 2" hopper.yaml \
    --set 'bodies.clumps[0]={name: big, material: a, size: drawn, spheres: [{centre: [-1, 0, 0], radius: 1}, {centre: [1, 0, 0], radius: 1}]}'
check 'refused: a rock as large as the box' scene_refused "insertions[0].sizes: the rock 'rock' has a ball of radius 3" rocks.yaml --set insertions[0].sizes=3 --set 'insertions[0].region=~'

# The stable step knows the smallest and the largest bodies that may come, however narrow their range among the sizes is
cat >sizes.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [9, 9, 9]}
step: {fraction: 0.5, count: 1, speed_max: 1}
contact: {law: hooke}
materials: [{name: a, density: 1}]
material_pairs: [{k_n: 1000, restitution: 0.6}]
particles: {from: single, position: [5, 5, 5], radius: 0.1101}
bodies: {clumps: [{radius_above: 0.11, radius_upto: 0.15, spheres: [{centre: [0, 0, 0], radius: 1}, {centre: [1, 0, 0], radius: 0.2}]}]}
insertions: [{rate: 1, sizes: {law: uniform, min: 0.1, max: 1}}]
output: {checkpoint: {at_end: false}}
YAML
step_of() { # DIR SETTING...
    run_scene 1 sizes.yaml "$@" && sed -n 's/.*"dt": \([^,]*\),.*/\1/p' "$1/report.json" >"$1.step"
}
knows() {
    step_of there --set insertions='[]' && step_of comes --set particles.radius=1 && step_of none --set particles.radius=1 --set bodies.clumps[0].radius_upto=0.11000001 --set bodies.clumps[0].radius_above=0.05 --set insertions[0].sizes=1 &&
        paste there.step comes.step none.step | awk '{ print "  steps " $1 ", " $2 " of those that come, " $3 " without"; exit !($2 <= $1 && $2 > 0.9 * $1 && $3 > 2 * $1) }'
}
check 'the stable step of bodies that come' knows
finish
