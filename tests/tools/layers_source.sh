#!/bin/sh
# Two rules about what core is written in: no floating point, and `<<` on
# unsigned operands only (a negative one has no defined result). The shifts are
# those of clang's syntax tree, so macros are seen through.
set -eu
cd "$(dirname "$0")/../.."
status=0

find core -name '*.[ch]' | sort | xargs awk '
    FNR == 1 { comment = 0 }
    {
        code = $0
        gsub(/\/\*[^*]*\*+([^\/*][^*]*\*+)*\//, " ", code)
        if (comment && !sub(/^.*\*\//, "", code))
            next
        comment = sub(/\/\*.*$/, "", code)
        gsub(/"([^"\\]|\\.)*"/, "\"\"", code)
        if (code ~ /(^|[^A-Za-z0-9_])(float|double)([^A-Za-z0-9_]|$)/ || \
            code ~ /(^|[^A-Za-z0-9_])[0-9]+\.[0-9]*([^A-Za-z0-9_]|[fF]|$)/) {
            print FILENAME ":" FNR ": floating point in core" > "/dev/stderr"
            failed = 1
        }
    }
    END { exit failed }' || status=1

for file in core/*/*.c; do
    clang -std=c99 -I. -fsyntax-only -fno-color-diagnostics -Xclang -ast-dump \
        "$file"
done | awk '
    # A location names its file and its line only where they differ from those
    # of the location before.
    {
        rest = $0
        while (match(rest, /[<, ][^<>, ]*:[0-9]+:[0-9]+/)) {
            n = split(substr(rest, RSTART + 1, RLENGTH - 1), part, ":")
            if (n == 3 && part[1] != "line")
                file = part[1]
            line = part[n - 1]
            rest = substr(rest, RSTART + RLENGTH)
        }
        sub(/[a-z]*\/\.\.\//, "", file)
    }
    # What is shifted comes next in the tree; a literal is never negative.
    shift != "" && !/(Paren|Cast)Expr/ {
        if (!/IntegerLiteral/) {
            print shift > "/dev/stderr"
            failed = 1
        }
        shift = ""
    }
    / '\''<<=?'\''/ && file ~ /^(\.\/)?core\// {
        type = $0
        sub(/'\'' '\''<<'\''$/, "", type) # of a <<=, its result comes last
        sub(/'\''$/, "", type)
        sub(/.*'\''/, "", type)
        if (type !~ /unsigned|uint[0-9]+_t$/ && !seen[file, line]++)
            shift = file ":" line ": << on a signed operand"
    }
    END { exit failed }' || status=1
exit $status
