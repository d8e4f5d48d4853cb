#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# What bounds a fluid: meshes, finite cylinders, packings from a file, open sides; the forces on bodies; and what makes no sense.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

# box NAME LOWER UPPER...: closed boxes in one STL file, corners as "x y z"; normals point out of each
boxes() {
    printf '%s\n' "${@:2}" | awk -v name="$1" '
        function facet(a, b, c) { print "facet normal 0 0 0\nouter loop"; print "vertex", p[a]; print "vertex", p[b]; print "vertex", p[c]; print "endloop\nendfacet" }
        BEGIN { print "solid", name }
        NR % 2 { split($0, l); next }
        { split($0, u)
          for (k = 0; k < 8; k++) p[k] = (k % 2 ? u[1] : l[1]) " " (int(k / 2) % 2 ? u[2] : l[2]) " " (k > 3 ? u[3] : l[3])
          split("0 2 1 1 2 3 4 5 6 5 7 6 0 1 4 1 5 4 2 6 3 3 6 7 0 4 2 2 4 6 1 3 5 3 7 5", f)
          for (k = 1; k <= 36; k += 3) facet(f[k], f[k + 1], f[k + 2]) }
        END { print "endsolid" }' >"$1.stl"
}
boxes plates '0 -0.5 0' '0.5 0 0.5' '0 1 0' '0.5 1.5 0.5'
boxes cube '0.3 0.3 0.3' '0.7 0.7 0.7'
awk '/^facet/ && !gone { skip = 1 } !skip { print } /^endfacet/ && skip { skip = 0; gone = 1 }' cube.stl >broken.stl

cat >plates.yaml <<'YAML'
units: none
box: {lower: [0, -0.5, 0], upper: [0.5, 1.5, 0.5], periodic: [true, false, true]}
walls:
  - {name: plates, shape: mesh, file: plates.stl}
fluid: {spacing: 0.0625, density: 1, viscosity: 1, equations: stokes, time: steady, drive: {body_force: [1, 0, 0]}, solver: {tolerance: 1e-9}}
step: {count: 1}
observables: {every: 1, list: [{name: fluid_velocity, components: x}, {name: drag}]}
YAML
sed '/name: plates/c\  - {name: lower, shape: plane, point: [0, 0, 0], normal: [0, 1, 0]}\n  - {name: upper, shape: plane, point: [0, 1, 0], normal: [0, -1, 0]}' plates.yaml >planes.yaml

needs_petsc planes.yaml 'bodies in a fluid'

run() { # RANKS SCENE SETTING...
    local ranks=$1 scene=$2
    shift 2
    rm -rf "$scene.$ranks"
    run_scene "$ranks" "$scene.yaml" "$scene.$ranks" --set threads=1 "$@"
}

plates() {
    run 1 planes && run 1 plates && run 2 plates &&
        within "$(last_of plates.1 fluid_velocity_x)" "$(last_of planes.1 fluid_velocity_x)" 1e-9 &&
        within "$(last_of plates.2 fluid_velocity_x)" "$(last_of planes.1 fluid_velocity_x)" 1e-7 &&
        within "$(last_of plates.1 drag_plates_x)" 0.25 1e-5 && within "$(last_of planes.1 drag_lower_x)" 0.125 1e-5 &&
        within "$(last_of planes.1 drag_lower_viscous_x)" 0.125 1e-5
}
check "plates of a mesh are planes, and carry the body force" plates

cat >cube.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [1, 1, 1], periodic: true}
walls: [{name: cube, shape: mesh, file: cube.stl}]
fluid: {spacing: 0.0625, density: 1, viscosity: 1, equations: stokes, time: steady, drive: {body_force: [1, 0, 0]}, solver: {tolerance: 1e-6}}
step: {count: 1}
observables: {every: 1, list: [{name: drag/cube, label: body}, {name: fluid_porosity}]}
YAML
sed 's/shape: mesh, file: cube.stl/shape: cylinder, point: [0.5, 0.5, 0.5], axis: [0, 0, 1], radius: 0.2, length: 0.4, inside: false/' cube.yaml >capped.yaml
balance() { # SCENE POROSITY WITHIN: the force on the body is that on the fluid; no torque
    run 1 "$1" && within "$(last_of "$1.1" fluid_porosity)" "$2" "$3" &&
        within "$(last_of "$1.1" body_x)" "$(last_of "$1.1" fluid_porosity)" 1e-4 && within "$(last_of "$1.1" body_torque_z)" 0 1e-6 &&
        within "$(last_of "$1.1" body_viscous_x)" "$(awk -v f="$(last_of "$1.1" body_x)" -v p="$(last_of "$1.1" body_pressure_x)" 'BEGIN { printf "%.12g", f - p }')" 1e-9
}
check "a cube from a mesh" balance cube 0.936 0.02
felt() { # its surface is that of the field: flat where the faces are
    local viscous=$(last_of cube.1 body_viscous_x)
    run 1 cube --set 'walls[0].field=true' && within "$(last_of cube.1 body_viscous_x)" "$viscous" 1e-4
}
check "a cube that is felt by a field" felt
check "a cylinder with ends" balance capped 0.9497 0.01

# Flow between an inlet and an outlet, and between two pressures, is Poiseuille's; drop = 12 mu U L / H^2
cat >channel.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [1, 0.5, 0], dimension: 2}
walls:
  - {name: lower, shape: plane, point: [0, 0, 0], normal: [0, 1, 0]}
  - {name: upper, shape: plane, point: [0, 0.5, 0], normal: [0, -1, 0]}
fluid:
  spacing: 0.03125
  density: 1
  viscosity: 0.1
  equations: stokes
  time: steady
  open:
    - {side: x_lower, velocity: [1.5, 0, 0], profile: parabolic}
    - {side: x_upper, pressure: 2}
  solver: {tolerance: 1e-7}
step: {count: 1}
observables: {every: 1, list: [{name: drag/lower}, {name: flow_rate}]}
output: {dump: {every: 1, fields: [position, velocity, pressure]}}
YAML
# profile DIR DROP OUT [P]: in the middle half, largest error of u, of v and of p against U = 1
profile() {
    awk -v drop="$2" -v end="$3" -v most="${4:-0.3}" '/^ITEM: TIMESTEP/ { u = v = p = n = 0; next }
        /^ITEM: ATOMS/ { for (k = 3; k <= NF; k++) at[$k] = k - 2; reading = 1; next } /^ITEM/ { reading = 0 }
        reading { x = $at["x"]; s = $at["y"] / 0.5; if (x < 0.25 || x > 0.75 || s < 0 || s > 1) next
            e = $at["vx"] - 6 * s * (1 - s); u = e * e > u ? e * e : u; e = $at["vy"]; v = e * e > v ? e * e : v
            e = $at["pressure"] - end - drop * (1 - x); p = e * e > p ? e * e : p; n++ }
        END { printf "  %d particles, errors of u %.3g, v %.3g, p %.3g\n", n, sqrt(u), sqrt(v), sqrt(p); exit !(n == 256 && u < 0.0065 ^ 2 && v < 0.002 ^ 2 && p < most ^ 2) }' "$1/dump.lammpstrj"
}
check "an inlet and an outlet" run 1 channel
check "their flow is that of Poiseuille, and the pressure does not alternate" profile channel.1 4.8 2 0.03
check "the wall carries half of the drop" within "$(last_of channel.1 drag_lower_x)" 1.2 0.04
check "on 3 ranks" run 3 channel
check "it is the same" within "$(last_of channel.1 drag_lower_x)" "$(last_of channel.3 drag_lower_x)" 2e-4
check "two pressures" run 1 channel --set 'fluid.open=[{side: x_lower, pressure: 6.8}, {side: x_upper, pressure: 2}]'
check "their flow is that of Poiseuille, too" profile channel.1 4.8 2
between=$(last_of channel.1 flow_rate_x)
check "a force in a periodic channel" run 1 channel --set 'fluid.open=[]' --set 'box.periodic=[true, false, false]' --set 'fluid.drive.body_force=[4.8, 0, 0]'
check "drives the same flow" within "$between" "$(last_of channel.1 flow_rate_x)" 1e-5
check "in time, with inertia" run 1 channel --set fluid.time=transient --set fluid.equations=navier_stokes --set 'fluid.initial={velocity: [1, 0, 0]}' \
    --set fluid.solver.tolerance=1e-4 --set 'step={dt: 0.01, count: 120}' --set output.dump.every=120
check "ends as that of Poiseuille" profile channel.1 4.8 2

# Spheres in a row between an inlet and an outlet: less than 0.5 % of the water gets lost, and each has the drag of one in a periodic array (the ends have some percent more).
cat >row.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [4, 1, 1], periodic: [false, true, true]}
particles: {from: file, format: table, file: row.txt, columns: [x, y, z, radius], density: 1, group: bed}
groups: [{name: bed, motion: frozen}]
fluid:
  spacing: 0.1
  density: 1
  viscosity: 1
  equations: stokes
  time: steady
  open: [{side: x_lower, velocity: [1, 0, 0]}, {side: x_upper, pressure: 0}]
step: {count: 1}
observables: {every: 1, list: [{name: fluid}, {name: drag/bed}]}
output: {checkpoint: {at_end: false}, dump: {every: 1, fields: [position, velocity]}}
YAML
printf '%s\n' '1 0.5 0.5 0.4' '2 0.5 0.5 0.4' '3 0.5 0.5 0.4' >row.txt
kept() { # the flow through each layer of particles without spheres
    awk '/^ITEM: ATOMS/ { for (k = 3; k <= NF; k++) at[$k] = k - 2; reading = 1; next } /^ITEM/ { reading = 0 }
        reading && $at["vx"] != 0 && ($at["x"] < 0.4 || $at["x"] > 3.6) { flow[int($at["x"] / 0.1)] += $at["vx"] / 100; n++ }
        END { for (k in flow) { least = least == "" || flow[k] < least ? flow[k] : least; most = flow[k] > most ? flow[k] : most }
            printf "  %.5f to %.5f through %d particles\n", least, most, n; exit !(n == 800 && least > 0.995 && most < 1.005) }' row.1/dump.lammpstrj
}
check "spheres between an inlet and an outlet" run 1 row
check "less than 0.5 % of the water gets lost" kept
check "in 64 iterations at most" awk -v n="$(last_of row.1 fluid_iterations)" 'BEGIN { exit !(n <= 64) }'
drag=$(last_of row.1 drag_bed_x)
check "on 2 ranks" run 2 row
check "the drag is the same" within "$(last_of row.2 drag_bed_x)" "$drag" 0.1
printf '%s\n' '0.5 0.5 0.5 0.4' >row.txt
check "a periodic array" run 1 row --set 'box.upper=[1, 1, 1]' --set box.periodic=true --set 'fluid.open=[]' --set 'fluid.drive={mass_flow: 1, axis: x}'
check "its drop is that of a sphere of the row" within "$(awk -v all="$drag" 'BEGIN { print all / 3 }')" "$(last_of row.1 pressure_drop_x)" 2.2

# In time, through narrower gaps: the mean flow is that of the inlet (2 % more with plain operators), and it ends as the steady one.
printf '%s\n' '1 0.5 0.5 0.47' '2 0.5 0.5 0.47' '3 0.5 0.5 0.47' >row.txt
in_time=(--set fluid.time=transient --set 'step={dt: 0.01, count: 12}' --set output.dump.every=12)
in_time() {
    run 1 row "${in_time[@]}" && within "$(last_of row.1 flow_rate_x)" 1 0.001 && ! grep 'gets lost' said
}
check "a flow in time loses less than 0.1 % between spheres" in_time
drag=$(last_of row.1 drag_bed_x)
check "on 2 ranks" run 2 row "${in_time[@]}"
check "the drag is the same, too" within "$(last_of row.2 drag_bed_x)" "$drag" 0.1
check "the steady flow" run 1 row
check "has that drag, to 1 %" within "$(last_of row.1 drag_bed_x)" "$drag" 6.5
lost() {
    run 1 row "${in_time[@]}" --set step.dt=1 && [ "$(grep -c 'warning: fluid.open: between the open sides 0.0[0-9]* of the flow gets lost in step 1' said)" = 1 ]
}
check "steps that are long against diffusion over a spacing lose some, and the run says so once" lost

# A force that a closed end holds: nothing flows but the noise of the solver, of which some comes in through the open end and all gets lost
still() {
    run 1 channel --set 'walls=[]' --set 'box.periodic=[false, true, false]' --set 'fluid.open=[{side: x_lower, velocity: [0, 0, 0]}, {side: x_upper, pressure: 0}]' \
        --set 'fluid.drive.body_force=[4.8, 0, 0]' --set fluid.spacing=0.0625 --set fluid.fill.jitter=0.2 --set fluid.time=transient --set 'step={dt: 0.01, count: 60}' \
        --set 'observables.list=[{name: fluid_speed}]' --set output.dump.every=60 && within "$(last_of channel.1 fluid_speed)" 0 1e-3 && lacks said 'gets lost'
}
check "a fluid that stays at rest loses nothing" still
# The same within a mesh: baffles that leave slits of two spacings, below the first and above the second (6 % of the flow lost and 24 % more drag with plain operators)
boxes baffles '0.5 0.125 -1' '0.75 1.5 1.5' '1.25 -0.5 -1' '1.5 0.875 1.5'
cat >baffles.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [2, 1, 0.3125], periodic: [false, false, true]}
walls:
  - {name: baffles, shape: mesh, file: baffles.stl}
  - {name: lower, shape: plane, point: [0, 0, 0], normal: [0, 1, 0]}
  - {name: upper, shape: plane, point: [0, 1, 0], normal: [0, -1, 0]}
fluid:
  spacing: 0.0625
  density: 1
  viscosity: 1
  equations: stokes
  open: [{side: x_lower, velocity: [0.01, 0, 0]}, {side: x_upper, pressure: 0}]
  initial: {velocity: [0.01, 0, 0]}
step: {dt: 0.004, count: 12}
observables: {every: 1, list: [{name: fluid_velocity, components: x}, {name: drag/baffles}]}
output: {checkpoint: {at_end: false}}
YAML
slits() {
    run 1 baffles && within "$(last_of baffles.1 fluid_velocity_x)" 0.01 1e-4 && ! grep 'gets lost' said
}
check "a flow in time loses less than 1 % in slits of a mesh" slits
drag=$(last_of baffles.1 drag_baffles_x)
check "the steady flow between the baffles" run 1 baffles --set fluid.time=steady --set step.count=1
check "has that drag, too, to 2 %" within "$(last_of baffles.1 drag_baffles_x)" "$drag" 0.2

# Grains of a packing in a file stand in the fluid; gaps between them that the spacing does not resolve are named.
printf '%s\n' '0.2 0.3 0.5 0.15' '0.2 0.7 0.5 0.15' '0.5 0.35 0.5 0.14' >packing.txt
sed -e '/^walls/d' -e 's/drag\/cube/drag\/bed/' cube.yaml >packing.yaml
cat >>packing.yaml <<'YAML'
particles: {from: file, format: table, file: packing.txt, columns: [x, y, z, radius], density: 1, group: bed}
groups: [{name: bed, motion: frozen}]
YAML
packing() {
    run 1 packing && grep -q 'note: packing.yaml:[0-9]*: fluid.spacing: is too coarse for [0-9]* gaps between grains.*between grains 1 and 3, is 0.' said &&
        within "$(last_of packing.1 body_x)" "$(last_of packing.1 fluid_porosity)" 1e-4 &&
        run 2 packing && within "$(last_of packing.2 body_x)" "$(last_of packing.1 body_x)" 1e-4
}
check "a packing from a file, its narrow gaps and its drag" packing

gaps() { # SCENE NARROW WORDS SETTING...: what check says of gaps
    "$scree" check --all "$1.yaml" "${@:4}" >said 2>&1 && grep -q "gaps *NOTE: $2 are below 2 spacings; the narrowest, between $3, is" said || { cat said; return 1; }
}
printf '%s\n' '0.1 0.5 0.5 0.13' '0.8 0.5 0.5 0.13' >packing.txt
check "a gap across a periodic side" gaps packing '1 between grains and 0 between grains and walls' 'grains 1 and 2'
disc=(--set 'particles={from: single, position: [0.5, 0.15, 0], radius: 0.13, density: 1, group: bed}' --set 'groups=[{name: bed, motion: frozen}]')
check "a gap between a grain and a wall" gaps channel '0 between grains and 1 between grains and walls' "grain 1 and wall 'lower'" "${disc[@]}"
check "the note of a run names it, too" grep -q "scree: note: channel.yaml:.*fluid.spacing: is too coarse for 0 gaps between grains and 1 between grains and walls" said

# A dense random packing at 6.5 spacings a diameter and a Reynolds number of 30: with advection by plain central differences the largest speed was 200 times the mean one after
# 25 steps, and the run stopped; Stokes flow has 16.
inertia() {
    "$scree" pack discrete dense.h5 diameters=1 weights=1 count=32 fraction=0.58 seed=1 --overwrite --quiet
    rm -rf inertia
    "$scree" run "$top_srcdir/examples/ergun/scene.yaml" -o inertia --quiet --set 'particles.sources[0].file='"$PWD/dense.h5" --set fluid.spacing=0.153418196586867 \
        --set 'fluid.drive.body_force=[0, 0, 32762.4]' --set step.dt=8e-5 --set step.count=60 >said 2>&1 || { cat said; return 1; }
    awk -v fast="$(last_of inertia fluid_speed)" -v mean="$(last_of inertia fluid_velocity_z)" 'BEGIN { printf "  mean %g, largest %g\n", mean, fast; exit !(mean > 15 && fast < 25 * mean) }'
}
check "a flow with inertia in narrow throats does not grow without bound" inertia

check "an open side without a condition" scene_refused 'channel.yaml:|fluid.fill|needed there|x_upper' channel.yaml --set 'fluid.open=[{side: x_lower, velocity: [1, 0, 0]}]'
check "a side with two conditions" scene_refused 'fluid.open[0]|not both' channel.yaml --set 'fluid.open=[{side: x_lower, velocity: [1, 0, 0], pressure: 1}, {side: x_upper, pressure: 0}]'
check "a side with none" scene_refused 'fluid.open[1]|not none' channel.yaml --set 'fluid.open=[{side: x_lower, velocity: [1, 0, 0]}, {side: x_upper}]'
check "a side twice" scene_refused 'fluid.open[1].side|twice' channel.yaml --set 'fluid.open=[{side: x_lower, velocity: [1, 0, 0]}, {side: x_lower, pressure: 0}]'
check "a side behind a wall" scene_refused 'fluid.open[2].side|no fluid lies at y_lower' channel.yaml --set 'fluid.open=[{side: x_lower, velocity: [1, 0, 0]}, {side: x_upper, pressure: 0}, {side: y_lower, pressure: 0}]'
check "a periodic side" scene_refused 'fluid.open[0].side|periodic' cube.yaml --set 'fluid.open=[{side: x_lower, pressure: 0}]'
check "more flows in than out" scene_refused 'fluid.open|balance' channel.yaml --set 'fluid.open=[{side: x_lower, velocity: [1, 0, 0]}, {side: x_upper, velocity: [0.5, 0, 0]}]'
check "a mesh with a hole" scene_refused 'walls[0].file|3 edges' cube.yaml --set 'walls[0].file=broken.stl'
check "a mesh in two dimensions" scene_refused 'walls[0].file|two dimensions' channel.yaml --set 'walls=[{name: a, shape: mesh, file: cube.stl}]'
check "a body that is not there" scene_refused 'drag|there is no wall or group "sphere"|cube' cube.yaml --set 'observables.list=[{name: drag/sphere}]'
finish
