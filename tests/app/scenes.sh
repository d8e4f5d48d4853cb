# SPDX-License-Identifier: BSD-3-Clause
# Sourced by tests of the whole program (bash, after common.sh): scenes that several of them run, without units, step and output.

# bed: writes the scene to the standard output, and the mesh step.stl of the scene into the current folder. Friction, rolling, two
# materials, periodic sides, a floor that oscillates, a lid that a servo pushes until the pressure under the lid is right, a mesh, a frozen
# particle
bed() {
    local above='{shape: box, lower: [0, 0, 1.6], upper: [6, 6, 8]}'
    printf 'solid step\nfacet normal 0 0 1\nouter loop\nvertex 1 1 1.5\nvertex 5 1 1.5\nvertex 3 5 1.5\nendloop\nendfacet\nendsolid\n' >step.stl
    cat <<EOF
box: {lower: [0, 0, 0], upper: [6, 6, 9], periodic: [true, true, false]}
gravity: [0, 0, -1]
materials: [{name: soft, density: 1}, {name: hard, density: 2}]
contact: {law: hooke, rolling: spring}
material_pairs: [{restitution: 0.6, friction: 0.5, rolling_friction: 0.05, k_n: 1500}]
walls:
  - {name: floor, shape: plane, material: hard, point: [0, 0, 0.2], normal: [0, 0, 1],
     motion: [{kind: oscillate, direction: [0, 0, 1], amplitude: 0.1, frequency: 5}]}
  - {name: lid, shape: plane, material: hard, point: [0, 0, 8.2], normal: [0, 0, -1],
     motion: [{kind: servo, direction: [0, 0, 1], pressure: 1.4, speed_max: 2}]}
  - {name: step, shape: mesh, material: soft, file: step.stl}
groups: [{name: stuck, motion: frozen, select: {ids: [12]}}]
particles:
  sources:
    - {from: random, count: 12, material: hard, velocity_sigma: 4, sizes: 0.9, region: $above}
    - {from: random, count: 300, material: soft, velocity_sigma: 4, sizes: {law: uniform, min: 0.22, max: 0.35}, region: $above}
skin: {relative: 0.2}
EOF
}
