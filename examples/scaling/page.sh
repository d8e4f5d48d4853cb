#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Writes scaling.md, and its pictures into images/: page.sh RUNS DOCUMENTS (run.sh calls it)
#
# RUNS holds PART.jsonl of the parts of run.sh; a part that is missing leaves its section out. LATENCY (2e-6 s a message) and
# BANDWIDTH (4e8 bytes a second and rank) of the model may be set.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
runs=$1
documents=$2
latency=${LATENCY:-2e-6}
bandwidth=${BANDWIDTH:-4e8}
pictures=$documents/images
mkdir -p "$pictures"
columns=$(mktemp -d)
trap 'rm -rf "$columns"' EXIT
cat "$runs"/*.jsonl >"$columns/all" 2>/dev/null || { echo "page: $runs holds no results" >&2; exit 1; }

has() {
    for part in "$@"; do
        [ -s "$runs/$part.jsonl" ] || return 1
    done
}
tables() { # SETTING=VALUE...
    settings=
    for setting in "$@"; do settings="$settings -v $setting"; done
    # shellcheck disable=SC2086
    awk $settings -f "$here/lines.awk" -f "$here/tables.awk" "$columns/all"
}
model() { # TABLE FORM SHARE
    awk -v table="$1" -v form="$2" -v share="$3" -v latency="$latency" -v bandwidth="$bandwidth" -f "$here/lines.awk" -f "$here/model.awk" \
        "$columns/all"
}
picture() { # NAME VARIABLE="VALUE"...
    name=$1
    shift
    settings="picture = '$pictures/scaling-$name.svg'; data = '$columns/'"
    command -v "${GNUPLOT:-gnuplot}" >/dev/null || return 0
    "${GNUPLOT:-gnuplot}" -e "$settings" "$here/$name.gp"
    printf '\n![%s](images/scaling-%s.svg)\n' "$*" "$name"
}
origin() {
    awk -F'"' '/"cpu"/ { cpu = $4 } /"compiler"/ { compiler = $4 } /"git_revision"/ { revision = $4 }
        END { printf "%s, revision %s, %s", cpu, revision, compiler }' "$runs/run/report.json" 2>/dev/null || echo 'a machine of which no report is left'
}

head_section() {
    cat <<END
# Scaling

This page is written by \`examples/scaling/run.sh\`, which makes all the runs below; [examples/scaling](../examples/scaling/README.md)
says what each is. Made on $(origin); $(awk 'match($0, /"cores": [0-9]+/) { n = substr($0, RSTART + 9, RLENGTH - 9) + 0; m = n > m ? n : m } END { print m }' "$columns/all") cores.

PUpCS: particle updates per core and second, steps x particles / (seconds x cores in use), as Eibl and Rüde (Parallel Computing 80
(2018) 36-48) define it; with more ranks x threads than cores, the cores count. Of several runs the one with the median time is shown.
END
}
speed_section() {
    cat <<END

## Weak and strong

An agitated gas with friction (\`scene.yaml\`). Weak: a like share for each core, so a perfect code keeps its PUpCS. Strong: one gas for
all. Efficiency: PUpCS over that of 1x1.

| ranks x threads | spheres | seconds | ns a sphere, step and core | M PUpCS | efficiency | imbalance | for other ranks |
|---|---|---|---|---|---|---|---|
END
    if has weak; then
        echo '| **weak** | | | | | | | |'
        tables table=weak form=page
        tables table=weak form=plot >"$columns/weak"
    fi
    if has strong; then
        echo '| **strong** | | | | | | | |'
        tables table=strong form=page
        tables table=strong form=plot >"$columns/strong"
    fi
    picture speed 'particle updates per core and second against ranks x threads'
}
hybrid_section() {
    cat <<END

## Threads against ranks

The bidisperse benchmark with R = 10 (\`examples/bench\`), seconds of each stage, medians of the runs, mean over ranks.

| stage | 1x1 | threads | ranks | speed-up, threads | speed-up, ranks | threads / ranks |
|---|---|---|---|---|---|---|
END
    tables table=hybrid form=page
    tables table=hybrid form=plot >"$columns/hybrid"
    picture hybrid 'seconds of each stage'
}
ranks_rows() { # SCENE DOMAIN SHARE TITLE
    rows=$(tables table=ranks form=page scene="$1" domain="$2" share="$3")
    [ -n "$rows" ] || return 0
    tables table=ranks form=plot scene="$1" domain="$2" share="$3" >"$columns/$1-$2"
    printf '\n%s\n\n' "$4"
    echo '| ranks | spheres a rank | copies a rank (most) | messages a step | kB a step | messages a rebuild | kB a rebuild | MB held | MB most | MB resident |'
    echo '|---|---|---|---|---|---|---|---|---|---|'
    echo "$rows"
}
ranks_section() {
    cat <<END

## Messages, bytes and memory of a rank

Weak scaling with small shares, many ranks on few cores: times mean nothing here, counts do. All are means over ranks, of what a rank
sends. Memory is what the program counts of itself: held at the end, and the most at any time, which here is set-up; then the largest resident
set, MPI and libraries included.
END
    ranks_rows scene brick 10 'The gas, a cube of 10 x 10 x 10 for each rank, bricks; a rank has 7 neighbours on 2 x 2 x 2 ranks and 26 from 3 x 3 x 3 on, and no message goes to one who needs no copy:'
    ranks_rows scene bisection 10 'The same by bisection (a division of equal numbers of particles; faces do not meet their like, so there are more neighbours):'
    ranks_rows boulders brick 8 'A boulder of 1.6 subdomain edges across for each 27 ranks, in a row of blocks of 3 x 3 x 3; it must be known beyond the neighbours of its owner, and copies spread as shadows:'
    cat <<END

A step sends one message to each rank that holds copies, and gets one back with forces. Once the box is longer than the reach in each
direction, the number of ranks plays no part any more.
END
    picture ranks 'messages and bytes of a rank against the number of ranks'
    rows=$(tables table=copies form=page)
    [ "$(echo "$rows" | wc -l)" -gt 1 ] || return 0
    cat <<END

Copies follow the geometry of the share: what lies within the reach h of a cube of edge L, outside of it, fills 6 L² h + 3 pi L h² + 4/3 pi h³
(h = 1.086: a radius, the largest radius and the skin). On 27 ranks:

| edge of the share | spheres a rank | copies a rank | by geometry | difference |
|---|---|---|---|---|
$rows
END
}
lengths_section() {
    cat <<END

## What has the length of the rank count

**In the step: nothing.** A step is one message to and from each rank of the plan (\`src/comm/ghosts.c\`, \`exchange.c\`) and one non-blocking
reduction of 2 x classes + 4 numbers (\`src/engine/step.c\`). \`grep -n 'comm->size\\|->ranks' src/comm/*.c\` shows all places that see the rank count:

| where | when | what |
|---|---|---|
| \`domain.c\`, bricks | set-up | a loop over the rank count that looks for its factors; faces of the grid, about 24 cbrt(P) bytes |
| \`domain_tree.c\` | set-up, division | the cut tree of a bisection: 16 bytes a rank, on every rank, kept |
| \`balance_zoltan.c\` | division of a bisection | corners, places and order of all subdomains, 84 bytes a rank, and what Zoltan takes |
| \`comm.c\` (\`comm_gather_varying\`) | text dumps | 8 bytes a rank and a loop over ranks, on rank 0 |
| \`observe/report.c\` | end of the run | copies, messages and bytes of all ranks: 24 bytes a rank, on every rank |
| \`formats/checkpoint.c\` | checkpoints | a row of each rank in the file; a resume on as many ranks reads 8 bytes a rank |
| \`formats/dump.c\` | text dumps | rank after rank is written by rank 0 |
| \`scene/source.c\` | set-up | every rank walks through all particles of the scene and keeps its own: time and 32 bytes a particle of the whole scene |

Sorting by rank (\`groups.c\`), which each rebuild does four times, follows the items and the ranks that occur among them.

END
    has lengths || return 0
    cat <<END

Measured on one process with made-up rank counts (\`bench_ranks\`): milliseconds to make a domain with its neighbours, its size; seconds to
make a cut tree from all corners; nanoseconds to find the owner of a position; milliseconds of one sorting by rank.

| ranks | bricks, ms | kB | bisection, ms | tree, kB | division, s | owner in bricks, ns | owner in the tree, ns | sorting, ms |
|---|---|---|---|---|---|---|---|---|
END
    tables table=lengths form=page
}
model_section() {
    cat <<END

## A model of 10^3 to 10^6 ranks

    T(P) = n w + (m + m'/k) a + (b + b'/k) S(n) / B + (1 + 3/k) 2 ceil(log2 P) a + 4 g(P) / k

n spheres a rank, w the work of one; m messages and b bytes of a step, m' and b' of a rebuild, one in k steps; a the latency of a message, B
the bandwidth of a rank, S(n) the growth of the shell of copies with the share; g(P) one sorting by rank, measured above, which does not grow.

| input | value | from |
|---|---|---|
END
    model inputs page 0
    cat <<END

Assumptions:

1. Weak scaling: every rank has the same share, and its neighbourhood is that of the largest run above; so m, b do not depend on P, as measured
   from 27 ranks on. The load is even. A layer of ranks that wait for a slower one is not in the model, nor are the noise of the system and jams in
   the network.
2. The network gives each message a latency of $(awk -v a="$latency" 'BEGIN { print 1e6 * a }') us and each rank $(awk -v b="$bandwidth" 'BEGIN { print b / 1e9 }') GB/s: 64 ranks that
   share a link of 200 Gbit/s, all of whose messages leave the node. Packing is in the work.
3. A reduction takes twice the depth of a binary tree. One a step (is a rebuild due?), and three a rebuild (migration, copies, exact
   displacements).
4. Nothing overlaps, although values travel while inner particles are worked on, and the reduction while pairs with copies are.
5. Bricks. A bisection adds its tree to the memory, and the division above, which each rank makes again when loads have become uneven.

| spheres a rank | ranks | work, ms | messages, ms | bytes, ms | reductions, ms | sorting by rank, ms | step, ms | efficiency |
|---|---|---|---|---|---|---|---|---|
$(model step page 0)
END
    model step plot 10000 >"$columns/model-10000"
    model step plot 100000 >"$columns/model-100000"
    picture model 'parts of a step against the number of ranks, as modelled'
    cat <<END

Memory of a rank, MB: particles, copies, pairs and histories; what sorting by rank takes while it works; the tree of a bisection; the report
at the end. MPI's own is not counted.

| spheres a rank | ranks | particles | sorting | tree | report |
|---|---|---|---|---|---|
$(model memory page 0)

What does not scale is the **set-up** from a scene's sources, as every rank walks through all particles, so that ids, places and random
numbers depend on nothing but the scene. A resume reads from a checkpoint only a rank's own part.

| spheres a rank | ranks | spheres | walk, s | GB a rank |
|---|---|---|---|---|
$(model setup page 0)
END
}

{
    head_section
    if has weak || has strong; then speed_section; fi
    if has hybrid; then hybrid_section; fi
    if has ranks; then ranks_section; fi
    if [ -s "$runs/ghosts/section.md" ]; then cat "$runs/ghosts/section.md"; fi
    if [ -s "$runs/pupcs/section.md" ]; then cat "$runs/pupcs/section.md"; fi
    if [ -s "$runs/pupcs/sizes.md" ]; then
        cat "$runs/pupcs/sizes.md"
        cp "$runs/pupcs/sizes.svg" "$pictures/scaling-sizes.svg" 2>/dev/null || true
    fi
    lengths_section
    if has weak strong ranks lengths; then model_section; fi
} >"$columns/page"
mv "$columns/page" "$documents/scaling.md"
echo "page: $documents/scaling.md"
