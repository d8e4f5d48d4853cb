#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Writes the three pages of performance and their pictures from the results of the benchmarks: page.sh RESULTS DOCUMENTS (called by
# report.sh)
set -eu
here=$(cd "$(dirname "$0")" && pwd)
results=$1
documents=$2
export LC_ALL=C
data=$results/plot
mkdir -p "$data" "$documents/images"

. "$here/tables.sh"

conditions() {
    echo "| benchmark | mode | machine | cores | busy before (or load) | revision | when | seconds |"
    echo "|---|---|---|---|---|---|---|---|"
    for file in "$results"/*.jsonl; do
        sed -n 's/^{"conditions": "\(.*\)"}$/\1/p' "$file" | head -n 1
    done >"$data/conditions"
    cat "$data/conditions"
    awk -F'|' '
        {
            gsub(/^ +| +$/, "", $2)
            gsub(/^ +| +$/, "", $6)
            share = $6 ~ /%$/
            loads = loads || (!share && $6 != "")
            if (share && $6 + 0 > 25) names = names (names == "" ? "" : ", ") $2
        }
        END {
            print "\nBusy: the share of all cores that other work took in the two seconds before."
            if (loads) print "A number without % is the load average of the minute before, in which the benchmark before it may have run; it tells nothing."
            if (names != "") printf "\nThe machine was busy with other work before these, and their times by wall clock mean little: %s. Run them again on a free one.\n", names
        }' "$data/conditions"
    for mark in "$results"/*.failed; do
        test ! -e "$mark" || printf '\nThe last run of %s failed, on %s; its results, if there are any, are older.\n' "$(basename "$mark" .failed)" "$(cat "$mark")"
    done
}

bidisperse() {
    printf '\n## Bidisperse, beside LAMMPS\n\n'
    echo 'Table 1 of Stratford, Shire and Hanley: spheres of radius 1 and R, Hooke contacts with slip history, a rebuild every 16 steps; medians.'
    echo 'Needed: a loop ratio of 7 and a rebuild ratio of 8 at R = 10, no lower at 20 and 40.'
    echo
    done_for bidisperse-10 bidisperse-20 bidisperse-40 || return 0
    for name in bidisperse-10 bidisperse-20 bidisperse-40; do
        fields $name '"loop_ratio"' R particles steps ranks threads seconds loop_ratio rebuild_seconds rebuild_ratio lammps/seconds kinetic_energy_difference | tail -n 1
    done | table R particles steps ranks threads 'loop, s:1:4' 'loop ratio' 'rebuilds, s:1:4' 'rebuild ratio' "LAMMPS's loop, s:1:4" 'difference of the kinetic energies'
}

table1() {
    printf '\n## Large systems, memory\n\n'
    echo 'The same systems in scree alone: a step with its share of rebuilds (one in 16). Needed: at most 400 bytes a particle at R = 10; R = 80 in 18 GiB.'
    echo 'What does not fit into the memory is left out, with bytes extrapolated from those a particle of the last system that ran.'
    echo
    done_for table1-10 table1-20 table1-40 table1-80 table1-100 || return 0
    for R in 10 20 40 80 100; do
        fields table1-$R '"summary"' R particles threads seconds ns_per_particle rebuild_seconds bytes_per_particle memory left_out
    done | awk -F'|' -v OFS='|' '
        $9 != "" {
            if ($7 + 0 > 0) { $7 = sprintf("%.4g (extrapolated)", $7); $8 = sprintf("%.3g (extrapolated)", $8 * 9.31322575e-10) }
        }
        { print }' | table R particles threads 'step, ms:1000' 'ns a particle and step:1' 'rebuild, s:1' 'bytes a particle:1:4' 'memory, GiB:9.31322575e-10' 'left out'
}

cells() {
    printf '\n## Time against cell size (Figures 3 and 4 of the report)\n\n'
    echo "LAMMPS's \`multi\` is the report's \`bytype\`, its \`multi/old\` the report's \`multi\`. Cells of the small spheres; a cut-off is 2.5. Published: at each R the curves"
    echo 'stand in the order multi newton off, multi newton on, bytype newton off, on, reduced ghosts; the optimum of bytype lies at twice the default, 2.5, that'
    echo 'of multi at 3.75 to 5; gains of multi newton on over bytype with reduced ghosts 7.5, 29, 161 at R = 10, 20, 40 (24 ranks).'
    echo "scree's multi tests long runs of cells 8 or 16 at a time. Its ratio therefore compares different codes, not different algorithms; both gains stand below."
    echo
    done_for cells-10 cells-20 cells-40 || return 0
    for R in 10 20 40; do
        test -s "$results/cells-$R.jsonl" || continue
        for style in 'multi newton on' 'multi newton off' 'bytype newton on' 'bytype newton off' 'bytype reduced' hgrid auto 'auto reduced'; do
            key=$(echo "$style" | tr ' ' '_')
            theirs=$(fields cells-$R '"summary"' "lammps_$key/binsz" "lammps_$key/rebuild_seconds")
            echo "$R|$style|$(fields cells-$R '"summary"' "scree_$key/binsz" "scree_$key/rebuild_seconds")|${theirs:-|}"
        done
    done | table R style 'best binsz, scree' 'rebuild, ms:1000' 'best binsz, LAMMPS' 'rebuild, ms:1000'
    echo
    echo 'Gain of bytype with reduced ghosts over multi newton on, each at its best size of cells:'
    echo
    for R in 10 20 40; do
        fields cells-$R '"summary"' R gain lammps_gain
    done | table R scree LAMMPS
    for R in 10 20 40; do
        for style in 'multi newton on' 'multi newton off' 'bytype newton on' 'bytype newton off' 'bytype reduced'; do
            for code in scree lammps; do
                fields cells-$R "\"code\": \"$code\".*\"style\": \"$style\"" binsz seconds comm_seconds >"$data/cells-$R-$code-$(echo "$style" | tr ' ' '-')"
            done
        done
        fields cells-$R '"style": "auto"' seconds >"$data/cells-$R-auto"
    done
    n=$(having "$data/cells-%-scree-bytype-newton-on" 10 20 40)
    plot cells 820,$((320 * n)) <<'GP'
file(R, code, style) = out . "cells-" . R . "-" . code . "-" . style
has(R) = int(system("wc -l <" . file(R, "scree", "bytype-newton-on"))) > 0
set multiplot layout has("10") + has("20") + has("40"),1
set logscale xy; set xlabel "edge of the cells of the small spheres"; set ylabel "s a rebuild"; set xrange [1.1:11]; set key outside right center
do for [R in "10 20 40"] {
    if (has(R)) {
        set title "R = " . R
        plot file(R, "lammps", "multi-newton-off") w lp ls 4 dt 2 t "LAMMPS multi/old, newton off", file(R, "lammps", "multi-newton-on") w lp ls 2 dt 2 t "newton on", \
            file(R, "lammps", "bytype-newton-off") w lp ls 6 dt 2 t "LAMMPS multi, newton off", file(R, "lammps", "bytype-newton-on") w lp ls 5 dt 2 t "newton on", \
            file(R, "lammps", "bytype-reduced") w lp ls 1 pt 1 ps 0.6 dt 2 t "reduced ghosts", \
            file(R, "scree", "multi-newton-off") w lp ls 4 t "scree multi, newton off", file(R, "scree", "multi-newton-on") w lp ls 2 t "newton on", \
            file(R, "scree", "bytype-newton-off") w lp ls 6 t "scree bytype, newton off", file(R, "scree", "bytype-newton-on") w lp ls 5 t "newton on", \
            file(R, "scree", "bytype-reduced") w lp ls 1 pt 1 ps 0.6 t "reduced ghosts", \
            real(system("cat " . out . "cells-" . R . "-auto")) ls 3 t "auto"
    }
}
unset multiplot
GP
}

continuous_names="continuous-dunkirk-10 continuous-dunkirk-20 continuous-dunkirk-40 continuous-exponential-50"
continuous() {
    printf '\n## Continuous sizes (Figures 7 and 9 of the report)\n\n'
    echo 'Dunkirk sand and an exponential law. d_sep separates two size classes; hgrid has levels of equal occupancy; auto is told nothing. A rebuild in'
    echo "milliseconds, best of each sweep; the ratio is LAMMPS's best over auto, medians in turns (needed: 5). The last column says"
    echo 'whether more than two levels pay: whether the fastest hgrid has more, and beats the better of multi and bytype by more than 3 %.'
    echo
    # shellcheck disable=SC2086
    done_for $continuous_names || return 0
    for name in $continuous_names; do
        fields $name '"summary"' law R particles multi/rebuild_seconds bytype/d_sep bytype/rebuild_seconds hgrid/levels hgrid/rebuild_seconds seconds lammps/d_sep \
            lammps/rebuild_seconds rebuild_ratio | awk -F'|' '$6 > 0 {
                two = $4 + 0 > 0 && $4 < $6 ? $4 : $6
                gain = two / $8
                print $0 "|" (gain < 0.97 || $7 <= 2 ? "no" : gain <= 1.03 ? "no difference" : sprintf("yes, %.2f times", gain)) }'
    done | table law R particles 'multi:1000' 'bytype at d_sep:1' 'bytype:1000' 'hgrid levels' 'hgrid:1000' 'auto:1000' 'LAMMPS at d_sep:1' 'LAMMPS:1000' 'ratio:1' 'more than two levels'
    for name in $continuous_names; do
        for index in multi bytype; do
            fields $name "\"code\": \"scree\".*\"index\": \"$index\"" d_sep seconds >"$data/$name-$index"
        done
        fields $name '"code": "lammps"' d_sep seconds | sort -t'|' -k1g,1 -k2gr,2 >"$data/$name-lammps"
        fields $name '"index": "hgrid"' levels seconds | awk -F'|' '!seen[$1]++' >"$data/$name-hgrid"
        fields $name '"summary": true' seconds >"$data/$name-auto"
    done
    # shellcheck disable=SC2086
    n=$(having "$data/%-bytype" $continuous_names)
    plot continuous 900,$((330 * ((n + 1) / 2))) <<'GP'
names = "continuous-dunkirk-10 continuous-dunkirk-20 continuous-dunkirk-40 continuous-exponential-50"
has(name) = int(system("wc -l <" . out . name . "-bytype")) > 0
n = 0
do for [name in names] { n = n + has(name) }
set multiplot layout (n + 1) / 2,2
set ylabel "s a rebuild"; set logscale xy; set xlabel "d_sep, or number of levels"; set key outside below horizontal
do for [name in names] {
    if (has(name)) {
        set title name
        plot out . name . "-multi" w lp ls 4 t "multi", out . name . "-bytype" w lp ls 5 t "bytype", out . name . "-lammps" w p ls 2 pt 12 ps 1 t "LAMMPS multi", \
            out . name . "-hgrid" w lp ls 1 pt 1 ps 0.6 t "hgrid (levels)", real(system("cat " . out . name . "-auto")) ls 3 t "auto"
    }
}
unset multiplot
GP
}

univol() {
    printf '\n## Levels (Figures 2 and 3 of the paper on packing fractions)\n\n'
    echo 'Spheres of size ratio 50, f(r) ~ r^-3, between hard walls, packing fraction nu. Complete detection without a skin, radii 1 % larger, hgrid with 1 to 32 (quick: 16)'
    echo 'levels of equal occupancy (32 size classes are the most; the paper goes to 50). Published (scalar code): best L 5 at nu = 0.1 to 8 at 0.62, speed-up over one level'
    echo '150 and more, K = 0.2 at any nu. Here long runs of candidates are tested 8 or 16 at a time: K, speed-up and best L are those'
    echo 'of another algorithm, and the absolute times are what compares (a code with the published algorithm, MercuryDPM: 530 ns a particle at nu = 0.4, 440 at 0.1 on one thread; needed: 100 on one thread, 50 on two).'
    echo
    done_for univol-0.1 univol-0.2 univol-0.4 univol-0.62 || return 0
    for nu in 0.1 0.2 0.4 0.62; do
        fields univol-$nu '"summary"' fraction particles best_levels one_level_seconds best_seconds speed_up K K_error auto_levels ns_per_particle ns_per_particle_all
    done | table nu particles 'best L' 'one level, ms:1000' 'best, ms:1000' 'speed-up' 'K of eq. 3' 'its error (log)' "auto's L" 'auto, ns a particle, one thread:1' 'all cores:1'
    echo
    echo 'Whole steps of soft frictionless spheres at overlaps of about 1 %, with a search in every step as in the paper, or when the skin is used up:'
    echo
    for nu in 0.1 0.2 0.4 0.62; do
        for kind in search skin; do
            fields univol-$nu '"summary"' fraction "$kind/best_levels" "$kind/step_seconds" "$kind/step_speed_up" "$kind/auto_step_seconds" | sed "s/|/|$kind|/"
        done
    done | table nu 'list' 'best L' 'step, ms:1000' 'speed-up over one level' 'auto, ms:1000'
    for nu in 0.1 0.2 0.4 0.62; do
        fields univol-$nu '"kind": "slowdown"' levels slowdown prediction model >"$data/univol-$nu"
        fields univol-$nu '"kind": "search".*"index": "hgrid"' levels seconds | sort -t'|' -k2g | awk -F'|' 'NR == 1 { least = $2 } { print $1 "|" $2 / least }' | sort -t'|' -g >"$data/univol-step-$nu"
        fields univol-$nu '"summary"' fraction best_levels speed_up search/best_levels search/step_speed_up
    done >"$data/univol-best"
    n=$(having "$data/univol-%" 0.1 0.2 0.4 0.62)
    plot univol 900,$((330 * ((n + 1) / 2))) <<'GP'
fractions = "0.1 0.2 0.4 0.62"
has(nu) = int(system("wc -l <" . out . "univol-" . nu)) > 0
n = 0
do for [nu in fractions] { n = n + has(nu) }
set multiplot layout (n + 1) / 2,2
set logscale xy; set xlabel "levels"; set ylabel "slowdown factor"; set xrange [0.9:40]; set yrange [0.9:*]; set key top center
do for [nu in fractions] {
    if (has(nu)) {
        set title "nu = " . nu
        plot out . "univol-" . nu using 1:2 w p ls 2 ps 1 t "detection", "" using 1:3 w l ls 1 t "eq. 3, K fitted", "" using 1:4 w l ls 3 t "cost model", \
            out . "univol-step-" . nu w p ls 4 ps 1 t "whole steps, a search in each"
    }
}
unset multiplot
GP
    plot optimum 700,360 <<'GP'
set multiplot layout 1,2
set xlabel "nu"; set xrange [0:0.7]; set yrange [0:*]
set ylabel "best number of levels"
plot out . "univol-best" using 1:2 w lp ls 2 ps 1 t "detection", "" using 1:4 w lp ls 4 ps 1 t "whole steps"
set ylabel "speed-up over one level"
plot out . "univol-best" using 1:3 w lp ls 2 ps 1 t "detection", "" using 1:5 w lp ls 4 ps 1 t "whole steps"
unset multiplot
GP
}

auto() {
    printf '\n## The index that chooses itself\n\n'
    echo 'Ratio: auto over the fastest of a sweep of hgrid (levels x cell sizes); detection (processor time), and ten steps with a rebuild (wall clock, medians in'
    echo 'turns with what was fastest). Needed: at most 1.10 in the median, never above 1.25, never slower than one level (linkcell).'
    echo
    done_for auto || return 0
    fields auto '"summary"' scenes threads ratio_median ratio_largest linkcell_ratio_largest run_ratio_median run_ratio_largest run_linkcell_ratio_largest prediction_median prediction_least prediction_largest |
        table scenes threads 'ratio, median' 'largest' 'over one level, largest' 'runs, median' 'largest' 'over one level, largest' 'predicted over measured, median' least largest
    echo
    fields auto '"kind": "scene"' scene particles ns_per_particle ratio linkcell_ratio prediction run_ratio run_linkcell_ratio |
        table scene particles 'detection, ns a particle:1' ratio 'over one level' 'predicted over measured' 'runs, ratio' 'over one level'
    fields auto '"kind": "scene"' seconds predicted >"$data/auto"
    plot auto 520,420 <<'GP'
set logscale xy; set xlabel "measured (ms a detection)"; set ylabel "predicted"; set key left top
plot out . "auto" using ($1 * 1e3):($2 * 1e3) w p ls 2 ps 1 t "scenes", "" using ($1 * 1e3):($1 * 1e3) w l ls 1 t "as predicted", \
    "" using ($1 * 1e3):($1 * 1.25e3) w l ls 7 t "25 %", "" using ($1 * 1e3):($1 / 1.25e-3) w l ls 7 notitle
GP
}

chute() {
    printf '\n## Chute, beside LAMMPS\n\n'
    echo 'Spheres down a rough incline (regenerated, not copied); needed: 3 times on one core and on two.'
    echo
    done_for chute || return 0
    fields chute '"loop_ratio_one"' particles steps cores seconds ns_per_particle loop_ratio loop_ratio_one kinetic_energy_difference |
        table particles steps cores 'loop, s:1:4' 'ns a particle and step:1' 'ratio, all cores' 'ratio, one core' 'difference of the kinetic energies'
}
roofline() {
    printf '\n## Under the roof\n\n'
    echo 'Bidisperse, R = 10. Share: the time that the lower of the two roofs (bandwidth of a triad, operations of the widest instructions without fused ones) would'
    echo 'allow, over the time taken. Needed: a step within twice the time of its compulsory bytes; a thread speed-up of 1.8 on two cores; 400 bytes a particle.'
    echo
    done_for roofline || return 0
    fields roofline '"loop"' loop threads gigabytes_per_second gigaflops | table loop threads 'GB/s' 'GFlop/s'
    echo
    fields roofline '"stage"' stage threads particles seconds bytes flops gigabytes_per_second gigaflops share |
        table stage threads particles 'ms:1000' 'bytes a particle' 'operations a particle' 'GB/s' 'GFlop/s' share
    echo
    fields roofline '"summary"' threads seconds compulsory_seconds step_over_compulsory step_speed_up rebuild_seconds rebuild_speed_up bytes_per_particle |
        table threads 'step, ms:1000' 'its bytes alone, ms:1000' 'over' 'speed-up of the step' 'rebuild, ms:1000' 'speed-up of the rebuild' 'memory, bytes a particle'
    fields roofline '"stage": "(step|pairs)"' threads bytes flops gigaflops stage | awk -F'|' '{ print $3 / $2 "|" $4 "|" $5 ", " $1 ($1 == 1 ? " thread" : " threads") }' >"$data/roofline"
    fields roofline '"loop": "triad"' gigabytes_per_second | tail -n 1 >"$data/roofline-triad"
    fields roofline '"loop": "peak"' gigaflops | tail -n 1 >"$data/roofline-peak"
    plot roofline 560,380 <<'GP'
triad = real(system("cat " . out . "roofline-triad")); peak = real(system("cat " . out . "roofline-peak"))
set logscale xy; set xrange [0.02:100]; set xlabel "operations a compulsory byte"; set ylabel "GFlop/s"; set key off
plot (x * triad < peak ? x * triad : peak) ls 1, out . "roofline" using 1:2 w p ls 2 ps 1.2, "" using 1:2:3 with labels offset 1,-0.8 left font ",9"
GP
}

growth() {
    printf '\n## Growth\n\n'
    echo 'Nanoseconds a particle and step (rebuilds included) and bytes a particle: with the number of particles (a packing of radii 1 to 10, a gas, a bed), with the radius of one boulder among equal'
    echo 'spheres, and with the spread of sizes at fixed number. In the last table the largest of a series over its least; needed: 2 in time, memory proportional to particles.'
    echo 'What threads cost shows with few particles, where one alone may be faster (`THREADS=1 examples/bench/growth.sh`), and so does the room that each of them keeps.'
    echo
    done_for growth || return 0
    fields growth '"series"' series R particles threads ns_per_particle rebuild_ns_per_particle bytes_per_particle pairs contacts |
        awk -F'|' -v OFS='|' '{ $8 = $8 / $3; $9 = $9 / $3; print }' |
        table series R particles threads 'ns a particle and step:1' 'ns a particle and rebuild:1' 'bytes a particle:1:4' 'pairs a particle:1' 'contacts a particle:1'
    echo
    fields growth '"summary"' particles_time boulder_time spread_time particles_memory boulder_memory spread_memory |
        table 'particles, time' 'boulder, time' 'spread, time' 'particles, memory' 'boulder, memory' 'spread, memory'
    fields growth '"series": "particles"' particles ns_per_particle >"$data/growth-particles"
    fields growth '"series": "boulder"' R ns_per_particle >"$data/growth-boulder"
    fields growth '"series": "spread"' R ns_per_particle >"$data/growth-spread"
    plot growth 760,360 <<'GP'
set multiplot layout 1,2
set logscale x; set yrange [0:*]; set ylabel "ns a particle and step"
set xlabel "particles"; plot out . "growth-particles" w lp ls 2 ps 1 notitle
set xlabel "size ratio"; plot out . "growth-boulder" w lp ls 5 ps 1 t "one boulder", out . "growth-spread" w lp ls 4 ps 1 t "r^-3"
unset multiplot
GP
}

needs() {
    printf '\n## What a scene does not need\n\n'
    echo '8,000 spheres, one thread; each line takes one more thing away.'
    echo
    done_for needs || return 0
    fields needs '"variant"' variant nanoseconds_a_particle_and_step bytes_a_particle history_bytes_a_pair passes contacts |
        table scene 'ns a particle and step' 'bytes a particle' 'history, bytes a pair' passes contacts
}

ablation() {
    printf '\n## Ablation\n\n'
    echo 'Measured here by `compare.sh`, the bidisperse packing R = 10: the setting in the first column instead of the default, in turns; how much longer it takes'
    echo '(median over the pairs, interval of at least 95 % by their order, if no less is said), the whole loop, the step and the rebuild.'
    echo
    if done_for ablation; then
        awk '
            function number(key, from, at) {
                at = index($0, from)
                rest = substr($0, at)
                match(rest, "\"gain\": [^,]*, \"interval\": \\[[^]]*\\]")
                s = substr(rest, RSTART, RLENGTH)
                split(s, part, /: |, "interval"/)
                gain = part[2]
                match(s, /\[[^]]*\]/)
                range = substr(s, RSTART + 1, RLENGTH - 2)
                sub(/, /, " ... ", range)
                return gain " (" range ")"
            }
            /"summary": true/ {
                match($0, /"B": "[^"]*"/)
                b = substr($0, RSTART + 6, RLENGTH - 7)
                match($0, /"pairs": [0-9]*/)
                pairs = substr($0, RSTART + 9, RLENGTH - 9)
                match($0, /"threads": [0-9]*/)
                threads = substr($0, RSTART + 11, RLENGTH - 11)
                if (pairs + 0 < 6) pairs = sprintf("%d (interval of %.0f %%)", pairs, 100 * (1 - 2 * 0.5 ^ pairs))
                print "`" b "`|" pairs "|" threads "|" number("gain", "\"ns_per_particle\"") "|" number("gain", "\"step\": {") "|" number("gain", "\"rebuild\": {")
            }' "$results/ablation.jsonl" | table setting pairs threads loop step rebuild
    fi
    printf '\nWhat cannot be switched, kept or taken out, as measured when it was tried (from `examples/bench/ablation.tsv`):\n\n'
    awk -F'\t' 'NR == 1 { print "| " $1 " | " $2 " | " $3 " | " $4 " | " $5 " |"; print "|---|---|---|---|---|"; next }
        { print "| " $1 " | " $2 " | " $3 " | " $4 " | " $5 " |" }' "$here/ablation.tsv"
}

{
    cat "$here/performance.head.md"
    bidisperse
    chute
    table1
    needs
    echo
    cat "$here/performance-guards.md"
} >"$documents/performance.md"
{
    cat "$here/performance-index.head.md"
    continuous
    auto
    cells
    univol
    roofline
    growth
} >"$documents/performance-index.md"
{
    cat "$here/performance-journal.head.md"
    printf '\n## Conditions\n\n'
    conditions
    ablation
} >"$documents/performance-journal.md"
