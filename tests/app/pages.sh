#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The scenes and commands of all pages run to their ends: each line of a block ```sh, each whole scene of a block ```yaml, and README's
# ```python. Long scenes run in a quick form, which the wrapper below names; with SCREE_LONG set, as they stand. Blocks without a language hold what
# this test cannot run; `elsewhere` names the test that does, or the reason, page by page. The scenes of the gallery are judged by their
# commands, and the numbers of the tutorial exist.
set -u
. "$top_srcdir/tests/app/common.sh"
cd "$out" || exit 1
gallery=$top_srcdir/examples/gallery

# A `scree` that runs the quick variant of a scene, draws small pictures, and is otherwise the program
mkdir bin pages
cat >bin/scree <<EOS
#!/usr/bin/env bash
quick=()
case \$1 in
run)
    name=\$(basename "\$2" .yaml)
    case \$name in
    sand) # to its end, with longer steps, once; the other runs of README show that they begin and end
        quick=(--set step.fraction=0.5)
        case "\$*" in *'-o sand') ;; *) quick+=(--set duration=0.005) ;; esac
        ;;
    gravel)
        quick=(--set particles.sources[0].volume_fraction=0.05 --set duration=0.002 --set output.trajectory.every.time=0.0002)
        ;;
    *) read -ra quick < <(sed -n "s/^\$name //p" "$gallery/quick.txt") ;;
    esac
    [ -z "\${SHORT:-}" ] || quick+=(--set duration=\$SHORT)
    case "\$*" in *--resume*) quick+=(--set duration=0.02) ;; esac
    quick+=(--quiet)
    ;;
ablate) # as many choices as take a second
    quick=(--samples 2 --members 2 --repeat 1 --only step)
    quick+=(--set particles.sources[0].sizes.min=4e-3 --set particles.sources[0].volume_fraction=0.3 --set 'materials[0].young=50 kPa')
    quick+=(--set guards.overlap=off)
    ;;
picture) quick=(--size 64x48) ;;
esac
[ -z "\${SCREE_LONG:-}" ] || [ "\$1" = picture ] || quick=()
exec "$scree" "\$@" "\${quick[@]}"
EOS
chmod +x bin/scree
export PATH=$out/bin:$PATH SCREE=$scree

# blocks PAGE LANGUAGE: the lines of its blocks of a language; a line `---` before each block where a third word is given
blocks() {
    awk -v language="$2" -v mark="${3:-}" '
        /^```/ { if (inside || other) { inside = other = 0; next }
                 if ($0 == "```" language) { inside = 1; if (mark) print mark } else other = 1; next }
        inside && NF' "$1"
}

# page FILE: its commands, one after another, in a folder of its own with examples/ beside it
page() {
    local file=$1 folder line
    folder=${file#"$top_srcdir"/}
    folder=pages/${folder//\//-}
    folder=${folder%.md}
    mkdir -p "$folder"
    ln -s "$top_srcdir/examples" "$folder/examples"
    ln -s "$out/bin" "$folder/build"
    cp sand.yaml "$folder" && [ ! -d sand ] || cp -r sand "$folder"
    blocks "$file" sh >"$folder/lines"
    case $file in */restart.md | */cluster.md) export SHORT=0.01 ;; *) export SHORT= ;; esac
    [ -s "$folder/lines" ] || { echo "  no commands in $file"; return 1; }
    while IFS= read -r line; do
        case $line in
        *'scree picture'*.mp4*) command -v povray >/dev/null && command -v ffmpeg >/dev/null || continue ;;
        *'scree picture'*) command -v povray >/dev/null || continue ;;
        *'scree report'*) command -v python3 >/dev/null || continue ;;
        *gnuplot*) command -v gnuplot >/dev/null || continue ;;
        examples/gallery/check*) line="${line/check/check --quick}" ;;
        mpirun*) line="$MPIRUN${line#mpirun}" ;;
        esac
        (cd "$folder" && eval "timeout $limit $line") >"$folder/said" 2>&1 </dev/null || { echo "  $line"; tail -n 15 "$folder/said"; return 1; }
    done <"$folder/lines"
}

blocks "$top_srcdir/README.md" yaml >sand.yaml
check 'the commands of README.md, its scene to the end' page "$top_srcdir/README.md"
ended() { # the time of the last row is the end of the scene, and no guard is expected to stop it
    within "$("$scree" info pages/README/sand --column time --row last)" 0.1 1e-6 && "$scree" check sand.yaml >checked && ! grep -q 'guards.overlap' checked
}
check "README's scene ends at its end, as check foretells" ended
[ ! -d pages/README/sand ] || mv pages/README/sand sand
python() { PYTHONPATH=$top_builddir/python PYTHONDONTWRITEBYTECODE=1 "${PYTHON:-/usr/bin/python3}" "$@"; }
if python -c 'import scree' 2>/dev/null; then
    blocks "$top_srcdir/README.md" python >pages/README/page.py
    check 'the Python of README.md' eval '(cd pages/README && python page.py)'
else
    skip 'the Python of README.md: cffi, numpy or pandas are not there'
fi
for file in "$top_srcdir"/docs/*.md "$top_srcdir"/docs/howto/*.md "$top_srcdir"/examples/*/README.md; do
    grep -q '^```sh$' "$file" || continue
    check "the commands of ${file#"$top_srcdir"/}" page "$file"
done
wrong() { printf '```sh\nfalse\n```\n' >wrong.md && ! page wrong.md >/dev/null; }
check 'a command that fails is noticed' wrong

# Whole scenes: those with a box; of a fluid where PETSc is
whole() {
    local file number=0 left=0 scene
    for file in "$top_srcdir"/docs/*.md "$top_srcdir"/docs/howto/*.md "$top_srcdir"/examples/*/README.md; do
        blocks "$file" yaml '---' | awk -v name="whole-$(basename "$file" .md)" '/^---$/ { n++; next } { print >(name "-" n ".yaml") }'
    done
    for scene in whole-*.yaml; do
        grep -q '^box:' "$scene" || continue
        number=$((number + 1))
        ! grep -q '^fluid:' "$scene" || [ -e "$top_builddir/libsolve_petsc.la" ] || { left=1; continue; }
        timeout "$limit" "$scree" run "$scene" -o "${scene%.yaml}" --quiet >said 2>&1 || { echo "  $scene"; cat said; return 1; }
    done
    [ $left = 0 ] || skip 'scenes of a fluid: PETSc is not there'
    [ $number -ge 1 ]
}
check 'the whole scenes of the pages' whole

# Blocks without a language that begin a line with a command of this project, or of a shell
cat >elsewhere <<'EOS'
README.md                        it installs packages and builds; the scenes tests/app/pages.sh runs
CONTRIBUTING.md                  it builds, and .ci/run is made of these commands
docs/benchmarks.md               hours; tests/app/benchmarks.sh
docs/building.md                 it builds; .ci/run
docs/library.md                  tests/app/library.sh
docs/packing.md                  files of the reader's, and up to 711,907 spheres; tests/app/pack.sh
docs/python.md                   tests/python/test_tutorial.py
docs/user-law.md                 tests/app/user_law.sh
docs/view.md                     it waits for a page, or takes a port that may not be free; tests/app/view.sh
docs/packaging/README.md         it builds packages; make deb
examples/columns/README.md       an hour; tests/app/benchmarks.sh
examples/dosta2024/README.md     hours; tests/app/benchmarks.sh
examples/fluidised_bed/README.md its two beds take hours; tests/app/scenes.sh, tests/app/gas.sh
examples/library/README.md       tests/app/library.sh
examples/verify/README.md        tests/app/verify.sh
EOS
commands='^([A-Z]+="|\./|\.\./|examples/|tests/|build/|scree |mpirun |make |cc |bash |apt-get |autoreconf |PYTHONPATH=)'
# scripts PAGE: its commands that are scripts of the examples
scripts() { blocks "$1" '' | grep -E '^([A-Z]+="[^"]*" )*(\./|examples/)[a-z_/]*(run\.sh|check)'; }
named() {
    local file page
    for file in "$top_srcdir"/*.md "$top_srcdir"/docs/*.md "$top_srcdir"/docs/*/*.md "$top_srcdir"/examples/*/README.md; do
        page=${file#"$top_srcdir"/}
        ! grep -q "^$page " elsewhere && blocks "$file" '' | grep -E "$commands" >commands || continue
        case $page in examples/*) scripts "$file" | cmp -s - commands && continue ;; esac
        echo "  no test runs the commands of $page"
        return 1
    done
}
check 'every other page with commands is named, with what runs them' named
examples() { # PAGE: its scripts, as they stand, in a copy of the examples
    local line folder=examples
    [ -d examples ] || cp -r "$top_srcdir/examples" examples
    scripts "$1" >lines
    while IFS= read -r line; do
        case $line in *./run.sh* | *./check*) folder=examples/$(basename "$(dirname "$1")") ;; *) folder=. ;; esac
        (cd "$folder" && eval "$line") >said 2>&1 </dev/null || { echo "  $line"; tail -n 15 said; return 1; }
    done <lines
}
if [ -n "${SCREE_LONG:-}" ]; then
    for file in "$top_srcdir"/examples/*/README.md; do
        grep -q "^${file#"$top_srcdir"/} " elsewhere || check "the scripts of ${file#"$top_srcdir"/}" examples "$file"
    done
else
    skip 'the scripts of the examples at full length (SCREE_LONG=1): minutes to hours; the tests of what they show run most in their quick forms'
fi
short() { # scenes that fit on a screen
    local scene
    for scene in "$gallery"/*.yaml; do
        [ "$(wc -l <"$scene")" -lt 40 ] && grep -q "literalinclude.*$(basename "$scene")" "$top_srcdir"/docs/howto/*.md || { echo "  $scene"; return 1; }
    done
}
check 'each scene has fewer than 40 lines and its how-to' short
finish
