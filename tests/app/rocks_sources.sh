#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Sources and insertions that name a shape of bodies: sizes of equal volume, true volume fractions, spheres among rocks, packings, ranks, indexes
# and a resume; messages.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

rows() { # DIR: the last frame of the dump, by id
    tail -n "+$(grep -n '^ITEM: ATOMS' "$1/dump.lammpstrj" | tail -n 1 | cut -d : -f 1)" "$1/dump.lammpstrj" | grep -v '^ITEM' | sort -n
}

# Rocks and spheres of one material and of the same sizes, and clumps that come: the sources alone tell them apart
cat >mixed.yaml <<'YAML'
units: none
seed: 3
threads: 1
reproducible: true
box: {lower: [0, 0, 0], upper: [8, 8, 8], periodic: [true, true, false]}
gravity: [0, 0, -10]
step: {dt: 1e-4, count: 1000}
contact: {law: hooke}
materials: [{name: a, density: 2}]
material_pairs: [{k_n: 2e4, restitution: 0.5, friction: 0.4}]
walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}, {name: lid, shape: plane, point: [0, 0, 8], normal: [0, 0, -1]}]
particles:
  sources:
    - {name: cubes, from: random, shape: cube, volume_fraction: 0.06, sizes: {law: uniform, min: 0.4, max: 0.5}, velocity: [0, 0, -3], region: {shape: box, lower: [0, 0, 0], upper: [8, 8, 5]}}
    - {name: spheres, from: random, count: 30, sizes: {law: uniform, min: 0.4, max: 0.5}, velocity: [0, 0, -3], region: {shape: box, lower: [0, 0, 0], upper: [8, 8, 5]}}
    - {name: one, from: single, shape: ballast, position: [4, 4, 7], radius: 0.4, velocity: [0, 0, -3]}
bodies:
  clumps: [{name: dumbbell, spheres: [{centre: [-1, 0, 0], radius: 1}, {centre: [1, 0, 0], radius: 1}]}]
  shapes:
    - {name: cube, vertices: [0,0,0, 1,0,0, 0,1,0, 1,1,0, 0,0,1, 1,0,1, 0,1,1, 1,1,1], rounding: 0.05}
    - {name: ballast, random: {corners: 14, variants: 5}, roundness: 0.2}
insertions:
  - {name: feed, shape: ballast, mass_rate: 60, sizes: {law: uniform, min: 0.2, max: 0.3}, velocity: [0, 0, -3], region: {shape: box, lower: [0, 0, 5], upper: [8, 8, 8]}}
  - {name: more, shape: dumbbell, rate: 60, sizes: 0.2, velocity: [0, 0, -3], region: {shape: box, lower: [0, 0, 5], upper: [8, 8, 8]}}
observables: {every: 500, list: [{name: particles}, {name: bodies}, {name: turnover}, {name: sum, of: mass, label: mass}, {name: solid_fraction}, {name: solid_volume, target: all}],
  regions: [{name: all, shape: box, lower: [-1, -1, -1], upper: [9, 9, 9]}]}
output: {dump: {every: 500, fields: [id, kind, body, body_part, rock_shape, radius, mass, position, velocity, angular_velocity, rock_orientation]}, checkpoint: {every: 500}}
YAML
check 'a scene with shapes in sources runs' run_scene 1 mixed.yaml mixed --set index.name=hgrid
rows mixed >mixed.rows

# The mass of a cube of radius r is density x 4/3 pi r^3; the ball around it is 0.829423 / (3 / 4 pi)^(1/3) times as large (test rocks.sh: as drawn 0.829423)
sizes() {
    awk '/^ITEM: ATOMS/ { for (k = 3; k <= NF; k++) at[$k] = k - 2; rows = ++frame == 1; next } /^ITEM/ { rows = 0 } !rows { next }
        $at["kind"] == 0 && $at["rock_shape"] == 1 { r = ($at["mass"] / 2 * 3 / 4 / 3.14159265358979) ^ (1 / 3); ball = $at["radius"] / r; cubes++; solid += $at["mass"] / 2
            if (r < least || !least) least = r; if (r > most) most = r; off = ball / 1.3370230 - 1; bad += off * off > 1e-10 }
        $at["kind"] == 0 && $at["rock_shape"] > 1 { r = ($at["mass"] / 2 * 3 / 4 / 3.14159265358979) ^ (1 / 3); rocks++; bad += (r / 0.4 - 1) ^ 2 > 1e-20 || $at["radius"] < r }
        $at["kind"] == 0 && $at["body"] < 0 { spheres++; bad += $at["radius"] < 0.4 || $at["radius"] > 0.5 }
        END { f = solid / 320; printf "  %d cubes of radii %g to %g, ball %.7g times; fraction %.4g; %d rocks, %d spheres\n", cubes, least, most, ball, f, rocks, spheres
            exit bad || !(cubes > 20 && least >= 0.4 && most <= 0.5 && f > 0.058 && f < 0.062 && rocks == 1 && spheres == 30) }' mixed/dump.lammpstrj
}
check 'radii are those of the same volume, and fractions count it' sizes
counts() { # the last row: what came has the mass that was due, and the solid volume is mass over density
    tail -n 1 mixed/observables.csv | awk -F, -v head="$(head -n 1 mixed/observables.csv)" '{ n = split(head, name, ","); for (k = 1; k <= n; k++) { sub(/\[.*/, "", name[k]); at[name[k]] = k }
        solid = $at["solid_volume_all"] * 2 / $at["mass"] - 1; fraction = $at["solid_fraction"] * 512 * 2 / $at["mass"] - 1
        printf "  %d bodies, inserted %d of mass %g, solid volume off by %.2g\n", $at["bodies"], $at["inserted"], $at["inserted_mass"], solid
        exit !($at["inserted"] > 10 && $at["inserted_mass"] > 4 && $at["inserted_mass"] < 7 && solid * solid < 1e-20 && fraction * fraction < 1e-20) }'
}
check 'a mass rate, and volumes of observables' counts
alike() { # RANKS INDEX
    rm -rf other && run_scene "$1" mixed.yaml other --set index.name="$2" && rows other | cmp - mixed.rows
}
check 'the same bits: 2 ranks, brute' alike 2 brute
check 'the same bits: 3 ranks, linkcell' alike 3 linkcell
resumed() {
    rm -rf more && run_scene 2 mixed.yaml more --resume mixed/checkpoint-500.h5 && rows more | cmp - mixed.rows
}
check 'a resume on 2 ranks gives the same bits' resumed

# Other sizes: the ball around the rock; and as drawn
masses() { # MASS RADIUS SETTING...: of one cube
    "$scree" check mixed.yaml --set insertions='[]' --set 'particles={from: single, shape: cube, position: [4, 4, 4], radius: 1}' "${@:3}" |
        awk -v mass="$1" -v radius="$2" '/^rocks/ { cube = /cube/ } cube && /each:/ { print; split($0, w, /[ ,:]+/); good = w[4] == radius && w[6] == mass } END { exit !good }'
}
check 'equal volume is the rule' masses 8.37758 1.33702
check 'size: grain scales the ball' masses 3.50511 1 --set bodies.shapes[0].size=grain
check 'size: drawn has the size of the entry' masses 2 0.829423 --set bodies.shapes[0].size=drawn

# A file whose radii are those of the volume: those above a bound stay out, by the radii of the file
printf 'x y z radius\n2 2 2 0.4\n6 6 6 0.5\n2 6 4 0.42\n' >table.txt
check 'a file, with a bound' masses 0.620678 0.56155 --set 'particles={from: file, file: table.txt, format: table, shape: cube, radius_above: 0.41, radius_upto: 0.45}'

# A box around a packing of rocks, with sand between them: the fractions are true ones, and no balls overlap
cat >packed.yaml <<'YAML'
units: none
box: {periodic: true}
step: {dt: 1e-4, count: 0}
contact: {law: hooke}
materials: [{name: a, density: 1}]
material_pairs: [{k_n: 1e4, restitution: 0.5}]
particles:
  sources:
    - {from: packed, shape: cube, count: 40, volume_fraction: 0.15, sizes: 1}
    - {from: packed, count: 300, sizes: 0.3}
bodies: {shapes: [{name: cube, vertices: [0,0,0, 1,0,0, 0,1,0, 1,1,0, 0,0,1, 1,0,1, 0,1,1, 1,1,1], rounding: 0.05}]}
observables: {every: 1, list: [{name: solid_fraction}, {name: bodies}, {name: particles}, {name: contacts}]}
output: {checkpoint: {at_end: false}}
YAML
packs() { # the fraction of both: 0.15 (1 + 300 x 0.3^3 / 40)
    run_scene 1 packed.yaml packed && tail -n 1 packed/observables.csv | awk -F, '{ print "  solid fraction " $2 ", bodies " $3 ", contacts " $5; exit !(($2 / 0.15 / (1 + 300 * 0.027 / 40) - 1) ^ 2 < 1e-16 && $3 == 40 && $5 == 0) }'
}
check 'a packing of rocks and sand to a fraction' packs
yields() { # sand that gives way to rocks
    run_scene 2 packed.yaml yields --set particles.sources[1].meets=yield && tail -n 1 yields/observables.csv | awk -F, '{ exit !($3 == 40 && $4 == 340 && $5 == 0) }'
}
check 'sand that gives way to rocks, on 2 ranks' yields

# The stable step knows the rocks that come
step_of() { "$scree" check mixed.yaml --set particles='~' "$@" | sed -n 's/^time step.*of the stable \([0-9.e+-]*\).*/\1/p'; }
stable() {
    local rocks spheres
    rocks=$(step_of --set 'insertions=[{shape: cube, rate: 1, sizes: 0.3}]')
    spheres=$(step_of --set 'insertions=[{rate: 1, sizes: 0.3}]' --set bodies='~' --set output.dump='~')
    awk -v a="$rocks" -v b="$spheres" 'BEGIN { print "  stable step of cubes " a ", of spheres of this mass " b; exit !(a > 0 && a < 0.6 * b) }'
}
check 'the stable step knows the rocks that come' stable

# In two dimensions: clumps by the ball
flat() {
    run_scene 1 mixed.yaml flat --overwrite --set reproducible=false --set 'box={lower: [0, 0, 0], upper: [8, 8, 0], dimension: 2, periodic: true}' --set gravity=[0,0,0] --set walls='[]' --set insertions='[]' \
        --set 'bodies={clumps: [{name: dumbbell, spheres: [{centre: [-1, 0, 0], radius: 1}, {centre: [1, 0, 0], radius: 1}]}]}' --set 'particles={sources: [{from: random, shape: dumbbell, count: 9, sizes: 0.5}, {from: random, count: 9, sizes: 0.3}]}' \
        --set 'observables={every: 1000, list: [{name: bodies}, {name: particles}]}' --set 'output={checkpoint: {at_end: false}}' --set step.count=10 && tail -n 1 flat/observables.csv | awk -F, '{ exit !($2 == 9 && $3 == 27) }'
}
check 'clumps in two dimensions' flat

# The examples, small and short
check 'rocks in a drum, a hopper and a heap' env OMP_NUM_THREADS=1 SCREE="$scree" "$top_srcdir/examples/rocks/check" --quick "$out/examples"
check 'packings of cubes and tetrahedra under a pressure' env OMP_NUM_THREADS=1 SCREE="$scree" "$top_srcdir/examples/rock_packing/check" --quick "$out/packings"

# Messages
wrong() { # TEXT SETTING...
    check "refused: $1" scene_refused "$1" mixed.yaml "${@:2}"
}
wrong "particles.sources[0].shape: no entry of bodies has the name 'cubes'; allowed: dumbbell, cube, ballast" --set particles.sources[0].shape=cubes
wrong "insertions[1].shape: no entry of bodies has the name 'x'" --set insertions[1].shape=x
wrong "particles.sources[0].shape: 'cube', and the scene has no section bodies" --set bodies='~'
wrong "particles.sources[0].shape: 2 entries of bodies have the name 'cube'" --set bodies.shapes[1].name=cube --set particles.sources[2].shape=cube --set insertions[0].shape=cube
wrong "bodies.shapes[0].material: a source names the entry 'cube' (shape)" --set bodies.shapes[0].material=a
wrong "bodies.shapes[0].radius_above: a source names the entry 'cube' (shape)" --set bodies.shapes[0].radius_above=0.1
wrong "bodies.shapes[1].radius_upto: a source names the entry 'ballast' (shape)" --set bodies.shapes[1].radius_upto=2
wrong "bodies.shapes[1]: size: volume needs a source or an insertion that names the entry (shape)" --set bodies.shapes[1].size=volume --set insertions[0].shape=cube --set particles.sources[2].shape=cube
wrong "particles.sources[0].volume_fraction: the part of a ball that its body fills is not known" --set bodies.shapes[0].size=drawn
wrong "particles.sources[0].sizes: the body 'cube' as drawn has a ball of radius 0.829423" --set bodies.shapes[0].size=drawn --set 'particles.sources[0]={from: random, shape: cube, count: 3, sizes: 0.4}'
wrong "equal spheres placed at random (balls around bodies, which fill 0.418 of them) end at 0.159" --set 'particles.sources[0]={from: random, shape: cube, volume_fraction: 0.3, sizes: 0.4}'
wrong "the volume of the balls around the bodies is" --set 'particles.sources[0]={from: packed, shape: cube, volume_fraction: 0.5, sizes: 0.4}'
wrong "insertions[0].sizes: the largest diameter, 12.77" --set insertions[0].sizes=4
wrong "particles.sources[0].spacing: 1.1 is less than the largest diameter, 1.337" --set 'particles.sources[0]={from: lattice, lattice: sc, spacing: 1.1, shape: cube, sizes: 0.5}'
wrong "bodies.clumps[0].size: volume: not in two dimensions" --set 'box={lower: [0, 0, 0], upper: [8, 8, 0], dimension: 2}' --set insertions='[]' --set walls='[]' --set gravity=[0,0,0] \
    --set 'bodies={clumps: [{name: dumbbell, size: volume, spheres: [{centre: [0, 0, 0], radius: 1}]}]}' --set 'particles={from: random, shape: dumbbell, count: 2, sizes: 1}'
finish
