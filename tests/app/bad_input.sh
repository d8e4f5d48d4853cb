#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Bad input: scenes, data files, meshes, checkpoints, command lines. Each run must end with exit status 2 and one line on
# standard error that begins with "scree: " and names the place; the program may not make or overwrite any file.
#
# The script is a table: NAME, the mistake, words of the message (separated by |), and the command.
set -u
. "$top_srcdir/tests/app/common.sh"
box=$out/box # all that the program sees; it must stay as it is
mkdir "$box" "$out/made"
cd "$box" || exit 1

state() {
    find . -type d | sort
    find . -type f -exec cksum {} + | sort
}

# refused WORDS STATUS STDERR: tells what is wrong with an answer
refused() {
    local words=$1 status=$2 said=$3 word
    local -a list
    [ "$status" = 2 ] || { echo "  exit status $status"; head -n 5 "$said"; return 1; }
    [ "$(wc -l <"$said")" = 1 ] && grep -q '^scree: ' "$said" || { echo "  not one line:"; head -n 5 "$said"; return 1; }
    IFS='|' read -ra list <<<"$words"
    for word in "${list[@]}"; do
        grep -qF -e "$word" "$said" || { echo "  no '$word' in: $(cat "$said")"; return 1; }
    done
    state >"$out/after"
    cmp -s "$out/before" "$out/after" || { echo "  files changed:"; diff "$out/before" "$out/after"; return 1; }
}

# bad NAME WHAT WORDS COMMAND...; RANKS: on how many ranks
RANKS=1
bad() {
    local name=$1 what=$2 words=$3
    shift 3
    state >"$out/before"
    on "$RANKS" "$@" >"$out/stdout" 2>"$out/stderr"
    local status=$?
    # mpirun adds lines of its own about the exit status
    [ "$RANKS" = 1 ] || { grep '^scree' "$out/stderr" >"$out/ours"; mv "$out/ours" "$out/stderr"; }
    check "$name: $what" refused "$words" $status "$out/stderr"
    [ -e new ] && rm -rf new
    return 0
}

good_scene='box: {lower: [0, 0, 0], upper: [10 mm, 10 mm, 10 mm]}
gravity: [0, 0, -9.81]
step: {count: 4}
contact: {law: hertz}
materials: [{name: glass, density: 2500, young: 10 MPa, poisson: 0.2}]
material_pairs: [{restitution: 0.5, friction: 0.3}]
particles: {from: single, position: [5 mm, 5 mm, 5 mm], radius: 1 mm}'

# write_scene FILE LINE...: the good scene; a line replaces the one of the same key, or is appended
write_scene() {
    local file=$1 line key
    shift
    echo "$good_scene" >"$file"
    for line in "$@"; do
        key=${line%%:*}
        if grep -q "^$key:" "$file"; then
            awk -v key="$key:" -v line="$line" 'index($0, key) == 1 { $0 = line } { print }' "$file" >"$out/edited"
            mv "$out/edited" "$file"
        else
            echo "$line" >>"$file"
        fi
    done
}

# scene WHAT WORDS LINE...: runs the good scene with these lines; `check` must say the same
alike() { cmp "$out/stderr" "$out/of_run"; }
scene() {
    local what=$1 words=$2
    shift 2
    write_scene case.yaml "$@"
    bad scene "$what" "$words" "$scree" run case.yaml -o new --quiet
    cp "$out/stderr" "$out/of_run"
    bad scene "$what: checked" "$words" "$scree" check case.yaml
    check "scene: $what: both say the same" alike
}

# data WHAT WORDS FORMAT TEXT: particles from a file of this text
data() {
    write_scene case.yaml "particles: {file: case.data, format: $3}"
    printf "$4" >case.data
    bad "$3" "$1" "$2" "$scree" run case.yaml -o new --quiet
}

# mesh WHAT WORDS: a wall from case.stl
mesh() {
    write_scene case.yaml 'walls: [{shape: mesh, file: case.stl}]'
    bad mesh "$1" "$2" "$scree" run case.yaml -o new --quiet
}

# flip FILE BYTE BIT
flip() {
    local value
    value=$(od -An -tu1 -j "$2" -N 1 "$1")
    printf "\\$(printf %03o $((value ^ 1 << $3)))" | dd of="$1" bs=1 seek="$2" conv=notrunc 2>/dev/null
}

# an empty table would pass every case: the good scene must run, and leave what the cases below need
write_scene good.yaml 'output: {trajectory: {every: 2}}'
check 'the good scene runs' run_scene 1 good.yaml there
ends_well() { run_scene 1 good.yaml there2 --resume there/checkpoint-4.h5 --set step.count=6 && rm -r there2; }
check 'its checkpoint is good' ends_well

echo '== scene'
scene 'unknown key, a like one known' "case.yaml:8|gravty|did you mean|gravity" 'gravty: [0, 0, -9.81]'
scene 'unknown key of a section' "case.yaml:4|contact|lav|law" 'contact: {lav: hertz}'
scene 'a key twice' "case.yaml:4|twice|gravity|case.yaml:2" 'step: {count: 4}
gravity: [0, 0, 0]'
scene 'text for a number' "case.yaml:3|step.count|whole number" 'step: {count: many}'
scene 'a fraction for a whole number' "case.yaml:3|step.count|whole number" 'step: {count: 2.5}'
scene 'a list for a section' "case.yaml:4|contact|section" 'contact: [hertz]'
scene 'two numbers for three' "case.yaml:2|gravity|three numbers" 'gravity: [0, 1]'
scene 'wrong unit' "case.yaml:3|step.dt|kg|s" 'step: {count: 4, dt: 1 kg}'
scene 'unknown unit' "case.yaml:3|step.dt|parsec" 'step: {count: 4, dt: 1 parsec}'
scene 'out of range' "case.yaml:6|restitution|1.5|from 0 to 1" 'material_pairs: [{restitution: 1.5, friction: 0.3}]'
scene 'a negative density' "case.yaml:5|density|> 0" 'materials: [{name: glass, density: -1, young: 10 MPa, poisson: 0.2}]'
scene 'not a number' "case.yaml:2|gravity|nan" 'gravity: [0, .nan, 0]'
scene 'a required key is missing' "case.yaml|materials|density" 'materials: [{name: glass, young: 10 MPa, poisson: 0.2}]'
scene 'no end' "duration|step.count" 'step: {dt: 1 us}'
scene 'unknown index' "case.yaml:8|index.name|octree|brute, linkcell, multi, bytype, hgrid" 'index: {name: octree}'
scene 'unknown law' "case.yaml:4|contact.law|jkr|hooke, hertz" 'contact: {law: jkr}'
scene 'unknown integrator' "case.yaml:8|integrator|euler|synchronised_verlet, velocity_verlet" 'integrator: euler'
scene 'unknown material' "case.yaml:7|material|steel|glass" \
    'particles: {from: single, position: [5 mm, 5 mm, 5 mm], radius: 1 mm, material: steel}'
scene 'a pair of materials is missing' "material_pairs|steel" \
    'materials: [{name: glass, density: 2500, young: 10 MPa, poisson: 0.2}, {name: steel, density: 7800, young: 20 MPa, poisson: 0.3}]' \
    'material_pairs: [{between: [glass, glass], restitution: 0.5}]' \
    'particles: {from: single, position: [5 mm, 5 mm, 5 mm], radius: 1 mm, material: glass}'
scene 'a key of the other law' "case.yaml:6|k_n|hooke" 'material_pairs: [{restitution: 0.5, friction: 0.3, k_n: 1e5}]'
scene 'no tangential stiffness' "case.yaml:6|k_t|> 0" 'contact: {law: hooke}' 'materials: [{name: glass, density: 2500}]' \
    'material_pairs: [{restitution: 0.5, friction: 0.3, k_n: 1e5, k_t: 0}]'
scene 'a step above the stable one' "case.yaml:3|step.dt|stable|step.force" 'step: {count: 4, dt: 1 ms}'
scene 'step.dt and step.fraction both' "case.yaml:3|step.fraction|step.dt|--set KEY=~" 'step: {count: 4, dt: 1 us, fraction: 0.1}'
scene 'gravity along z in two dimensions' "case.yaml:2|gravity|two-dimensional" \
    'box: {dimension: 2, lower: [0, 0, 0], upper: [10 mm, 10 mm, 10 mm]}'
plane='box: {dimension: 2, lower: [0, 0, 0], upper: [10 mm, 10 mm, 10 mm]}'
flat() { # WHAT WORDS LINE: in two dimensions
    scene "$1 in two dimensions" "$2" "$plane" 'gravity: [0, -9.81]' "$3"
}
flat 'an insertion along z' "insertions[0].velocity|two-dimensional|[x, y, 0]" 'insertions: [{sizes: 1 mm, rate: 1, velocity: [0, 0, 3]}]'
flat 'an insertion that tumbles' "insertions[0].omega|plane|[0, 0, z]" 'insertions: [{sizes: 1 mm, rate: 1, omega: [5, 0, 0]}]'
flat 'a group that tumbles' "groups[0].omega|plane|[0, 0, z]" 'groups: [{name: a, motion: moving, omega: [0, 1, 0], select: {ids: [1]}}]'
flat 'a slanting plane' "walls[0].normal|two-dimensional|[x, y, 0]" 'walls: [{shape: plane, point: [0, 0, 0], normal: [0, 1, 1]}]'
flat 'a plane across the particles' "walls[0].normal|where the box ends" 'walls: [{shape: plane, point: [0, 0, 1 mm], normal: [0, 0, 1]}]'
flat 'a leaning cylinder' "walls[0].axis|plane|[0, 0, 1]" 'walls: [{shape: cylinder, point: [0, 0, 0], axis: [0, 1, 1], radius: 1 mm}]'
flat 'a wall that moves along z' "walls[0].motion[0].velocity|two-dimensional|[x, y, 0]" \
    'walls: [{shape: plane, point: [0, 0, 0], normal: [0, 1], motion: [{kind: translate, velocity: [0, 0, 1]}]}]'
flat 'a wall that turns about x' "walls[0].motion[0].direction|plane|[0, 0, z]" \
    'walls: [{shape: plane, point: [0, 0, 0], normal: [0, 1], motion: [{kind: rotate, direction: [1, 0, 0], rate: 1}]}]'
printf '0 0 0 0 0 0 0\n1 0 0 1 0 0 0\n' >motion.txt
flat 'a table along z' "motion.txt:2|plane of a two-dimensional scene" \
    'walls: [{shape: plane, point: [0, 0, 0], normal: [0, 1], motion: [{kind: table, file: motion.txt}]}]'
rm motion.txt
scene 'reduced ghosts, newton off' "case.yaml:8|ghosts|newton: on" 'ghosts: reduced' 'newton: off'
scene 'a periodic box too thin for its particles' "case.yaml:7|diameter|periodic box in x" \
    'box: {lower: [0, 0, 0], upper: [1 mm, 10 mm, 10 mm], periodic: [true, false, false]}' \
    'particles: {from: single, position: [0.5 mm, 5 mm, 5 mm], radius: 1 mm}'
scene 'a plane across a periodic direction' "case.yaml:8|walls[0].normal|periodic" \
    'box: {lower: [0, 0, 0], upper: [10 mm, 10 mm, 10 mm], periodic: true}' \
    'walls: [{shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}]'
scene 'a box turned inside out' "case.yaml:1|box.upper" 'box: {lower: [0, 0, 0], upper: [10 mm, -10 mm, 10 mm]}'
scene 'no such file' "nowhere.data|No such file" 'particles: {file: nowhere.data, format: table}'
scene 'no such mesh' "nowhere.stl|No such file" 'walls: [{shape: mesh, file: nowhere.stl}]'
scene 'no room for the particles' "case.yaml:7|attempts" \
    'particles: {from: random, count: 100000, sizes: 1 mm, attempts: 10}'
scene 'a field that a dump has no columns for' "case.yaml:9|field \"orientation\"|output.trajectory.fields" \
    'bodies: {clumps: [{radius_above: 1 m, spheres: [{centre: [0, 0, 0], radius: 1 mm}]}]}' 'output: {dump: {every: 1, fields: [id, orientation]}}'
scene 'a cut tabulator of YAML' "case.yaml:8" '	index: hgrid'
scene 'a periodic box too thin for the search' "case.yaml:1|periodic x edge|skin" \
    'box: {lower: [0, 0, 0], upper: [2.1 mm, 10 mm, 10 mm], periodic: [true, false, false]}' \
    'particles: {from: single, position: [1 mm, 5 mm, 5 mm], radius: 1 mm}'
scene 'an observable of an unknown wall' "case.yaml:8|observables|lid" \
    'observables: {every: 1, list: [{name: wall_force, target: lid}]}'
scene 'an observable of an absent particle' "case.yaml:8|observables.list[0].id|17" 'observables: {every: 1, list: [{name: position, id: 17}]}'
scene 'an observable without its particle' "case.yaml:8|observables: position|id of a particle" 'observables: {every: 1, list: [{name: position}]}'
scene 'a count of an unknown region' "case.yaml:8|observables: count|no region|lid" \
    'observables: {every: 1, list: [{name: count, target: lid}]}'
scene 'a count without a region' "case.yaml:8|observables: count|no region" 'observables: {every: 1, list: [{name: count}]}'
scene 'a field of the dump that the scene does not have' "case.yaml:8|spinn|no such field" \
    'output: {dump: {every: 2, fields: [position, spinn]}}'
scene 'a field that the scene does not have' "case.yaml:8|torque" 'contact: {law: hertz, tangential: none}' \
    'material_pairs: [{restitution: 0.5}]' 'output: {trajectory: {every: 2, fields: [position, torque]}}'

scene 'an insertion larger than its region' "case.yaml:8|insertions[0].sizes|0.004|up to 0.003" \
    'insertions: [{rate: 1e5, sizes: 2 mm, region: {shape: box, lower: [0, 0, 0], upper: [10 mm, 10 mm, 3 mm]}}]'
s_single() { echo "particles: {from: single, position: [5 mm, 5 mm, 5 mm], radius: $1}"; }
scene 'a radius without a mass' "case.yaml:7|mass|out of range" "$(s_single 1e300)"
scene 'a radius too small for numbers' "case.yaml:7|mass|out of range" "$(s_single 1e-300)"
scene 'a box too large for numbers' "case.yaml:7|rounding" 'box: {lower: [-1e300, 0, 0], upper: [1e300, 10 mm, 10 mm]}'
scene 'the same name twice' "case.yaml:5|materials[1].name|taken" \
    'materials: [{name: glass, density: 2500, young: 10 MPa, poisson: 0.2}, {name: glass, density: 1, young: 1, poisson: 0}]'
scene 'a list for a word' "case.yaml:8|index.name|a list" 'index: {name: [hgrid]}'
scene 'a wall without a direction' "case.yaml:8|walls[0].normal|direction" 'walls: [{shape: plane, point: [0, 0, 0], normal: [0, 0, 0]}]'
scene 'a folder for a mesh' "there|directory" 'walls: [{shape: mesh, file: there}]'
printf 'title: caf\351\n%s\n' "$good_scene" >case.yaml
bad scene 'not UTF-8' "case.yaml:1|YAML" "$scree" run case.yaml -o new --quiet
printf '%s\n---\n%s\n' "$good_scene" "$good_scene" >case.yaml
bad scene 'two documents' "case.yaml:8|second document" "$scree" run case.yaml -o new --quiet
head -c 1000 /dev/zero >case.yaml
bad scene 'zeros' "case.yaml|not a text file" "$scree" run case.yaml -o new --quiet
: >case.yaml
bad scene 'empty' "case.yaml:1|materials" "$scree" run case.yaml -o new --quiet

echo '== what people write who know another program: the message says what to write here'
glass() { echo "materials: [{name: glass, density: 2500, young: 10 MPa, poisson: 0.2}]" | sed "s/$1/$2/"; }
# mistake WHAT WORDS LINE...: as scene, but run alone: `check` reads scenes by the same functions
mistake() {
    local what=$1 words=$2
    shift 2
    write_scene case.yaml "$@"
    bad mistake "$what" "$words" "$scree" run case.yaml -o new --quiet
}
mistake 'rho' "case.yaml:5: unknown key 'materials[0].rho'|'materials[].density'|here: name, density, young, poisson" "$(glass density rho)"
mistake "Young's modulus" "case.yaml:5|'materials[].young'" "$(glass young youngs_modulus)"
mistake 'nu' "case.yaml:5|'materials[].poisson'" "$(glass poisson nu)"
mistake 'mu' "case.yaml:6|'material_pairs[].friction'" 'material_pairs: [{restitution: 0.5, mu: 0.3}]'
mistake 'a long word for restitution' "case.yaml:6|'material_pairs[].restitution'" 'material_pairs: [{restitution_coefficient: 0.5}]'
mistake 'timestep' "case.yaml:8|'step.dt'|allowed here: title" 'timestep: 1 us'
mistake 'a diameter' "case.yaml:7|'particles.radius' (half of the diameter)" \
    'particles: {from: single, position: [5 mm, 5 mm, 5 mm], diameter: 2 mm}'
mistake 'vtk' "case.yaml:8|'output.trajectory' (ParaView" 'output: {vtk: {every: 2}}'
mistake 'a decimal comma in braces' "case.yaml:5|materials[0].poisson|write a decimal point: 0.2" "$(glass '0\.2' 0,2)"
mistake 'a decimal comma in a line' "case.yaml:9|skin.relative|decimal comma" 'skin:
  relative: 0,2'
mistake 'a time for steps' "case.yaml:8|output.trajectory.every|write {time: 10 ms}" 'output: {trajectory: {every: 10 ms}}'
mistake 'names in a list of observables' "case.yaml:8|observables.list[0]|write {name: energy}" 'observables: {every: 2, list: [energy]}'
mistake 'an observable with a typing error' "case.yaml:8|'enrgy' is unknown (did you mean 'energy'?)" \
    'observables: {every: 2, list: [{name: enrgy}]}'
mistake 'two materials of one name, one pair of a third' "case.yaml:5|materials[1].name|taken already" \
    "$(glass '\]' ', {name: glass, density: 1, young: 1, poisson: 0}]')" 'material_pairs: [{between: [glass, steel], restitution: 0.5}]'
mistake 'a tab' "case.yaml:9|a tab indents this line" 'skin:
	relative: 0.1'
mistake 'a key without a colon' "case.yaml:8|a colon and a space must follow" 'threads
index: hgrid'
mistake 'an open quotation mark' "case.yaml:8|not closed" 'title: "a bed'
mistake 'an open brace' "case.yaml:9|the '{' is in line 8" 'index: {name: hgrid
threads: 1'
mistake 'an alias of nothing' "case.yaml:8|'*bed' stands for nothing" 'title: *bed'
mistake 'a wall that faces away' "case.yaml:8: walls[0].normal|'floor' faces away|turned round: [0, 0, 1]" \
    'particles: {from: random, count: 30, sizes: 0.5 mm}' 'walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, -1]}]'
echo 'v 0 0 0' >case.obj
mistake 'an OBJ file without a triangle for a mesh' "case.obj|OBJ" 'walls: [{shape: mesh, file: case.obj}]'
echo 'solid' | gzip >case.stl
mistake 'a packed mesh' "case.stl|gzip|gunzip" 'walls: [{shape: mesh, file: case.stl}]'
rm case.obj case.stl
mistake 'a mesh that is not there' "case.yaml:8: walls[0].file|nowhere.stl|No such file" 'walls: [{shape: mesh, file: nowhere.stl}]'
: >case.data
mistake 'an empty table' "case.data: the file holds no particles" 'particles: {file: case.data, format: table}'
echo 1 >case.data
mistake 'no such column' "case.yaml:7: particles.sources[0].columns|'zz' is not a column" \
    'particles: {file: case.data, format: table, columns: [zz]}'

# several mistakes: a line each, up to ten
write_scene case.yaml 'step: {count: many}' 'gravty: 3' 'contact: {law: jkr}' "$(glass density rho)" \
    'material_pairs: [{restitution: 1.5, friction: -0.3}]' 'newton: off' 'ghosts: reduced'
said="8: unknown key 'gravty'|3: step.count|4: contact.law|5: unknown key 'materials\[0\].rho'|6: .*restitution|6: .*friction"
several() { # LINES: the run says so many lines, each of them of the list
    "$scree" run case.yaml -o new --quiet 2>"$out/stderr"
    [ $? = 2 ] && [ "$(wc -l <"$out/stderr")" = "$1" ] && [ "$(grep -cE "^scree: case.yaml:($said)" "$out/stderr")" = "$1" ]
}
check 'six mistakes: six lines, and nothing that follows from them' several 6
write_scene case.yaml 'units: none'
said='.*no units in a dimensionless scene'
check 'units in a scene without units' several 4
write_scene case.yaml 'box: {lower: [0, 0, 0], upper: [10 mm, 10 mm, 10 mm], a: 1, b: 1, c: 1, d: 1, e: 1, f: 1, g: 1, h: 1, i: 1, j: 1, k: 1}'
eleven() {
    "$scree" run case.yaml -o new --quiet 2>"$out/stderr"
    [ $? = 2 ] && [ "$(grep -c "^scree: case.yaml:1: unknown key" "$out/stderr")" = 10 ] &&
        [ "$(tail -n 1 "$out/stderr")" = 'scree: and there are more mistakes' ]
}
check 'eleven mistakes: ten lines, and one more' eleven
write_scene case.yaml 'step: {count: 4, fraction: 0.1, dt: 1 us}' 'newton: off' 'ghosts: reduced'
said='3: step.fraction|9: ghosts'
check 'two impossible combinations: two lines' several 2

# notes: the run is possible, but hardly meant
noted() { # WORDS LINE...: a run of no steps prints this note
    local words=$1
    shift
    write_scene case.yaml 'step: {count: 0}' "$@"
    "$scree" run case.yaml -o noted 2>"$out/stderr" >/dev/null || return 1
    rm -r noted
    grep -qF -e "$words" "$out/stderr" || { cat "$out/stderr"; return 1; }
}
lid='walls: [{name: lid, shape: plane, point: [0, 0, 9 mm], normal: [0, 0, -1], motion: [{kind: servo, force: 1 N, speed_max: 1, direction: [0, 0, 1]}]}]'
check 'a servo that pushes away from the particles' noted "servo of wall 'lid' pushes away" "${lid/0, 0, 1]\}/0, 0, -1]\}}"
check 'a servo that pushes on the particles' eval "! noted 'pushes away' \"\$lid\" >/dev/null"; rm -rf noted
printf 'solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 100 0 0\nvertex 0 100 0\nendloop\nendfacet\nendsolid\n' >case.stl
check 'a mesh in millimetres' noted 'in millimetres (walls[0].scale: 0.001)?' 'walls: [{shape: mesh, file: case.stl}]'
rm case.stl
mkdir empty
fits() { "$scree" run good.yaml --quiet -o "$1" >/dev/null 2>&1 && [ -e "$1/report.json" ] && rm -r "${1%%/*}"; }
check 'an empty folder is taken' fits empty
check 'a folder in folders that are missing is made' fits deep/er/new

echo '== messages that name the key and the remedy'
mistake 'a fraction above the whole step' "case.yaml:3: step.fraction: 2 of the stable time step|up to 1" 'step: {count: 4, fraction: 2}'
mistake 'sieves in falling order' "sizes: diameters must increase: 0.001 comes after 0.002|finest sieve" \
    'particles: {from: random, count: 10, sizes: {law: table, diameters: [2 mm, 1 mm, 0.5 mm], passing: [1, 0.5, 0]}}'
mistake 'a strain along an open side' "box.strain.rate: the box is open along z|box.periodic along z" \
    'box: {lower: [0, 0, 0], upper: [10 mm, 10 mm, 10 mm], strain: {rate: [0, 0, -0.1]}}'
mistake 'two observables of one column' "a column of list[2] would be called \"momentum_x\", as one of list[0] is" \
    'observables: {every: 2, list: [{name: momentum}, {name: speed_max}, {name: momentum}]}'
mistake 'another word for a field' "did you mean 'angular_velocity'?" 'output: {dump: {every: 2, fields: [omega]}}'
write_scene two.yaml 'materials: [{name: a, density: 2500, young: 10 MPa, poisson: 0.2}, {name: b, density: 2500, young: 10 MPa, poisson: 0.2}]' \
    'particles: {from: single, position: [5 mm, 5 mm, 5 mm], radius: 1 mm, material: a}'
bad mistake 'a key of a pair that has no entry' "material_pairs[b, a].friction: |known: 0; material_pairs[b, a]={...} adds an entry" \
    "$scree" check two.yaml --set 'material_pairs[b, a].friction=0.1'
bad mistake 'a pair of an unknown material' "material_pairs[1].between[1]: 'wa'|known: a, b" \
    "$scree" check two.yaml --set 'material_pairs[b, wa]={friction: 0.1, restitution: 0.3}'
added() { "$scree" check two.yaml --set 'material_pairs[b, a]={friction: 0.1, restitution: 0.3}' --set 'material_pairs[a, b].friction=0.2' | grep -q ': valid'; }
check 'a whole entry of a pair is added' added
mkdir bare
bad mistake 'info of a folder without files of a run' "bare: is a folder without trajectory.h5" "$scree" info bare
of_folder() { "$scree" info there >"$out/told" && holds "$out/told" 'there/trajectory.h5: H5MD' && holds "$out/told" 'there/checkpoint-4.h5: checkpoint'; }
check 'info of the folder of a run' of_folder
light() { "$scree" check good.yaml --set materials[0].density=2.5 >"$out/told" && holds "$out/told" 'NOTE: materials[0].density: 2.5 kg/m3 is the density of a gas; of a solid? Then write 2.5 g/cm3'; }
check 'a density in g/cm3 is noted' light
: >page.html
bad mistake 'report over a file' "page.html: is there already (--overwrite replaces it)" "$scree" report there -o page.html
: >page.pov
bad mistake 'picture over a file' "page.pov: is there already (--overwrite replaces it)" "$scree" picture there -o page.pov

echo '== pipes'
mkfifo pipe
piped() { mistake "a named pipe: $1" "$2: pipe is a named pipe" "$3"; }
piped 'a table' 'particles.sources[0].file' 'particles: {file: pipe, format: table}'
piped 'a mesh' 'walls[0].file' 'walls: [{shape: mesh, file: pipe}]'
piped 'sizes' 'sizes.file' 'particles: {from: random, count: 3, sizes: {law: table, file: pipe}}'
piped 'bonds' 'bonds.list' 'bonds: {list: pipe, laws: [{k_n: 1, k_s: 1}]}'
piped 'a motion' 'walls[0].motion[0].file' 'walls: [{shape: plane, point: [0, 0, 0], normal: [0, 0, 1], motion: [{kind: table, file: pipe}]}]'
write_scene case.yaml 'contact: {law: {file: pipe}}' 'materials: [{name: glass, density: 2500}]' 'material_pairs: [{restitution: 0.5, friction: 0.3, k_n: 1e5}]'
bad mistake 'a named pipe: a law' 'pipe is a named pipe' "$scree" run case.yaml -o new --quiet
bad mistake 'a named pipe: a scene' 'pipe: is a named pipe' "$scree" run pipe -o new --quiet
bad mistake 'a named pipe: info' 'pipe: is a named pipe' "$scree" info pipe
bad mistake 'a named pipe: convert' 'pipe: is a named pipe' "$scree" convert pipe new.data
bad mistake 'a named pipe: resume' 'pipe: is not a file' "$scree" run good.yaml -o new --resume pipe
rm pipe
unnamed() { "$scree" check <(cat good.yaml) | grep -q ': valid'; }
check 'a pipe without a name is read' unnamed

echo '== data files'
head='LAMMPS\n\n2 atoms\n1 atom types\n0 0.01 xlo xhi\n0 0.01 ylo yhi\n0 0.01 zlo zhi\n\nAtoms # sphere\n\n'
first='1 1 0.002 2500 0.002 0.005 0.005\n'
data 'truncated' "case.data|2" lammps-data "$head$first"
data 'a word for a number' "case.data:12|not a number" lammps-data "$head$first"'2 1 wide 2500 0.006 0.005 0.005\n'
data 'too few columns' "case.data:12" lammps-data "$head$first"'2 1 0.002 2500\n'
data 'more atoms than announced' "case.data" lammps-data \
    "$head$first"'2 1 0.002 2500 0.006 0.005 0.005\n3 1 0.002 2500 0.008 0.005 0.005\n'
data 'an id twice' "case.data:12|particle 1, line 11" lammps-data "$head$first"'1 1 0.002 2500 0.006 0.005 0.005\n'
data 'another atom style' "case.data:9|molecular|sphere" lammps-data "${head/sphere/molecular}$first"
data 'a type without material' "case.data|type" lammps-data "$head$first"'2 2 0.002 2500 0.006 0.005 0.005\n'
data 'empty' "case.data" lammps-data ''
second='2 1 0.002 2500 0.006 0.005 0.005\n'
data 'nan for a position' "case.data:12|not a number" lammps-data "$head$first"'2 1 0.002 2500 nan 0.005 0.005\n'
data 'a negative diameter' "case.data:12|positive" lammps-data "$head$first"'2 1 -0.002 2500 0.006 0.005 0.005\n'
data 'a velocity twice' "case.data:17|second velocity|id 1" lammps-data \
    "$head$first$second"'\nVelocities\n\n1 0 0 0 0 0 0\n1 0 0 0 0 0 0\n'
data 'a velocity without spin' "case.data:16|4 columns|7: id vx vy vz wx wy wz" lammps-data \
    "$head$first$second"'\nVelocities\n\n1 0 0 0\n2 0 0 0\n'
data 'a velocity of too many numbers' "case.data:16|8 columns|wx wy wz" lammps-data \
    "$head$first$second"'\nVelocities\n\n1 0 0 0 0 0 0 0\n2 0 0 0\n'
dump='ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\nITEM: ATOMS id x y z radius\n1 0 0 0 1\n'
data 'a dump' "case.data:1|LAMMPS dump|scree convert" lammps-data "$dump"
data 'a dump' "case.data:1|LAMMPS dump|scree convert" table "$dump"
data 'a speed out of range' "case.data|speed" lammps-data \
    "$head$first$second"'\nVelocities\n\n1 0 0 0 0 0 0\n2 1e300 0 0 0 0 0\n'
data 'more atoms than a file can hold' "case.data|too short" lammps-data "${head/2 atoms/1000000000000 atoms}$first"
data 'no such column' "case.data:1|colour" table 'radius x y z colour\n0.001 0.005 0.005 0.005 3\n'
data 'a word for a number' "case.data:2|here" table 'radius x y z\n0.001 here 0.005 0.005\n'
data 'truncated row' "case.data:3" table 'radius x y z\n0.001 0.002 0.005 0.005\n0.001 0.006\n'
data 'coinciding centres' "case.data|coincide" table 'radius x y z\n0.001 0.002 0.005 0.005\n0.001 0.002 0.005 0.005\n'
printf 'id radius x y z\n3 0.001 0.002 0.002 0.002\n7 0.001 0.002 0.002 0.005\n' >other.data
printf 'id radius x y z\n7 0.001 0.006 0.005 0.005\n' >case.data
scene 'an id of two files' 'case.data:2: |particle 7, line 3 of other.data|`ids: new`' \
    'particles: {sources: [{file: other.data, format: table}, {file: case.data, format: table}]}'
data 'an id twice' "case.data:3|particle 7|line 2" table 'id radius x y z\n7 0.001 0.002 0.005 0.005\n7 0.001 0.006 0.005 0.005\n'
data 'a radius of zero' "case.data:2|radius" table 'radius x y z\n0 0.002 0.005 0.005\n'
data 'infinite position' "case.data:2|x" table 'radius x y z\n0.001 inf 0.005 0.005\n'
data 'too far away' "case.data:2|rounding" table 'radius x y z\n0.001 1e30 0.005 0.005\n'
write_scene case.yaml 'particles: {file: case.data, format: lammps-data}'
printf "$head$first$second" >case.data
check 'packed: particles as they are' run_scene 1 case.yaml plain
"$scree" info case.data >"$out/plain_info"
gzip <case.data >packed
gzip <case.yaml >packed.yaml
cp packed case.data
same_run() { # SCENE DIR
    run_scene 1 "$1" "$2" && contents plain/checkpoint-4.h5 >"$out/plain" && contents "$2/checkpoint-4.h5" >"$out/unpacked" &&
        diff "$out/plain" "$out/unpacked"
}
same_info() { grep -q 'particles *2$' "$out/plain_info" && "$scree" info case.data | diff "$out/plain_info" -; }
check 'packed: particles are read' same_run case.yaml of_packed
check 'packed: so is a scene' same_run packed.yaml of_scene
check 'packed: info tells the same' same_info
rm -r plain of_packed of_scene packed.yaml
size=$(stat -c %s packed)
for length in 40 $((size - 6)); do
    head -c "$length" packed >case.data
    bad packed "cut to $length of $size bytes" "case.data|cut off" "$scree" run case.yaml -o new --quiet
done
cp packed case.data
flip case.data $((size / 2)) 3
bad packed 'a bit flipped' "case.data|damaged" "$scree" run case.yaml -o new --quiet
rm packed
write_scene case.yaml 'box: {lower: [0, 0, 0], upper: [10 mm, 10 mm, 10 mm], leave: {all: error}}' \
    'particles: {file: case.data, format: table}'
printf 'radius x y z\n0.001 0.002 0.005 0.005\n0.001 0.02 0.005 0.005\n' >case.data
bad table 'a centre outside of a closed box' "case.data|outside" "$scree" run case.yaml -o new --quiet
write_scene case.yaml 'particles: {file: case.data, format: h5md}'
h5md() { bad h5md "$1" "$2" "$scree" run case.yaml -o new --quiet; }
size=$(stat -c %s there/trajectory.h5)
head -c $((size / 2)) there/trajectory.h5 >case.data
h5md 'truncated' "case.data"
echo 'not HDF5' >case.data
h5md 'a text file' "case.data|HDF5"
cp there/checkpoint-4.h5 case.data
h5md 'a checkpoint' "case.data"
write_scene case.yaml 'particles: {file: there/trajectory.h5, format: h5md, frame: 99}'
h5md 'a frame that is not there' "there/trajectory.h5|99"

echo '== meshes'
# stl COUNT HEX...: a binary STL that announces COUNT triangles, of the given floats (octal escapes, little endian)
zero='\0\0\0\0' one='\0\0\200\77' nan='\0\0\300\177'
stl() {
    printf '%80s' ''
    printf "\\$(printf %03o "$1")\\0\\0\\0"
    shift
    printf "$zero$zero$zero"
    printf "$1"
    printf '\0\0'
}
triangle="$zero$zero$zero$one$zero$zero$zero$one$zero"
stl 1 "$triangle" | head -c 100 >case.stl
mesh 'binary STL cut off' "case.stl|truncated"
stl 3 "$triangle" >case.stl
mesh 'binary STL with fewer triangles than it says' "case.stl|3 triangles"
stl 1 "$zero$zero$nan$one$zero$zero$zero$one$zero" >case.stl
mesh 'a corner that is no number' "case.stl|triangle 1|not finite"
stl 1 "$one$one$one$one$one$one$one$one$one" >case.stl
mesh 'all corners at one point' "case.stl|one point"
stl 1 "$zero$zero$zero$one$zero$zero$one$zero$zero" >case.stl
mesh 'a sliver and nothing else' "case.stl|degenerate"
: >case.stl
mesh 'empty' "case.stl|empty"
printf 'solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0\n' >case.stl
mesh 'ASCII STL with a vertex of two numbers' "case.stl:5|three numbers"
printf 'solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n' >case.stl
mesh 'ASCII STL cut off' "case.stl|truncated"

echo '== checkpoints'
resume() { bad checkpoint "$1" "$2" "$scree" run good.yaml -o new --quiet --set step.count=6 --resume case.h5; }
checkpoint=there/checkpoint-4.h5
size=$(stat -c %s $checkpoint)
for length in 0 100 4096 $((size / 2)) $((size - 1)); do
    head -c "$length" $checkpoint >case.h5
    resume "cut to $length of $size bytes" "case.h5"
done
cp $checkpoint case.h5
printf 'more' >>case.h5
resume 'longer than it was' "case.h5|more"
for byte in 9 300 $((size / 4)) $((size / 2)) $((3 * size / 4)) $((size - 1)); do
    cp $checkpoint case.h5
    flip case.h5 "$byte" $((byte % 8))
    resume "bit $((byte % 8)) of byte $byte of $size flipped" "case.h5"
done
cp there/trajectory.h5 case.h5
resume 'another HDF5 file' "case.h5|is not a checkpoint"
cp good.yaml case.h5
resume 'a text file' "case.h5|is not a checkpoint"
rm case.h5
resume 'no such file' "case.h5|No such file"
cp $checkpoint case.h5
bad checkpoint 'of another box' "case.h5|box" \
    "$scree" run good.yaml -o new --quiet --set 'box.upper=[20 mm, 10 mm, 10 mm]' --resume case.h5
bad checkpoint 'of another law' "case.h5|contact.law" \
    "$scree" run good.yaml -o new --quiet --set contact.rolling=spring --resume case.h5
rm case.h5
bad checkpoint 'the last of a folder without any' "there2" "$scree" run good.yaml -o there2 --quiet --resume last

echo '== command line'
line() { local words=$2 what=$1; shift 2; bad 'command line' "$what" "command line|$words" "$scree" "$@"; }
line 'unknown command' "walk|run, check" walk good.yaml
line 'unknown flag' "--fast" run good.yaml -o new --fast
line 'a flag with a slip' '--ouput (did you mean --output?)' run good.yaml --ouput new
line 'a flag of another command' "--frame" run good.yaml -o new --frame 1
line 'no -o' "-o DIR" run good.yaml
line 'no scene' "too few" run -o new
line 'the beginning of several flags' "several flags begin with --s" ablate good.yaml -o new --s 3
line 'an argument for none' "--quiet takes no argument" run good.yaml -o new --quiet=3
line 'a flag twice' "--output is given twice: a and b" run good.yaml --out a -o b
line 'two scenes' "one argument too many" run good.yaml good.yaml -o new
line '-o without a folder' "needs its DIR" run good.yaml -o
line '--set without =' "KEY=VALUE" run good.yaml -o new --set step.count
line '--set of an unknown key' "step.cuont" run good.yaml -o new --set step.cuont=3
line '--set of a bad value' "step.count|many" run good.yaml -o new --set step.count=many
line '--set of an empty key' "--set" run good.yaml -o new --set =3
line 'ablate of an unknown index' "octree" ablate good.yaml -o new --index brute,octree
line 'convert to an unknown format' "vtk|lammps-data" convert there/trajectory.h5 new --to vtk
line 'a packing of more than can be numbered' "too many|fewer than 134217728" \
    pack bidisperse new.data ratio=10 box=1200 numbers=recipe
line '-o without a name' "-o|empty" run good.yaml -o ''
line '--set of a number that is not in the list' "materials[-1]|list has 1" run good.yaml -o new --set 'materials[-1].young=1'
bad 'command line' 'convert into itself' "there/trajectory.h5|itself" \
    "$scree" convert there/trajectory.h5 there/trajectory.h5 --overwrite
bad 'command line' 'resume from a folder' "there|not a file" "$scree" run good.yaml -o new --resume there
printf 'ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1000000000000\nITEM: BOX BOUNDS pp pp pp\n0 1\n0 1\n0 1\nITEM: ATOMS id x y z radius\n' >case.lammpstrj
bad 'command line' 'convert a dump of more than it can hold' "case.lammpstrj:4|cannot be in this file" \
    "$scree" convert case.lammpstrj new --to lammps-data
bad 'command line' 'no such scene' "nowhere.yaml|No such file" "$scree" run nowhere.yaml -o new
bad 'command line' 'a folder for a scene' "there" "$scree" run there -o new
little() { # COMMAND: of a machine with little memory
    bad "$1" 'more particles than memory' 'particles: 20000000 particles need|GiB are free' bash -c 'ulimit -v 3000000; exec "$@"' little "$scree" "$@"
}
write_scene case.yaml 'particles: {from: random, count: 20000000, sizes: 1 um}'
little run case.yaml -o new --quiet
little check case.yaml
bad 'command line' 'a folder that exists' "there|exists already|--overwrite" "$scree" run good.yaml -o there
bad 'command line' 'a file in place of the folder' "good.yaml|not a directory" "$scree" run good.yaml -o good.yaml --overwrite
bad 'command line' 'a folder below a file' "good.yaml/where|Not a directory" "$scree" run good.yaml -o good.yaml/where
line 'two folders' "--output is given twice: new and there" run good.yaml -o new -o there
bad 'command line' 'info of a foreign file' "good.yaml" "$scree" info good.yaml
bad 'command line' 'convert over a file' "good.yaml|there already|--overwrite replaces it" "$scree" convert there/trajectory.h5 good.yaml --to lammps-data

echo '== on two ranks'
RANKS=2
scene 'unknown key' "case.yaml:8|gravty" 'gravty: [0, 0, -9.81]'
data 'coinciding centres' "case.data|coincide" table 'radius x y z\n0.001 0.002 0.005 0.005\n0.001 0.002 0.005 0.005\n'
stl 1 "$triangle" | head -c 100 >case.stl
mesh 'binary STL cut off' "case.stl|truncated"
head -c $((size / 2)) $checkpoint >case.h5
resume 'cut in the middle' "case.h5"
line '--set without =' "KEY=VALUE" run good.yaml -o new --set step.count
little() (
    ulimit -v 3000000
    bad 'memory' 'more particles than memory' "particles: 20000000 particles need|GiB are free" "$scree" "$@" && [ "$failures" = 0 ]
)
write_scene case.yaml 'particles: {from: random, count: 20000000, sizes: 1 um}'
little run case.yaml -o new --quiet
little check case.yaml
bad 'command line' 'a folder that exists' "there|exists already" "$scree" run good.yaml -o there

finish
