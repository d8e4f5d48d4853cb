#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# What cohesion among small grains costs beside boulders: cohesion.sh [--quick]
#
# Three settings of cohesion.yaml (radii 10 and 40): Hertz's law; JKR with a surface energy of 0, which is the price of the law; and JKR among
# the small grains alone, which has a range. (A range that one number set for all pairs would widen the search of the boulders, too.)
# A line of JSON a setting: pairs in the list, contacts at the end, and medians of REPEAT (5) runs, which take turns: seconds of the
# steps and of the rebuilds. With valgrind, the instructions of a step and of a rebuild, which other load on the machine does not
# change: runs of 1 step, of STEPS more without a rebuild, and of as many with one each are compared. The last line has the ratios of
# JKR among small grains to Hertz's law.

here=$(cd "$(dirname "$0")" && pwd)
. "$here/bench.sh"
quick_after 0 "cohesion.sh [--quick]" "$@"
export OMP_NUM_THREADS=1 OMP_WAIT_POLICY=passive LC_ALL=C
repeat=${REPEAT:-$(by_mode 1 5)}
steps=${STEPS:-$(by_mode 5 20)}
box=$(by_mode 400 800)
out=$work/cohesion
mkdir -p "$out"

pair='restitution: 0.5, friction: 0.5'
size=(--set "box.upper=[$box, $box, $box]" --set "particles.sources[0].count=$(by_mode 60 480)" --set "particles.sources[1].count=$(by_mode 3000 24000)")
for source in 0 1; do
    size+=(--set "particles.sources[$source].region={shape: box, lower: [0, 0, 0], upper: [$box, $box, $box]}")
done
flags_of() { # NAME
    case $1 in
    hertz) flags=() ;;
    jkr_zero) flags=(--set contact.cohesion=jkr --set "material_pairs=[{$pair, surface_energy: 0}]") ;;
    jkr_small) flags=(--set contact.cohesion=jkr --set "material_pairs=[{$pair, surface_energy: 0}, {between: [small, small], $pair, surface_energy: 1e4}]") ;;
    esac
}
run() { # NAME FLAG...: into OUT/NAME; COUNTED: under callgrind, and prints the instructions
    local name=$1 with=()
    shift
    [ -z "${COUNTED:-}" ] || with=(valgrind --tool=callgrind --callgrind-out-file=/dev/null)
    "${with[@]}" "$SCREE" run "$here/cohesion.yaml" -o "$out/$name" --overwrite --quiet --set threads=1 "${size[@]}" "${flags[@]}" "$@" >"$out/$name.log" 2>&1 || {
        cat "$out/$name.log" >&2
        exit 1
    }
    [ -z "${COUNTED:-}" ] || sed -n 's/.*Collected : \([0-9]*\).*/\1/p' "$out/$name.log"
}
names=(hertz jkr_zero jkr_small)
for name in "${names[@]}"; do : >"$out/$name.rows"; done
for ((r = 0; r < repeat; r++)); do
    for name in "${names[@]}"; do
        flags_of "$name"
        run "$name"
        echo "$(report_stages "$out/$name" sweep advance contact decide finish) $(report_stages "$out/$name" migrate reorder ghosts index pairs history)" >>"$out/$name.rows"
    done
done
declare -A figure
for name in "${names[@]}"; do
    flags_of "$name"
    figure[$name,pairs]=$(report_number "$out/$name" pairs)
    figure[$name,contacts]=$(report_number "$out/$name" contacts)
    figure[$name,step_seconds]=$(median 1 "$out/$name.rows")
    figure[$name,rebuild_seconds]=$(median 2 "$out/$name.rows")
    figure[$name,step_instructions]=0
    figure[$name,rebuild_instructions]=0
    if command -v valgrind >/dev/null; then
        one=$(COUNTED=1 run "$name-1" --set step.count=1 --set step.rebuild_every=1000)
        plain=$(COUNTED=1 run "$name-2" --set step.count=$((steps + 1)) --set step.rebuild_every=1000)
        rebuilt=$(COUNTED=1 run "$name-3" --set step.count=$((steps + 1)) --set step.rebuild_every=1)
        figure[$name,step_instructions]=$(((plain - one) / steps))
        figure[$name,rebuild_instructions]=$(((rebuilt - plain) / steps))
    fi
    printf '{"setting": "%s", "particles": %d' "$name" "$(report_number "$out/$name" particles)"
    for key in pairs contacts step_seconds rebuild_seconds step_instructions rebuild_instructions; do
        printf ', "%s": %s' $key "${figure[$name,$key]}"
    done
    echo '}'
done
printf '{"summary": true'
for key in pairs step_seconds rebuild_seconds step_instructions rebuild_instructions; do
    printf ', "%s": %s' $key "$(awk -v a="${figure[hertz,$key]}" -v b="${figure[jkr_small,$key]}" 'BEGIN { if (a > 0) printf "%.4g", b / a; else printf "null" }')"
done
echo '}'
