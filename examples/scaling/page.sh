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

\`examples/scaling/run.sh\` makes all the runs below and writes this page; [examples/scaling](../examples/scaling/README.md)
describes the runs. Made on $(origin); $(awk 'match($0, /"cores": [0-9]+/) { n = substr($0, RSTART + 9, RLENGTH - 9) + 0; m = n > m ? n : m } END { print m }' "$columns/all") cores.

PUpCS means particle updates per core and second: steps x particles / (seconds x cores in use), as defined by Eibl and Rüde (Parallel Computing 80
(2018) 36-48); with more ranks x threads than cores, the divisor is the number of cores. Of several runs the tables show the run with the median
time.
END
}
speed_section() {
    cat <<END

## Weak and strong

The scene is an agitated gas with friction (\`scene.yaml\`). Weak: each thread of each rank has an equal share, so a perfect code keeps its PUpCS.
Strong: all layouts have the same gas. Efficiency: PUpCS divided by the PUpCS of 1x1. The last column is the share of communication and waiting.

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

The scene is the bidisperse benchmark with R = 10 (\`examples/bench\`). The table has the seconds of each stage, medians of the runs, means over
ranks.

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

The runs are weak scaling with small shares and many ranks on few cores, so only the counts have a meaning, the times do not. All counts are means
over ranks of the messages and bytes that a rank sends. Memory is the memory that the program counts: the memory held at the end, and the most at
any time, which here is the set-up. The last column is the largest resident set, MPI and libraries included.
END
    ranks_rows scene brick 10 'The gas, a cube of 10 x 10 x 10 for each rank, bricks. A rank has 7 neighbours on 2 x 2 x 2 ranks and 26 from 3 x 3 x 3 on. A rank that needs no copy gets no message:'
    ranks_rows scene bisection 10 'The same gas, divided by bisection (subdomains with equal numbers of particles; their faces do not match, so there are more neighbours):'
    ranks_rows boulders brick 8 'A boulder of 1.6 subdomain edges across for each 27 ranks, in a row of blocks of 3 x 3 x 3; ranks beyond the neighbours of its owner need copies, and copies spread as shadows:'
    cat <<END

In a step the owner sends one message to each rank that holds copies, and gets one message with forces back. If the box is clearly longer than the
reach in each direction, the counts do not depend on the number of ranks.
END
    picture ranks 'messages and bytes of a rank against the number of ranks'
    rows=$(tables table=copies form=page)
    [ "$(echo "$rows" | wc -l)" -gt 1 ] || return 0
    cat <<END

Copies follow the geometry of the share. The space outside a cube of edge L within the reach h of the cube has the volume
6 L² h + 3 pi L h² + 4/3 pi h³. Here h = 1.086: a radius, the largest radius and the skin. On 27 ranks:

| edge of the share | spheres a rank | copies a rank | by geometry | difference |
|---|---|---|---|---|
$rows
END
}
lengths_section() {
    cat <<END

## Many threads and NUMA nodes

Instructions of 16 steps and 5 searches of 5,020 spheres of radii 1 and 5, under callgrind, on all threads together. Work that
grows with the threads is the surface between their ranges (second copies of pairs), tables with an entry for each two threads, and libgomp.

| threads | all | pair list | levels searched from the larger side | libgomp, the largest part |
|---|---|---|---|---|
| 1 | 157.3 million | 0.0 | 0.5 | 0.0 |
| 8 | 173.5 million | 4.5 | 0.6 | 0.1 |
| 64 | 207.5 million | 7.1 | 0.8 | 0.6 |
| 64, as it was while each thread looked through the pairs of all | 232.9 million | 30.6 | 3.7 | 0.6 |

The next table is of the first thread: 34,097 spheres of radii 1 and 5 in a periodic cube of edge 75, velocities of 1, hgrid, one rank, a rebuild each
8 steps. "Alone" are the instructions outside of parallel regions. A rebuild includes the plan that the step after it makes. The last columns are as
it was while one thread marked the particles that move early, added up the starts of histories and looked through the classes four times. (callgrind
counts each byte that a long memset clears; new arrays that one thread clears, 0.15 million bytes a rebuild, are left out of "alone".)

| threads | a step | alone | a rebuild | alone | a rebuild, as it was | alone |
|---|---|---|---|---|---|---|
| 8 | 0.865 million | 0.006 | 5.88 | 0.11 | 6.37 | 0.66 |
| 32 | 0.265 million | 0.020 | 2.44 | 0.15 | 3.25 | 0.98 |
| 64 | 0.164 million | 0.036 | 1.48 | 0.20 | 2.32 | 1.05 |

What a thread does alone in a step are sums and largest values over the threads, about 500 instructions a thread. A step in fused order has one parallel
region with one barrier inside. A step with a rebuild has 20 regions with 11 barriers inside, and
the next step has three regions more for the plan. With 64 threads the first thread has 1.28 million instructions in the regions of a rebuild, and the mean
of the others is 0.79 million. The reason: a range at a face of the box also searches the images beyond the face. Here a range is a third of a layer of
cells.

Particles with very many partners have a slot in each thread. From the rebuild on it is known which slots the pairs of a thread add to; only these
are added up, in the order of the threads, and cleared. From 2,048 such slots on all threads share this work. (Before, one thread added up and cleared the
slots of all threads.) With 20 spheres of radius 8 among 5,000 of radius 1 on 64 threads, a rebuild each 8 steps, the first thread alone takes 73,000
instructions a step. Before these were 113,000.

In a rebuild one thread alone looks once through the classes of all particles (an instruction a particle) and cuts the rows into blocks. This thread also
adds up a table of threads x threads for the levels, and numbers the slots of particles with very many partners. With several kinds of particles this
thread also sorts the order of a reorder by class. On several ranks one thread makes the lists of copies and of their originals, which grow with the border of a rank. (In
the first table each thread's cuts looked through the classes again: with 64 threads 1.2 of the 207.5 million instructions.)

Before the first rebuild all threads copy the arrays of the particles to fresh memory, each thread its part, because the thread that reads or makes the
particles would otherwise be the first to touch all pages. \`perf record -e page-faults -c 1 -d\` shows the thread of each first touch (711,907 spheres, 4
threads, huge pages): before, the first thread touched all pages of states and forces; now each of the four threads touches its quarter. The
same holds for the pair list, the positions of the skin and the second array of a reorder. Histories and the buffers of pairs are allocated by the
threads that use them. Arrays that are freed and allocated again in a rebuild (keys of the index, kept histories; 4 to 8 bytes a particle) get blocks that
other threads may have touched. With many size classes of equal numbers the quarters of an array are not the ranges of the threads, which have a part
of each class.

A rank works best on one NUMA node: each socket, or each die with memory of its own, gets one rank with as many threads as it has cores
(\`mpirun --map-by ppr:1:numa:pe=CORES --bind-to core\`). One rank on several nodes has its pages where its threads are only if the threads stay there
(\`OMP_PROC_BIND=close OMP_PLACES=cores\`). What this gains was not measured on such a machine.

## Data with the length of the rank count

**A step has no such data.** A step has one message to and from each rank of the plan (\`src/kernel/comm/ghosts.c\`, \`exchange.c\`) and one non-blocking
reduction of 2 x classes + 4 numbers (\`src/engine/decide.c\`). \`grep -n 'comm->size\\|->ranks' src/kernel/comm/*.c\` shows the places in \`src/kernel/comm\` that read the rank count:

| file | time | data |
|---|---|---|
| \`domain.c\`, bricks | set-up | a loop over the rank count for its factors; faces of the grid, about 24 cbrt(P) bytes |
| \`domain_grid.c\`, bricks | set-up | loads of all bricks of a grid that is tried: 8 bytes a rank, on every rank, not kept |
| \`domain_tree.c\` | set-up, division | the cut tree of a bisection: 16 bytes a rank, on every rank, kept |
| \`balance_zoltan.c\` | division of a bisection | corners, places and order of all subdomains, 84 bytes a rank, and what Zoltan takes |
| \`comm.c\` (\`comm_gather_varying\`) | text dumps | 8 bytes a rank and a loop over ranks, on rank 0 |
| \`data/observe/report.c\` | end of the run | copies, messages and bytes of all ranks: 24 bytes a rank, on every rank |
| \`data/formats/checkpoint.c\` | checkpoints | a row of each rank in the file; a resume on as many ranks reads 8 bytes a rank |
| \`data/formats/dump.c\` | text dumps | rank 0 writes the rows of one rank after another |
| \`data/scene/scene_particles.c\` | set-up | every rank goes through all particles of the scene and keeps its own particles: time and 32 bytes a particle of the whole scene |

Each rebuild sorts items by rank four times (\`groups.c\`); the time of a sorting depends on the number of items and of the ranks that occur among the
items.

END
    has lengths || return 0
    cat <<END

The following times and sizes were measured on one process with pretended rank counts (\`bench_ranks\`):

- the milliseconds to make a domain with its neighbours, and the size of the domain;
- the seconds to make a cut tree from all corners;
- the nanoseconds to find the owner of a position;
- the milliseconds of one sorting by rank.

| ranks | bricks, ms | kB | bisection, ms | tree, kB | division, s | owner in bricks, ns | owner in the tree, ns | sorting, ms |
|---|---|---|---|---|---|---|---|---|
END
    tables table=lengths form=page
}
model_section() {
    cat <<END

## A model of 10^3 to 10^6 ranks

    T(P) = n w + (m + m'/k) a + (b + b'/k) S(n) / B + (1 + 3/k) 2 ceil(log2 P) a + 4 g(P) / k

Here n is the number of spheres of a rank, w the work of one sphere. m and b are the messages and bytes of a step. m' and b' are those of a rebuild, with
one rebuild in k steps. a is the latency of a message, B the bandwidth of a rank. S(n) is the growth of the shell of copies with the share. g(P) is the
time of one sorting by rank, measured above, which does not grow.

| input | value | from |
|---|---|---|
END
    model inputs page 0
    cat <<END

Assumptions:

1. Scaling is weak: every rank has the same share, and its neighbourhood is that of the largest run above; so m and b do not depend on P, as
   measured from 27 ranks on. The load is even. The model leaves out ranks that wait for a slower rank, the noise of the system, and jams in the
   network.
2. The network gives each message a latency of $(awk -v a="$latency" 'BEGIN { print 1e6 * a }') us and each rank $(awk -v b="$bandwidth" 'BEGIN { print b / 1e9 }') GB/s: 64 ranks
   share a link of 200 Gbit/s, and all messages leave the node. The work includes packing.
3. A reduction takes twice the depth of a binary tree. A step has one reduction (is a rebuild due?), and a rebuild three (migration, copies, exact
   displacements).
4. Nothing overlaps. (In the program values travel during the work on inner particles, and the reduction runs during the work on pairs with copies.)
5. The domain is bricks. A bisection adds its tree to the memory, and the time of the division above, which each rank repeats when loads have become
   uneven.

| spheres a rank | ranks | work, ms | messages, ms | bytes, ms | reductions, ms | sorting by rank, ms | step, ms | efficiency |
|---|---|---|---|---|---|---|---|---|
$(model step page 0)
END
    model step plot 10000 >"$columns/model-10000"
    model step plot 100000 >"$columns/model-100000"
    picture model 'parts of a step against the number of ranks, as modelled'
    cat <<END

The next table has the memory of a rank in MB: particles, copies, pairs and histories; the temporary memory of sorting by rank; the tree of a
bisection; the report at the end. The memory of MPI is not counted.

| spheres a rank | ranks | particles | sorting | tree | report |
|---|---|---|---|---|---|
$(model memory page 0)

The **set-up** from the sources of a scene does not scale, because every rank goes through all particles, so that ids, places and random
numbers depend on the scene alone. In a resume a rank reads only its own part of a checkpoint.

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
    if [ -s "$runs/counts/section.md" ]; then cat "$runs/counts/section.md"; fi
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
