#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The commands of the pages (tutorial, gallery, how-tos) run: each line of a block ```sh, in a quick form of its scene. The scenes of the
# gallery are judged thereby, and the numbers of the tutorial exist.
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
    quick=(--set particles.sources[0].sizes.min=4e-3 --set particles.sources[0].volume_fraction=0.3 --set 'materials[0].young=50 kPa'
        --samples 2 --members 2 --repeat 1 --only step)
    ;;
picture) quick=(--size 64x48) ;;
esac
exec "$scree" "\$@" "\${quick[@]}"
EOS
chmod +x bin/scree
export PATH=$out/bin:$PATH SCREE=$scree

# blocks PAGE: the lines of its sh blocks
blocks() {
    awk '/^```sh$/ { inside = 1; next } /^```/ { inside = 0 } inside && NF' "$1"
}

# page FILE: its commands, one after another, in a folder of its own with examples/ beside it
page() {
    local file=$1 folder line
    folder=pages/$(basename "$file" .md)
    mkdir -p "$folder"
    ln -s "$top_srcdir/examples" "$folder/examples"
    blocks "$file" >"$folder/lines"
    case $file in */restart.md | */cluster.md) export SHORT=0.01 ;; *) export SHORT= ;; esac
    [ -s "$folder/lines" ] || { echo "  no commands in $file"; return 1; }
    while IFS= read -r line; do
        case $line in
        *'scree picture'*) command -v povray >/dev/null || continue ;;
        *'scree report'*) command -v python3 >/dev/null || continue ;;
        *gnuplot*) command -v gnuplot >/dev/null || continue ;;
        examples/gallery/check*) line="${line/check/check --quick}" ;;
        mpirun*) line="$MPIRUN${line#mpirun}" ;;
        esac
        (cd "$folder" && eval "timeout $limit $line") >"$folder/said" 2>&1 </dev/null || { echo "  $line"; tail -n 15 "$folder/said"; return 1; }
    done <"$folder/lines"
}

for file in "$top_srcdir"/docs/tutorial.md "$top_srcdir"/docs/gallery.md "$top_srcdir"/docs/howto/*.md; do
    grep -q '^```sh$' "$file" || continue
    check "the commands of ${file#"$top_srcdir"/}" page "$file"
done
wrong() { printf '```sh\nfalse\n```\n' >wrong.md && ! page wrong.md >/dev/null; }
check 'a command that fails is noticed' wrong
short() { # scenes that fit on a screen
    local scene
    for scene in "$gallery"/*.yaml; do
        [ "$(wc -l <"$scene")" -lt 40 ] && grep -q "literalinclude.*$(basename "$scene")" "$top_srcdir"/docs/howto/*.md || { echo "  $scene"; return 1; }
    done
}
check 'each scene has fewer than 40 lines and its how-to' short
finish
