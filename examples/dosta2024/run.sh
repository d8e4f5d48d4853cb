#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# A case of Dosta et al., Comput. Phys. Commun. 296 (2024) 109066, beside the curves of other codes:
#     run.sh CASE [--short] [--step published|safe|soft|solver] [DIR]
# CASE: impact25 impact50 impact100 silo-large-m1 silo-small-m1 silo-large-m2 silo-small-m2 drum
#
# Prints JSON lines; the last holds the result, the reference, and whether the run passed; the exit status is then 0 or 1. Draws DIR/CASE.svg.
# A run that was stopped goes on from its last checkpoint when the same command is given again, and a run after its --short from there.
# --short: impacts 32 ms, silos 0.3 s, the drum 0.5 s. --step safe: the longest step that `scree check` calls stable, times 0.9;
# soft: the same, with grains of a hundredth of the modulus, so that steps are six times longer (not for impacts, whose ball would crush the beads);
# solver: steps of 0.1 ms (impacts 20 us) by the solver of contacts, the same law and moduli.
# BED: the published initial state of an impact or a silo, instead of a bed that the script pours. SEEDS: impacts with so many
# places of the ball, 0.1 mm apart. DURATION, FILL: other simulated seconds of the run and of the pouring. SCREE_RANKS, SCREE_ARGS:
# ranks, and more arguments of each run.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
export LC_ALL=C
cases="impact25 impact50 impact100 silo-large-m1 silo-small-m1 silo-large-m2 silo-small-m2 drum"
wrong_call() {
    echo "usage: run.sh CASE [--short] [--step published|safe|soft|solver] [DIR]; CASE is one of $cases" >&2
    exit 2
}

case_name=${1:-}
case " $cases " in *" $case_name "*) shift ;; *) wrong_call ;; esac
short= step=published out=
while [ $# -gt 0 ]; do
    case $1 in
    --short) short=yes ;;
    --step)
        test $# -ge 2 || wrong_call
        shift
        step=$1
        ;;
    -*) wrong_call ;;
    *) out=$1 ;;
    esac
    shift
done
case $step,$case_name in
soft,impact*)
    echo "run.sh: --step soft is for silos and the drum: beads of a hundredth of the modulus would be crushed by the ball" >&2
    exit 2
    ;;
published,* | safe,* | soft,* | solver,*) ;;
*) wrong_call ;;
esac
test -n "$out" || out=$(results "out-$case_name")
mkdir -p "$out"
out=$(cd "$out" && pwd)

# bed_source FILE: the source of grains that lie in a file of this program
bed_source() { echo "{name: bed, file: '$1', format: h5md, material: $grain}"; }

# What the cases differ in. The arguments of a run are the parameters of the shell, as they have spaces.
solver_step=1e-4 fill=0 rest=0.05 thick=0.11 bed= soft= rough=
case $case_name in
impact*)
    thousand=${case_name#impact}
    count=${thousand}000 scene=$here/../penetration/scene.yaml grain=glass solver_step=2e-5 soft="--set materials[glass].young=1e7"
    duration=0.1
    test -z "$short" || duration=0.032
    set -- --set "particles.sources[ball].id=$((count + 1))" --set output.trajectory.every=0 \
        --set "observables.list=[{name: position, label: ball, id: $((count + 1)), components: z}, {name: velocity, label: ball, id: $((count + 1)), components: z}]"
    if [ "$thousand" != 25 ]; then
        # deep beds splash beads up to there, and some over the rim
        set -- "$@" --set box.upper='[52 mm, 33 mm, 60 cm]' --set box.leave=delete
        fill=0.25 rest=0.02 thick=0.028 solid=0.5
        # beads of the case settle to a denser bed than the published one; rougher ones settle to its height
        rough="--set material_pairs[0].friction=1 --set contact.rolling=spring --set material_pairs[0].rolling_friction=0.3"
        bed="{name: bed, from: packed, count: $count, sizes: 1 mm, material: glass, region: {shape: box, lower: [-0.049, -0.03, -0.0902431], upper: [0.049, 0.03, $(
            awk -v n=$count -v f=$solid 'BEGIN { printf "%.6f", -0.0902431 + n * 4.18879e-9 / f / (0.098 * 0.06) }')]}}"
    fi
    ;;
silo*)
    count=100000 scene=$here/silo.yaml grain=grain fill=0.25 soft="--set materials[grain].young=1e7"
    duration=5
    test -z "$short" || duration=0.3
    set --
    case $case_name in
    *small*)
        set -- --set walls[barrel].point='[0, 0, 0.1707]' --set walls[barrel].length=0.3001 \
            --set walls[cone].point='[0, 0, -0.0593008]' --set walls[cone].radius=0.02 --set walls[cone].length=0.08 \
            --set walls[lid].point='[0, 0, -0.0593008]' --set walls[lid].radius=0.02 \
            --set 'particles.sources[bed].region={shape: cylinder, centre: [0, 0, 0.1079], radius: 0.1, length: 0.1744}' --set particles.sources[bed].count=89652 \
            --set 'particles.sources[cone1].region={shape: cylinder, centre: [0, 0, -0.0459508], radius: 0.02, length: 0.0267}' --set particles.sources[cone1].count=520 \
            --set 'particles.sources[cone2].region={shape: cylinder, centre: [0, 0, -0.0192508], radius: 0.0467, length: 0.0267}' --set particles.sources[cone2].count=2838 \
            --set 'particles.sources[cone3].region={shape: cylinder, centre: [0, 0, 0.0074492], radius: 0.0733, length: 0.0267}' --set particles.sources[cone3].count=6990 \
            --set 'deletions[outlet].region.upper=[1, 1, -0.0893008]' --set 'observables.regions[silo].lower=[-.inf, -.inf, -0.0593008]'
        ;;
    esac
    case $case_name in
    *m2)
        set -- "$@" --set materials[grain].density=2000 --set materials[grain].young=5e8 --set 'material_pairs[grain, grain].restitution=0.4' \
            --set 'material_pairs[grain, grain].friction=0.4' --set step.dt=2e-6 --set step.force=true
        soft="--set materials[grain].young=5e6"
        ;;
    esac
    ;;
drum)
    count=38000 scene=$here/../drum/scene.yaml soft="--set materials[m1].young=1e7 --set materials[m2].young=5e6"
    duration=5
    test -z "$short" || duration=0.5
    set -- --set output.trajectory.every=0
    ;;
esac
duration=${DURATION:-$duration}
fill=${FILL:-$fill}

solver="--set contact.solver=gauss_seidel --set contact.solver.sweeps=30"
# shellcheck disable=SC2086
scree_run() { on_ranks "${SCREE_RANKS:-1}" "$SCREE" run "$@" ${SCREE_ARGS:-} >&2; }

# sink NAME SECONDS VISCOSITY ARGUMENT...: the grains sink in a viscous fluid into DIR/NAME/trajectory.h5, unless they are there; prints its line
sink() {
    layer=$1 seconds=$2 viscosity=$3
    shift 3
    ! grep -q "\"simulated\": $seconds," "$out/$layer.json" 2>/dev/null || { cat "$out/$layer.json"; return; }
    echo "pouring the bed, $layer: $seconds s" >&2
    scree_run "$scene" -o "$out/$layer" --overwrite "$@" --set "drag={law: stokes, fluid: {density: 1, viscosity: $viscosity}}" --set 'step.dt=~' --set step.fraction=0.9 \
        --set duration="$seconds" --set "output.trajectory.every={time: $seconds}" --set output.checkpoint.at_end=false \
        --set 'observables.list=[{name: energy_kinetic_mean}, {name: particles}, {name: overlap_max}, {name: largest, of: z, unit: m, label: top}]'
    printf '{"bed": "%s", "particles": %d, "seconds": %.4g, "simulated": %s, "top": %.5f, "overlap": %.5f, "mean_kinetic_energy": %.3g}\n' "$layer" \
        "$(report_number "$out/$layer" particles)" "$(report_number "$out/$layer" seconds)" "$seconds" "$("$SCREE" info "$out/$layer" --column top --row last)" \
        "$("$SCREE" info "$out/$layer" --column overlap_max --row last)" "$("$SCREE" info "$out/$layer" --column energy_kinetic_mean --row last)" | tee "$out/$layer.json"
}

# pour ARGUMENT...: the bed of a case that is not published with these examples, as bed_source. Grains of a hundredth of the modulus sink at 0.2 m/s, as
# they would bounce without a fluid. Then grains of the case expand in a fluid 40 times as thick, so that the overlaps of the soft ones lift the bed slowly.
pour() {
    if [ -n "${BED:-}" ]; then
        { echo radius x y z; tr -d '\r' <"$BED" | awk 'NF == 4 && $1 + 0 > 0 { print $1, $2, $3, $4 } NF == 3 && $1 == $1 + 0 { print 0.002, $1, $2, $3 }'; } >"$out/bed.txt"
        bed_source="{name: bed, file: '$out/bed.txt', format: table, material: $grain}"
        echo "{\"bed\": \"$BED\", \"particles\": $(($(wc -l <"$out/bed.txt") - 1))}"
        return
    fi
    # shellcheck disable=SC2086
    sink soft "$fill" $thick "$@" $soft $rough ${bed:+--set} ${bed:+"particles.sources=[$bed]"}
    bed_source=$(bed_source "$out/soft/trajectory.h5")
    test $step != soft || return 0
    sink bed "$rest" "$(awk -v mu=$thick 'BEGIN { print 40 * mu }')" "$@" --set "particles.sources=[$bed_source]"
    bed_source=$(bed_source "$out/bed/trajectory.h5")
}

# ended: has the run come to its end?
ended() { test -s "$run/report.json" && awk -v t="$(report_number "$run" time)" -v end="$duration" 'BEGIN { exit t < end * (1 - 1e-6) }'; }

# advance FOLDER ARGUMENT...: the run, from its last checkpoint if it has one; its steps, seconds, updates go to FOLDER/segments
advance() {
    run=$out/$1
    shift
    how=--overwrite
    settings="$case_name $step" # ranks, threads and SCREE_ARGS may be others than before
    if [ "$(cat "$run/settings" 2>/dev/null)" = "$settings" ] && ls "$run"/checkpoint-*.h5 >/dev/null 2>&1; then
        how='--resume last'
        ! ended || return 0
    else
        mkdir -p "$run"
        rm -f "$run/segments" "$run"/checkpoint-*.h5
        echo "$settings" >"$run/settings"
    fi
    touch "$run/segments"
    rm -f "$run/report.json"
    # shellcheck disable=SC2086
    case $step in
    safe) set -- "$@" --set 'step.dt=~' --set step.fraction=0.9 ;;
    soft) set -- "$@" --set 'step.dt=~' --set step.fraction=0.9 $soft ;;
    solver) set -- "$@" --set step.dt=$solver_step $solver ;;
    esac
    # shellcheck disable=SC2086
    scree_run "$scene" -o "$run" $how "$@" --set duration="$duration" --set output.checkpoint.minutes=10 || failed=$?
    test -s "$run/report.json" || exit "${failed:-1}"
    printf '%s %s %s %s %s\n' "$(report_number "$run" steps)" "$(report_number "$run" seconds)" "$(report_number "$run" particle_steps_per_second)" \
        "$(report_number "$run" ranks)" "$(report_number "$run" threads)" >>"$run/segments"
    ! ended || return 0
    echo "stopped at $(report_number "$run" time) s; the same command goes on from there" >&2
    exit 3
}

# verdict FOLDER: the last line of a case
verdict() {
    run=$out/$1
    {
        awk -v time="$(report_number "$run" time)" '{ steps += $1; seconds += $2; updates += $2 * $3; cores = $4 * $5; spent += $2 * cores }
            END { speed = spent > 0 ? updates / spent : 0; printf "%d %.6g %d %.6g %.6g\n", steps, seconds, cores, speed, time }' "$run/segments"
        printf '%s %s %s\n' "$(report_number "$run" git_revision)" "$(report_number "$run" dt)" "$(report_number "$run" cpu | tr -d '"')"
    } >"$run/costs"
    awk -F, -v name="$case_name" -v count="$count" -v step="$step" -v costs="$run/costs" -v folder="$here/curves" \
        -f "$here/curves.awk" -f "$here/${case_name%%[-0-9]*}.awk" "$run/observables.csv" | tee "$run/verdict.json"
}

picture() {
    command -v gnuplot >/dev/null || { echo "no gnuplot here, so nothing is drawn" >&2; return 0; }
    gnuplot -e "name='$case_name'; ours='$out/run/observables.csv'; curves='$here/curves'; picture='$out/$case_name.svg'" "$here/picture.gp" &&
        echo "drawn: $out/$case_name.svg" >&2
}

test "$fill" = 0 || pour "$@"
case $case_name in
impact25) ;;
impact*) set -- "$@" --set "particles.sources[bed]=$bed_source" ;;
silo*) set -- "$@" --set "particles.sources=[$bed_source]" --set 'walls[lid]=~' ;;
esac
seed=1
: >"$out/verdicts"
while [ "$seed" -le "${SEEDS:-1}" ]; do
    folder=run
    case $seed,$case_name in
    1,*) advance run "$@" ;;
    *,impact*)
        folder=run-$seed
        advance $folder "$@" --set "particles.sources[ball].position=[$(awk -v k="$seed" 'BEGIN { print 1e-4 * (k - 1) }'), 0, 6 cm]"
        ;;
    *) break ;;
    esac
    verdict $folder >"$out/verdict.json"
    cat "$out/verdict.json" >>"$out/verdicts"
    test "${SEEDS:-1}" = 1 || cat "$out/verdict.json"
    seed=$((seed + 1))
done
picture
awk -f "$here/seeds.awk" "$out/verdicts"
