#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The error of a step that is a larger part of the stable one, law by law and scene by scene, as docs/speed-error.md shows it:
# step-fraction.sh [impacts|cases|gas|SCENE|tables]...; all of it without words
#
# impacts: 40 pairs of spheres meet, each at another part of a step; the velocities after the impact against those at 0.005 of the stable
# step (STEP_IMPACT=NAME: one of the rows alone). cases: scenes of examples/verify with few spheres, what they end with. gas: the energy of
# elastic spheres. SCENE: scree ablate --error --only step at 0.3 of the stable step; the names stand below, in `scenes`. tables: prints
# what is there of the results. Results in out-step-fraction, or STEP_FRACTION_OUT. All of it takes some 5 minutes of one core's time.

here=$(cd "$(dirname "$0")" && pwd)
. "$here/common.sh"
out=${STEP_FRACTION_OUT:-$(results out-step-fraction)}
fractions='0.05 0.1 0.15 0.3 0.5 0.7 0.9'
export OMP_NUM_THREADS=1 LC_ALL=C
mkdir -p "$out" || exit 1

# pairs RATIO OBLIQUE: 40 pairs, the lower sphere RATIO times as large; gaps spread over 0.2, half of the pairs at 0.3 of the speed; with
# OBLIQUE (a number) the upper sphere also moves across, at up to OBLIQUE times the speed of approach, and spins
pairs() {
    awk -v ratio="$1" -v oblique="$2" 'BEGIN { print "radius x y z vx vy vz wx wy wz"
        for (k = 0; k < 40; k++) { v = k % 2 ? 0.3 : 1; gap = 0.2 * v * (k * 0.6180339887 % 1) + 0.001; t = oblique * v * (k + 1) / 40
            x = 4 * (1 + ratio) * k
            print ratio, x, 0, 0, 0, 0, 0, 0, 0, 0
            print 1, x, 0, 1 + ratio + gap, t, 0, -v, 0, t, t / 2 } }'
}

# impact NAME RATIO OBLIQUE CONTACT MATERIAL PAIR: a row of $out/impacts.tsv: the largest difference of a sphere's velocity, or spin times
# radius, over the speed of approach, at each fraction, of the pairs that part; then the mean difference of the restitution at 0.15 and at 0.9
impact() {
    local name=$1 fraction errors='' means=''
    [ -z "${STEP_IMPACT:-}" ] || [ "$name" = "$STEP_IMPACT" ] || return 0
    pairs "$2" "$3" >"$out/pairs.txt"
    cat >"$out/impact.yaml" <<EOS
units: none
box: {lower: [-40, -40, -40], upper: [2000, 40, 60]}
duration: 0.5
contact: {$4}
materials: [{name: ball, density: 0.238732414637843$5}]
material_pairs: [{$6}]
particles: {file: pairs.txt, format: table}
guards: {energy: off}
output: {checkpoint: {at_end: false}, dump: {every: {time: 0.5}}}
EOS
    for fraction in 0.005 $fractions; do
        "$SCREE" run "$out/impact.yaml" -o "$out/impact" --overwrite --quiet --set step.fraction="$fraction" --set threads=1 >"$out/said" 2>&1 ||
            { errors="$errors	stopped"; cat "$out/said" >&2; continue; }
        awk '/^ITEM: ATOMS/ { n = 0; reading = 1; next } /^ITEM:/ { reading = 0; next } reading { line[++n] = $0 }
            END { for (k = 1; k <= n; k++) print line[k] }' "$out/impact/dump.lammpstrj" | sort -n >"$out/after"
        if [ "$fraction" = 0.005 ]; then
            cp "$out/after" "$out/fine"
            continue
        fi
        # $out/apart: rows `largest difference, difference of the restitution`, a row a pair; pairs that both runs leave together have no row
        paste -d ' ' "$out/fine" "$out/after" | awk '
            function parted(at,   d) { d = (under[at + 5] - $(at + 5)) ^ 2 + (under[at + 7] - $(at + 7)) ^ 2; return d > (1.001 * (under[3] + $3)) ^ 2 }
            { half = NF / 2; last = half > 13 ? 13 : 10 } # velocity, and spin where spheres have it
            NR % 2 { for (k = 1; k <= NF; k++) under[k] = $k; next }
            { v = int(($1 - 1) / 2) % 2 ? 0.3 : 1; most = 0; fine = parted(0); other = parted(half); e = ($(10 + half) - under[10 + half] - $10 + under[10]) / v }
            !fine && !other { next }
            { for (k = 8; k <= last; k++) for (which = 0; which < 2; which++) {
                apart = which ? ($k - $(k + half)) * (k > 10 ? $3 : 1) : (under[k] - under[k + half]) * (k > 10 ? under[3] : 1)
                if (apart < 0) apart = -apart
                if (apart / v > most) most = apart / v }
              print most, e }' >"$out/apart"
        errors="$errors	$(awk '$1 > most { most = $1 } END { printf "%.2g", most }' "$out/apart")"
        case $fraction in
        0.15 | 0.9) means="$means	$(awk '{ sum += $2 } END { printf "%.2g", NR ? sum / NR : 0 }' "$out/apart")" ;;
        esac
    done
    printf '%s%s%s\n' "$name" "$errors" "$means" | tee -a "$out/impacts.tsv"
}

impacts() {
    local e ratio hertz=', young: 2e5, poisson: 0.25'
    : >"$out/impacts.tsv"
    for e in 1 0.9 0.5 0.1; do
        impact "hooke, restitution $e" 1 0 'law: hooke, tangential: none' '' "restitution: $e, k_n: 1e4"
        impact "hertz, restitution $e" 1 0 'law: hertz, tangential: none' "$hertz" "restitution: $e"
    done
    for ratio in 1 10; do
        impact "hooke, friction, ratio $ratio" $ratio 1 'law: hooke' '' 'restitution: 0.5, friction: 0.5, k_n: 1e4'
        impact "hertz, friction, ratio $ratio" $ratio 1 'law: hertz' "$hertz" 'restitution: 0.5, friction: 0.5'
    done
    impact 'hertz, viscoelastic' 1 0 'law: hertz, damping: viscoelastic, tangential: none' "$hertz" 'dissipative_time: 0.001'
    impact 'hertz, rolling spring, twisting sds' 1 1 'law: hertz, rolling: spring, twisting: sds' "$hertz" 'restitution: 0.5, friction: 0.5, rolling_friction: 0.1, twisting_friction: 0.1, twisting_stiffness: 500, twisting_damping: 1'
    impact 'hertz, rolling epsd, twisting marshall' 1 1 'law: hertz, rolling: epsd, twisting: marshall' "$hertz" 'restitution: 0.5, friction: 0.5, rolling_friction: 0.1'
    impact 'jkr' 1 0 'law: hertz, cohesion: jkr, tangential: none' "$hertz" 'restitution: 0.9, surface_energy: 1'
    impact 'jkr, restitution 0.5' 1 0 'law: hertz, cohesion: jkr, tangential: none' "$hertz" 'restitution: 0.5, surface_energy: 1'
    impact 'jkr, friction' 1 1 'law: hertz, cohesion: jkr' "$hertz" 'restitution: 0.9, friction: 0.5, surface_energy: 1'
    impact 'dmt' 1 0 'law: hertz, cohesion: dmt, tangential: none' "$hertz" 'restitution: 0.9, surface_energy: 1'
    impact 'sjkr' 1 0 'law: hertz, cohesion: sjkr, tangential: none' "$hertz" 'restitution: 0.9, cohesion_density: 1000'
    impact 'capillary' 1 0 'law: hertz, cohesion: capillary, tangential: none' "$hertz" 'restitution: 0.9, surface_tension: 0.02, contact_angle: 0.3, bridge_volume: 0.001'
    impact 'van der Waals' 1 0 'law: hertz, cohesion: van_der_waals, tangential: none' "$hertz" 'restitution: 0.9, hamaker: 1e-4, gap_least: 0.001, cut_off: 0.1'
    impact 'luding' 1 0 'law: luding, tangential: none' '' 'restitution: 1, k_n: 1e4, k_2: 3e4, k_c: 5e3'
    impact 'luding, restitution 0.5' 1 0 'law: luding, tangential: none' '' 'restitution: 0.5, k_n: 1e4, k_2: 3e4, k_c: 5e3'
    impact 'luding, friction' 1 1 'law: luding' '' 'restitution: 0.9, friction: 0.5, k_n: 1e4, k_2: 3e4, k_c: 5e3'
    impact 'thornton' 1 0 'law: thornton, tangential: none' "$hertz" 'restitution: 1, yield_pressure: 4000'
    impact 'thornton, restitution 0.5' 1 0 'law: thornton, tangential: none' "$hertz" 'restitution: 0.5, yield_pressure: 4000'
    impact 'thornton, jkr' 1 0 'law: thornton, cohesion: jkr, tangential: none' "$hertz" 'restitution: 1, yield_pressure: 4000, surface_energy: 0.5'
    impact 'eepa' 1 0 'law: eepa, tangential: none' "$hertz" 'restitution: 1, plasticity_ratio: 0.6, adhesion_energy: 20'
    impact 'eepa, restitution 0.5' 1 0 'law: eepa, tangential: none' "$hertz" 'restitution: 0.5, plasticity_ratio: 0.6, adhesion_energy: 20'
}

# single NAME WORDS SCENE DURATION COLUMN=SCALE,... FLAG...: a row of $out/cases.tsv: the largest difference of the columns at the end from
# those at 0.02 of the stable step, over their scales; all steps end at the same time
single() {
    local words=$2 scene=$here/verify/$3/scene.yaml duration=$4 columns=$5 fraction stable steps column errors=
    shift 5
    once 0.9 '' "$@" || return 1
    stable=$(report_number "$out/single" dt | awk '{ print $1 / 0.9 }')
    for fraction in 0.02 $fractions; do
        steps=$(awk -v t="$duration" -v f="$fraction" -v s="$stable" 'BEGIN { n = t / (f * s); print int(n) + (n > int(n)) }')
        once "$fraction" "$steps" "$@" || return 1
        for column in ${columns//,/ }; do
            echo "$("$SCREE" info "$out/single" --column "${column%=*}" --row last) ${column#*=}"
        done >"$out/last"
        if [ "$fraction" = 0.02 ]; then cp "$out/last" "$out/fine"; continue; fi
        errors="$errors	$(paste -d ' ' "$out/fine" "$out/last" | awk '{ apart = ($1 - $3) / $2; if (apart < 0) apart = -apart; if (apart > most) most = apart } END { printf "%.2g", most }')"
    done
    printf '%s%s\n' "$words" "$errors" | tee -a "$out/cases.tsv"
}
# once FRACTION STEPS FLAG...: a run of $scene over $duration, in so many steps or ('') at this part of the stable step
once() {
    local step="{fraction: $1}" length="duration=$duration" every=1000000
    [ -z "$2" ] || { step="{dt: $(awk -v t="$duration" -v n="$2" 'BEGIN { printf "%.17g", t / n }'), count: $2}" length='duration=~' every=$2; }
    shift 2
    "$SCREE" run "$scene" -o "$out/single" --overwrite --quiet --set step="$step" --set "$length" --set observables.every=$every --set 'output={checkpoint: {at_end: false}}' \
        --set threads=1 "$@" >"$out/said" 2>&1 || { cat "$out/said" >&2; return 1; }
}

cases() {
    : >"$out/cases.tsv"
    single stack 'stack of five spheres, at rest' stack 8 particle5_z=0.015,energy_elastic_normal=0.275
    single stack 'elastic stack that swings by half its compression, 4.5 periods' stack 1 particle5_z=0.0075,energy_elastic_normal=0.275 --set 'material_pairs[0].restitution=1' \
        --set 'particles.sources=[{from: single, position: [0, 0, 0.9975], radius: 1}, {from: single, position: [0, 0, 2.9955], radius: 1}, {from: single, position: [0, 0, 4.994], radius: 1}, {from: single, position: [0, 0, 6.993], radius: 1}, {from: single, position: [0, 0, 8.9925], radius: 1}]'
    single stack 'the same, released without compression: contacts open' stack 1 particle5_z=0.015,energy_elastic_normal=0.275 --set 'material_pairs[0].restitution=1'
    single chain 'chain that swings, 3.3 periods' chain 6 particle4_x=0.04
    single cantilever 'bonded beam that swings, 2.4 periods' bonded-cantilever 12 particle17_z=0.19
    single decay 'sphere that rolls to rest, 5.6 s of 8.4 s' rolling-decay 5.6 particle1_vx=3
    single incline 'spheres that roll and slide down' incline 1 particle1_vx=5,particle2_vx=5,particle2_wy=5,particle3_vx=5
    single wall 'spheres that meet a moving wall' moving-wall 2 particle1_vz=3,particle2_vz=3,particle3_vz=3
    single cradle 'five spheres in a row' cradle 2 particle1_vx=1,particle5_vx=1
    single vyas 'small sphere on a saddle (Vyas et al.), ratio 100' vyas 0.06 particle3_y=0.0013,particle3_z=0.0033 --set 'material_pairs[0].k_n=1e3' --set 'material_pairs[0].k_t=823.5'
}

# gas: rows of $out/gas.tsv: the largest change of the energy of elastic spheres that collide some 80 times each
gas() {
    local law fraction duration=40 errors scene
    : >"$out/gas.tsv"
    for law in hooke hertz; do
        errors='' scene=$here/verify/drift-$law/scene.yaml
        for fraction in $fractions; do
            once "$fraction" '' --set 'observables.every={time: 1}'
            for column in energy_kinetic energy_elastic_normal; do "$SCREE" info "$out/single" --column $column >"$out/$column"; done
            errors="$errors	$(paste -d ' ' "$out/energy_kinetic" "$out/energy_elastic_normal" | awk '{ e = $1 + $2; if (NR == 1) first = e
                off = e / first - 1; if (off < 0) off = -off; if (off > most) most = off } END { printf "%.2g", most }')"
        done
        printf '%s%s\n' "elastic gas, $law" "$errors" | tee -a "$out/gas.tsv"
    done
}

# study NAME WORDS SCENE FLAG...: a row of $out/scenes.tsv: name, words, spread or error of the reference, then the judged error and
# the drift of the energy at each step
study() {
    local name=$1 words=$2 scene=$3
    shift 3
    "$SCREE" ablate "$here/$scene" --error --only step -o "$out/$name" --overwrite --repeat 1 --members 3 --set threads=1 "$@" >"$out/$name.said" 2>&1 ||
        { cat "$out/$name.said" >&2; return 1; }
    awk -F, -v OFS='\t' -v name="$name" -v words="$words" '
        FNR == NR && $3 == 1 { floor = $7 > floor ? $7 : floor; floor = $9 > floor ? $9 : floor }
        FNR == NR { next }
        FNR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
        { part = sprintf("%.3g", $at["dt_of_stable"]); error[part] = $at["judged_error"]; drift[part] = $at["energy_drift"]; seconds[part] = $at["seconds"]; parts[++n] = part }
        END { printf "%s\t%s\t%.2g", name, words, floor; for (k = 1; k <= n; k++) printf "\t%s:%.2g:%.2g:%.3g", parts[k], error[parts[k]], drift[parts[k]], seconds[parts[k]]; print "" }' \
        "$out/$name/speed_error_reference.csv" "$out/$name/speed_error.csv" | tee "$out/$name.row"
}

# column NAME WORDS FLAG...: a small column of soft sand that collapses
column() {
    local name=$1 words=$2
    shift 2
    study "$name" "$words" column/scene.yaml --duration 0.05 --samples 25 --set step.fraction=0.3 --judge sand_z \
        --set 'particles.region={shape: cylinder, centre: [0, 0, 9 mm], radius: 8 mm, length: 18 mm}' --set 'materials[0].young=0.5 MPa' "$@"
}

scene() { # NAME
    case $1 in
    hertz) column "$1" 'column, Hertz, rolling spring, sizes 1 to 3' ;;
    inelastic) column "$1" 'column, restitution 0.1' --set 'material_pairs[0].restitution=0.1' ;;
    hooke) column "$1" 'column, Hooke' --set contact.law=hooke --set 'materials=[{name: quartz, density: 2650}]' \
        --set 'material_pairs=[{restitution: 0.6, friction: 0.5, rolling_friction: 0.1, k_n: 50}]' ;;
    luding) column "$1" 'column, Luding' --set contact.law=luding --set 'materials=[{name: quartz, density: 2650}]' \
        --set 'material_pairs=[{restitution: 0.6, friction: 0.5, rolling_friction: 0.1, k_n: 50, k_2: 150, k_c: 20}]' ;;
    eepa) column "$1" 'column, EEPA' --set contact.law=eepa \
        --set 'material_pairs=[{restitution: 0.6, friction: 0.5, rolling_friction: 0.1, plasticity_ratio: 0.6, adhesion_energy: 0.05}]' ;;
    thornton) column "$1" 'column, Thornton and JKR' --set contact.law=thornton --set contact.cohesion=jkr --set contact.rolling=none --set "materials[0].young=2 MPa" \
        --set 'material_pairs=[{restitution: 0.6, friction: 0.5, yield_pressure: 60000, surface_energy: 0.02}]' ;;
    jkr) column "$1" 'column, JKR' --set contact.cohesion=jkr \
        --set 'material_pairs=[{restitution: 0.6, friction: 0.5, rolling_friction: 0.1, surface_energy: 0.05}]' ;;
    dmt) column "$1" 'column, DMT' --set contact.cohesion=dmt \
        --set 'material_pairs=[{restitution: 0.6, friction: 0.5, rolling_friction: 0.1, surface_energy: 0.05}]' ;;
    capillary) study "$1" 'sand castle, capillary bridges, a moving mould' wet_pile/scene.yaml --duration 0.1 --samples 40 --set step.fraction=0.3 --judge sand_z \
        --set 'materials[0].young=0.1 MPa' --set 'materials[1].young=0.1 MPa' --set 'walls[1].motion[0].start=0.03 s' \
        --set 'particles.region={shape: cylinder, centre: [0, 0, 7 mm], radius: 7.1 mm, length: 12 mm}' ;;
    drum) study "$1" 'discs in a turning drum, mean centre' verify/drum-angle/scene.yaml --duration 40 --samples 120 --mean-from 15 --set 'step={fraction: 0.3}' \
        --set duration=40 --judge centre_x,centre_y --set 'material_pairs[0].k_n=3000' ;;
    pouring) study "$1" 'grains poured into a heap, Hertz, rolling epsd' gallery/pouring.yaml --duration 0.4 --samples 80 --mean-from 0.3 --set step.fraction=0.3 \
        --set 'output=~' --set 'materials[0].young=0.1 MPa' --set 'insertions[0].sizes={law: uniform, min: 2 mm, max: 2.8 mm}' \
        --set 'insertions[0].mass_rate=60 g/s' --set 'observables.list=[{name: centre, components: z}]' --judge centre_z ;;
    slit) study "$1" 'discs flow out of a slit, Hooke' verify/beverloo/scene.yaml --duration 12 --samples 30 --set 'step={fraction: 0.3}' --set duration=12 \
        --judge particles --set particles.count=600 --set 'material_pairs[0].k_n=3000' ;;
    shear) study "$1" 'sheared periodic box, mean stresses' gallery/shear_cell.yaml --duration 0.9 --samples 450 --mean-from 0.15 --set step.fraction=0.3 \
        --set 'output=~' --set 'box.upper=[7 mm, 7 mm, 6 mm]' --set particles.count=220 --set 'material_pairs[0].k_n=20' --judge stress_xy,stress_yy ;;
    dumbbells) study "$1" 'a drum of dumbbells (bodies)' dumbbells/scene.yaml --duration 0.2 --samples 20 --set 'step={fraction: 0.3}' \
        --judge centre_x,centre_z --set 'material_pairs[0].k_n=100 N/m' ;;
    esac
}

# tables: what is there of the results, as the tables of docs/speed-error.md; errors in percent
tables() {
    # shellcheck disable=SC2046
    awk -F'\t' -v parts="$fractions" '
        FNR == 1 { kind = FILENAME; sub(/.*\//, "", kind); last = kind == "impacts.tsv" ? " | mean at 0.15 | mean at 0.9" : ""
            line = "| " (kind == "impacts.tsv" ? "impacts" : kind == "gas.tsv" ? "energy" : "at the end"); rule = "|---"; n = split(parts, part, " ")
            for (k = 1; k <= n; k++) { line = line " | " part[k]; rule = rule "|---" }
            if (last) { line = line last; rule = rule "|---|---" }
            print "\n" line " |\n" rule "|" }
        { line = "| " $1; for (k = 2; k <= NF; k++) line = line " | " ($k ~ /^[-+.e0-9]+$/ ? sprintf("%.2g", 100 * $k) : $k); print line " |" }' \
        $(for name in impacts gas cases; do [ ! -s "$out/$name.tsv" ] || echo "$out/$name.tsv"; done)
    printf '\n| scene | told apart from | 0.15 | 0.3 | 0.45 | 0.6 | 0.9 | drift of the energy, 0.15 to 0.9 | 0.9 is faster than 0.15 by |\n|---|---|---|---|---|---|---|---|---|\n'
    for name in $scenes; do
        [ ! -e "$out/$name.row" ] || awk -F'\t' '
            function percent(x) { return x == "nan" || x >= 0.999 ? "" : sprintf("%.2g", 100 * x) }
            { for (k = 4; k <= NF; k++) { split($k, is, ":"); p = sprintf("%.2f", 0.05 * int(is[1] / 0.05 + 0.5))
                    error[p] = is[2]; drift[p] = is[3]; seconds[p] = is[4] }
                printf "| %s | %s", $2, percent($3)
                n = split("0.15 0.30 0.45 0.60 0.90", part, " ")
                for (k = 1; k <= n; k++) printf " | %s", percent(error[part[k]])
                printf " | %s | %.1f |\n", percent(drift["0.15"]) == "" ? "not counted" : percent(drift["0.15"]) " to " percent(drift["0.90"]), seconds["0.15"] / seconds["0.90"] }' "$out/$name.row"
    done
}

scenes='hertz inelastic hooke luding eepa thornton jkr dmt capillary pouring drum slit shear dumbbells'
# shellcheck disable=SC2086
[ $# -gt 0 ] || set -- impacts cases gas $scenes tables
for part in "$@"; do
    case " impacts cases gas tables $scenes " in
    *" $part "*) ;;
    *) echo "step-fraction.sh: there is no '$part'; there are: impacts cases gas tables $scenes" >&2 && exit 2 ;;
    esac
    case $part in
    impacts | cases | gas | tables) "$part" ;;
    *) scene "$part" || exit 1 ;;
    esac
done
