#!/bin/sh
# table.sh MCU.TSV [1] : prints the counts beside bench/mcu/budgets.tsv (of the
# matrix of paints those over budget); fails when one is above what it was, or
# is missing there or here, or docs/MATRIX.md is not what follows. A little more
# is what the stopwatch rounds when a call begins at another place in one of its
# ticks. With 1, the counts are written there as the new state, budgets
# unchanged, and the document too.
set -eu
limits=bench/mcu/budgets.tsv
new=${1%/*}/budgets.new
status=0
awk -F '\t' -v OFS='\t' -v accept="${2-}" -v new="$new" '
    function fail(what) {
        if (accept)
            return
        print FILENAME ":" FNR ": " what > "/dev/stderr"
        failed = 1
    }
    FNR == NR {
        if (FNR > 1) {
            key[++keys] = $1 OFS $2 OFS $3
            count[key[keys]] = $4
        }
        next
    }
    /^#/ || NF == 0 { print > new; next }
    !header++ {
        print "instructions (not cycles) per triangle in a box of E px, per" \
              " pixel, or per hit test"
        printf "%-14s %-26s %5s %12s %9s %9s\n", "cpu", "case", "E",
               "instructions", "was", "budget"
    }
    !(($1 OFS $2 OFS $3) in count) {
        fail($1 " " $2 " " $3 " is not counted")
        next
    }
    {
        measured = count[$1 OFS $2 OFS $3]
        late = $4 != "-" && measured > $4 + 0 ? " over budget" : ""
        if (late || $2 !~ /\//)
            printf "%-14s %-26s %5d %12s %9s %9s%s\n", $1, $2, $3, measured,
                   $5, $4, late
        if (measured > 1.002 * $5 + .01)
            fail($1 " " $2 " " $3 ": " measured " instructions, was " $5)
        print $1, $2, $3, $4, measured > new
        delete count[$1 OFS $2 OFS $3]
    }
    END {
        for (i = 1; i <= keys; i++)
            if (key[i] in count) {
                fail(key[i] " is counted and not here")
                print key[i], "-", count[key[i]] > new
            }
        exit failed
    }' "$1" "$limits" || status=1
[ -z "${2-}" ] || cp "$new" "$limits"
bench/mcu/matrix.sh ${2-} || status=1
echo "every paint on every CPU and format: docs/MATRIX.md"
[ $status = 0 ] ||
    echo "bench-mcu: a change that is meant: make bench-mcu ACCEPT=1" >&2
exit $status
