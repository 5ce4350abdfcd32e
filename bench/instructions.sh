#!/bin/sh
# usage: instructions.sh PROGRAM CSV
# Counts the instructions of each workload with callgrind and prints a table:
# compiler, workload, instructions for one shape. They are not cycles.
set -eu
program=$1
csv=$2
dumps=$(mktemp -d)
trap 'rm -rf "$dumps"' EXIT
if ! valgrind -q --tool=callgrind --collect-atstart=no \
     --callgrind-out-file="$dumps/out" "$program" 2>"$dumps/messages"; then
    cat "$dumps/messages" >&2
    echo "pel: bench: callgrind failed; see its messages above" >&2
    exit 2
fi
{
    echo "compiler,workload,instructions"
    ls "$dumps"/out.* | sort -V | xargs awk '
        /^desc: Trigger: Client Request: / {
            sub(/^desc: Trigger: Client Request: /, "")
            split($0, name, ",")
        }
        /^summary: / && name[1] != "" {
            printf "%s,%s,%.1f\n", name[1], name[2], $2 / name[3]
            name[1] = ""
        }'
} >"$dumps/csv"
mv "$dumps/csv" "$csv"
column -s, -t "$csv"
