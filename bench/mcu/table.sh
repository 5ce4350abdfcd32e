#!/bin/sh
# table.sh MCU.TSV [1] : prints the counts beside bench/mcu/budgets.tsv (of the
# matrix of paints those over budget); fails when one is above what it was, or
# is missing there or here, when a cell of the matrix takes more than 1.3 times as
# much at -Os as at -O2, or docs/MATRIX.md is not what follows. 1.6 times hold for
# text and paints that keep few rows or colors there, so that every pair of shape
# and paint fits 384 bytes of stack (tests/link/pairs.sh), and 2.3 for horizontal
# gradients, whose rows are not copied there. A little more
# is what the stopwatch rounds when a call begins at another place in one of its
# ticks. With 1, the counts are written there as the new state, budgets
# unchanged, and the document too.
set -eu
limits=bench/mcu/budgets.tsv
new=${1%/*}/budgets.new
status=0
awk -F '\t' -v OFS='\t' -v accept="${2-}" -v new="$new" '
    function fail(what) {
        print FILENAME ":" FNR ": " what > "/dev/stderr"
        failed = 1
    }
    # The level is behind the last "-" of the CPU.
    function level_of(cpu,    part, n) {
        n = split(cpu, part, "-")
        return part[n]
    }
    function measured(key, level) {
        return (key, level) in count ? count[key, level] : "-"
    }
    FNR == NR {
        if (FNR == 1)
            next
        level = level_of($1)
        key = substr($1, 1, length($1) - length(level) - 1) OFS $2 OFS $3
        if (!(key in unseen))
            keys[++n] = key
        unseen[key]
        count[key, level] = $4
        next
    }
    BEGIN {
        split("O2 Os small", levels, " ")
        few = "/(text|fan|nearest|dithered-nearest|nine-slice|bilinear|checker|" \
            "hatch|xor-flat|mesh-phong)$"
    }
    /^#/ || NF == 0 { print > new; next }
    !header++ {
        print "instructions (not cycles) per triangle in a box of E px, per" \
              " pixel, or per hit test"
        printf "%-14s %-26s %5s %9s %9s %9s %9s %9s\n", "cpu", "case", "E",
               "-O2", "was", "budget", "-Os", "small"
    }
    {
        key = $1 OFS $2 OFS $3
        at_o2 = measured(key, "O2")
        at_os = measured(key, "Os")
        late = $4 != "-" && at_o2 > $4 + 0 ? " over budget" : ""
        if (late || $2 !~ /\//)
            printf "%-14s %-26s %5d %9s %9s %9s %9s %9s%s\n", $1, $2, $3,
                   at_o2, $5, $4, at_os, measured(key, "small"), late
        for (i = 1; i <= 3 && !accept; i++) {
            now = measured(key, levels[i])
            if (now == "-" ? $(4 + i) != "-" : now > 1.002 * $(4 + i) + .01)
                fail($1 " " $2 " " $3 ": " now " instructions with " \
                     levels[i] ", was " $(4 + i))
        }
        most = $2 ~ /horizontal$/ ? 2.3 : $2 ~ few ? 1.6 : 1.3
        if ($2 ~ /\// && at_os > most * at_o2 + .02)
            fail($1 " " $2 " " $3 ": " at_os " instructions at -Os, " at_o2 \
                 " at -O2")
        print $1, $2, $3, $4, at_o2, at_os, measured(key, "small") > new
        delete unseen[key]
    }
    END {
        for (i = 1; i <= n; i++)
            if (keys[i] in unseen) {
                if (!accept)
                    fail(keys[i] " is counted and not here")
                print keys[i], "-", measured(keys[i], "O2"),
                    measured(keys[i], "Os"), measured(keys[i], "small") > new
            }
        exit failed
    }' "$1" "$limits" || status=1
[ -z "${2-}" ] || cp "$new" "$limits"
bench/mcu/matrix.sh ${2-} || status=1
echo "every paint on every CPU and format: docs/MATRIX.md"
[ $status = 0 ] ||
    echo "bench-mcu: a change that is meant: make bench-mcu ACCEPT=1" >&2
exit $status
