#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Slow flow through an array of spheres: run.sh [DIR]. Draws the plane through the centres into DIR/spheres.png.
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
out=${1:-$(results out)}
on_ranks "${SCREE_RANKS:-1}" "$SCREE" run "$here/scene.yaml" -o "$out" --overwrite --set fluid.spacing=0.03125
"$here/../flow.sh" "$out" "$out/spheres.png" 0.05 0.484375 0.01
