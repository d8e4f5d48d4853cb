#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# A gas of inelastic spheres in scree and in Yade, from the same state: run.sh [DIR]
# Prints a JSON line: the largest differences of the kinetic energy until 4 ms and until 40 ms, and the seconds of one thread each. Exit status 1 if the
# energies differ by more than 0.1 % until 4 ms or 5 % until 40 ms (collisions are chaotic). Needs Debian's package yade (YADE: the program); without
# it the stored energies of Yade 2023.02a are compared.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
out=${1:-$(results out)}
# shellcheck disable=SC2086
"$SCREE" run "$here/gas.yaml" -o "$out" --overwrite --quiet --set threads=1 ${SCREE_ARGS:-} >&2
cp "$here/yade.csv" "$out/yade.csv"
if command -v "${YADE:-yade}" >/dev/null; then
    awk '/^ITEM: TIMESTEP/ { frame++ } /^ITEM: ATOMS/ { on = frame == 1; for (k = 3; k <= NF; k++) at[$k] = k - 2; next } /^ITEM/ { on = 0 }
        on { print $at["x"], $at["y"], $at["z"], $at["radius"], $at["vx"], $at["vy"], $at["vz"] }' "$out/dump.lammpstrj" >"$out/state"
    (cd "$out" && OMP_NUM_THREADS=1 "${YADE:-yade}" -n -x "$here/gas.py" state yade.csv >yade.log 2>&1)
fi
awk -F, -v ours="$(report_number "$out" seconds)" -v spheres="$(report_number "$out" particles)" '
    /^# seconds/ { split($0, part, " "); theirs = part[3]; next }
    FNR == 1 { file++; next }
    file == 1 { energy[FNR] = $2; next }
    {
        d = $2 / energy[FNR] - 1
        d = d < 0 ? -d : d
        if ($1 < 0.0045 && d > early) early = d
        if (d > late) late = d
        rows++
    }
    END {
        passed = rows == 21 && early < 1e-3 && late < 0.05
        seconds = theirs == "" ? "null" : sprintf("%.4g", theirs)
        printf "{\"spheres\": %d, \"steps\": 40000, \"difference_4ms\": %.2g, \"difference_40ms\": %.2g, \"seconds\": %.4g, \"yade_seconds\": %s, \"passed\": %s}\n",
            spheres, early, late, ours, seconds, passed ? "true" : "false"
        exit !passed
    }' "$out/yade.csv" "$out/observables.csv"
