#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# A stream scours sand around a boulder, and a flow shears a bed of spheres: run.sh [--quick] [--onset] [DIR]
#
# --onset   spheres in three dimensions under a lid that slides (onset.yaml), at four Shields numbers; no picture
# --quick   with --onset two Shields numbers and a third of the time; else no stream, until the sand lies; no picture
# DIR       the results (out)
#
# Prints lines of JSON, which DIR/results.jsonl has, too. Without --onset: mean height of the surface of the sand, depth of the scour near the boulder and height of the
# highest dune from there, in diameters of sand, and the place of that dune. With --onset: Shields number by the force on the lid, and mean velocity of the free spheres over (shear rate at the start) x diameter, in the last third of the run.
# Draws DIR/scour.png where gnuplot is. SCREE_RANKS: MPI ranks (1).
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
quick=no
scene=scene.yaml
out=
for argument; do
    case $argument in
        --quick) quick=yes ;;
        --onset) scene=onset.yaml ;;
        -*) echo "run.sh: $argument: allowed are --quick and --onset" >&2; exit 2 ;;
        *) out=$argument ;;
    esac
done
out=${out:-$(results out)}
mkdir -p "$out"
: >"$out/results.jsonl"
# run NAME [FLAG...]
run() {
    name=$1
    shift
    # shellcheck disable=SC2086
    on_ranks "${SCREE_RANKS:-1}" "$SCREE" run "$here/$scene" -o "$out/$name" --overwrite --quiet "$@" ${SCREE_ARGS:-}
}
if [ $scene = onset.yaml ]; then
    steps=24000 list='0.0111 0.00556 0.0037 0.00139'
    [ $quick = no ] || { steps=8000; list='0.0111 0.00139'; }
    for g in $list; do # a sphere has the mass 282.7; the lid has the area 720
        run "gravity-$g" --set gravity="[0, 0, -$g]" --set step.count=$steps
        awk -F , -v g="$g" 'NR > 1 { t[NR] = $1; v[NR] = $2 / (40 * 282.743); lid[NR] = -$6; z = $5 }
            END { for (k = 2 + int(2 * (NR - 1) / 3); k <= NR; k++) { n++; mean += v[k]; force += lid[k] }
                printf "{\"shields\": %.3f, \"velocity\": %.4f, \"height\": %.2f, \"time\": %g}\n", force / n / 720 / (9 * g), mean / n / 0.12, z, t[NR] }' \
            "$out/gravity-$g/observables.csv" | tee -a "$out/results.jsonl"
    done
    exit
fi
set --
[ $quick = no ] || set -- --set step.count=16000
run stream "$@"
# the surface of the sand: the highest grain in each strip of eight, at the end; the boulder stands at x = 60
awk '/^ITEM: ATOMS/ { for (k = 3; k <= NF; k++) at[$k] = k - 2; reading = 1; delete top; next } /^ITEM/ { reading = 0 }
    reading && NF > 4 && $at["kind"] == 0 && $at["radius"] < 4 { strip = int($at["x"] / 8) % 20; y = $at["y"] + $at["radius"]; if (y > top[strip]) top[strip] = y }
    END { low = most = mean = top[7]; mean = 0
        for (s = 0; s < 20; s++) { mean += top[s] / 20; if (s > 4 && s < 10 && top[s] < low) low = top[s]; if (top[s] > most) { most = top[s]; place = s * 8 + 4 } }
        printf "{\"surface\": %.2f, \"scour\": %.2f, \"dune\": %.2f, \"dune_at\": %d}\n", mean, (mean - low) / 6, (most - mean) / 6, place }' \
    "$out/stream/dump.lammpstrj" | tee "$out/results.jsonl"
if [ $quick = no ] && command -v gnuplot >/dev/null; then
    flow_frames "$out/stream/dump.lammpstrj" "$out"
    gnuplot -e "out='$out/'" "$here/picture.gp"
    rm "$out"/discs-*.txt "$out"/fluid-*.txt
    echo "drawn: $out/scour.png" >&2
fi
