#!/bin/sh
# guide.sh FOLDER COMPILER ARGUMENT... : the program of docs/firmware.md, its
# files written to FOLDER, compiles and links with these arguments.
set -eu
folder=$1
compiler=$2
shift 2
mkdir -p "$folder"
for name in main board; do
    awk -v name="$name" 'index($0, "`" name ".c`") { on = 1; next }
        on && /^[^ ]/ && code { exit }
        on && (/^    / || /^$/) { sub(/^    /, ""); code = code || NF; print }' \
        docs/firmware.md > "$folder/$name.c"
done
"$compiler" "$folder/main.c" "$folder/board.c" "$@"
