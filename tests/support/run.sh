#!/bin/sh
# Runs tests, several at a time, and adds up what they say.
#
#     run.sh DIR < LIST
#
# LIST has a line `NAME<TAB>COMMAND` for each; their output goes to DIR. PEL_JOBS
# says how many run at once (one for each CPU). Prints a line for each test (see
# run_one.sh), the slowest three, and last `N passed, N failed`; exit status 1 when any failed. A test
# that did not end counts as one that failed.
set -u
dir=$1
here=$(dirname "$0")
mkdir -p "$dir"
rm -f "$dir"/*.log "$dir"/*.count
unset MAKEFLAGS MFLAGS MAKELEVEL

grep . >"$dir/list"
tr '\n' '\0' <"$dir/list" |
    xargs -0 -n 1 -P "${PEL_JOBS:-$(nproc)}" sh "$here/run_one.sh" "$dir"
sort -k 3 -n -r "$dir"/*.count | awk 'NR <= 3 {
    s = $3 / 1000
    $1 = $2 = $3 = ""
    printf "slow: %.1f s %s\n", s, $0
}'
cat "$dir"/*.count | awk -v tests="$(wc -l <"$dir/list")" '
    { passed += $1; failed += $2 }
    END {
        if (NR < tests)
            printf "%d tests did not end\n", tests - NR
        failed += tests - NR
        printf "%d passed, %d failed\n", passed, failed
        exit failed > 0 || passed == 0
    }'
