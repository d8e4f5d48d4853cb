#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Runs the case and draws the zone counts: run.sh [DIR [SECONDS]]
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
out=${1:-$(results out)}
"$SCREE" run "$here/scene.yaml" -o "$out" --overwrite --set duration="${2:-0.5} s"
if command -v gnuplot >/dev/null; then
    gnuplot -e "ours='$out/observables.csv'; lammps='$here/lammps-1.csv'; again='$here/lammps-2.csv'; picture='$out/zones.svg'" \
        "$here/zones.gp"
    echo "drawn: $out/zones.svg"
fi
