#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The libraries as other programs see them: the names that they export, what they need, and the programs of
# examples/library, built and run.

. "$(dirname "$0")/common.sh"
libs=$top_builddir/.libs
examples=$top_srcdir/examples/library

# exports LIBRARY: the names that it gives to others
exports() {
    ${NM:-nm} -D --defined-only "$libs/$1.so" | awk '$2 ~ /[TDBRVW]/ { sub(/@.*/, "", $3); print $3 }' | sort
}

# declared HEADER...: the functions that headers declare
declared() {
    grep -vhE '^(/\*| \*)' "$@" | grep -oE '\bscree_[a-z_]+\(' | tr -d '(' | sort -u
}

# mapped MAP: the names of a map
mapped() {
    sed -n 's/^ *\(scree_[a-z_]*\);/\1/p' "$top_srcdir/src/front/library/$1.map" | sort
}

# same_names LIBRARY HEADER...: library, map and headers have the same names
same_names() {
    local library=$1
    shift
    (cd "$top_srcdir/src" && declared "$@") >"$out/declared"
    exports "$library" | grep -v '^MPI_File_' >"$out/exported"
    mapped "$library" | diff - "$out/declared" && diff "$out/exported" "$out/declared" && [ -s "$out/declared" ]
}
check "libscree exports what its headers declare" same_names libscree scree.h scree_pairs.h
check "libscree-index exports what its header declares" same_names libscree-index scree_pairs.h

# needs LIBRARY: the libraries that it names
needs() {
    objdump -p "$libs/$1.so" | awk '$1 == "NEEDED" { print $2 }'
}
lacks_all() {
    local word
    for word in "$@"; do
        lacks "$out/needs" "$word" || return 1
    done
}
needs libscree-index >"$out/needs"
check "libscree-index needs neither MPI, HDF5, YAML nor zlib" lacks_all mpi hdf5 yaml libz
check "libscree-index needs OpenMP" grep -q omp "$out/needs"

# build NAME LIBRARY: a program of examples/library
build() {
    ${CC:-cc} -Wall -Wextra -Werror -I"$top_srcdir/src" "$examples/$1.c" -o "$out/$1" -L"$libs" "-l$2" "-Wl,-rpath,$libs" -lm
}
check "search.c builds with libscree-index alone" build search scree-index
check "search.c finds pairs" bash -c "'$out/search' >'$out/said' && grep -qE '^[0-9]+ pairs nearer than 0.1, [0-9]+ of them touch' '$out/said'"
check "simulation.c builds with libscree" build simulation scree
"$out/simulation" >"$out/said" 2>"$out/errors"
check "simulation.c swings as the cosine" [ $? = 0 ]
check "the library prints nothing by itself" [ "$(cat "$out/errors")" = "" ]
check "simulation.c shows eleven rows" [ "$(grep -c '^t =' "$out/said")" = 11 ]

finish
