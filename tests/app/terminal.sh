#!/usr/bin/env bash
# The words of the program to people: help, notes.

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

finish
