#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Bodies in the fluid of drag: a rock falls at the speed of the sphere of its volume, a body of the fluid's density stays, whatever its members
# overlap; ranks, indexes and a resume; messages.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

rows() { # DIR: the last frame of the dump, by id
    tail -n "+$(grep -n '^ITEM: ATOMS' "$1/dump.lammpstrj" | tail -n 1 | cut -d : -f 1)" "$1/dump.lammpstrj" | grep -v '^ITEM' | sort -n
}

cat >fall.yaml <<'YAML'
units: none
seed: 3
threads: 1
reproducible: true
box: {lower: [0, 0, 0], upper: [5, 5, 5], periodic: true}
gravity: [0, 0, -10]
step: {dt: 0.0005, count: 4000}
contact: {law: hooke}
materials: [{name: a, density: 3}, {name: b, density: 3}]
material_pairs: [{restitution: 0.7, friction: 0.4, k_n: 2000}]
particles: {from: single, position: [2, 2, 2], radius: 1, material: a}
bodies: {shapes: [{name: cube, material: a, vertices: [0,0,0, 1,0,0, 0,1,0, 1,1,0, 0,0,1, 1,0,1, 0,1,1, 1,1,1], rounding: 0.1, size: drawn, angular_velocity: [1, 2, 0]}]}
drag: {law: stokes, fluid: {density: 1, viscosity: 1.5}}
observables: {every: 2000, list: [{name: velocity, id: 1, components: z}, {name: energy_balance}, {name: energy_kinetic}]}
output: {dump: {every: 2000, fields: [id, position, velocity, angular_velocity]}, checkpoint: {every: 2000}}
YAML
clump='bodies={clumps: [{name: pair, material: a, spheres: [{centre: [-0.5, 0, 0], radius: 1}, {centre: [0.5, 0, 0], radius: 1}]}]}'

# A cube of edge 1: (3 - 1) g / (6 pi mu r), 4/3 pi r^3 = 1
falls() { # RANKS
    run_scene "$1" fall.yaml fall --overwrite && tail -n 1 fall/observables.csv | awk -F, '{ pi = atan2(0, -1); u = -20 / (6 * pi * 1.5 * (0.75 / pi) ^ (1 / 3)); print "  " $2 ", closed form " u; off = $2 / u - 1; exit !(off < 1e-5 && off > -1e-5) }'
}
check 'a cube falls as the sphere of its volume' falls 1
check 'on 2 ranks' falls 2
floats() { # SETTING...
    run_scene 1 fall.yaml float --overwrite --set drag.fluid.density=3 --set guards.energy=off "$@" && tail -n 1 float/observables.csv | awk -F, '{ print "  " $2; exit !($2 < 1e-12 && $2 > -1e-12) }'
}
check 'a rock of the density of the fluid stays' floats
check 'so does a clump whose members overlap' floats --set "$clump"

many=(--set 'particles={sources: [{from: random, count: 40, sizes: {law: uniform, min: 0.35, max: 0.5}, velocity_sigma: 2, material: a}, {from: random, count: 30, sizes: 0.3, velocity_sigma: 2, material: b}]}' --set step.count=400 --set step.dt=0.0003
    --set observables.every=100 --set output.dump.every=200 --set output.checkpoint.every=200)
everywhere() { # SETTING...
    rm -rf one other more
    run_scene 1 fall.yaml one --set index.name=hgrid "${many[@]}" "$@" && rows one >one.rows && run_scene 2 fall.yaml other --set index.name=brute "${many[@]}" "$@" && rows other | cmp - one.rows &&
        run_scene 3 fall.yaml more --resume one/checkpoint-200.h5 "${many[@]}" "$@" && rows more | cmp - one.rows
}
check 'rocks: the same bits everywhere' everywhere --set 'bodies={shapes: [{name: rock, material: a, random: {corners: 14, variants: 5}, roundness: 0.2}]}'
check 'clumps that overlap' everywhere --set "$clump"
check 'refused: rocks with a porosity' scene_refused 'drag.law: a porosity is a sum over spheres' fall.yaml --set drag.law=di_felice --set drag.porosity.support=4
finish
