#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# A lid drives the fluid in a square cavity: run.sh [DIR]. Draws DIR/cavity.png.
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
out=${1:-$(results out)}
on_ranks "${SCREE_RANKS:-1}" "$SCREE" run "$here/scene.yaml" -o "$out" --overwrite --set fluid.spacing=0.015625 --set step.dt=7.8125e-3
"$here/../flow.sh" "$out" "$out/cavity.png" 0.08
