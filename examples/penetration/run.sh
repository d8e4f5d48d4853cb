#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The demonstration: run.sh [DIR]
# Runs the case of scene.yaml from just above the bed, where the ball arrives after 20.5 ms of free fall, until it has
# bounced; prints how deep it went and draws DIR/depth.svg and DIR/penetration.png. DIR is out beside this script if not given.
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
out=${1:-$(results out)}

# where a ball thrown from z = 0.06 m at 5 m/s is after 20.5 ms, and how fast
"$SCREE" run "$here/scene.yaml" -o "$out" --overwrite \
    --set "particles.sources[1].position=[0, 0, -0.0445615]" --set "particles.sources[1].velocity=[0, 0, -5.201105]" \
    --set duration="12.5 ms" --set "output.trajectory.every={time: 2.5 ms}"

awk -F, -v surface=-0.0555472 -v radius=0.01 '
    NR == 1 { for (k = 1; k <= NF; k++) if ($k ~ /^ball_z\[/) z = k; next }
    NR == 2 || $z < low { low = $z; when = $1 }
    END { printf "the ball went %.1f mm deep into the bed, %.1f ms after the throw\n", 1e3 * (surface - low + radius),
        1e3 * when + 20.5 }' "$out/observables.csv"

if command -v gnuplot >/dev/null; then
    gnuplot -e "ours='$out/observables.csv'; lammps='$here/lammps.csv'; start=20.5; picture='$out/depth.svg'" "$here/depth.gp"
    echo "drawn: $out/depth.svg (depth over time)"
else
    echo "no gnuplot here, so the depth is not drawn"
fi
if command -v povray >/dev/null; then
    # the bed cut open before the ball, its beads in the colours of the layers in which they lay
    "$SCREE" picture "$out" -o "$out/penetration.png" --overwrite --frame -2 --colour z@0 --bands 6 --grey steel --cut 'y<0' --view 0,6 \
        --size 1500x900 --bare
    echo "drawn: $out/penetration.png (the ball in its crater)"
else
    echo "no POV-Ray here, so the ball is not drawn"
fi
