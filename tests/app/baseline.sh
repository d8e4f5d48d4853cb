#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The program runs on any x86-64: only dispatched kernels and clones have code for newer instructions, and without these instructions the
# bits are the same. The test looks into the object files, runs a scene with each set of instructions, and runs the scene on emulated
# CPUs without these instructions (qemu-x86_64: Debian's qemu-user; without qemu the test reports that this part is skipped).
set -u
. "$top_srcdir/tests/app/common.sh"
top_builddir=$(cd "$top_builddir" && pwd)
scree=${SCREE:-$top_builddir/scree}
cd "$out" || exit 1

if [ "$(uname -m)" != x86_64 ]; then
    skip "this CPU is not of the x86-64 kind"
    exit 77
fi
flags=$(sed -n 's/^#define SCREE_FLAGS "\(.*\)"/\1/p' "$top_builddir/config.h")
case $flags in
*-march=*)
    skip "built for one CPU alone ($flags)"
    exit 77
    ;;
*-fsanitize=*) no_emulator='a program with sanitizers does not run under an emulator' ;;
*) no_emulator= ;;
esac

# newer OBJECT: the instructions in it that an x86-64 of 2003 does not have: those coded by VEX and EVEX (their names begin with v, or
# with k for masks), those of SSE3 to SSE4.2, and of BMI. (tzcnt is not among them: old CPUs read it as bsf, and compilers use it so.) The
# versions of a function with clones (base/clones.h) do not count: the program takes the one that its CPU has.
newer() {
    objdump -d --no-show-raw-insn "$1" | awk -F'\t' '
        /^[0-9a-f]+ <.*>:$/ { clone = /[.]avx(2|512f)[.a-z0-9]*>:$/ }
        clone || NF < 2 { next }
        $2 ~ /^(v[a-z0-9]+ +.*%[xyz]mm|vzero|k(mov|and|or|xor|test|shift|unpck)[a-z]* )/ ||
        $2 ~ /^(haddp|hsubp|addsubp|lddqu|movddup|movs[hl]dup|pshufb|pabs[bwd]|palignr|pmaddubsw|phadd|phsub|psign|pmulhrsw)/ ||
        $2 ~ /^(pmulld|pmuldq|pblend|blendv?p|pmovsx|pmovzx|pminsb|pminsd|pminuw|pminud|pmaxsb|pmaxsd|pmaxuw|pmaxud|ptest|rounds|roundp)/ ||
        $2 ~ /^(pextr[bdq] |pinsr[bdq] |insertps|extractps|dppd|dpps|packusdw|pcmpeqq|pcmpgtq|pcmpestr|pcmpistr|crc32|popcnt)/ ||
        $2 ~ /^(andn|bextr|blsr|blsmsk|blsi|bzhi|pdep|pext|mulx|rorx|sarx|shlx|shrx|lzcnt) / { print $2 }'
}
# objects KIND: those of the dispatched kernels, or the others
objects() {
    local kernels='search_avx2\.o$|search_avx512\.o$|_v[34]_la-[^/]*\.o$' all
    all=$(find "$top_builddir/src" "$top_builddir/index" -name '*.o' -path '*/.libs/*' | sort)
    if [ "$1" = kernels ]; then grep -E "$kernels" <<<"$all"; else grep -Ev "$kernels" <<<"$all"; fi
}
kernels_have_some() {
    local object count=0
    while IFS= read -r object; do
        newer "$object" >found
        [ -s found ] || { echo "  none in $object"; return 1; }
        count=$((count + 1))
    done < <(objects kernels)
    echo "  $count kernels"
    [ "$count" -ge 4 ]
}
others_have_none() {
    local object count=0 bad=0
    while IFS= read -r object; do
        count=$((count + 1))
        newer "$object" >found
        [ -s found ] || continue
        bad=$((bad + 1))
        echo "  $object: $(awk '{ print $1 }' found | sort | uniq -c | sort -rn | head -n 3 | tr -s ' \n' ' ')"
    done < <(objects others)
    echo "  $count objects"
    [ "$count" -ge 100 ] && [ "$bad" = 0 ]
}

cat >scene.yaml <<'END'
units: none
box: {lower: [0, 0, 0], upper: [8, 8, 8], periodic: [true, true, false]}
step: {dt: 0.0005, count: 100, force: true}
contact: {law: hertz, rolling: spring}
materials: [{name: soft, density: 1, young: 10000, poisson: 0.3}]
material_pairs: [{restitution: 0.7, friction: 0.4, rolling_friction: 0.05}]
walls: [{name: floor, shape: plane, point: [0, 0, 1], normal: [0, 0, 1]}]
particles:
  sources:
    - {from: single, position: [4, 4, 4], radius: 1.5}
    - from: random
      count: 2000
      sizes: {law: uniform, min: 0.1, max: 0.25}
      velocity: [1, 2, -6] # not random: normal numbers come from the C library, which may take other instructions for them
      region: {shape: box, lower: [0, 0, 1], upper: [8, 8, 8]}
observables: {every: 20, list: [{name: energy_kinetic}, {name: momentum}, {name: contacts}]}
output: {checkpoint: {at_end: true}}
guards: {overlap_bound: 0.9, speed: off}
END

# contents CHECKPOINT: name, bytes and checksum of each dataset but the scene's text
contents() {
    head -c 8192 "$1" | grep -a '^dataset ' | awk '$2 != "/scene" && $2 !~ "^/runs/" { print $2, $4, $6 } END { exit NR < 15 }'
}
# same_bits FOLDER
same_bits() {
    contents widest/checkpoint-100.h5 >first.txt && contents "$1/checkpoint-100.h5" >second.txt || return 1
    diff first.txt second.txt && cmp widest/observables.csv "$1/observables.csv"
}
touching() {
    local contacts
    contacts=$(number widest/report.json contacts)
    echo "  $contacts contacts"
    [ "$contacts" -gt 50 ]
}
with() {
    run_scene 1 scene.yaml "$1" --set simd="$1" && same_bits "$1"
}
# emulated CPU: what libraries below choose by the CPU is chosen for the emulated one, too
emulated() {
    OMP_NUM_THREADS=1 timeout 600 "$qemu" -cpu "$1" "$program" run scene.yaml -o "emulated-$1" --quiet >said 2>&1 || { cat said; return 1; }
    same_bits "emulated-$1"
}
refuses() {
    local status=0
    OMP_NUM_THREADS=1 timeout 600 "$qemu" -cpu "$1" "$program" run scene.yaml -o refused --quiet --set simd=x86-64-v4 >said 2>&1 || status=$?
    [ $status = 2 ] || { echo "  status $status"; cat said; return 1; }
    holds said simd
}

check 'the kernels for newer instructions have some' kernels_have_some
check 'nothing else has' others_have_none
check 'a scene' run_scene 1 scene.yaml widest
check 'with more than fifty contacts' touching
check 'the baseline gives the same bits' with baseline
for pair in 'x86-64-v3 avx2' 'x86-64-v4 avx512f'; do
    # shellcheck disable=SC2086
    set -- $pair
    if grep -qw "$2" /proc/cpuinfo; then
        check "$1 gives the same bits" with "$1"
    else
        skip "this CPU has no $2"
    fi
done

qemu=$(command -v qemu-x86_64 || command -v qemu-x86_64-static)
# the program itself, where libtool has put a script in its place
program=$scree
[ ! -x "$(dirname "$scree")/.libs/scree" ] || program=$(dirname "$scree")/.libs/scree
if [ -n "$no_emulator" ]; then
    skip "emulated CPUs: $no_emulator"
elif [ -z "$qemu" ]; then
    skip "emulated CPUs: no qemu-x86_64 here (Debian: qemu-user)"
else
    check 'an emulated CPU without AVX (core2duo) gives the same bits' emulated core2duo
    check 'and refuses AVX-512' refuses core2duo
    check 'the least of all (qemu64) gives the same bits' emulated qemu64
fi
finish
