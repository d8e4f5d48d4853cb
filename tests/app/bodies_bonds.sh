#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Bonds between members of bodies: momentum and energy while bonds hold and break, a body of one sphere beside the sphere, bodies that are
# deleted with their bonds, the stable step; ranks, indexes and a resume; messages.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

rows() { # DIR: the last frame of the dump, by id
    tail -n "+$(grep -n '^ITEM: ATOMS' "$1/dump.lammpstrj" | tail -n 1 | cut -d : -f 1)" "$1/dump.lammpstrj" | grep -v '^ITEM' | sort -n
}

cat >bonds.yaml <<'YAML'
units: none
seed: 3
threads: 1
reproducible: true
box: {lower: [0, 0, 0], upper: [5, 5, 5], periodic: true}
step: {dt: 0.0003, count: 400}
contact: {law: hooke}
materials: [{name: a, density: 1}, {name: b, density: 2}]
material_pairs: [{restitution: 0.7, friction: 0.4, k_n: 2000}]
particles:
  sources:
    - {from: random, count: 40, sizes: {law: uniform, min: 0.35, max: 0.5}, velocity_sigma: 1.5, omega: [1, 0, 2], material: a}
    - {from: random, count: 40, sizes: 0.3, velocity_sigma: 1.5, material: b}
bodies: {clumps: [{name: triple, material: a, spheres: [{centre: [-1, 0, 0], radius: 1}, {centre: [1, 0, 0], radius: 1}, {centre: [0, 1, 0], radius: 0.7}]}]}
bonds: {gap: 0.2, laws: [{k_n: 2000, k_s: 800, radius: 0.6, tensile_strength: 150, shear_strength: 150}]}
observables: {every: 50, list: [{name: momentum}, {name: energy_balance}, {name: energy_kinetic}, {name: bonds}]}
output: {dump: {every: 200, fields: [id, position, velocity, angular_velocity]}, checkpoint: {every: 200}}
YAML
rock='bodies={shapes: [{name: rock, material: a, random: {corners: 14, variants: 5}, roundness: 0.2}]}'
none='bodies=~'
ball='bodies={clumps: [{name: ball, material: a, spheres: [{centre: [0, 0, 0], radius: 1}]}]}'

kept() { # DIR: momentum to rounding, energy to a thousandth of what there is; bonds hold, and some break
    awk -F, 'NR == 1 { for (k = 1; k <= NF; k++) { sub(/\[.*/, "", $k); at[$k] = k } next }
        NR == 2 { for (k = 2; k < 6; k++) first[k] = $k; all = $at["bonds_whole"] }
        { for (k = 2; k < 5; k++) { d = $k - first[k]; p += d * d } d = ($5 - first[5]) / $6; d = d < 0 ? -d : d; if (d > e) e = d; left = $at["bonds_whole"] }
        END { printf "  momentum %.2g, energy %.2g, bonds %d of %d\n", sqrt(p), e, left, all; exit !(NR == 10 && p < 1e-24 && e < 1e-3 && left > 5 && left < all) }' "$1/observables.csv"
}
everywhere() { # SETTING...
    rm -rf one other more
    run_scene 1 bonds.yaml one --set index.name=hgrid "$@" && rows one >one.rows && kept one && run_scene 2 bonds.yaml other --set index.name=brute "$@" && rows other | cmp - one.rows &&
        run_scene 4 bonds.yaml other --overwrite --set index.name=linkcell "$@" && rows other | cmp - one.rows &&
        run_scene 3 bonds.yaml more --resume one/checkpoint-200.h5 "$@" && rows more | cmp - one.rows
}
check 'bonded clumps: momentum, energy, the same bits everywhere' everywhere
check 'bonded rocks' everywhere --set "$rock"
check 'bonded clumps that are deleted' run_scene 2 bonds.yaml gone --set 'deletions=[{region: {shape: box, lower: [0, 0, 0], upper: [3, 5, 5]}, every: 100}]'
lost() { tail -n 1 gone/observables.csv | awk -F, '{ print "  bonds " $7; exit !($7 >= 0 && $7 < 20) }'; }
check 'their bonds are gone, too' lost
as_spheres() {
    run_scene 1 bonds.yaml spheres --set "$none" && run_scene 1 bonds.yaml balls --set "$ball" && paste -d, spheres/observables.csv balls/observables.csv | awk -F, 'NR > 1 { n = NF / 2
        for (k = 2; k <= n; k++) { d = $k - $(n + k); d = d < 0 ? -d : d; if (d > most) most = d } } END { printf "  largest difference %.2g\n", most; exit !(NR == 10 && most < 1e-8) }'
}
check 'a bonded body of one sphere moves as the sphere' as_spheres

run_scene 1 bonds.yaml ids --set step.count=1 --set 'output={checkpoint: {at_end: false}, dump: {every: 1, fields: [id, body, body_part]}}' >/dev/null
rows ids | awk '$3 == 1 { print $1 }' | head -n 2 | paste -s -d ' ' >own.txt
one_body() {
    ! run_scene 1 bonds.yaml refused --set 'bonds.gap=~' --set bonds.list=own.txt 2>said && grep -q 'are of one rigid body' said || { cat own.txt said; return 1; }
}
check 'refused: a bond inside of a body' one_body
echo '1 41' >own.txt # of a centre
centre() { ! run_scene 1 bonds.yaml refused --set 'bonds.gap=~' --set bonds.list=own.txt 2>said && grep -q 'particle 1 is no grain' said || { cat said; return 1; }; }
check 'refused: a bond of the centre of a body' centre

# Two bonded cubes that overlap: where the bond stands for their contact, this bounds no step
cat >cubes.yaml <<'YAML'
units: none
box: {lower: [-5, -5, -5], upper: [5, 5, 5]}
step: {fraction: 1, count: 1}
contact: {law: hertz}
materials: [{name: rock, density: 1, young: 1e6, poisson: 0.3}]
material_pairs: [{restitution: 0.3, friction: 0.5}]
particles:
  sources:
    - {from: single, position: [0, 0, 0], radius: 1}
    - {from: single, position: [0, 0, 0.95], radius: 1}
bodies:
  shapes: [{name: cube, vertices: [0,0,0, 1,0,0, 0,1,0, 1,1,0, 0,0,1, 1,0,1, 0,1,1, 1,1,1], rounding: 0.05, size: drawn, orientation: given, quaternion: [1, 0, 0, 0]}]
bonds: {gap: 0.2, laws: [{k_n: 200, k_s: 80, radius: 0.6}]}
output: {checkpoint: {at_end: false}}
YAML
step_of() { # DIR SETTING...
    run_scene 1 cubes.yaml "$@" && sed -n 's/.*"dt": \([^,]*\),.*/\1/p' "$1/report.json" >"$1.step"
}
stands() {
    step_of apart --set particles.sources[1].position=[0,0,1.05] && step_of touch && step_of bonded --set bonds.contacts=false &&
        paste apart.step touch.step bonded.step | awk '{ print "  steps " $1 ", " $2 " with the contact, " $3 " without"; exit !($2 < 0.9 * $1 && $3 == $1) }'
}
check 'a contact for which a bond stands bounds no step' stands
finish
