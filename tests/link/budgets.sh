#!/bin/sh
# budgets.sh SIZE.TSV [1] : holds the rows that budgets.tsv, beside this script,
# names against it. With 1, what was measured is written there as the new state,
# budgets unchanged.
set -eu
limits=$(dirname "$0")/budgets.tsv
new=${1%/*}/budgets.new
status=0
form='%-14s %-18s %6s %6s %6s %6s %6s %6s %6s\n'
awk -F '\t' -v OFS='\t' -v form="$form" -v accept="${2-}" -v new="$new" '
    function over(what, bytes, limit, kind) {
        if (limit == "-" || bytes + 0 <= limit + 0)
            return 0
        print FILENAME ":" FNR ": " $1 " " $2 ": " bytes " bytes of " what \
              ", " kind " " limit > "/dev/stderr"
        return failed = 1
    }
    FNR == NR {
        size[$1 FS $2] = $3 + $4
        depth[$1 FS $2] = $6
        used[$1 FS $2] = $7
        if (FNR > 1 && $2 !~ /\//)
            unnamed[unnamed_key[++unnameds] = $1 FS $2]
        next
    }
    /^#/ || NF == 0 { print > new; next }
    FNR > 1 && !header++ {
        printf form, "cpu", "feature", "text", "was", "budget", "stack",
            "was", "used", "budget"
    }
    {
        if (!(($1 FS $2) in size)) {
            print FILENAME ":" FNR ": " $1 " " $2 ": not measured, name a " \
                  "program of tests/link" > "/dev/stderr"
            failed = 1
        }
        delete unnamed[$1 FS $2]
        text = size[$1 FS $2]
        stack = depth[$1 FS $2]
        printf form, $1, $2, text, $3, $4, stack, $5, used[$1 FS $2], $6
        over("code", text, $4, "budget")
        over("stack", used[$1 FS $2], $6, "budget")
        if (!accept) {
            over("code", text, $3, "was")
            over("stack", stack, $5, "was")
        }
        print $1, $2, text, $4, stack, $6 > new
    }
    END {
        for (i = 1; i <= unnameds; i++) {
            key = unnamed_key[i]
            if (!(key in unnamed))
                continue
            print key, size[key], "-", depth[key], "-" > new
            if (accept)
                continue
            sub(FS, " ", key)
            print FILENAME ":" FNR ": no line for " key > "/dev/stderr"
            failed = 1
        }
        exit failed
    }' "$1" "$limits" || status=1
if [ -n "${2-}" ]; then
    cp "$new" "$limits"
elif [ $status != 0 ]; then
    echo "size: a growth that is meant: make size ACCEPT=1" >&2
fi
exit $status
