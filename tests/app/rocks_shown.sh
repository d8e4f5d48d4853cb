#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Rocks in files and pictures: polygons for ParaView, closed and of the right volume, from trajectories and checkpoints; pictures from both; the
# live view; messages.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1

cat >mixed.yaml <<'YAML'
units: none
box: {lower: [0, 0, 0], upper: [5, 5, 5], periodic: true}
gravity: [0, 1, -10]
step: {dt: 1e-4, count: 20}
contact: {law: hooke}
materials: [{name: a, density: 2}]
material_pairs: [{k_n: 1e4, restitution: 0.5, friction: 0.4}]
particles:
  sources:
    - {from: random, shape: cube, count: 5, sizes: 0.5, velocity_sigma: 1}
    - {from: random, shape: ballast, count: 6, sizes: {law: uniform, min: 0.3, max: 0.4}, omega: [0, 1, 0]}
    - {from: random, count: 7, sizes: 0.3}
    - {from: random, shape: dumbbell, count: 2, sizes: 0.3}
bodies:
  clumps: [{name: dumbbell, spheres: [{centre: [-1, 0, 0], radius: 1}, {centre: [1, 0, 0], radius: 1}]}]
  shapes:
    - {name: cube, vertices: [0,0,0, 1,0,0, 0,1,0, 1,1,0, 0,0,1, 1,0,1, 0,1,1, 1,1,1], rounding: 0.05}
    - {name: ballast, random: {corners: 14, variants: 5}, roundness: 0.2}
output: {trajectory: {every: 10}, checkpoint: {every: 20, at_end: false}, dump: {every: 20, fields: [id, kind, position, rock_shape, rock_orientation]}}
YAML
check 'a run' run_scene 1 mixed.yaml run

# shown FILE TIME: all sides of polygons have another polygon on the other side; the volume of each rock is a little less than mass over density,
# that of cubes of edge a and rounding r is b^3 + 6 b^2 r + 6 b r^2 + 4/3 r^3 with b = a - 2 r
cat >shown.py <<'PY'
import re, struct, sys
data = open(sys.argv[1], "rb").read()
text, rest = data.split(b'<AppendedData encoding="raw">\n_', 1)
text = text.decode()
sign = "<" if "LittleEndian" in text else ">"
code = {"Float64": "d", "Int64": "q", "Int32": "i"}
array = {}
for kind, name, width, place in re.findall(r'type="(\w+)" Name="(\w+)" NumberOfComponents="(\d)" format="appended" offset="(\d+)"', text):
    size, = struct.unpack_from(sign + "Q", rest, int(place))
    values = struct.unpack_from(f"{sign}{size // struct.calcsize(code[kind])}{code[kind]}", rest, int(place) + 8)
    array[name] = [values[k:k + int(width)] for k in range(0, len(values), int(width))] if width != "1" else values
points, polygons = (int(re.search(f'NumberOf{what}="(\\d+)"', text).group(1)) for what in ("Points", "Polys"))
assert points == len(array["Points"]) and polygons == len(array["offsets"]) == len(array["id"]) == len(array["velocity"]), (points, polygons)
assert abs(float(re.search(r"ascii\">([^<]*)<", text).group(1)) - float(sys.argv[2])) < 1e-12
sides, volume, shape, radius, first = {}, {}, {}, {}, 0
for p, end in enumerate(array["offsets"]):
    ring = array["connectivity"][first:end]
    first, rock = end, array["id"][p]
    shape[rock], radius[rock] = array["rock_shape"][p], array["radius"][p]
    for a, b in zip(ring, ring[1:] + ring[:1]):
        assert (a, b) not in sides
        sides[a, b] = rock
    x = array["Points"][ring[0]]
    for a, b in zip(ring[1:], ring[2:]):
        u, v = ([q - o for q, o in zip(array["Points"][k], x)] for k in (a, b))
        volume[rock] = volume.get(rock, 0) + sum(x[d] * (u[(d + 1) % 3] * v[(d + 2) % 3] - u[(d + 2) % 3] * v[(d + 1) % 3]) for d in range(3)) / 6
assert all(sides[b, a] == rock for (a, b), rock in sides.items())
assert len(volume) == 11 and sorted(shape.values())[:5] == [1] * 5 and min(shape.values()) == 1 and max(shape.values()) <= 6, shape
b, r = 0.9, 0.05
whole = 4 / 3 * 3.14159265358979 * 0.5 ** 3
cube = (b ** 3 + 6 * b * b * r + 6 * b * r * r + 4 / 3 * r ** 3) * whole
for rock in volume:
    if shape[rock] == 1:
        assert abs(volume[rock] / cube - 1) < 1e-9, (rock, volume[rock], cube)
    else:
        assert 0.1 < volume[rock] < 0.27, volume[rock]
print(f"  {len(volume)} rocks, {polygons} polygons")
PY
faces() { # IN OUT TIME FLAG...
    on 1 "$scree" convert "$1" "$2" "${@:4}" >said 2>&1 && python3 shown.py "$2" "$3" || { cat said; return 1; }
}
check 'polygons of the last frame of a trajectory' faces run/trajectory.h5 last.vtp 0.002
check 'of a frame' faces run first.vtp 0 --frame 0
check 'of a checkpoint' faces run/checkpoint-20.h5 check.vtp 0.002
check 'a checkpoint gives the bytes of its frame, with velocities of the full step' cmp check.vtp last.vtp
both_as() { # ENDING: of all particles, members of clumps too
    on 1 "$scree" convert run/trajectory.h5 "frame.$1" --frame -1 && on 1 "$scree" convert run/checkpoint-20.h5 "state.$1" && cmp "frame.$1" "state.$1"
}
check 'as a dump' both_as lammpstrj
check 'as a data file' both_as data
listed() {
    on 1 "$scree" convert run all.pvd && [ "$(grep -c 'file="all-[0-9]*.vtp"' all.pvd)" = 3 ] && cmp all-20.vtp last.vtp && cmp all-0.vtp first.vtp && python3 shown.py all-10.vtp 0.001
}
check 'a list of all frames' listed

# The shapes in the trajectory, turned and scaled by the fields of its last frame, are what convert writes
cat >shapes.py <<'PY'
import struct, sys
import h5py
import numpy as np
with h5py.File(sys.argv[1]) as f:
    q, number, radius, x = (f[f"particles/all/{name}/value" if isinstance(f[f"particles/all/{name}"], h5py.Group) else f"particles/all/{name}"] for name in ("rock_orientation", "rock_shape", "radius", "position"))
    q, number, radius, x = (a[-1] if a.ndim > b else a[:] for a, b in ((q, 2), (number, 1), (radius, 1), (x, 2)))
    corners = []
    for k in np.flatnonzero(number >= 0):
        shape = f[f"parameters/shapes/{number[k]}"]
        w, u = q[k, 0], q[k, 1:]
        c = shape["corners"][:] * radius[k] / shape.attrs["radius"]
        corners.append(x[k] + c + 2 * np.cross(u, np.cross(u, c) + w * c))
        start, ring = shape["polygon_start"][:], shape["polygon_corners"][:]
        assert start[0] == 0 and start[-1] == len(ring) and 0 <= ring.min() and ring.max() == len(c) - 1
    assert f["parameters/shapes/1"].attrs["name"] == b"cube" and "0" not in f["parameters/shapes"]
data = open(sys.argv[2], "rb").read().split(b'<AppendedData encoding="raw">\n_')[1]
size, = struct.unpack("<Q", data[:8])
drawn = np.frombuffer(data[8:8 + size]).reshape(-1, 3)
assert np.abs(np.concatenate(corners) - drawn).max() < 1e-12, np.abs(np.concatenate(corners) - drawn).max()
PY
reader=
for python in "${PYTHON:-python3}" /usr/bin/python3; do [ -n "$reader" ] || ! "$python" -c 'import h5py, numpy' 2>/dev/null || reader=$python; done
shapes() { # RANKS
    run_scene "$1" mixed.yaml "shapes$1" && on 1 "$scree" convert "shapes$1/trajectory.h5" shapes.vtp --overwrite && "$reader" shapes.py "shapes$1/trajectory.h5" shapes.vtp
}
if [ -n "$reader" ]; then
    check 'a trajectory has the corners and polygons of its shapes' shapes 1
    check 'written by 3 ranks, too' shapes 3
else
    skip 'shapes in a trajectory: no h5py here'
fi

refuses() { # WORDS COMMAND...: status 2
    local words=$1 status=0
    shift
    on 1 "$scree" "$@" >said 2>&1 || status=$?
    [ $status = 2 ] && grep -qF -e "$words" said || { cat said; return 1; }
}
check 'refused: a file that is there' refuses 'all.pvd: is there already' convert run all.pvd
check 'refused: a frame that is there, under a new list' eval 'cp all-10.vtp new-10.vtp && refuses "new-10.vtp: is there already" convert run new.pvd && [ ! -f new.pvd ]'
spheres() {
    run_scene 1 mixed.yaml spheres --set particles='{from: random, count: 3, sizes: 0.3}' --set bodies='~' --set output.dump='~' && refuses 'has no rocks (bodies.shapes)' convert spheres x.vtp && [ ! -f x.vtp ]
}
check 'refused: a run without rocks' spheres
lacking() {
    run_scene 1 mixed.yaml lacking --set output.trajectory.fields='[position, radius]' && refuses 'with the fields rock_shape and rock_orientation' convert lacking/trajectory.h5 x.vtp
}
check 'refused: a trajectory without orientations' lacking
sceneless() { # a dump does not hold its scene
    run_scene 1 mixed.yaml dumped --set output.dump.fields='[id, position, radius]' && refuses 'dump.lammpstrj: has no scene' convert dumped/dump.lammpstrj x.vtp && [ ! -f x.vtp ]
}
check 'refused: a file without the scene' sceneless

# Pictures: the same rocks from a checkpoint as from a trajectory, and members instead of bodies
pictures() {
    on 1 "$scree" picture run -o trajectory.pov --colour radius && on 1 "$scree" picture run/checkpoint-20.h5 -o checkpoint.pov --colour radius || return 1
    sed '/^object{R/!d;s/ *texture.*//' trajectory.pov >a && sed '/^object{R/!d;s/ *texture.*//' checkpoint.pov >b
    [ "$(wc -l <a)" = 11 ] && cmp a b && [ "$(grep -c '^sphere.*texture' checkpoint.pov)" = 11 ] && [ "$(grep -c '^sphere.*texture' trajectory.pov)" = 11 ] || { wc -l a b; grep -c '^sphere.*texture' checkpoint.pov trajectory.pov; return 1; }
}
check 'pictures from a checkpoint show facets' pictures
coloured() { on 1 "$scree" picture run/checkpoint-20.h5 -o field.pov --colour body_part --overwrite >said 2>&1 || { cat said; return 1; }; }
check 'any field of a checkpoint gives a colour' coloured

# The live view: shapes, and a row of ten numbers a particle
if ! grep -q 'define HAVE_MICROHTTPD 1' "$top_builddir/config.h"; then
    skip 'rocks in the live view: this program has no libmicrohttpd'
    finish
fi
cat >look.py <<'PY'
import json, struct, sys, time, urllib.request
url = sys.argv[1]
about = json.loads(urllib.request.urlopen(url + "about").read())
assert len(about["shapes"]) == 7 and about["shapes"][0] is None, about
cube = about["shapes"][1]
assert len(cube["corners"]) == 72 and sorted(map(len, cube["polygons"])) == [3] * 8 + [4] * 18, cube
assert all(max(ring) < len(shape["corners"]) // 3 for shape in about["shapes"][1:] for ring in shape["polygons"])
while True:  # the limit of the test ends it
    answer = urllib.request.urlopen(url + "frame?after=0")
    data = answer.read()
    if answer.status == 200 and len(data) >= 512:
        break
    time.sleep(0.02)
head = json.loads(data[:512])
rows = list(struct.iter_unpack("<10f", data[512:]))
assert head["numbers"] == 10 and head["count"] == head["total"] == len(rows) == 22, head  # 11 rocks, 7 spheres, 4 members; no bodies
assert sorted(row[5] for row in rows)[:11] == [0] * 11 and [row[5] for row in rows].count(2) == 5
frame = open(sys.argv[2]).read().split("ITEM: TIMESTEP")[1].split("ITEM: ATOMS ")[1].split("\n")  # w x y z in the dump, x y z w in the view
dumped = [dict(zip(frame[0].split(), map(float, line.split()))) for line in frame[1:] if line]
for rock in (one for one in dumped if one["rock_shape"] >= 0):
    row = min(rows, key=lambda row: sum((row[d] - rock["xyz"[d]]) ** 2 for d in range(3)))
    assert row[5] == rock["rock_shape"] + 1 and all(abs(row[6 + d] - rock["quat" + "ijkw"[d]]) < 1e-6 for d in range(4)), (row, rock)
urllib.request.urlopen(urllib.request.Request(url + "go", method="POST"))
PY
address() {
    url=$(sed -n 's/^scree: live view: \(http[^ ]*\).*/\1/p' "$1" 2>/dev/null)
    [ -n "$url" ]
}
viewed() { # RANKS
    on "$1" "$scree" run mixed.yaml -o "viewed$1" --quiet --view --paused >"viewed$1.said" 2>&1 &
    local job=$!
    wait_until address "viewed$1.said" && python3 look.py "$url" "viewed$1/dump.lammpstrj"
    local status=$?
    [ $status = 0 ] || kill $job
    wait $job && return $status
}
check 'the live view has the shapes and orientations of rocks' viewed 1
check 'on 2 ranks, too' viewed 2
drawn() { # the page draws all rocks by their faces; a slow machine gets more time
    on 1 "$scree" run mixed.yaml -o drawn --quiet --view --paused >drawn.said 2>&1 &
    local job=$! time
    wait_until address drawn.said || return 1
    for time in 2500 10000 40000; do
        browse "$limit" --use-angle=swiftshader --enable-unsafe-swiftshader --virtual-time-budget=$time --window-size=1000,640 --dump-dom "$url" >drawn.dom 2>drawn.log
        ! grep -q 'data-rocks="11"' drawn.dom || break
    done
    python3 -c 'import sys, urllib.request as u; u.urlopen(u.Request(sys.argv[1] + "go", method="POST"))' "$url" && wait $job && grep -q 'data-rocks="11"' drawn.dom && ! grep -q 'THREE.WebGLProgram: Shader Error' drawn.log
}
if [ -n "$browser" ]; then
    check 'a browser draws the faces of rocks' drawn
else
    skip 'rocks in a browser: no chromium here'
fi
finish
