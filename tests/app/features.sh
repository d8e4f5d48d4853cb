#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Features with features (docs/features.md). Each scene has many at once: the state at the end is the same to the last bit on one rank,
# on two, and after a resume half-way on other ranks. Closed scenes keep momentum and energy. What does not go together is refused by
# name.
set -u
. "$top_srcdir/tests/app/common.sh"
find_bisection
cd "$out" || exit 1

cat >space.yaml <<'EOF'
units: none
seed: 3
reproducible: true
threads: 1
gravity: [0, 0, -1]
box: {lower: [-1, 0, 2], upper: [7, 8, 10], periodic: [true, true, false]}
step: {dt: 0.002, count: 100, force: true}
contact: {law: hooke}
materials: [{name: a, density: 1}, {name: b, density: 2}]
material_pairs: [{restitution: 0.7, friction: 0.4, k_n: 2000}]
guards: {overlap: warn, energy: off}
walls:
  - {name: floor, shape: plane, point: [0, 0, 2], normal: [0, 0, 1], material: a}
  - {name: lid, shape: plane, point: [0, 0, 10], normal: [0, 0, -1], material: a}
particles:
  sources:
    - {from: random, count: 70, sizes: {law: uniform, min: 0.35, max: 0.6}, velocity_sigma: 2, material: a}
    - {from: random, count: 10, sizes: 0.5, velocity_sigma: 2, material: b}
observables: {every: 25, list: [{name: energy}, {name: momentum}, {name: contacts}]}
output: {checkpoint: {every: 50, keep: 9}}
EOF
sed 's/^gravity: .*/gravity: [0, -1]/; s/^box: .*/box: {dimension: 2, lower: [-1, 2], upper: [15, 10], periodic: [true, false]}/
    s/point: \[0, 0, \([0-9]*\)\], normal: \[0, 0, \(-*1\)\]/point: [0, \1], normal: [0, \2]/
    s/count: 70/count: 50/' space.yaml >plane.yaml

awk 'BEGIN { split("0 2 1 1 2 3 4 5 6 5 7 6 0 1 4 1 5 4 2 6 3 3 6 7 0 4 2 2 4 6 1 3 5 3 7 5", c) # a cube
    for (t = 0; t < 12; t++) { for (k = 1; k <= 3; k++) { v = c[3 * t + k]; printf "%d %d %d ", v % 2, int(v / 2) % 2, int(v / 4) } print "" } }' >lump.txt

# What a feature sets, in three dimensions and, where it differs, in two; separated by lines
declare -A sets=(
    [hertz]='contact.law=hertz
material_pairs[0].k_n=~
materials=[{name: a, density: 1, young: 3000, poisson: 0.2}, {name: b, density: 2, young: 4000, poisson: 0.3}]'
    [luding]='contact.law=luding
material_pairs[0].k_2=4000
material_pairs[0].k_c=500'
    [rolling]='contact.rolling=spring
contact.twisting=marshall
material_pairs[0].rolling_friction=0.2'
    [capillary]='contact.cohesion=capillary
material_pairs[0].surface_tension=3
material_pairs[0].bridge_fraction=0.02'
    [clumps]='bodies.clumps=[{material: b, spheres: [{centre: [-0.5, 0, 0], radius: 1}, {centre: [0.7, 0, 0], radius: 0.8}]}]'
    [bonds]='bonds={gap: 0.25, laws: [{k_n: 2000, k_s: 800, radius: 0.6, tensile_strength: 150, shear_strength: 150}]}'
    [heat]='heat={temperature: 300, materials: [{conductivity: 2, capacity: 3}], gas: {conductivity: 0.1, distance: 0.1, roughness: 0.01}, dissipation: 1}'
    [hot]='heat.walls=[{wall: floor, temperature: 400}]'
    [drag]='drag={law: di_felice, fluid: {density: 0.1, viscosity: 0.05, velocity: [0.5, 0, 0]}, porosity: {support: 3.5}}'
    [stokes]='drag={law: stokes, fluid: {density: 0.1, viscosity: 0.05, velocity: [0.5, 0, 0]}}'
    [stokes-plane]='drag={law: stokes, fluid: {density: 0.1, viscosity: 0.05, velocity: [0.5, 0]}}'
    [density]='number_density.support=1.5'
    [mesh]='walls[floor]={name: floor, shape: rectangle, point: [-1, 0, 2], along: [8, 0, 0], across: [0, 8, 0], material: a}'
    [mesh-plane]='walls[floor]={name: floor, shape: rectangle, point: [-1, 2, -1], along: [0, 0, 2], across: [16, 0, 0], material: a}'
    [moving]='walls[floor].motion=[{kind: oscillate, direction: [1, 0, 0.3], amplitude: 0.2, frequency: 2}]'
    [moving-plane]='walls[floor].motion=[{kind: oscillate, direction: [1, 0.3], amplitude: 0.2, frequency: 2}]'
    [servo]='walls[lid].motion=[{kind: servo, direction: [0, 0, 1], force: 50, speed_max: 2}]'
    [servo-plane]='walls[lid].motion=[{kind: servo, direction: [0, 1], force: 50, speed_max: 2}]'
    [free]='walls[2]={name: block, shape: box, lower: [2, 3, 6], upper: [3.5, 4, 6.6], material: a, free: {density: 1, angular_velocity: [0, 1, 0]}}'
    [touch]='walls[2]={name: block, shape: box, lower: [2, 3, 9.4], upper: [3.5, 4, 10.02], material: a, free: {density: 1, angular_velocity: [0, 1, 0]}}
wall_contacts={rounding: 0.05, pairs: [{walls: [block, lid]}]}'
    [field]='walls[3]={name: lump, shape: mesh, file: lump.txt, format: table, scale: 1.5, offset: [4, 4, 2.5], field: true, field_spacing: 0.1, material: a}'
    [free-plane]='walls[2]={name: block, shape: box, lower: [2, 6, -1], upper: [4, 7, 1], material: a, free: {mass: 2, angular_velocity: [0, 0, 1]}}'
    [closed]='walls=~
box.periodic=true
gravity=[0, 0, 0]'
    [closed-plane]='walls=~
box.periodic=true
gravity=[0, 0]'
    [sheared]='box.shear={rate: 0.5, flow: x, gradient: y}'
    [long]='box.upper=[13, 8, 10]'
    [strained]='box.strain.rate=[-0.1, 0.05, 0]'
    [strained-plane]='box.strain.rate=[-0.1, 0.05]'
    [squeezed]='box.strain.rate=[-0.1, 0]'
    [stressed]='box.stress={xx: 5, yy: 5}'
    [stressed-plane]='box.stress={yy: 5}'
    [insertion]='insertions=[{region: {shape: box, lower: [0, 1, 8], upper: [6, 7, 10]}, sizes: 0.3, rate: 100, velocity: [0, 0, -1], material: a}]'
    [insertion-plane]='insertions=[{region: {shape: box, lower: [0, 8], upper: [14, 10]}, sizes: 0.3, rate: 100, velocity: [0, -1], material: a}]'
    [more-clumps]='insertions=[{region: {shape: box, lower: [0, 1, 8], upper: [6, 7, 10]}, sizes: 0.5, rate: 100, velocity: [0, 0, -3], material: b}]'
    [more-clumps-plane]='insertions=[{region: {shape: box, lower: [0, 8], upper: [14, 10]}, sizes: 0.5, rate: 100, velocity: [0, -3], material: b}]'
    [deletion]='deletions=[{region: {shape: box, lower: [-1, 0, 2], upper: [7, 4, 3]}, every: 20}]'
    [deletion-plane]='deletions=[{region: {shape: box, lower: [-1, 2], upper: [7, 3]}, every: 20}]'
    [leave]='walls=~
box.leave={z_upper: delete, z_lower: delete}'
    [stages]='step.count=~
stages=[{name: one, duration: 0.12}, {name: two, duration: 0.08, set: {gravity: [1, 0, -1]}}]'
    [stages-plane]='step.count=~
stages=[{name: one, duration: 0.12}, {name: two, duration: 0.08, set: {gravity: [1, -1]}}]'
    [groups]='groups=[{name: moves, motion: moving, velocity: [0.5, 0, 0]}, {name: held, motion: frozen}]
particles.sources[0].count=60
particles.sources[2]={from: random, count: 6, sizes: 0.4, material: a, group: moves}
particles.sources[3]={from: random, count: 4, sizes: 0.4, material: a, group: held}'
    [groups-plane]='groups=[{name: moves, motion: moving, velocity: [0.5, 0]}, {name: held, motion: frozen}]
particles.sources[0].count=60
particles.sources[2]={from: random, count: 6, sizes: 0.4, material: a, group: moves}
particles.sources[3]={from: random, count: 4, sizes: 0.4, material: a, group: held}'
    [packed]='particles.sources[0].from=packed
particles.sources[1].from=packed'
    [grids]='observables.grids=[{name: g, cells: [4, 1, 4]}, {name: c, cells: [1, 1, 8], kernel: gauss, width: 0.5}]
observables.list=[{name: energy}, {name: sum, of: mass * (vx * vx + vy * vy), label: k}, {name: stress}, {name: largest, of: y, label: top}]'
    [grids-plane]='observables.grids=[{name: g, cells: [4, 4, 1]}, {name: c, cells: [1, 8, 1], kernel: gauss, width: 0.5}]
observables.list=[{name: energy}, {name: sum, of: mass * (vx * vx + vy * vy), label: k}, {name: stress}, {name: largest, of: y, label: top}]'
    [files]='output.trajectory={every: 50, contacts: {steps: 50}}
output.dump.every=50'
    [vtk]='output.walls.every=50'
    [auto]='skin=auto'
    [verlet]='integrator=velocity_verlet'
)
for law in thornton eepa jkr; do sets[$law]=${sets[hertz]}; done
sets[thornton]+=$'\ncontact.law=thornton\nmaterial_pairs[0].yield_pressure=500'
sets[eepa]+=$'\ncontact.law=eepa\nmaterial_pairs[0].plasticity_ratio=0.5\nmaterial_pairs[0].adhesion_energy=1'
sets[jkr]+=$'\ncontact.cohesion=jkr\nmaterial_pairs[0].surface_energy=3'

# everywhere SCENE FEATURE...: the same bits on other layouts, and after a resume
everywhere() {
    local scene=$1 flags
    take "$@"
    rm -rf one two again
    run_scene 1 "$scene.yaml" one --set index=brute "${flags[@]}" && checkpoint_lines one/checkpoint-100.h5 >one.lines &&
        run_scene 2 "$scene.yaml" two --set index=hgrid "${flags[@]}" && checkpoint_lines two/checkpoint-100.h5 | cmp - one.lines &&
        run_scene 3 "$scene.yaml" again --set index=linkcell --set domain="$bisection" --resume one/checkpoint-50.h5 "${flags[@]}" &&
        checkpoint_lines again/checkpoint-100.h5 | cmp - one.lines
}
together() { # SCENE FEATURE...: on a line of its own
    check "$*" everywhere "$@"
}
together space hertz rolling clumps heat hot drag mesh moving grids files vtk packed free field
together space bonds clumps heat hot stokes density mesh servo insertion stages grids packed free field touch
together space jkr clumps stokes density moving servo insertion groups files auto free field
together space capillary bonds heat drag mesh moving deletion groups grids verlet files vtk packed free
together space thornton clumps heat hot density servo mesh groups stages
together space eepa bonds clumps drag density mesh moving insertion deletion auto
together space luding rolling bonds heat density groups leave insertion
together space hertz rolling jkr insertion deletion stages servo heat hot drag
together space capillary rolling clumps drag groups servo stages auto
together space rolling clumps more-clumps deletion servo heat hot stokes stages groups grids files
together space jkr clumps more-clumps deletion leave density drag auto
together space hertz heat stokes density grids files rolling closed sheared deletion stages packed
together space luding clumps heat stokes density grids files closed stressed auto packed
together space jkr clumps heat drag grids closed strained deletion stages packed
together space capillary clumps drag density files long closed sheared strained
together space rolling heat closed deletion stages verlet stressed # gravity comes in a stage
together space hertz drag moving deletion groups files vtk auto touch
together plane clumps heat hot stokes density moving grids files vtk packed free
together plane hertz bonds heat stokes servo insertion deletion groups stages free
together plane hertz clumps more-clumps deletion leave heat stokes grids
together plane jkr rolling clumps mesh insertion moving stages auto
together plane luding clumps heat stokes density closed sheared grids
together plane capillary heat closed squeezed stressed files packed

# keeps SCENE FEATURE...: in a closed box momentum to rounding, and the balance of energies to a part of what is there, on two ranks in the
# fast mode
keeps() {
    local scene=$1 flags
    take "$@"
    rm -rf kept
    run_scene 2 "$scene.yaml" kept --set reproducible=false --set step.dt=0.0005 --set step.count=400 --set observables.every=100 \
        --set 'observables.list=[{name: momentum}, {name: energy_balance}, {name: energy_kinetic}, {name: energy_dissipated}]' "${flags[@]}" &&
        awk -F, 'NR == 1 { for (k = 1; k <= NF; k++) { sub(/\[.*/, "", $k); at[$k] = k } next }
            NR == 2 { first = $at["energy_balance"]; size = $at["energy_kinetic"]; for (d = 0; d < 3; d++) p[d] = $(at["momentum_x"] + d) }
            { e = $at["energy_balance"] - first; e = e < 0 ? -e : e; if (e > energy) energy = e
              for (d = 0; d < 3; d++) { m = $(at["momentum_x"] + d) - p[d]; m = m < 0 ? -m : m; if (m > moment) moment = m } }
            END { printf "  momentum within %.1g, energy within %.1g of %.3g, of which %.3g was lost\n", moment, energy, size, $at["energy_dissipated"]
                  exit !(NR == 6 && size > 0 && moment < 1e-11 * size && energy < 0.002 * size) }' kept/observables.csv
}
balanced() {
    check "balance: $*" keeps "$@"
}
balanced space hertz rolling clumps heat density closed
balanced space bonds heat closed verlet
balanced space luding rolling bonds clumps density closed auto
balanced space thornton clumps closed
balanced space eepa bonds heat closed
balanced plane hertz clumps heat closed
balanced plane bonds clumps heat closed

# refused WORDS SCENE FEATURE...: `check` names the key and the reason
sets[hooke-jkr]=$'contact.cohesion=jkr\nmaterial_pairs[0].surface_energy=3'
refused() {
    local words=$1 flags
    shift
    take "$@"
    scene_refused "$words" "$1.yaml" "${flags[@]}"
}
named() {
    check "refused: ${*:2}" refused "$@"
}
named 'bonds: does not go with a box that moves' space bonds closed stressed
named 'box.shear: does not go with walls' space sheared
named 'box.shear: does not go with groups' space closed groups sheared
named 'box.stress: does not go with insertions' space closed insertion stressed
named 'box.stress.xx: the edge along x has a rate by box.strain' space closed stressed strained
named 'drag.law: a law with a porosity needs a box of three dimensions' plane drag
named 'heat.walls[0].wall|known: none' space heat hot closed
named 'output.walls.every: the scene has no walls' space closed vtk
named 'contact.cohesion.law: jkr goes with contact.law hertz, thornton' space hooke-jkr

# Discs that a fluid moves, beside other features: the same places on two ranks, to the tolerance of its solver
cat >flow.yaml <<'EOF'
units: none
threads: 1
box: {dimension: 2, lower: [0, 0], upper: [4, 4], periodic: true}
gravity: [0, -1]
step: {dt: 0.01, count: 6, force: true}
contact: {law: hooke}
materials: [{name: a, density: 3}]
material_pairs: [{restitution: 0.7, friction: 0.4, k_n: 200}]
particles: {sources: [{from: single, position: [1, 1.5], radius: 0.5}, {from: single, position: [1.95, 1.5], radius: 0.5}, {from: single, position: [3.2, 3.2], radius: 0.4}]}
fluid: {spacing: 0.2, density: 1, viscosity: 1, motion: lagrangian, grains: free, solver: {tolerance: 1e-9}}
observables: {every: 6, list: [{name: momentum}, {name: fluid_velocity}]}
output: {dump: {every: 6, fields: [id, position]}, checkpoint: {at_end: false}}
EOF
sets[bonds-flow]='bonds={gap: 0.01, laws: [{k_n: 100, k_s: 50}]}'
sets[heat-flow]='heat={temperature: 300, materials: [{conductivity: 2, capacity: 3}], dissipation: 1}'
sets[stages-flow]=$'step.count=~\nstages=[{name: a, duration: 0.03}, {name: b, duration: 0.03, set: {gravity: [1, 0]}}]'
sets[deletion-flow]='deletions=[{region: {shape: box, lower: [0, 1], upper: [1.5, 2]}, every: 5}]'
sets[insertion-flow]='insertions=[{sizes: 0.2, rate: 100}]'
sets[reproducible-flow]='reproducible=true'
sets[sheared-flow]='box.shear={rate: 0.5, flow: x, gradient: y}'
sets[clumps-flow]='bodies.clumps=[{spheres: [{centre: [-0.1, 0, 0], radius: 1}, {centre: [0.1, 0, 0], radius: 1}]}]'
sets[rigid-flow]=$'fluid.spacing=0.16\nfluid.motion=fixed\nfluid.grains={motion: free, coupling: rigid}'
sets[solved-flow]=$'contact={law: rigid, solver: {sweeps: 50}}\nmaterial_pairs[0].k_n=~'
sets[stokes-flow]=${sets[stokes-plane]}
sets[capillary-flow]=${sets[capillary]} sets[density-flow]=${sets[density]} sets[verlet-flow]=${sets[verlet]}
last_frame() { tail -n "$(sed -n '/NUMBER OF ATOMS/{n;p;}' "$1/dump.lammpstrj" | tail -n 1)" "$1/dump.lammpstrj" | sort -n; }
nearly() { # FEATURE...
    local flags
    take flow "$@"
    rm -rf one two
    run_scene 1 flow.yaml one "${flags[@]}" && run_scene 2 flow.yaml two "${flags[@]}" &&
        paste -d ' ' <(last_frame one) <(last_frame two) | awk '
            function off(a, b) { a -= b; a -= 4 * int(a / 4 + (a > 0 ? 0.5 : -0.5)); return a < 0 ? -a : a }
            { n = NF / 2; if ($1 != $(n + 1)) bad = 1; for (k = n - 2; k < n; k++) if (off($k, $(n + k)) > worst) worst = off($k, $(n + k)) }
            END { printf "  %d particles, places within %.1g\n", NR, worst; exit bad || NR < 300 || worst > 1e-7 }'
}
if "$scree" check flow.yaml >said 2>&1; then
    check 'a fluid with bonds heat density verlet' nearly bonds heat density verlet
    check 'a fluid with capillary stages' nearly capillary stages
    check 'a fluid with rigid grains, bonds heat density verlet' nearly rigid bonds heat density verlet
    check 'a fluid with rigid grains, capillary stages' nearly rigid capillary stages
    check 'a fluid with rigid bodies, heat stages' nearly rigid clumps heat stages
    check 'a fluid with rigid grains, a solver of contacts, density stages' nearly rigid solved density stages
    named 'deletions: would take grains out of the fluid' flow deletion
    named 'insertions: grains cannot be inserted into a fluid' flow insertion
    named 'reproducible: the linear systems of a fluid' flow reproducible
    named 'fluid: does not go with a box that moves' flow sheared
    named 'fluid: a fluid around bodies needs coupling: rigid' flow clumps
    named 'drag.fluid: is a second fluid' flow stokes
else
    grep -q 'built without PETSc' said || { cat said; check 'a build without PETSc says so' false; }
    skip "a fluid with other features: $(cat said)"
fi
finish
