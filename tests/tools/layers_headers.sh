#!/bin/sh
# layers_headers.sh CC WARNINGS... : every header of core compiles on its own,
# twice included, as C99; the public ones, to which pel.h leads, as C++11 too.
# Bodies (core/format/body.h) are no headers: formats end with them.
set -u
cd "$(dirname "$0")/../.." || exit 1
cc=$1
shift
warnings=$*
status=0

# compiles HEADER COMPILER...
compiles() {
    header=$1
    shift
    printf '#include "%s"\n#include "%s"\nint main(void);\n' \
        "$header" "$header" | "$@" $warnings -I. -fsyntax-only - || {
        echo "$header:1: does not compile on its own: $*" >&2
        status=1
    }
}

for header in $(find core -name '*.h' ! -path 'core/format/body*' | sort); do
    compiles "$header" $cc -std=c99 -x c
    compiles "$header" clang -std=c99 -x c
done

public=$($cc -std=c99 -I. -MM -MT x core/pel.h | tr -d '\\' |
    sed 's/^x://' | tr ' ' '\n' | sed 's|[a-z]*/\.\./||' | sort -u)
for header in $public; do
    compiles "$header" g++ -std=c++11 -x c++
    compiles "$header" clang++ -std=c++11 -x c++
done
exit $status
