#!/bin/sh
# agree.sh FOLDER FOLDER : two runs of the atlas (their csv folders) against each
# other. Figures without a spread are exact and must be the same; the spreads of
# times must meet. Prints how many do, and the times that do not; fails when an
# exact figure differs, or when more than one time in twenty stands apart.
set -eu
for file in "$1"/*.csv; do
    [ ! -e "$2/${file##*/}" ] || cat "$file" "$2/${file##*/}"
done | awk -F, '
    $1 == "case" { next }
    {
        key = $1 "," $2 "," $3 "," $4 "," $5
        seen[key]++
    }
    !(key in value) {
        value[key] = $6
        low[key] = $7
        high[key] = $8
        next
    }
    $7 == "" {
        exact++
        if (value[key] != $6) {
            changed++
            print "changed: " key ": " value[key] ", " $6
        }
        next
    }
    {
        times++
        if (low[key] + 0 > $8 + 0 || $7 + 0 > high[key] + 0) {
            apart++
            printf "apart: %s: %s (%s to %s), %s (%s to %s)\n", key, value[key],
                low[key], high[key], $6, $7, $8
        }
    }
    END {
        for (key in seen)
            if (seen[key] == 1) {
                changed++
                print "in one run alone: " key
            }
        printf "%d exact figures, %d changed; %d times, %d apart\n", exact,
            changed, times, apart
        exit changed > 0 || apart * 20 > times
    }'
