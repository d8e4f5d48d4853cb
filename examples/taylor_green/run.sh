#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Four vortices decay: run.sh [DIR]. Prints the energy at the end beside the exact one, and draws DIR/vortices.png.
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
out=${1:-$(results out)}
on_ranks "${SCREE_RANKS:-1}" "$SCREE" run "$here/scene.yaml" -o "$out" --overwrite
awk -F , 'NR == 1 { for (k = 1; k <= NF; k++) if ($k ~ /fluid_energy/) e = k } { last = $e; t = $1 }
    END { pi = atan2(0, -1); printf "kinetic energy at t = %g: %.6g; exact: %.6g\n", t, last, 0.25 * exp(-0.16 * pi * pi * t) }' "$out/observables.csv"
"$here/../flow.sh" "$out" "$out/vortices.png" 0.04
