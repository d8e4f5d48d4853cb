#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# How time and memory grow: growth.sh [--quick]
#
# particles: packings of radii 1 ... 10, number density ~ r^-3, solid fraction 0.4, of 10^4, 10^5, 10^6 and 10^7 particles;
# gas: of radii 1 ... 1.2, solid fraction 0.2; bed: the same radii, solid fraction 0.55, in a cube that is not periodic. 10^8 where memory allows.
# boulder: 200,000 equal spheres of radius 1 in a cube, and one of radius R = 1, 10, 100, 1000 that reaches into it from below.
# spread: 200,000 particles with radii 1 ... R, number density ~ r^-3, solid fraction 0.4, for R = 2, 10, 100, 1000: nearly all small.
#
# 96 steps with Hooke contacts and slip history, a rebuild every 16. One JSON line a point: seconds is one step, rebuilds
# included, the fastest of RUNS; rebuild_seconds is one rebuild; bytes_per_particle is all memory that the program counts. The last line
# is the summary: the largest time per particle of each of each series over its least, the same for memory.
#
# --quick: up to 10^5 particles, 20,000 small ones. SCREE, THREADS (all cores), RUNS (5; quick: 3), NUMBERS (of particles of
# the first three series), SMALL (small ones of the others), WORK (keeps the packings) may be set.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
. "$here/packing.sh"
quick_after 0 "growth.sh [--quick]" "$@"
threads=${THREADS:-$cores}
runs=${RUNS:-$(by_mode 3 5)}
steps=96
numbers="10000 100000 1000000 10000000 100000000"
small=200000
if [ -n "$quick" ]; then
    numbers="10000 30000 100000"
    small=20000
fi
numbers=${NUMBERS:-$numbers}
small=${SMALL:-$small}
rows=$work/growth.rows
: >"$rows"

# point SERIES R KEY=VALUE...: runs the packing and prints the fastest
point() {
    series=$1 R=$2
    shift 2
    : >"$work/growth.runs"
    run=0
    while [ $run -lt "$runs" ]; do
        packing_run threads="$threads" step.count=$steps observables.every=$steps step.rebuild_every=16 guards.speed=off "$@"
        echo "$(report seconds) $(stages $rebuild_stages) $(report rebuilds) $(report bytes_per_particle) $(report pairs) $(report contacts)" \
            >>"$work/growth.runs"
        run=$((run + 1))
    done
    sort -g "$work/growth.runs" | head -n 1 | awk -v series="$series" -v R="$R" -v threads="$threads" -v n="$(report particles)" \
        -v steps=$steps '{
        printf "{\"series\": \"%s\", \"R\": %d, \"threads\": %d, \"particles\": %d, \"seconds\": %.6g, \"ns_per_particle\": %.6g, ",
            series, R, threads, n, $1 / steps, 1e9 * $1 / steps / n
        printf "\"rebuild_seconds\": %.6g, \"rebuild_ns_per_particle\": %.6g, \"rebuilds\": %d, \"bytes_per_particle\": %.5g, \"pairs\": %.0f, \"contacts\": %.0f}\n",
            $2 / $3, 1e9 * $2 / $3 / n, $3, $4, $5, $6 }' | tee -a "$rows"
}

for n in $numbers; do
    if ! memory_for $((n * 700)); then
        echo "growth.sh: $n particles are left out: $((n * 700)) bytes are not free" >&2
        continue
    fi
    packed power min=1 max=10 exponent=-3 fraction=0.4 count="$n" velocity=1
    point particles 10
    packed power min=1 max=1.2 fraction=0.2 count="$n" velocity=1
    point gas 1
    packed power min=1 max=1.2 fraction=0.55 count="$n" walls=hard velocity=1
    point bed 1 box.periodic=false
done

# the boulder's top is 10 above the floor of the cube; spheres that it would overlap are left out
packed power min=1 max=1.001 fraction=0.5 count=$small walls=hard velocity=1
bed=$packing
for R in 1 10 100 1000; do
    packing=$work/growth-boulder-$R-$small
    awk -v R=$R '
        / xlo xhi/ { edge = $2; next }
        / ylo yhi/ || / zlo zhi/ { next }
        /^Atoms/ { at = "atoms"; next }
        /^Velocities/ { at = "velocities"; next }
        at == "atoms" && NF >= 7 {
            dx = $5 - edge / 2; dy = $6 - edge / 2; dz = $7 - (10 - R)
            if (dx * dx + dy * dy + dz * dz > (R + $3 / 2) ^ 2) { atom[++n] = $2 " " $3 " " $4 " " $5 " " $6 " " $7; new[$1] = n }
        }
        at == "velocities" && NF >= 4 && ($1 in new) { velocity[new[$1]] = $2 " " $3 " " $4 " 0 0 0" }
        END {
            n++
            atom[n] = "1 " 2 * R " 1 " edge / 2 " " edge / 2 " " 10 - R
            velocity[n] = "0 0 0 0 0 0"
            printf "a bed and a boulder\n\n%d atoms\n1 atom types\n\n%g %g xlo xhi\n%g %g ylo yhi\n%g %g zlo zhi\n\nAtoms # sphere\n\n",
                n, -R, edge + R, -R, edge + R, -2 * R, edge + R
            for (k = 1; k <= n; k++) print k, atom[k]
            print "\nVelocities\n"
            for (k = 1; k <= n; k++) print k, velocity[k]
        }' "$bed.data" >"$packing.data"
    point boulder $R box.periodic=false
done

for R in 2 10 100 1000; do
    packed power min=1 max=$R exponent=-3 fraction=0.4 count=$small velocity=1
    point spread $R
done

awk '
    function value(key) {
        match($0, "\"" key "\": [^,}]*")
        return substr($0, RSTART + length(key) + 4, RLENGTH - length(key) - 4)
    }
    {
        series = value("series")
        gsub(/"/, "", series)
        ns = value("ns_per_particle") + 0
        bytes = value("bytes_per_particle") + 0
        if (!(series in most)) { most[series] = least[series] = ns; much[series] = little[series] = bytes }
        if (ns > most[series]) most[series] = ns
        if (ns < least[series]) least[series] = ns
        if (bytes > much[series]) much[series] = bytes
        if (bytes < little[series]) little[series] = bytes
        seconds = value("seconds") + 0; particles = value("particles") + 0; threads = value("threads")
        if (series == "particles") { largest = particles; slowest = seconds }
    }
    END {
        printf "{\"summary\": true, \"threads\": %d, \"seconds\": %.6g, \"particles\": %d, \"ns_per_particle\": %.6g", threads, slowest, largest,
            1e9 * slowest / largest
        n = split("particles gas bed boulder spread", name, " ")
        for (k = 1; k <= n; k++)
            printf ", \"%s_time\": %.3g, \"%s_memory\": %.3g", name[k], most[name[k]] / least[name[k]], name[k], much[name[k]] / little[name[k]]
        print "}"
    }' "$rows"
