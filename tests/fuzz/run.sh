#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The readers of text under libFuzzer, with AddressSanitizer and UBSan: builds tests/fuzz/readers by clang, makes a corpus of
# valid inputs, and gives each reader its share of the time, two at once.
#
#   run.sh [SECONDS]    60 if left out: other inputs at each call
#   run.sh --runs N     N inputs a reader, the same ones at each call, on any machine
#
# SCREE_FUZZ="dump mesh" tries these readers alone.
# An input that crashes, hangs, leaks or overflows fails; it stays in $FUZZ_BUILD/found, and the command that repeats it is
# printed. Environment: FUZZ_BUILD, the build folder (build-fuzz in the source tree), which is kept between calls; FUZZ_CC
# (clang). Status 77, with a reason, where there is no clang with libFuzzer.
set -u

top=$(cd "$(dirname "$0")/../.." && pwd)
seconds=60 runs=
case ${1:-} in
--runs) runs=${2:-} ;;
?*) seconds=$1 ;;
esac
build=${FUZZ_BUILD:-$top/build-fuzz}
cc=${FUZZ_CC:-clang}
jobs=2
readers=${SCREE_FUZZ:-scene setting table lammps-data source-data dump mesh numbers}
export OMP_NUM_THREADS=1 UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1

case $seconds$runs in
*[!0-9]*) echo "run.sh: '$*' is neither SECONDS nor --runs N" >&2; exit 2 ;;
esac
mkdir -p "$build" && build=$(cd "$build" && pwd) || exit 1
echo 'int LLVMFuzzerTestOneInput(const unsigned char *data, unsigned long size) { return !data && size; }' >"$build/probe.c"
if ! $cc -fopenmp -fsanitize=fuzzer,address "$build/probe.c" -o "$build/probe" >"$build/probe.log" 2>&1; then
    echo "skipped: no clang with libFuzzer and OpenMP (clang, libomp-dev): $(head -n 1 "$build/probe.log")"
    exit 77
fi

# The program: what reads is watched by libFuzzer and the sanitizers, what computes is only linked
[ -x "$top/configure" ] || (cd "$top" && autoreconf -i) >"$build/build.log" 2>&1 || { tail "$build/build.log"; exit 1; }
cd "$build" || exit 1
watched='-fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer'
{
    { [ -f config.status ] || "$top/configure" CC="$cc" --quiet --enable-debug; } &&
        make -j"$jobs" CFLAGS='-O1 -g' libindex.la libpairs.la libcomm.la libcontact.la libintegrate.la &&
        make -j"$jobs" CFLAGS="-O1 -g $watched" tests/fuzz/readers
} >build.log 2>&1 || { tail -n 30 build.log; exit 1; }

# The corpus: the examples, and small inputs that show each form once
corpus=$build/corpus
rm -rf "$corpus" "$build/found"
for reader in scene setting table lammps-data source-data dump mesh numbers; do mkdir -p "$corpus/$reader"; done
mkdir -p "$build/found" "$build/logs"

k=0
while IFS= read -r file; do
    k=$((k + 1))
    cp "$file" "$corpus/scene/$k.yaml"
    sed -n 's/^\([a-z_]*\): *\([^ #].*\)$/\1=\2/p' "$file" | head -n 6 >"$corpus/setting/$k"
done < <(find "$top/examples" -name '*.yaml' | sort)
printf '%s\n' 'walls[0]={shape: plane, point: [0, 0, 0], normal: [0, 0, 1]}' 'walls[0].name=floor' 'particles.columns=[radius, x]' >"$corpus/setting/list"
printf '%s\n' 'materials[1].density=3 kg/m3' 'step=~' 'duration=.inf' 'particles.sources[0].rows=1e3' >"$corpus/setting/number"

k=0
for file in "$top"/examples/verify/*/particles.txt "$top"/examples/hard/*.txt; do
    k=$((k + 1))
    head -n 20 "$file" >"$corpus/table/$k"
done
printf 'id radius[mm] x y z vx vy vz material density\n1 2 .1 .2 .3 0 0 1 glass 2\n7 2 .4 .2 .3 0 0 1 2 3\n' >"$corpus/table/columns"
printf '# diameter; x, y\tz # all\n# note\n.1;.1,.2\t.3 # end\n' >"$corpus/table/comment"

head='a title # note\n\n2 atoms\n2 atom types\n# note\n0 1 xlo xhi\n0 1 ylo yhi\n-1 1 zlo zhi\n\n'
printf "${head}Masses\n\n1 2\n\nAtoms # sphere\n\n2 1 .2 3 .1 .2 .5 0 -1 2\n1 2 .1 3 .4 .5 -.5 # note\n\nVelocities\n\n1 1 2 3 4 5 6\n2 0 0 0 0 0 0\n" >"$corpus/lammps-data/all"
printf "${head}Atoms\n\n2 1 .2 3 .1 .2 .5\n1 2 .1 3 .4 .5 .5\n" >"$corpus/lammps-data/few"
gzip -c "$corpus/lammps-data/all" >"$corpus/lammps-data/packed"
cp "$corpus"/lammps-data/* "$corpus/source-data"

head='ITEM: TIMESTEP\n5\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp ff\n0 2\n0 2\n0 4\n'
printf "ITEM: UNITS\nlj\nITEM: TIME\n.5\n${head}ITEM: ATOMS id type diameter xs ys zs vx vy vz\n7 2 1 .5 .2 .5 1 2 3\n8 1 1 .1 .2 .3 0 0 0\n" >"$corpus/dump/scaled"
printf "${head}ITEM: ATOMS id x yu z ix iy iz omegax omegay omegaz radius mass f\n1 .5 .2 .5 1 2 3 1 2 3 .1 2 x\n8 1 1 .1 0 0 0 0 0 0 1 1 1\n${head}ITEM: ATOMS x y z\n1 1 1\n0 0 0\n" >"$corpus/dump/frames"
gzip -c "$corpus/dump/frames" >"$corpus/dump/packed"

cp "$top/examples/verify/wall-edge/plate.txt" "$corpus/mesh/table"
head -n 20 "$top/examples/penetration/walls.txt" >"$corpus/mesh/table2"
printf 'solid a b\nfacet normal 0 0 1\nouter loop\nvertex 1 1 1.5\nvertex 5 1 1.5\nvertex 3 5 1.5e0\nendloop\nendfacet\nendsolid a\nSOLID\nendsolid\n' >"$corpus/mesh/ascii"
{ head -c 80 /dev/zero; printf '\1\0\0\0'; head -c 50 /dev/zero; } >"$corpus/mesh/binary"
printf '# a square\no a\nv 0 0 0\nv 2 0 0 1\nv 2 1 0\nv 0 1 0\nvn 0 0 1\nf 1/1/1 2//1 3 -1\nf 1 2 3\n' >"$corpus/mesh/obj"
head='element vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n'
printf "ply\nformat ascii 1.0\ncomment a square\n${head}0 0 0\n2 0 0\n2 1 0\n0 1 0\n4 0 1 2 3\n" >"$corpus/mesh/ply"
{ printf "ply\nformat binary_little_endian 1.0\n$head"; head -c 48 /dev/zero; printf '\4\0\0\0\0\1\0\0\0\2\0\0\0\3\0\0\0'; } >"$corpus/mesh/ply_little"
{ printf "ply\nformat binary_big_endian 1.0\nobj_info none\nelement colour 1\nproperty list ushort double shade\nproperty int8 flag\n$head"
    printf '\0\1'; head -c 57 /dev/zero; printf '\4\0\0\0\0\0\0\0\1\0\0\0\2\0\0\0\3'; } >"$corpus/mesh/ply_big"
printf 'time x y z a b c\n0 0 0 0 0 0 0\r\n# note\n1e-3, 1; 2 3\t4 5 6\n\n2 1 1 1 1 1 1' >"$corpus/numbers/table"
cp "$top/examples/verify/end-of-contact/force.txt" "$corpus/numbers/two"

# one READER: within its limits; what it says is in logs/READER
one() {
    mkdir -p "$build/at/$1" && cd "$build/at/$1" || return 1
    # shellcheck disable=SC2086
    SCREE_FUZZ=$1 "$build/tests/fuzz/readers" $limits -timeout=60 -rss_limit_mb=3000 -max_len=4096 \
        -print_final_stats=1 -artifact_prefix="$build/found/$1-" "$corpus/$1" >"$build/logs/$1" 2>&1 || return 1
    echo "passed: $1: $(awk '/number_of_executed_units/ { print $2 }' "$build/logs/$1") inputs"
}
export -f one
count=$(wc -w <<<"$readers")
share=$((seconds * jobs / count))
limits="-max_total_time=$((share > 0 ? share : 1))"
[ -z "$runs" ] || limits="-runs=$runs -seed=1 -keep_seed=1"
export build corpus limits
tr ' ' '\n' <<<"$readers" | xargs -P "$jobs" -I READER bash -c 'one READER || echo "FAILED: READER"' | tee "$build/result"

failed=0
while read -r _ reader; do
    failed=$((failed + 1))
    grep -m 1 -A 12 -E 'ERROR: |runtime error: |^refused without' "$build/logs/$reader" || tail -n 5 "$build/logs/$reader"
    for input in "$build/found/$reader"-*; do
        [ -e "$input" ] && echo "repeat: SCREE_FUZZ=$reader $build/tests/fuzz/readers $input"
    done
done < <(grep '^FAILED' "$build/result")
echo "$count readers, $failed failed"
[ "$failed" = 0 ] && [ "$(grep -c '^passed' "$build/result")" = "$count" ]
