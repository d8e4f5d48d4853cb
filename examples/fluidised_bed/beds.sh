#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The beds of Goldschmidt and of NETL's small-scale challenge: beds.sh CASE [--short] [DIR]
#
# CASE      goldschmidt-1.25, goldschmidt-1.5, goldschmidt-2 (the velocity over that of least fluidisation); netl-2.19, netl-3.28, netl-4.38 (m/s)
# --short   the first 0.3 s instead of 2 s
# DIR       the results (CASE)
#
# Prints a line of JSON, which DIR/row.jsonl has, too: beads, simulated seconds, seconds of the run; of the second half of the time mean and
# spread of the pressure drop (standard deviation), weight of the beads over the section, mean height of the beads, and drop over weight.
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
case=${1:-}
[ $# = 0 ] || shift
case $case in
    goldschmidt-1.25) bed=goldschmidt velocity=1.60 ;;
    goldschmidt-1.5) bed=goldschmidt velocity=1.92 ;;
    goldschmidt-2) bed=goldschmidt velocity=2.56 ;;
    netl-2.19 | netl-3.28 | netl-4.38) bed=netl velocity=${case#netl-} ;;
    *) echo "beds.sh: allowed is goldschmidt-1.25, goldschmidt-1.5, goldschmidt-2, netl-2.19, netl-3.28, netl-4.38" >&2; exit 2 ;;
esac
duration='2 s'
[ "${1:-}" != --short ] || { duration='0.3 s'; shift; }
out=${1:-$(results "$case")}
flow="[0, 0, $velocity]"
# shellcheck disable=SC2086
on_ranks "${SCREE_RANKS:-1}" "$SCREE" run "$here/$bed.yaml" -o "$out" --overwrite --quiet --set duration="$duration" --set fluid.initial.velocity="$flow" \
    --set "fluid.open[0].velocity=$flow" ${SCREE_ARGS:-}
beads=$(awk '/^ITEM: ATOMS/ { for (k = 3; k <= NF; k++) at[$k] = k - 2; frames++; next } /^ITEM/ { next } frames > 1 { exit } frames && $at["kind"] == 0 { n++ } END { print n }' "$out/dump.lammpstrj")
seconds=$(report_number "$out" seconds)
awk -F , -v case="$case" -v bed=$bed -v beads="$beads" -v seconds="$seconds" '
    NR == 1 { for (k = 1; k <= NF; k++) { name = $k; sub(/\[.*/, "", name); at[name] = k } next }
    { t[++n] = $1; drop[n] = $at["pressure_drop_z"]; height[n] = $at["height"] }
    END {
        for (k = 1; k <= n; k++) if (t[k] >= 0.5 * t[n]) { m++; a += drop[k]; b += drop[k] ^ 2; h += height[k] }
        a /= m; h /= m; spread = b / m - a * a; spread = spread > 0 ? sqrt(spread) : 0
        d = bed == "netl" ? 3.256e-3 : 2.5e-3; density = bed == "netl" ? 1131 : 2526; area = bed == "netl" ? 0.225 * 0.075 : 0.15 * 0.015
        weight = beads * atan2(0, -1) / 6 * d ^ 3 * (density - 1.2) * 9.81 / area
        printf "{\"case\": \"%s\", \"beads\": %d, \"simulated\": %.4g, \"seconds\": %.4g, \"drop\": %.4g, \"drop_spread\": %.3g, \"weight\": %.4g, \"drop_over_weight\": %.4f, \"height\": %.4g}\n",
            case, beads, t[n], seconds, a, spread, weight, a / weight, h
    }' "$out/observables.csv" | tee "$out/row.jsonl"
