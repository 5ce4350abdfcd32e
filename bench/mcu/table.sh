#!/bin/sh
# table.sh MCU.TSV [1] : prints the counts beside bench/mcu/budgets.tsv; fails
# when one is above what it was, or is missing. Up to 0.2 % more is what the
# stopwatch rounds when a call begins at another place in one of its ticks. With 1, the counts are written
# there as the new state, budgets unchanged.
set -eu
limits=bench/mcu/budgets.tsv
new=${1%/*}/budgets.new
status=0
awk -F '\t' -v OFS='\t' -v accept="${2-}" -v new="$new" '
    FNR == NR {
        if (FNR > 1)
            count[$1 FS $2 FS $3] = $4
        next
    }
    /^#/ || NF == 0 { print > new; next }
    !header++ {
        print "instructions (not cycles) per triangle in a box of E px, per" \
              " pixel, or per hit test"
        printf "%-14s %-15s %5s %12s %9s %9s\n", "cpu", "case", "E",
               "instructions", "was", "budget"
    }
    {
        key = $1 FS $2 FS $3
        measured = (key in count) ? count[key] : "-"
        late = $4 != "-" && measured > $4 + 0 ? " over budget" : ""
        printf "%-14s %-15s %5d %12s %9s %9s%s\n", $1, $2, $3, measured, $5,
               $4, late
        if (measured == "-" || (!accept && $5 != "-" && measured > 1.002 * $5)) {
            print FILENAME ":" FNR ": " $1 " " $2 " " $3 ": " measured \
                  " instructions, was " $5 > "/dev/stderr"
            failed = 1
        }
        print $1, $2, $3, $4, measured > new
    }
    END { exit failed }' "$1" "$limits" || status=1
if [ -n "${2-}" ]; then
    cp "$new" "$limits"
elif [ $status != 0 ]; then
    echo "bench-mcu: a growth that is meant: make bench-mcu ACCEPT=1" >&2
fi
exit $status
