#!/bin/sh
# pairs.sh CPU-LEVEL ELF BUDGET : the stack of every shape with every paint as pairs.c
# measures it on its board, as TSV, a row for each shape: what pel_SHAPE and all
# below it use. Fails when a pair is above the budget.
set -eu
here=$(dirname "$0")
. "$here/board.sh"

{
    arm-none-eabi-objdump -d --no-show-raw-insn "$2" |
        awk -v frames=draw_ -f "$here/stack.awk"
    run_on_board "$1" "$2"
} | awk -v OFS='\t' -v cpu="$1" -v budget="$3" '
    NF == 2 { frame[$1] = $2; next }
    NF == 3 {
        used = $3 - frame["draw_" $1]
        line[$1] = line[$1] OFS used
        if (!($1 in seen))
            shape[++shapes] = $1
        seen[$1]
        if (!($2 in named))
            names = names OFS $2
        named[$2]
        if (used > budget) {
            print "size: " cpu ": " $1 " with " $2 " uses " used \
                  " bytes of stack, budget " budget > "/dev/stderr"
            failed = 1
        }
        pairs++
    }
    END {
        print "cpu", "shape" names
        for (i = 1; i <= shapes; i++)
            print cpu, shape[i] line[shape[i]]
        if (!pairs) {
            print "size: " cpu ": no pairs were measured" > "/dev/stderr"
            failed = 1
        }
        exit failed
    }'
