#!/bin/sh
# Measures every C source and checks its layout.
set -u
cd "$(dirname "$0")/../.." || exit 1
files=$(find core drivers port sim page bench tests examples \
    -name '*.[ch]' -o -name '*.inc' -o -name '*.cpp' | sort)
status=0
LC_ALL=C awk -f tests/tools/metrics.awk $files || status=1
clang-format --dry-run -Werror -style=file $files 2>&1 |
    awk -F : '/error:/ && !seen[$1]++ {
        print $1 ":" $2 ": not laid out by the house style: clang-format -i " $1
        bad = 1
    }
    END { exit bad }' >&2 || status=1
exit $status
