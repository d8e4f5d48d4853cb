#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# From Darcy's flow to Forchheimer's: a periodic random packing at rising Reynolds numbers, beside Ergun. inertia.sh [DIR]
#
# SPHERES spheres (32) of diameter 1 at a porosity of 0.42, by `scree pack`, ACROSS spacings a diameter (10). The flow is given, the force that keeps it up
# is what is looked for; the flow of Navier and Stokes goes on until the force no longer changes. Prints a line of JSON for each Reynolds number of
# NUMBERS ("0 1 5 20 60"; 0: Stokes), of velocity over the cross-section and diameter:
# friction is force d^2 porosity^3 / (viscosity velocity (1 - porosity)^2): 180 of Carman, 150 + 1.75 Re / (1 - porosity) of Ergun.
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
out=${1:-$(results out-inertia)}
across=${ACROSS:-10}
mkdir -p "$out"
"$SCREE" pack power "$out/spheres.h5" --overwrite --quiet count="${SPHERES:-32}" min=0.5 max=0.5 fraction=0.58 seed="${SEED:-1}"
cat >"$out/scene.yaml" <<YAML
title: Water through a random packing that repeats
units: none
box: {periodic: true}
particles: {from: file, format: h5md, file: spheres.h5, density: 1, group: bed}
groups: [{name: bed, motion: frozen}]
fluid: {spacing: 0.1, density: 1, viscosity: 1, drive: {mass_flow: 1, axis: x}}
observables: {every: 1, list: [{name: fluid}]}
output: {checkpoint: {at_end: false}}
YAML
