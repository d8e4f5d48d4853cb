#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Runs scenes of the gallery, draws a picture and a plot of each, and judges its numbers: run.sh [--quick] [-o DIR] [NAME...]
# --quick: seconds instead of minutes, as the tests do; it draws nothing.
set -e
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
quick=
out=
while :; do
    case ${1:-} in
    --quick) quick=--quick ;;
    -o) out=$2 && shift ;;
    *) break ;;
    esac
    shift
done
out=${out:-$(results out)}
[ $# != 0 ] || set -- hopper drum shear_cell compaction pouring sieve
mkdir -p "$out"
for name; do
    dir=$out/$name
    # shellcheck disable=SC2046
    "$SCREE" run "$here/$name.yaml" -o "$dir" --overwrite --quiet $([ -z "$quick" ] || sed -n "s/^$name //p" "$here/quick.txt")
    "$here/check" $quick "$name" "$dir"
    [ -z "$quick" ] || continue
    from=$dir
    [ "$name" != shear_cell ] || from=$(ls "$dir"/checkpoint-*.h5) # frames of a sheared box cannot be drawn, the last state can
    # shellcheck disable=SC2046
    "$SCREE" picture "$from" -o "$out/$name.png" --overwrite --size 480x360 $(sed -n "s/^$name //p" "$here/pictures.txt")
    ! command -v gnuplot >/dev/null || gnuplot -e "name='$name'; folder='$dir'; picture='$out/$name-plot.png'" "$here/plot.gp"
    echo "drawn: $out/$name.png and $out/$name-plot.png"
done
