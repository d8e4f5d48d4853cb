# SPDX-License-Identifier: BSD-3-Clause
# Sourced by the scripts of the examples (sh, with `here` set to their folder): finds the program, starts it on ranks.
#
# SCREE, if set, is the program to run; else build/scree of this checkout, else the installed scree.

examples=$(cd "$here" && while [ ! -f common.sh ]; do cd ..; done && pwd)

# results NAME: where results go if no folder is named: beside the script, or here where that cannot be written
results() {
    if [ -w "$here" ]; then
        echo "$here/$1"
    else
        echo "$PWD/$(basename "$here")-$1"
    fi
}

# quick_or_folder [--quick] [DIR]: sets `quick`, yes or no, and `out`, the folder of the results, which it makes
quick_or_folder() {
    quick=no
    out=
    for argument; do
        case $argument in
            --quick) quick=yes ;;
            -*) echo "run.sh: $argument: allowed is --quick" >&2; exit 2 ;;
            *) out=$argument ;;
        esac
    done
    out=${out:-$(results out)}
    mkdir -p "$out"
}

# flow_frames DUMP DIR: each frame of a dump of discs in a fluid as DIR/discs-STEP.txt and DIR/fluid-STEP.txt, with place, speed and radius
flow_frames() {
    awk -v out="$2" '/^ITEM: TIMESTEP/ { getline; frame = $1 } /^ITEM: ATOMS/ { for (k = 3; k <= NF; k++) at[$k] = k - 2; reading = 1; next } /^ITEM/ { reading = 0 }
        reading && NF > 4 && $at["kind"] < 2 { print $at["x"], $at["y"], sqrt($at["vx"] ^ 2 + $at["vy"] ^ 2), $at["radius"] >(out "/" ($at["kind"] == 0 ? "discs" : "fluid") "-" frame ".txt") }' "$1"
}

find_scree() {
    if [ -n "${SCREE:-}" ]; then
        :
    elif [ -x "$examples/../build/scree" ]; then
        SCREE=$examples/../build/scree
    elif command -v scree >/dev/null; then
        SCREE=scree
    else
        echo "no scree here: ./setup build makes it, or set SCREE to the program" >&2
        exit 1
    fi
}

# on_ranks N COMMAND ...: also with more ranks than cores, and as root
on_ranks() {
    if [ "$1" = 1 ]; then
        shift
        "$@"
    else
        OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "${MPIRUN:-mpirun}" --oversubscribe \
            --bind-to none --mca mpi_yield_when_idle 1 --mca btl_vader_single_copy_mechanism none -n "$@"
    fi
}

# report_number DIR KEY: a value of the report of a run
report_number() {
    "$SCREE" info "$1" --get "$2"
}

# median COLUMN FILE
median() {
    cut -d ' ' -f "$1" "$2" | sort -g | awk '{ v[NR] = $1 } END { print NR % 2 ? v[(NR + 1) / 2] : (v[NR / 2] + v[NR / 2 + 1]) / 2 }'
}

find_scree
