#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# scree report: what a page of a run and of an ablation has, its messages, and how a browser shows it.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

cat >fall.yaml <<'EOS'
title: a fall & <a rest>
units: none
gravity: [0, 0, -10]
duration: 0.1
box: {lower: [-2, -2, 0], upper: [2, 2, 4]}
contact: {law: hooke}
materials: [{name: glass, density: 1}]
material_pairs: [{restitution: 0.5, k_n: 1000}]
particles: {from: single, position: [0, 0, 2], radius: 0.5}
step: {dt: 0.001}
observables: {every: 10, list: [{name: centre}, {name: momentum}, {name: energy}, {name: speed_max, label: <!--<script>}]}
EOS
check 'a run' run_scene 1 fall.yaml fall
mkdir choice
cat >choice/speed_error.csv <<'EOS'
group,settings,dt,seconds,judged_error,on_front,outcome
scene,as it is,0.001,4,0.01,0,"done"
step,"dt x 2, shifted",0.002,2,0.02,1,"done"
step,dt x 0.5,0.0005,8,0.001,1,"done"
stiffness,/ 10,0.003,1,nan,0,"stopped, by a guard"
EOS
printf '\211PNG' >fall/bed.png

page() { on 1 "$scree" report "$1" -o "$1.html" --overwrite && [ ! -e "$1.html.log" ] && [ ! -e "$1.html.scene" ]; }
check 'the page of a run' page fall
check 'has the title of the scene' holds fall.html '<h1>a fall &amp; &lt;a rest&gt;</h1>'
check 'has the effective scene' holds fall.html 'integrator: '
check 'has the picture of the folder' holds fall.html 'data:image/png;base64,iVBORw=='
check 'no name of the user stands raw' eval '[ "$(grep -c "<script" fall.html)" = 3 ] && ! grep -qF "<!--" fall.html'
check 'has the licence of uPlot' holds fall.html 'MIT License'
check 'asks for nothing from elsewhere' eval '! grep -Eq "(src|href)=.?http" fall.html'
check 'the page of an ablation' page choice
numbers() { # plots: three units of the run; values of the first and the last row
    python3 - <<'EOS'
import json, re
def plots(name):
    return json.loads(re.search(r'id="plots">(.*?)</script>', open(name).read(), re.S).group(1))
run, choice = plots("fall.html"), plots("choice.html")
table = [line.strip().split(",") for line in open("fall/observables.csv")]
curves = {name: values for plot in run for name, values in zip(plot["names"], plot["data"][1:])}
assert len(curves) == len(table[0]) - 1, curves.keys()
for k, name in enumerate(table[0][1:], 1):
    assert curves[name.split("[")[0]] == [float(row[k]) for row in table[1:]], name
assert [row["settings"] for row in choice[0]["rows"]] == ["dt x 2, shifted", "as it is", "dt x 0.5"], choice
assert [row["front"] for row in choice[0]["rows"]] == [True, False, True]
EOS
}
check 'plots have the numbers of the tables' numbers
says() { # TEXT ARGUMENT...: exit status 2 and the text
    local text=$1 status=0
    shift
    on 1 "$scree" report "$@" >said.txt 2>&1 || status=$?
    [ "$status" = 2 ] && grep -q -- "$text" said.txt || { cat said.txt; return 1; }
}
mkdir empty
check 'message: nothing to report' says 'neither report.json' empty -o a.html
check 'message: no folder' says 'no such folder' nothing -o a.html
check 'message: no name' says 'needs -o FILE.html' fall
absent() { local status=0; PATH=/nowhere "$scree" report fall -o a.html >said.txt 2>&1 || status=$?; [ $status = 2 ] && grep -q 'python3 is not there' said.txt; }
check 'message: Python is not there' absent

mkdir -p "$top_builddir/tests/app"
shown() { # the page draws all its plots: NAME PLOTS
    browse 200 --disable-gpu --virtual-time-budget=2000 --dump-dom "file://$out/$1.html" 2>/dev/null >"$1.dom"
    grep -q "<body data-drawn=\"$2\"" "$1.dom" && [ "$(grep -o '<canvas' "$1.dom" | wc -l)" = "$2" ]
}
seen() { # a screenshot, kept in the build folder
    browse 200 --disable-gpu --virtual-time-budget=2000 --window-size=1100,1400 \
        --screenshot="$top_builddir/tests/app/report.png" "file://$out/fall.html" 2>/dev/null && [ "$(wc -c <"$top_builddir/tests/app/report.png")" -gt 20000 ]
}
if [ -n "$browser" ]; then
    cp choice/speed_error.csv fall
    page fall
    plots=$(grep -o 'data-plot=' fall.html | wc -l)
    check "a browser draws all $plots plots, of the run and of speed against error" shown fall "$plots"
    check 'a screenshot' seen
else
    skip 'pages in a browser: no chromium here'
fi
finish
