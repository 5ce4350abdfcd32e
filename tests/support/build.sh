#!/bin/sh
# build.sh MAKE ARGUMENT...: builds, and instead of each command tells how many
# of all are done, now and then; what else make and compilers say is shown.
set -u
all=$("$@" -n 2>/dev/null | grep -c '^[^ ]*\(cc\|gcc\|clang\) .* -c ')
{
    "$@" 2>&1
    echo "make ended with $?"
} | awk -v all="$all" '
    /^make ended with [0-9]+$/ { status = $4; next }
    / -c .* -o / { if (++n % 100 == 0) print n " of " all " compiled"; next }
    /^(cc|gcc|clang|ar|rm -f) / { next }
    { print; fflush() }
    END { exit status }'
