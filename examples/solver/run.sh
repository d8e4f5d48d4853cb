#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Where hard contacts pay: run.sh [--short] [DIR]
# Pours a bed of rigid grains, takes the gate away, and sets the solver's run beside explicit runs of the same collapse at 5 MPa, 1 GPa
# and 70 GPa, by `scree ablate --error`; then the table of solvers by `scree ablate --vary`. DIR (out beside this script) keeps both
# tables, also as JSON lines, and page.md: the rows of docs/hard.md. --short: a fifth of the time, without 70 GPa, seconds instead of minutes.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
export LC_ALL=C OMP_WAIT_POLICY=passive
duration=0.05 young="--young 70e9"
if [ "${1:-}" = --short ]; then
    duration=0.01 young=
    shift
fi
out=${1:-$(results out)}
mkdir -p "$out"
out=$(cd "$out" && pwd)
"$SCREE" run "$here/bed.yaml" -o "$out/bed" --overwrite --quiet --set threads=1
# shellcheck disable=SC2086
"$SCREE" ablate "$here/collapse.yaml" --error -o "$out/error" --overwrite --set "particles.sources[0].file='$out/bed/trajectory.h5'" \
    --duration $duration --samples 25 --repeat "${REPEAT:-1}" --only step,solver,explicit $young \
    --judge centre_x,centre_z,solid_fraction_slice1,solid_fraction_slice2,solid_fraction_slice3
"$SCREE" ablate "$here/collapse.yaml" -o "$out/table" --overwrite --set "particles.sources[0].file='$out/bed/trajectory.h5'" --set duration=$duration \
    --vary contact.solver.kappa=10,40,400 --vary contact.solver.sweeps=10,30,100 --vary step.dt=1e-4,3e-4

{
    echo '| run | step, µs | steps | seconds | centre x off by | centre z | slice by the wall | force on the floor |'
    echo '|---|---|---|---|---|---|---|---|'
    awk -F, 'NR == 1 { for (k = 1; k <= NF; k++) at[$k] = k; next }
        function part(name) { return sprintf("%.2g %%", 100 * $at[name "_error"]) }
        $1 == "combined" { next }
        $at["outcome"] != "done" { printf "| %s | | | | %s | | | |\n", $2, $at["outcome"]; next }
        { printf "| %s | %.3g | %d | %.2g | %s | %s | %s | %s |\n", $1 == "scene" ? "the solver" : $2, 1e6 * $at["dt"], $at["steps"], $at["cpu_seconds"],
            part("centre_x"), part("centre_z"), part("solid_fraction_slice1"), part("floor_fz") }' "$out/error/speed_error.csv" | sed 's/"//g'
    echo
    sed -n '/^measured on/p; /^the load/p; /^reference:/p; /^differences/p' "$out/error/speed_error.txt"
    echo
    echo '| kappa | sweeps at most | step, s | sweeps a step | largest residual | largest overlap | seconds |'
    echo '|---|---|---|---|---|---|---|'
    awk -F, 'NR == 1 { for (k = 1; k <= NF; k++) at[$k] = k; next }
        { printf "| %s | %s | %s | %s | %s | %s | %.2g |\n", $3, $4, $5, $at["sweeps"], $at["residual"], $at["overlap"], $at["seconds"] }' "$out/table/ablate.csv"
} >"$out/page.md"
cat "$out/page.md"
