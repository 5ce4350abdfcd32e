#!/bin/sh
# run.sh : for each line `CPU SHIFT PROGRAM EMULATOR` of the input, runs the program
# twice and writes its counts as TSV. The two runs must agree to the last
# instruction.
set -eu

count() {
    timeout 300 $emulator "$elf" -icount $shift,sleep=off </dev/null
}

printf 'cpu\tcase\tparameter\tinstructions\n'
while read -r cpu shift elf emulator; do
    count >"$elf.counts" || {
        echo "bench-mcu: $elf failed" >&2
        exit 1
    }
    count | cmp -s - "$elf.counts" || {
        echo "bench-mcu: two runs of $elf gave different counts" >&2
        exit 1
    }
    # case, parameter, eighths of instructions, and how many calls or pixels
    # they are for; a longer row may take less than a short one
    awk -v cpu="$cpu" '{
        printf "%s\t%s\t%d\t%.2f\n", cpu, $1, $2, $3 < 0 ? 0 : $3 / 8 / $4
        rows++
    }
    NF != 4 { print "bench-mcu: " cpu ": " $0 > "/dev/stderr"; bad = 1 }
    END { exit bad || !rows }' "$elf.counts"
done
