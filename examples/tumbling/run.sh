#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Two discs sink one above the other: run.sh [--quick] [DIR]
#
# --quick   a coarser fluid, from where the discs are near each other until they have touched
# DIR       the results (out)
#
# Prints a line of JSON, which DIR/results.jsonl has, too: when the discs touch, how much faster the upper one was, when it has overtaken the lower one. Draws
# DIR/tumbling.png where gnuplot is.
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
quick_or_folder "$@"
set --
[ $quick = no ] || set -- --set fluid.spacing=0.05 --set box.upper='[2, 2.4, 0]' --set 'walls[3].point=[0, 2.4, 0]' --set step.count=1100 --set output.dump=~ \
    --set 'particles.sources[0].position=[1, 2.1, 0]' --set 'particles.sources[1].position=[0.999, 1.8, 0]'
# shellcheck disable=SC2086
"$SCREE" run "$here/scene.yaml" -o "$out" --overwrite --quiet "$@" ${SCREE_ARGS:-}
awk -F , 'NR > 1 { x = $2 - $5; y = $3 - $6; gap = sqrt(x * x + y * y) - 0.2
        if (!kiss && $12 < 0 && $9 / $12 > ratio && $1 > 0.2) ratio = $9 / $12
        if (gap < 0.02 && kiss == "") kiss = $1
        if (y < 0 && tumble == "") tumble = $1
        last = gap }
    END { printf "{\"faster\": %.3f, \"touch\": %s, \"overtakes\": %s, \"gap\": %.4f, \"time\": %g}\n", ratio, kiss == "" ? "null" : kiss, tumble == "" ? "null" : tumble, last, $1 }' \
    "$out/observables.csv" | tee "$out/results.jsonl"
if [ $quick = no ] && command -v gnuplot >/dev/null; then
    flow_frames "$out/dump.lammpstrj" "$out"
    gnuplot -e "out='$out/'" "$here/picture.gp"
    rm "$out"/discs-*.txt "$out"/fluid-*.txt
    echo "drawn: $out/tumbling.png" >&2
fi
