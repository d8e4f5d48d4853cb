#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# What a pair of rocks costs beside one of spheres and of clumps: rocks.sh [--quick]
#
# Bodies of one volume fly about in a periodic box (rocks.yaml): spheres; clumps of eight spheres; cubes; rocks of 16 corners. Full size are 97,336
# bodies, --quick takes 1,000. A line of JSON a setting: particles, pairs in the list and contacts at the end, and medians of REPEAT (3) runs, which take turns: seconds, ns a
# particle and step, and ns a pair and step of the stages of contacts alone. With valgrind, the instructions of a step for each pair, which other load on the
# machine does not change: runs of 1,000 bodies of WARM (200) steps and of COUNT (20; 0: none are counted) more are compared. Then the rocks again on each index but brute: all of them find the same pairs. The last line
# has the ratios to spheres.

here=$(cd "$(dirname "$0")" && pwd)
. "$here/bench.sh"
quick_after 0 "rocks.sh [--quick]" "$@"
export OMP_WAIT_POLICY=passive LC_ALL=C
threads=${OMP_NUM_THREADS:-$cores}
repeat=${REPEAT:-$(by_mode 1 3)}
steps=${STEPS:-$(by_mode 200 400)}
edge=${EDGE:-$(by_mode 10 46)}
warm=${WARM:-$(by_mode 50 200)}
count=${COUNT:-$(by_mode 5 20)}
out=$work/rocks
mkdir -p "$out"

# Of the volume 4/3 pi: eight spheres of radius r at the corners of a cube of edge 2 r; a cube of edge 2 h; 16 corners on a sphere of radius big
r=0.5
h=0.80599598
big=1.1449
flags_of() { # NAME
    case $1 in
    spheres) flags=() ;;
    clumps)
        spheres=
        for x in -$r $r; do for y in -$r $r; do for z in -$r $r; do spheres="$spheres{centre: [$x, $y, $z], radius: $r}, "; done; done; done
        flags=(--set "bodies={clumps: [{size: drawn, orientation: given, quaternion: [1, 0, 0, 0], spheres: [${spheres%, }]}]}")
        ;;
    cubes)
        corners=
        for x in -$h $h; do for y in -$h $h; do for z in -$h $h; do corners="$corners$x, $y, $z, "; done; done; done
        flags=(--set "bodies={shapes: [{size: drawn, rounding: 0.1, orientation: given, quaternion: [1, 0, 0, 0], vertices: [${corners%, }]}]}")
        ;;
    rocks)
        corners=$(awk 'BEGIN { for (k = 0; k < 16; k++) { z = (k - 7.5) / 8; s = sqrt(1 - z * z); printf "%s%.6g, %.6g, %.6g", k ? ", " : "", '$big' * s * cos(2.4 * k), '$big' * s * sin(2.4 * k), '$big' * z } }')
        flags=(--set "bodies={shapes: [{size: drawn, rounding: 0.1, orientation: given, quaternion: [1, 0, 0, 0], vertices: [$corners]}]}")
        ;;
    esac
}
sized() { # EDGE
    size=(--set "box.upper=[$(awk -v n="$1" 'BEGIN { e = 2.4 * n; print e "," e "," e }')]")
}
run() { # NAME FLAG...: into OUT/NAME; COUNTED: under callgrind, and prints the instructions
    local name=$1 with=()
    shift
    [ -z "${COUNTED:-}" ] || with=(valgrind --tool=callgrind --callgrind-out-file=/dev/null)
    "${with[@]}" "$SCREE" run "$here/rocks.yaml" -o "$out/$name" --overwrite --quiet --set threads="$threads" "${size[@]}" "${flags[@]}" "$@" >"$out/$name.log" 2>&1 || {
        cat "$out/$name.log" >&2
        exit 1
    }
    [ -z "${COUNTED:-}" ] || sed -n 's/.*Collected : \([0-9]*\).*/\1/p' "$out/$name.log"
}
# told NAME SETTING INDEX: the line of a setting from the rows of its runs; sets per_pair
told() {
    local particles pairs contacts seconds stages
    particles=$((edge * edge * edge))
    pairs=$(report_number "$out/$1" pairs)
    contacts=$(report_number "$out/$1" contacts)
    seconds=$(median 1 "$out/$1.rows")
    stages=$(median 2 "$out/$1.rows")
    per_pair=$(awk -v s="$stages" -v n="$pairs" -v k="$steps" 'BEGIN { printf "%.4g", 1e9 * s / n / k }')
    printf '{"setting": "%s", "index": "%s", "threads": %d, "particles": %d, "pairs": %d, "contacts": %d, "seconds": %s, "ns_per_particle": %s, "ns_per_pair": %s' \
        "$2" "$3" "$threads" "$particles" "$pairs" "$contacts" "$seconds" "$(awk -v s="$seconds" -v n="$particles" -v k="$steps" 'BEGIN { printf "%.4g", 1e9 * s / n / k }')" "$per_pair"
}

names=(spheres clumps cubes rocks)
sized "$edge"
for name in "${names[@]}"; do : >"$out/$name.rows"; done
for ((k = 0; k < repeat; k++)); do
    for name in "${names[@]}"; do
        flags_of "$name"
        run "$name" --set step.count="$steps"
        echo "$(report_number "$out/$name" seconds) $(report_stages "$out/$name" sweep contact rocks)" >>"$out/$name.rows"
    done
done
declare -A price instructions
for name in "${names[@]}"; do
    told "$name" "$name" auto
    price[$name]=$per_pair
    if [ "$count" -gt 0 ] && command -v valgrind >/dev/null; then
        flags_of "$name"
        sized 10
        threads_kept=$threads
        threads=1
        less=$(COUNTED=1 run "$name-1" --set step.count="$warm" --set step.rebuild_every=1000)
        more=$(COUNTED=1 run "$name-2" --set step.count=$((warm + count)) --set step.rebuild_every=1000)
        instructions[$name]=$(awk -v a="$less" -v b="$more" -v n="$(report_number "$out/$name-2" pairs)" -v k="$count" 'BEGIN { printf "%.4g", (b - a) / n / k }')
        threads=$threads_kept
        printf ', "instructions_per_pair": %s' "${instructions[$name]}"
    fi
    echo '}'
done
sized "$edge"
flags_of rocks
for index in $("$SCREE" help index.name | sed -n 's/,//g; s/^ *one of \(.*\); default .*/\1/p'); do
    [ "$index" != brute ] && [ "$index" != auto ] || continue
    run "index-$index" --set step.count="$steps" --set index.name="$index"
    echo "$(report_number "$out/index-$index" seconds) $(report_stages "$out/index-$index" sweep contact rocks)" >"$out/index-$index.rows"
    told "index-$index" rocks "$index"
    printf ', "rebuild_seconds": %s}\n' "$(report_stages "$out/index-$index" migrate reorder ghosts index pairs history)"
done
told rocks summary auto | sed 's/"setting": "summary"/"summary": true/' | tr -d '\n'
for name in clumps cubes rocks; do
    printf ', "%s_over_spheres": %s' "$name" "$(awk -v a="${price[spheres]}" -v b="${price[$name]}" 'BEGIN { printf "%.4g", b / a }')"
    [ -z "${instructions[spheres]:-}" ] || printf ', "%s_over_spheres_instructions": %s' "$name" "$(awk -v a="${instructions[spheres]}" -v b="${instructions[$name]}" 'BEGIN { printf "%.4g", b / a }')"
done
echo '}'
