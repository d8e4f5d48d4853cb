#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The output of the program for people: help, progress on terminals of any width, notes.

. "$(dirname "$0")/common.sh"
cd "$out" || exit 1

echo '== help'
# section COMMAND FLAG: the lines of help on a flag
section() { "$scree" help "$1" | awk -v flag="--$2" '$1 ~ /^--/ { on = $1 == flag } on'; }
overwrites() { # COMMAND WORDS: what its own --overwrite does, and that alone
    section "$1" overwrite >said
    [ "$(wc -l <said)" = 2 ] && holds said "$2"
}
check 'convert replaces a file' overwrites convert 'a file that is there already is replaced'
check 'pack replaces a file' overwrites pack 'a file that is there already is replaced'
check 'run deletes the files of an earlier run' overwrites run 'files of an earlier run in it, checkpoints too, are deleted'
check 'ablate replaces tables' overwrites ablate 'tables of an earlier ablate in it are replaced'
resumes() { section "$1" output >said && holds said 'exists: refused' && lacks said --resume; }
check 'ablate has no --resume to point to' resumes ablate

cat >scene.yaml <<'EOS'
units: none
box: {lower: [0, 0, 0], upper: [10, 10, 10]}
gravity: [0, 0, -10]
threads: 1
step: {dt: 0.001, count: 1000000000}
contact: {law: hooke, tangential: none}
materials: [{name: soft, density: 1}]
material_pairs: [{restitution: 0.6, k_n: 10000}]
walls: [{name: floor, shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}]
particles: {from: random, count: 200, sizes: 0.3}
observables: {every: 1000000}
EOS

echo '== progress'
# typed COLUMNS SCENE WORDS: `drawn` gets the lines with these words, three at least, of what a terminal of that width is sent. SIGINT ends
# the run once it has drawn them
typed() {
    local columns=$1 scene=$2 words=$3 good
    rm -f pid drawn
    : >sent
    TERM=xterm script -qfc "stty cols $columns; echo \$\$ >pid; exec $scree run $scene -o typed --overwrite" sent </dev/null >/dev/null &
    wait_until drawings "$words"
    good=$?
    kill -INT "$(cat pid)"
    wait $!
    drawings "$words" # the last one whole
    [ $good = 0 ] || { echo "  only $(wc -l <drawn) drawings"; cat said; }
    return $good
}
drawings() {
    [ -s pid ] || return 1
    tr '\r' '\n' <sent >said
    grep -a "$1" said | sed 's/^.\[K//' >drawn
    [ "$(wc -l <drawn)" -ge 3 ]
}
fits() { # COLUMNS WORDS: each drawing is shorter than the terminal is wide, and says so much
    local columns=$1 words=$2
    typed "$columns" scene.yaml ' left' || return 1
    awk -v columns="$columns" 'length($0) >= columns { print "  " length($0) " columns: " $0; bad = 1 } END { exit bad }' drawn &&
        tail -n 1 drawn && [ "$(tail -n 1 drawn | grep -cE "$words")" = 1 ]
}
if script -qc true /dev/null </dev/null >/dev/null 2>&1; then
    check '40 columns: how much is done, and the time left' fits 40 '^\[[#.]{8,}\]  *[0-9]+ % [-0-9:]+ left$'
    check '80 columns: the step, too' fits 80 '% [-0-9:]+ left, step [0-9]+ of 1000000000'
    check '108 columns: the time, too' fits 108 ' left, step [0-9]+ of 1000000000, t = '
    check '200 columns: memory and observables, too' fits 200 ' left, step [0-9]+ of 1000000000, t = .*, [0-9.e+]+ particle-steps/s, [0-9]+ MiB'
    check '20 columns: no bar' fits 20 '^ *[0-9]+ % [-0-9:]+ left$'
    endless() { # nobody knows the end of a stage that ends by conditions: the step, and neither a bar nor a part
        sed '/^step:/s/, count: [0-9]*//' scene.yaml >open.yaml
        echo 'stages: [{name: long, until: [{name: particles, at_least: 100000}]}]' >>open.yaml
        typed 40 open.yaml 'step [1-9][0-9]*, t = ' && lacks said '% ' && awk 'length($0) >= 40 { exit 1 }' drawn || { cat said; return 1; }
    }
    check '40 columns, and an end that nobody knows: the step' endless
else
    skip 'terminals: no script (bsdutils) here'
fi
piped() { # lines, and nothing for a terminal; tests/data/observe/test_progress counts how many
    local line='^ *0 % .* left, step [0-9]* of 1000000000, t = .* particle-steps/s, [0-9]* MiB, energy_kinetic [-+.e0-9]*, ' runner good
    "$scree" run scene.yaml -o piped >said 2>told &
    runner=$!
    wait_until lines_there told "$line" 1
    good=$?
    kill -INT $runner
    wait $runner
    [ $good = 0 ] && lacks told '[K' || { cat told; return 1; }
}
check 'a line after some seconds where there is no terminal' piped
tenths() { "$scree" run scene.yaml -o tenths --set step.count=100 --set output.progress=lines >said 2>told; [ "$(grep -c ' % .* left, step ' told)" = 10 ] || { cat told; return 1; }; }
check 'at each tenth where lines are asked for' tenths
silent() { "$scree" run scene.yaml -o silent --quiet --set step.count=100 --set output.progress=lines >said 2>told && [ ! -s told ] && [ ! -s said ]; }
check 'none where it is to be quiet' silent

echo '== what a run will cost'
costs() { # COUNT WORDS FLAG...: check prints so many such lines
    local count=$1 words=$2
    shift 2
    "$scree" check --all scene.yaml "$@" >said 2>&1
    sed -n '/^what a run will cost/,/^$/p' said >cost
    [ "$(grep -cE "$words" cost)" = "$count" ] || { cat said; return 1; }
}
check 'steps, time and files' costs 6 '^  steps +100 of 0.001$|^    trajectory.h5 +11 frames, about [0-9.]+ kB$|^    dump.lammpstrj +3 frames|^    observables.csv +1 row$|^  time +about [0-9.e-]+ s, by the 100 first steps|^    checkpoint-STEP.h5 +1 file' \
    --set step.count=100 --set output.trajectory.every=10 --set output.trajectory.xdmf=off --set output.dump.every=50
check 'lists of contacts, and grids' costs 2 '^    contacts in trajectory.h5 +11 lists$|^    grid-all.csv +24 rows$' --set step.count=100 --set output.trajectory.contacts=10 --set 'observables.grids=[{name: all, every: 50, cells: [2, 2, 2]}]'
check 'nothing is written' costs 1 '^    nothing else will be written' --set 'observables=~' --set step.count=1
check 'no end' costs 1 '^  steps +without end' --set duration=1e300
sized() { # the size that check tells is that of the file, within a tenth
    "$scree" run scene.yaml -o sized --quiet --set step.count=100 --set output.trajectory.every=1 && "$scree" check --all scene.yaml --set step.count=100 --set output.trajectory.every=1 >said 2>&1
    awk -v size="$(stat -c %s sized/trajectory.h5)" '$1 == "trajectory.h5" { told = $5 * ($6 == "MB" ? 1e6 : 1e3); print told, size; good = told > 0.9 * size && told < 1.1 * size } END { exit !good }' said
}
check 'the size of a trajectory' sized

echo '== notes'
printf 'solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 2 0\nendloop\nendfacet\nendsolid\n' >far.stl
# repeats STATUS COUNT [FLAG...]: check and run have the same so many notes; check ends with this status
repeats() {
    local status=$1 count=$2 given
    shift 2
    "$scree" check --all scene.yaml --set step.count=1 "$@" >said 2>&1
    given=$?
    [ "$given" = "$status" ] || { echo "  status $given"; tail -n 3 said; return 1; }
    rm -rf noted
    "$scree" run scene.yaml -o noted --set step.count=1 "$@" >said_run 2>told
    grep -E '^(NOTE|warning): ' said >of_check
    sed -n 's/^scree: \(NOTE: \|warning: \)/\1/p' told | grep -v ' (said once)$' >of_run
    cat of_check
    [ "$(wc -l <of_check)" = "$count" ] && cmp of_check of_run || { cat told; return 1; }
}
check 'nothing to note' repeats 0 0
check 'particles outside of the box' repeats 0 1 --set 'particles={from: single, position: [12, 5, 5], radius: 1}'
check 'a mesh outside of the box' repeats 0 1 --set 'walls[1]={name: far, shape: mesh, file: far.stl, offset: [20, 0, 0]}'
check 'a guard that would warn' repeats 0 1 --set guards.speed=warn --set guards.overlap=off --set step.speed_max=2000
check 'one that would stop the run: status 3' repeats 3 1 --set guards.overlap=off --set step.speed_max=2000
check 'a step above the stable one' repeats 0 1 --set step.force=true --set step.dt=0.01 --set guards.overlap=off
check 'no output but the end' repeats 0 1 --set 'observables=~'
still() { "$scree" run scene.yaml -o still --quiet --set step.count=1 --set 'observables=~' >said 2>told && [ ! -s told ]; }
check 'no notes where it is to be quiet' still

echo '== single values'
run_scene 1 scene.yaml short --set step.count=3 --set observables='{every: 1, list: [{name: energy_kinetic}, {name: momentum}]}'
gets() { [ "$("$scree" info short --get "$1")" = "$2" ] && [ "$("$scree" info short/report.json --get "$1")" = "$2" ]; }
check 'a key of the report' gets last_step 3
check 'the same, with the name of the file' gets report.last_step 3
check 'a text of the report' gets index "$(sed -n 's/^  "index": "\([a-z]*\)",/\1/p' short/report.json)"
stage() { local found; found=$("$scree" info short --get stages.contact.max) && [ -n "$found" ] && grep -qF "\"contact\": {" short/report.json && grep -F '"contact": {' short/report.json | grep -qF "\"max\": $found}"; }
check 'a key of a stage' stage
rows() { # ROW LINE: the values of the columns in that line of the file
    [ "$("$scree" info short --column energy_kinetic --row "$1"),$("$scree" info short/observables.csv --column 'momentum_z[1]' --row "$1")" = \
        "$(sed -n "$2"p short/observables.csv | awk -F , '{ print $2 "," $5 }')" ]
}
check 'the last row of a column' rows last 5
check 'the first row of a column' rows first 2
check 'row 1, and row -2' eval 'rows 1 3 && rows -2 4'
check 'a whole column' eval '[ "$("$scree" info short --column energy_kinetic)" = "$(awk -F , "NR > 1 { print \$2 }" short/observables.csv)" ]'
refuses() { # WORDS ARGUMENT...: with status 2, and nothing on standard output
    local words=$1
    shift
    "$scree" info "$@" >answer 2>said
    [ $? = 2 ] && [ ! -s answer ] && [ "$(wc -l <said)" = 1 ] && holds said "$words"
}
check 'an unknown key' refuses 'at the top are' short --get colour
check 'a key in several places' refuses 'stands in several places: stages.' short --get mean
check 'a section' refuses 'is no single value; it has' short --get stages.contact
check 'an unknown column' refuses 'there are time' short --column colour
check 'a row that is not there' refuses 'there is no such row; there are 4' short --column energy_kinetic --row 4
check 'a row that is no number' refuses 'must be first, last' short --column energy_kinetic --row next
check 'a table for a report' refuses 'reads report.json' short/observables.csv --get pairs

echo '== manual page and completion'
described() { # every flag of every command stands in both
    "$scree" help --man | sed 's/\\-/-/g' >page && "$scree" help --bash >completion && bash -n completion || return 1
    for command in run check ablate info convert picture report pack; do
        "$scree" help "$command" | sed -n 's/^  \(--[a-z-]*\).*/\1/p' >flags
        [ -s flags ] && holds page ".SS scree $command" || return 1
        while read -r flag; do
            holds page "$flag" && holds completion "$flag" || return 1
        done <flags
    done
}
check 'they have all flags' described
completes() { # WORDS ANSWER
    local answer
    answer=$(bash -c 'source ./completion; COMP_WORDS=('"$1"'); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _scree; echo "${COMPREPLY[*]}"')
    [ "$answer" = "$2" ] || { echo "  $answer"; return 1; }
}
check 'a command is completed' completes 'scree ab' ablate
check 'a flag is completed' completes 'scree check --ra' --ranks

fish_completes() {
    "$scree" help --fish >scree.fish
    [ "$(HOME=$out fish -c 'source scree.fish; complete -C "scree pic"' | cut -f1)" = picture ] &&
        HOME=$out fish -c 'source scree.fish; complete -C "scree check --ra"' | grep -q '^--ranks'
}
if command -v fish >/dev/null; then check 'fish completes commands and flags' fish_completes; else skip 'completion: no fish here'; fi
zsh_completes() { # _describe and _arguments get the words
    "$scree" help --zsh >_scree && zsh -n _scree &&
        zsh -c '_describe() { print -l $commands }; CURRENT=2; words=(scree pic); source ./_scree' | grep -q '^picture:draws' &&
        zsh -c '_arguments() { print -l $@ }; CURRENT=3; words=(scree check --ra); source ./_scree' | grep -q '^--ranks\[.*\]:N:'
}
if command -v zsh >/dev/null; then check 'zsh completes commands and flags' zsh_completes; else skip 'completion: no zsh here'; fi

echo '== a layout'
foretold() { # by one rank: the copies of two
    "$scree" check --all scene.yaml --ranks 2 --threads 3 --set step.count=1 >told && holds told "on 2 ranks of 3 threads (6 cores)" || return 1
    run_scene 2 scene.yaml two --set step.count=1 --set output.checkpoint.at_end=false || return 1
    sed -n 's/^  "ghosts": \[\([0-9]*\), \([0-9]*\)\],/\1\n\2/p' two/report.json | sort -n >held
    [ "$(wc -l <held)" = 2 ] && holds told "copies of a rank       $(head -n 1 held) to $(tail -n 1 held), "
}
check 'copies of two ranks' foretold
refused() { "$scree" check --all scene.yaml "$@" >/dev/null 2>said; [ $? = 2 ]; }
check 'no ranks' refused --ranks 0
check 'threads without ranks' refused --threads 2

finish
