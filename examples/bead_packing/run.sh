#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Water flows through a packing of beads that scree pours itself: run.sh [--spacing LENGTH] [--quick] [--open] [--packing FILE] [DIR]
#
# --spacing LENGTH   the finest of three spacings; the others are 1.25 and 1.25^2 times as long (64 um)
# --quick            410 beads in a column of 4.4 mm instead of 6,864 in one of 8.8 mm
# --open             each flow also between an inlet and an outlet, beside the periodic one
# --packing FILE     takes these beads (radius x y z a line, metres) instead of pouring; its folder has the pouring's height
# DIR                the results (out)
#
# Prints lines of JSON: the packing, the flow at each spacing, and last the pressure drop extrapolated from all. SCREE_RANKS: MPI ranks of
# the flow (1). SEED: of the pouring (1). SCREE_ARGS: further settings of the flow. PICTURE=1 draws DIR/bead-packing.png.
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"

finest=64um
beads=6864 column=4.4e-3 height=12.8e-3
packing=
between=no
out=
while [ $# -gt 0 ]; do
    case $1 in
        --spacing) finest=$2; shift ;;
        --quick) beads=410 column=2.2e-3 height=3.2e-3 ;;
        --open) between=yes ;;
        --packing) packing=$2; shift ;;
        -*) echo "run.sh: $1: allowed are --spacing LENGTH, --quick, --open, --packing FILE" >&2; exit 2 ;;
        *) out=$1 ;;
    esac
    shift
done
out=${out:-$(results out)}
mkdir -p "$out"
finest=$(echo "$finest" | awk '{ gsub(/ /, ""); n = $0 + 0; u = $0; sub(/^[-+.0-9eE]*/, "", u)
    f = u == "um" ? 1e-6 : u == "mm" ? 1e-3 : u == "m" || u == "" ? 1 : 0; if (n * f <= 0) exit 1; printf "%.15g", n * f }') ||
    { echo "run.sh: --spacing wants a length, as in 60um" >&2; exit 2; }

# core: the processor seconds of all that this script has started and waited for
core_seconds() {
    times >"$out/times"
    core=$(awk 'NR == 2 { for (k = 1; k <= 2; k++) { split($k, t, /[ms]/); sum += 60 * t[1] + t[2] } print sum }' "$out/times")
}
. "$here/pour.sh"
. "$here/flow.sh"
. "$here/open.sh"

[ -n "$packing" ] || pour
[ -z "$packing" ] || cp "$packing" "$out/packing.txt"
awk -v column="$column" -v height="$height" -v profile="$out/profile.txt" -f "$here/packing.awk" "$out/packing.txt" >"$out/packing.json"
cat "$out/packing.json"
: >"$out/flows.jsonl"
: >"$out/open.jsonl"
for cells in $(awk -v h="$finest" -v height="$height" 'BEGIN { for (k = 2; k >= 0; k--) printf "%d ", int(height / (h * 1.25 ^ k) + 0.5) }'); do
    flow "$cells"
    [ "$between" = no ] || open "$cells"
done
core_seconds
cat "$out/packing.json" "$out/flows.jsonl" | awk -v seconds="$core" -f "$here/summary.awk" | tee "$out/summary.json"
[ -z "${PICTURE:-}" ] || "$here/picture.sh" "$out"
