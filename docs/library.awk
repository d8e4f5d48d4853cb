# SPDX-License-Identifier: BSD-3-Clause
# Makes docs/library.md of the public headers: awk -f library.awk scree_pairs.h scree.h
# A block is a comment and the declarations below it, up to an empty line.

function flush() {
    if (code != "") {
        if (note != "")
            printf "%s\n\n", note
        printf "```c\n%s```\n\n", code
    }
    note = code = ""
}

# Takes a line of a comment.
function add_note(line) {
    sub(/^\/\* ?/, "", line)
    sub(/^ \* ?/, "", line)
    sub(/ ?\*\/$/, "", line)
    note = note (note == "" ? "" : "\n") line
}

BEGIN {
    print "# The C library\n"
    print "The program `docs/library.awk` makes this page from the headers `src/scree_pairs.h` and `src/scree.h` (`make pages`)."
    print "[examples/library](../examples/library/README.md) has two programs. The libraries export"
    print "these names alone, with the version `SCREE_0.1`. A name of a version keeps its meaning: a function that has to change gets"
    print "another version, and `tests/app/library.sh` compares the exported names with the headers and the maps.\n"
}

FNR == 1 {
    flush()
    name = FILENAME
    sub(/.*\//, "", name)
    part = "head"
    print "## " name "\n"
    next
}
part == "head" && /^\/\*/ { inside = 1 }
part == "head" && inside {
    add_note($0)
    if ($0 ~ /\*\/$/) {
        inside = 0
        part = "start"
        print note "\n"
        note = ""
    }
    next
}
part == "start" { if ($0 ~ /^extern "C"/) part = "skip"; next }
part == "skip" { part = "body"; next }
part == "body" && /^#ifdef/ { flush(); part = "end"; next }
part == "body" && /^$/ { flush(); next }
part == "body" && code == "" && (/^\/\*/ || inside) {
    inside = $0 !~ /\*\/$/
    add_note($0)
    next
}
part == "body" { code = code $0 "\n" }
