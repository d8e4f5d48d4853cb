#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# A drum with grains turns on two rollers: run.sh [DIR]. With povray, draws DIR/drum.png. Ranks by SCREE_RANKS, further settings by SCREE_ARGS.
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
out=${1:-$(results out)}
# shellcheck disable=SC2086
on_ranks "${SCREE_RANKS:-1}" "$SCREE" run "$here/scene.yaml" -o "$out" --overwrite ${SCREE_ARGS:-}
if command -v povray >/dev/null; then
    "$SCREE" picture "$out"/checkpoint-*.h5 -o "$out/drum.png" --overwrite --view front --size 800x800 && echo "drawn: $out/drum.png"
fi
