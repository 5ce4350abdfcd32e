#!/bin/sh
# layers_headers.sh CC WARNINGS... : every header of core compiles on its own,
# twice included, as C99. The public ones, to which pel.h leads, the outline
# filter and those of drivers and ports as C++11 too, with every warning about
# casts, on platforms whose headers define words such as near and max, and they
# include nothing inside extern "C".
set -u
cd "$(dirname "$0")/../.." || exit 1
cc=$1
shift
warnings=$*
status=0
drm=$(pkg-config --cflags libdrm 2>/dev/null | sed 's/-I/-isystem /g')

# compiles HEADER COMPILER... : what stands before it comes by standard input
compiles() {
    header=$1
    shift
    { cat; printf '#include "%s"\n#include "%s"\nint main(void);\n' \
        "$header" "$header"; } | "$@" $warnings -I. -fsyntax-only - || {
        echo "$header:1: does not compile on its own: $*" >&2
        return 1
    }
}

for header in $(find core -name '*.h' | sort); do
    compiles "$header" $cc -std=c99 -x c </dev/null || status=1
    compiles "$header" clang -std=c99 -x c </dev/null || status=1
done

public=$($cc -std=c99 -I. -MM -MT x core/pel.h | tr -d '\\' |
    sed 's/^x://' | tr ' ' '\n' | sed 's|[a-z]*/\.\./||' | grep '\.h$' |
    sort -u)
public="$public core/outline/outline_filter.h $(echo drivers/*.h port/*/*.h)"
casts="-Wcast-qual -Wold-style-cast -D_GNU_SOURCE $drm"
# Words that headers of platforms define; system headers come before them.
rubbish() {
    sed -n 's/^#include </&/p' $public | sort -u | grep -v drm
    for word in near far round min max small interface abs I IN OUT hyper; do
        echo "#define $word (this word is taken)"
    done
}
for header in $public; do
    rubbish | compiles "$header" g++ -std=c++11 -x c++ $casts -Wuseless-cast ||
        status=1
    rubbish | compiles "$header" clang++ -std=c++11 -x c++ $casts ||
        status=1
    rubbish | compiles "$header" $cc -std=gnu99 -x c -Wcast-qual \
        -D_GNU_SOURCE $drm || status=1
    awk '/PEL_BEGIN_DECLS/ { inside = FNR } /PEL_END_DECLS/ { inside = 0 }
        /^#include.*\.h/ && inside { print FILENAME ":" FNR \
            ": included inside extern \"C\""; bad = 1 } END { exit bad }' \
        "$header" >&2 || status=1
    grep -E '^(extern |(const )?((enum|struct) )?[a-z_0-9]+ \**[a-z_0-9]+\()' \
        "$header" | grep -qvE '^(static|typedef|inline)' &&
        ! grep -q PEL_BEGIN_DECLS "$header" && {
        echo "$header:1: declares functions without PEL_BEGIN_DECLS" >&2
        status=1
    }
done
exit $status
