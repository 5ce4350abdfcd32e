#!/bin/sh
# table.sh MCU.TSV : prints the counts beside bench/mcu/budgets.tsv; fails when
# one is above its budget, or is missing.
exec awk -F '\t' '
    /^#/ || NF == 0 { next }
    FNR == NR {
        key = $1 FS $2 FS $3
        budget[key] = $4
        line[key] = FILENAME ":" FNR
        next
    }
    FNR == 1 {
        print "instructions (not cycles) per triangle in a box of E px, or" \
              " per pixel"
        printf "%-14s %-14s %5s %12s %9s\n", "cpu", "case", "E",
               "instructions", "budget"
        next
    }
    {
        key = $1 FS $2 FS $3
        limit = (key in budget) ? budget[key] : "-"
        printf "%-14s %-14s %5d %12.2f %9s\n", $1, $2, $3, $4, limit
        if (limit != "-" && $4 > limit + 0)
            over[++n] = line[key] ": " $1 " " $2 " " $3 ": " $4 \
                        " instructions, budget " limit
        delete budget[key]
    }
    END {
        fflush()
        for (key in budget)
            over[++n] = line[key] ": this case was not measured"
        for (i = 1; i <= n; i++)
            print over[i] > "/dev/stderr"
        exit n > 0
    }' "$(dirname "$0")/budgets.tsv" "$1"
