#!/bin/sh
# guide.sh FILE COMPILER ARGUMENT... : the program of docs/firmware.md, written to
# FILE, compiles and links with these arguments.
set -eu
file=$1
compiler=$2
shift 2
mkdir -p "$(dirname "$file")"
awk 'index($0, "`main.c`:") { on = 1; next }
    on && /^[^ ]/ && code { exit }
    on && (/^    / || /^$/) { sub(/^    /, ""); code = code || NF; print }' \
    docs/firmware.md >"$file"
"$compiler" "$file" "$@"
