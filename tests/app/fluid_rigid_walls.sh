#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Walls that move through a fluid in which the flow is rigid in solids (tests/app/fluid_rigid.sh has grains): a rod is a disc of a given motion, a prism that turns in a bore has the torque of
# Couette's flow, a paddle and a rod stir grains on all layouts and after a resume, and what does not go.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

# A rod crosses a periodic side, as a disc of a group does, beside a free disc
cat >rod.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [32, 24, 0], dimension: 2, periodic: [true, false, false]}
walls:
  - {name: floor, shape: plane, point: [0, 0, 0], normal: [0, 1, 0]}
  - {name: lid, shape: plane, point: [0, 24, 0], normal: [0, -1, 0]}
  - {name: rod, shape: cylinder, point: [24.3, 12.2, 0], axis: [0, 0, 1], radius: 4, inside: false, motion: [{kind: translate, velocity: [0.5, -0.05, 0]}]}
particles: {from: single, position: [8.2, 14, 0], radius: 3, density: 0.3}
fluid: {spacing: 1, density: 1, viscosity: 0.2, grains: {motion: free, coupling: rigid}}
step: {dt: 0.5, count: 40}
observables: {every: 40, list: [{name: fluid_velocity}, {name: fluid_energy}, {name: fluid_porosity}, {name: position, id: 1}, {name: velocity, id: 1}, {name: drag, target: rod}]}
output: {checkpoint: {every: 20}}
YAML
needs_petsc rod.yaml 'walls that move through a fluid'
walled() { run_scene 1 rod.yaml rod --set threads=1; }
disc=(--set 'walls=[{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 1, 0]}, {name: lid, shape: plane, point: [0, 24, 0], normal: [0, -1, 0]}]'
    --set 'groups=[{name: moved, motion: moving, velocity: [0.5, -0.05, 0]}]' --set 'particles={sources: [{from: single, position: [8.2, 14, 0], radius: 3, density: 0.3}, {from: single, position: [24.3, 12.2, 0], radius: 4, density: 0.3, group: moved}]}'
    --set 'observables.list=[{name: fluid_velocity}, {name: fluid_energy}, {name: fluid_porosity}, {name: position, id: 1}, {name: velocity, id: 1}, {name: drag, target: moved}]')
alike() {
    run_scene 1 rod.yaml disc --set threads=1 "${disc[@]}" && rows_close rod disc 1e-3 && awk -v f="$(last_of rod drag_rod_x)" 'BEGIN { printf "  force %.4g\n", f; exit !(f < -0.5) }'
}
check "a rod moves across a periodic side" walled
check "a disc with the same motion moves the fluid alike" alike
check "scree check names it" eval "\"\$scree\" check --all rod.yaml | grep -q \"wall 'rod' moves through the fluid\""
again() { # SCENE DIR RANKS BOUND FLAG...
    local scene=$1 dir=$2 ranks=$3 bound=$4
    shift 4
    rm -rf other
    run_scene "$ranks" "$scene.yaml" other --set threads=1 "$@" && rows_close "$dir" other "$bound"
}
same() { cmp <(tail -n 1 "$1/observables.csv") <(tail -n 1 other/observables.csv); }
check "the same on 2 ranks, to the tolerance" again rod rod 2 2e-3
check "a resume gives the same bits" eval 'again rod rod 1 0 --resume rod/checkpoint-20.h5 && same rod'
check "a resume on 2 ranks agrees to the tolerance" again rod rod 2 2e-3 --resume rod/checkpoint-20.h5

# A prism of 48 sides, longer than the periodic box, turns in a bore: 4 pi mu rate r^2 R^2 / (R^2 - r^2) a length; the bore feels the same
awk -v n=48 'BEGIN {
    pi = 3.14159265358979; r = 5 * sqrt(2 * pi / n / sin(2 * pi / n)); print "solid prism"
    for (k = 0; k < n; k++) {
        x = 12 + r * cos(2 * pi * k / n); y = 12 + r * sin(2 * pi * k / n); u = 12 + r * cos(2 * pi * (k + 1) / n); v = 12 + r * sin(2 * pi * (k + 1) / n)
        facet(x, y, -3, u, v, -3, u, v, 9); facet(x, y, -3, u, v, 9, x, y, 9); facet(12, 12, 9, x, y, 9, u, v, 9); facet(12, 12, -3, u, v, -3, x, y, -3)
    }
    print "endsolid" }
    function facet(a, b, c, d, e, f, g, h, i) { printf "facet normal 0 0 0\nouter loop\nvertex %.9g %.9g %.9g\nvertex %.9g %.9g %.9g\nvertex %.9g %.9g %.9g\nendloop\nendfacet\n", a, b, c, d, e, f, g, h, i }' >prism.stl
cat >couette.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [24, 24, 6], periodic: [false, false, true]}
walls:
  - {name: bore, shape: cylinder, point: [12, 12, 0], axis: [0, 0, 1], radius: 11}
  - {name: prism, shape: mesh, file: prism.stl, motion: [{kind: rotate, direction: [0, 0, 1], point: [12, 12, 0], rate: 0.1}]}
fluid: {spacing: 1, density: 1, viscosity: 1, equations: stokes, grains: {coupling: rigid}}
step: {dt: 2, count: 40}
observables: {every: 40, list: [{name: drag, target: prism}, {name: drag, target: bore}]}
output: {checkpoint: {at_end: false}}
YAML
couette() {
    run_scene 1 couette.yaml couette --set threads=1 && awk -v t="$(last_of couette drag_prism_torque_z)" -v o="$(last_of couette drag_bore_torque_z)" 'BEGIN {
        exact = 6 * 4 * 3.14159265358979 * 0.1 * 25 * 121 / 96; printf "  torques over the closed form: %.4g and %.4g\n", -t / exact, o / exact
        exit !(-t > 0.96 * exact && -t < 1.04 * exact && o > 0.98 * -t && o < 1.02 * -t) }'
}
check "a prism that turns in a bore" couette

# A drum full of water and discs, in which a blade turns about the middle and a rod swings: two dimensions
cat >stir.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [48, 48, 0], dimension: 2, density: area}
gravity: [0, -0.0833333, 0]
walls:
  - {name: drum, shape: cylinder, point: [24, 24, 0], axis: [0, 0, 1], radius: 22}
  - {name: blade, shape: box, lower: [8, 22, -5], upper: [40, 26, 5], motion: [{kind: rotate, direction: [0, 0, 1], point: [24, 24, 0], rate: 0.02}]}
  - {name: rod, shape: cylinder, point: [24, 38, 0], axis: [0, 0, 1], radius: 2.5, inside: false, motion: [{kind: oscillate, direction: [1, 0, 0], amplitude: 3, frequency: 0.02}]}
contact: {law: hertz}
materials: [{name: glass, density: 2.5, young: 1000, poisson: 0.3}]
material_pairs: [{restitution: 0.2, friction: 0.5}]
particles: {from: file, format: table, file: discs.txt, columns: [x, y, z, radius]}
fluid: {spacing: 1, density: 1, viscosity: 0.2, grains: {motion: free, every: 20, hydraulic: 0.8}}
step: {dt: 0.0125, count: 1600}
observables: {every: 400, list: [{name: centre}, {name: energy_kinetic}, {name: fluid_velocity}, {name: fluid_speed}, {name: drag, target: blade}, {name: drag, target: rod}, {name: wall_force, target: blade}]}
output: {checkpoint: {every: 800}}
YAML
printf '%s\n' '18 7 0 3' '24.5 6 0 3' '31 7.5 0 3' '22 12.5 0 3' '28 13 0 3' '20 30.2 0 3' >discs.txt
stirs() {
    rm -rf stir
    run_scene 1 stir.yaml stir --set threads=1 && awk -v t="$(last_of stir drag_blade_torque_z)" -v v="$(last_of stir fluid_speed)" -v e="$(last_of stir energy_kinetic)" \
        'BEGIN { printf "  torque on the blade %.4g, water up to %.3g, grains %.3g\n", t, v, e; exit !(t < -1 && v > 0.2 && v < 2 && e > 0) }'
}
check "a blade and a rod stir water and grains" stirs
check "the same on 2 ranks, to the tolerance" again stir stir 2 5e-3
check "the same with another index and 2 threads" again stir stir 1 5e-4 --set index=hgrid --set threads=2
check "a resume gives the same bits" eval 'again stir stir 1 0 --resume stir/checkpoint-800.h5 && same stir'
check "a resume on 2 ranks agrees to the tolerance" again stir stir 2 5e-3 --resume stir/checkpoint-800.h5
solved=(--set 'contact={law: rigid, solver: {sweeps: 100, tolerance: 1e-6}}' --set 'materials=[{name: glass, density: 2.5}]' --set step.dt=0.25 --set step.force=true --set fluid.grains.every=1
    --set step.count=80 --set observables.every=20 --set output.checkpoint.every=40)
solves() { rm -rf stir && run_scene 1 stir.yaml stir --set threads=1 "${solved[@]}" && again stir stir 2 5e-3 "${solved[@]}" && again stir stir 1 0 "${solved[@]}" --resume stir/checkpoint-40.h5 && same stir; }
check "with a solver of contacts: 2 ranks, a resume" solves
near=(--set fluid.grains.hydraulic=1 --set fluid.grains.lubrication=0.02)
lubricated() { rm -rf stir && run_scene 1 stir.yaml stir --set threads=1 "${near[@]}" && again stir stir 2 5e-3 "${near[@]}" && again stir stir 1 0 "${near[@]}" --resume stir/checkpoint-800.h5 && same stir; }
check "with lubrication: 2 ranks, a resume" lubricated

# A blade that stops in a later stage stays where it is, and the fluid stays out of it
staged=(--set step.count=~ --set 'stages=[{name: turn, duration: 10}, {name: rest, duration: 10, set: {"walls[blade].motion": []}}]')
stops() {
    rm -rf stir
    run_scene 1 stir.yaml stir --set threads=1 "${staged[@]}" && awk -v s="$(last_of stir fluid_porosity)" -v t="$(last_of stir drag_blade_torque_z)" 'BEGIN { printf "  porosity %.4g, torque %.4g\n", s, t
        exit !(s > 0.5 && s < 0.7 && t > 1) }'
}
check "a blade that stops in a stage stays" eval 'staged+=(--set "observables.list=[{name: drag, target: blade}, {name: fluid_porosity}]"); stops'

# What does not go
leaves_alone() { # WORDS SETTING...: the run stops in its first step
    local words=$1
    shift
    rm -rf other
    on 1 "$scree" run rod.yaml -o other --quiet "$@" >said 2>&1
    [ $? = 2 ] && grep -q "$words" said || { cat said; return 1; }
}
check "a plane that moves into the fluid stops the run" leaves_alone 'a wall moves towards the fluid.*coupling: rigid' --set 'walls[1].motion=[{kind: translate, velocity: [0, -0.1, 0]}]'
check "mirrors of a wall that moves stop the run" leaves_alone 'a wall moves towards the fluid' --set 'fluid.grains={motion: given, coupling: mirror}' --set particles.group=moved --set 'groups=[{name: moved, motion: frozen}]'
sed 's/^vertex/v/' prism.stl | awk '$1 == "v" { n++; line[n % 3] = $0; if (n % 3 == 0) { print "facet normal 0 0 0\nouter loop"; print line[2]; print line[1]; print line[0]; print "endloop\nendfacet" } }' | sed 's/^v /vertex /' |
    sed '1i solid inward' >inward.stl
echo endsolid >>inward.stl
check "a mesh whose normals point into it" scene_refused 'walls[1].file|point into it' couette.yaml --set walls[1].file=inward.stl
check "a blade that leans, in two dimensions" scene_refused 'walls[1].shape|sides that lean' stir.yaml --set 'walls[1].upper=[40, 26, 0.5]'
check "a servo" scene_refused 'walls[1].motion[0]|servo' stir.yaml --set 'walls[1].motion=[{kind: servo, direction: [0, 1, 0], force: 1, speed_max: 0.1}]'
check "a free wall" scene_refused 'walls[1].free|bodies' stir.yaml --set 'walls[1]={name: blade, shape: box, lower: [8, 22, -5], upper: [40, 26, 5], free: {mass: 100}}'

# A cylinder that turns about its axis alone keeps its mirrors
mirrored() { ! "$scree" check --all stir.yaml --set 'walls[2].motion=[{kind: rotate, direction: [0, 0, 2], point: [24, 38, 1], rate: 1}]' | grep "wall 'rod' moves through"; }
check "a rod that turns about its axis bounds the fluid" mirrored
check "a blade stirs water, grains and a dye" env SCREE="$scree" SCREE_ARGS='--set threads=1' sh "$top_srcdir/examples/mixer/check" "$out/mixer"
finish
