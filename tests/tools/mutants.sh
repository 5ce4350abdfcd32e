#!/bin/sh
# mutants.sh TESTS CC [FILE...] : changes core in one place at a time and runs
# the tests of the changed file, in the default build and, where they notice
# nothing, in the portable one. TESTS is the folder of the builds mutant_host
# and mutant_portable; FILEs those of mutants_tests.txt to change, all unless
# told. PEL_JOBS says how many mutants are tried at once.
#
# A mutant is killed when a test fails, crashes or does not end. It is not
# counted when it does not compile, or when both builds have the same code
# with and without it. All others survive: each is printed, and must be in
# mutants_equivalent.txt with the reason why no test can notice it.
set -u
here=tests/tools
tests=$1 cc=$2
shift 2
work=$tests/mutants
rm -rf "$work"
mkdir -p "$work/results"

# FILE TEST... on one line each.
sed 's/#.*//' $here/mutants_tests.txt | tr '\n' ' ' |
    sed 's| *core/|\ncore/|g; s/: / /g' | grep . >"$work/tests.txt"
[ $# -gt 0 ] || set -- $(cut -d ' ' -f 1 "$work/tests.txt")

# The objects of core that the tests of this build link.
linked_core()
{
    for o in $(find "$tests/$1/tests" -name 'test_*.o'); do
        $cc "$o" "$tests/portable_core.o" "$tests/$1/libsupport.a" \
            "$tests/$1/libpel.a" -lcmocka -Wl,-M -o "$work/linked"
    done | sed -n 's/.*libpel\.a(\([a-z0-9_]*\)\.o).*/\1/p' | sort -u
}

# OBJECT SOURCE for each file that those objects and the tests depend on.
for build in mutant_host mutant_portable; do
    linked_core $build >"$work/linked.txt"
    find "$tests/$build" -name '*.d' | sort | while read -r d; do
        object=${d#"$tests/$build/"}
        object=${object%.d}
        [ -f "$object.c" ] || continue
        case $object in core/*)
            grep -qx "${object##*/}" "$work/linked.txt" || continue
            ;;
        esac
        sed 's/\\$//; s/^[^ ]*: //; /:$/d' "$d" | tr ' ' '\n' | grep . |
            sed 's|[a-z]*/\.\./||g' | sort -u | sed "s|^|$object.o |"
    done >"$work/$build.deps"
done

# A test that fails without any change would kill every mutant.
for build in mutant_host mutant_portable; do
    sed 's/^[^ ]* //; s/+//g' "$work/tests.txt" | tr ' ' '\n' | grep . |
        sort -u | while read -r test; do
        scale=${test##*:}
        [ "$scale" != "$test" ] || scale=100
        program=$tests/$build/tests/${test%%:*}
        [ ! -x "$program" ] || PEL_SCALE=$scale "$program" \
            >"$work/unchanged.txt" 2>&1 || {
            cat "$work/unchanged.txt"
            echo "$program fails without any change of core" >&2
            exit 1
        }
    done || exit 1
done

# Line numbers of $1 that one of the builds compiles.
active_lines()
{
    for build in mutant_host mutant_portable; do
        flags=
        [ $build = mutant_host ] ||
            flags='-DPEL_FAST_64BIT=0 -DPEL_VECTORS=0'
        source=$(awk -v f="$1" '$2 == f && /^core/ { print $1; exit }' \
            "$work/$build.deps")
        [ -n "$source" ] || continue
        $cc -std=c99 -I. $flags -E "${source%.o}.c" | awk -v f="$1" '
            /^# [0-9]+ "/ {
                line = $2
                name = $3
                gsub(/"/, "", name)
                gsub(/[a-z]*\/\.\.\//, "", name)
                next
            }
            { if (name == f && /[^ ]/) print line; line++ }'
    done | sort -nu
}

for file; do
    active_lines "$file" >"$work/active"
    awk -v active="$work/active" -f $here/mutants.awk "$file"
done >"$work/list.txt"

count=$(wc -l <"$work/list.txt")
echo "$count mutants of $# files"
seq "$count" | xargs -P "${PEL_JOBS:-$(nproc)}" -n 1 \
    sh $here/mutants_one.sh "$tests" "$cc"
for i in $(seq "$count"); do
    paste "$work/results/$i" - <<LINE
$(sed -n "${i}p" "$work/list.txt")
LINE
done >"$work/results.txt"
awk -f $here/mutants_report.awk $here/mutants_equivalent.txt \
    "$work/results.txt"
