#!/bin/sh
# pairs_smooth.sh STACK.TSV... [1] : holds the pairs of smooth shapes and paints that
# pairs.sh has measured against pairs_smooth.tsv, beside this script: none may use
# more stack. With 1, they are written there as the new state.
set -eu
limits=$(dirname "$0")/pairs_smooth.tsv
accept=
for last; do :; done
if [ "$last" = 1 ]; then
    accept=1
fi
new=${1%/*}/pairs_smooth.new
for file; do
    [ "$file" = 1 ] || grep -e "$(printf 'shape\tflat\t')" \
        -e "$(printf '\tsmooth_')" "$file"
done | awk '!/\tshape\t/ || !header++' >"$new"
if [ -n "$accept" ]; then
    cp "$new" "$limits"
    exit
fi
awk -F '\t' '
    FNR == 1 { split($0, paint); next }
    FNR == NR {
        lines[$1, $2]
        for (i = 3; i <= NF; i++)
            limit[$1, $2, i] = $i
        next
    }
    {
        for (i = 3; i <= NF; i++)
            if (!(($1, $2, i) in limit) || $i > limit[$1, $2, i] + 0) {
                print "size: " $1 ": " $2 " with " paint[i] " uses " $i \
                      " bytes of stack, budget " limit[$1, $2, i] > "/dev/stderr"
                failed = 1
            }
        delete lines[$1, $2]
    }
    END {
        for (key in lines) {
            sub(SUBSEP, " ", key)
            print "size: " key ": not measured" > "/dev/stderr"
            failed = 1
        }
        exit failed
    }' "$limits" "$new"
