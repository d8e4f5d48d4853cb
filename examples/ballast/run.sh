#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Sand rains on rocks: run.sh [DIR]
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
out=${1:-$(results out)}
on_ranks "${SCREE_RANKS:-1}" "$SCREE" run "$here/scene.yaml" -o "$out" --overwrite
