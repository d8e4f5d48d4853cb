#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# scree run --view: who gets an answer, what a frame holds, pause and step, one and three ranks, the same bits as without a view,
# and how a browser shows it.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

cat >heap.yaml <<'EOS'
title: a heap & <more>
units: none
gravity: [0, 0, -10]
step: {dt: 0.001, count: 400}
box: {lower: [-2, -2, 0], upper: [2, 2, 4]}
walls: [{shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}]
contact: {law: hooke}
materials: [{name: glass, density: 1}]
material_pairs: [{restitution: 0.5, k_n: 1000}]
particles:
  sources:
    - {from: lattice, lattice: sc, spacing: 0.42, sizes: 0.2, region: {shape: box, lower: [-1.9, -1.9, 0.3], upper: [1.9, 1.9, 2]}}
    - {from: single, position: [0, 0, 2.8], radius: 0.6}
observables: {every: 10, list: [{name: energy}]}
output: {checkpoint: {at_end: true}}
EOS

without() {
    local status=0
    on 1 "$scree" run heap.yaml -o none --view --quiet >said 2>&1 || status=$?
    [ $status = 2 ] && grep -q 'built without libmicrohttpd' said
}
if ! grep -q 'define HAVE_MICROHTTPD 1' "$top_builddir/config.h"; then
    check 'message: no server in this program' without
    skip 'live view: this program has no libmicrohttpd'
    finish
fi
says() { # TEXT FLAG...: exit status 2 and the text
    local text=$1 status=0
    shift
    on 1 "$scree" run heap.yaml -o wrong "$@" >said 2>&1 || status=$?
    [ "$status" = 2 ] && grep -qF -- "$text" said || { cat said; return 1; }
}
check 'message: no port' says '--view x: the port' --view=x
check 'message: too large a port' says '--view 70000: the port' --view 70000
check 'message: paused alone' says '--paused goes with --view' --paused

check 'a run without a view' run_scene 1 heap.yaml plain
check 'a run without a view on three ranks' run_scene 3 heap.yaml plain3

begin() { # RANKS DIR: a run with a view, which waits; sets `job` and `url`
    on "$1" "$scree" run heap.yaml -o "$2" --quiet --view --paused >"$2.said" 2>&1 &
    job=$!
    wait_until address "$2.said" || { echo 'no address:'; cat "$2.said"; return 1; }
}
address() {
    url=$(sed -n 's/^scree: live view: \(http[^ ]*\).*/\1/p' "$1" 2>/dev/null)
    [ -n "$url" ]
}
cat >look.py <<'EOS'
import http.client, json, struct, sys, time
from urllib.parse import urlsplit
url = urlsplit(sys.argv[1])
path = url.path

def ask(target, method="GET", host=None, body=None):
    link = http.client.HTTPConnection("127.0.0.1", url.port)
    link.putrequest(method, target, skip_host=True)
    if host != "":
        link.putheader("Host", host or url.netloc)
    if body:
        link.putheader("Content-Length", str(len(body)))
    link.endheaders()
    if body:
        link.send(body)
    answer = link.getresponse()
    return answer.status, answer.read(), answer

def refused(*arguments, **more):
    """The status, 0 where the server hangs up."""
    try:
        return ask(*arguments, **more)[0]
    except (http.client.HTTPException, OSError):
        return 0

def frame(after=0, field=0, least=None):
    while True:  # the limit of the test ends it
        status, data, answer = ask(f"{path}frame?after={after}&field={field}")
        if status == 200 and len(data) >= 512:
            head = json.loads(data[:512])
            if head["field"] == field and (least is None or head["step"] >= least and head["paused"]):
                rows = list(struct.iter_unpack("<5f", data[512:]))
                assert len(rows) == head["count"], (len(rows), head)
                return head, rows, int(answer.headers["X-Frame"])
        time.sleep(0.02)

assert url.hostname == "127.0.0.1" and len(path) == 34, url
wrong = "/" + ("0" if path[1] != "0" else "1") + path[2:]
for target in ("/", "/about", wrong, wrong + "frame", path[:-1], "/" + path[1:17]):
    assert ask(target)[0] == 403, target
    assert ask(target, "POST")[0] == 403, target
for host in ("example.org", "example.org:80", "127.0.0.1.example.org", "localhost.example.org:1", ""):
    assert ask(path + "about", host=host)[0] in (400, 403), host
assert ask(path + "about", host="localhost:9")[0] == 200
assert ask(path + "../report.py")[0] == 404 and ask(path + "report.py")[0] == 404
assert ask(path + "go", "PUT")[0] == 405 and ask(path + "go")[0] == 404 and ask(path + "about", "POST")[0] == 404
assert refused(path + "step?count=1", "POST", body=b"x" * 100) in (0, 400, 413)
assert refused(path + "about?" + "x" * 40000) in (0, 400, 413, 414, 431)
about = json.loads(ask(path + "about")[1])
assert about["title"] == "a heap & <more>" and about["lower"] == [-2, -2, 0], about
names = [field["name"] for field in about["fields"]]
head, rows, number = frame()
assert head["step"] == 0 and head["paused"] and head["count"] == head["total"] == len(rows) > 100, head
assert max(row[3] for row in rows) == struct.unpack("f", struct.pack("f", 0.6))[0]
assert all(abs(row[4] - 0.005) < 1e-6 for row in rows)  # of the half step before
assert any(abs(row[2] - 2.8) < 1e-6 and abs(row[0]) < 1e-6 for row in rows)
assert ask(path + f"frame?after={number}")[0] == 204
head, rows, number = frame(number, names.index("radius"))
assert all(row[3] == row[4] for row in rows)
assert ask(path + "step?count=7", "POST")[0] == 204
head, rows, number = frame(number, 0, 7)
assert head["step"] == 7 and abs(head["time"] - 0.007) < 1e-12, head
assert max(row[4] for row in rows) > 0.05
assert ask(path + "step?count=250", "POST")[0] == 204
assert frame(number, 0, 257)[0]["step"] == 257
table = ask(path + "observables")[1]
assert table.startswith(b"time") and table.count(b"\n") == 27, table
assert ask(path + f"observables?from={len(table)}")[0] == 204
EOS
mkdir -p "$top_builddir/tests/app"
seen_once() { # TIME: the page, in so many of its own milliseconds
    browse "$limit" --use-angle=swiftshader --enable-unsafe-swiftshader \
        --virtual-time-budget="$1" --window-size=1000,640 --dump-dom \
        --screenshot="$top_builddir/tests/app/view.png" "$url" >view.dom 2>view.log
    grep -q 'data-drawn="[1-9][0-9]' view.dom && grep -q 'data-rows="26"' view.dom && grep -q 'step 257' view.dom &&
        [ "$(wc -c <"$top_builddir/tests/app/view.png")" -gt 20000 ]
}
seen() { # the page draws all particles and rows; a screenshot, kept in the build folder. A slow machine gets more time
    local time
    for time in 2500 10000 40000; do
        if seen_once $time; then return 0; fi
    done
    head -c 1200 view.dom
    tail -n 3 view.log
    return 1
}
go_on() { python3 -c 'import sys, urllib.request as u; u.urlopen(u.Request(sys.argv[1] + "go", method="POST"))' "$url" && wait "$job"; }
same() { contents "$1"/checkpoint-400.h5 >a && contents "$2"/checkpoint-400.h5 >b && cmp a b; }

check 'a run with a view says its address' begin 1 viewed
check 'answers and refusals, frames, pause and step' python3 look.py "$url"
stalled() { # 200 connections that never ask for anything do not hold up one that does
    python3 -c '
import socket, sys, urllib.parse, urllib.request
place = urllib.parse.urlsplit(sys.argv[1])
idle = [socket.create_connection((place.hostname, place.port)) for k in range(200)]
sys.exit(0 if b"<html" in urllib.request.urlopen(sys.argv[1], timeout=25).read().lower() else 1)' "$url"
}
check 'connections that stall do not lock the page' stalled
if [ -n "$browser" ]; then
    check 'a browser draws the particles and the observables' seen
else
    skip 'the live view in a browser: no chromium here'
fi
check 'the run goes on to its end' go_on
check 'the state at the end is that of the run without a view' same plain viewed
check 'three ranks: a run with a view says its address' begin 3 viewed3
check 'three ranks: answers and refusals, frames, pause and step' python3 look.py "$url"
check 'three ranks: the run goes on to its end' go_on
check 'three ranks: the state at the end is that of the run without a view' same plain3 viewed3
finish
