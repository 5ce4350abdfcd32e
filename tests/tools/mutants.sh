#!/bin/sh
# mutants.sh TESTS CC [FILE...] : changes core in one place at a time and runs
# the tests of the changed file, in the default build and, where they notice
# nothing, in the portable one, and then in the one for a short stack. TESTS is
# the folder of these builds, mutant_host to mutant_stack; FILEs those of
# mutants_tests.txt to change, all unless told. PEL_JOBS says how many mutants
# are tried at once.
#
# A mutant is killed when a test fails, crashes or takes much longer. It is not
# counted when it does not compile, or when all builds have the same code with
# and without it. All others survive: each is printed, and must be in
# mutants_equivalent.txt with the reason why no test can notice it.
#
# A run that was stopped goes on where it was: TESTS/mutants has a folder for
# each file with what is known of its mutants, for as long as neither the file
# nor its tests change.
set -u
here=tests/tools
tests=$1 cc=$2
shift 2
work=$tests/mutants
builds='mutant_host mutant_portable mutant_stack'
mkdir -p "$work"
rm -rf "$work"/tree.*

die()
{
    echo "mutants.sh: $*" >&2
    exit 1
}

# FILE TEST... on one line each.
sed 's/#.*//' $here/mutants_tests.txt | tr '\n' ' ' |
    sed 's| *core/|\ncore/|g; s/: / /g' | grep . >"$work/tests.txt"
for file in $(cut -d ' ' -f 1 "$work/tests.txt"); do
    [ -f "$file" ] || die "$file is listed, and does not exist"
done
awk -f $here/mutants_stale.awk $here/mutants_equivalent.txt >&2 ||
    die "what is gone needs no reason"
[ $# -gt 0 ] || set -- $(cut -d ' ' -f 1 "$work/tests.txt")

tests_of()
{
    sed -n "s|^$1 ||p" "$work/tests.txt"
}

# OBJECT SOURCE for each file that an object depends on.
list_depends()
{
    for d in $(find "$tests/$1/core" "$tests/$1/tests" -name '*.d'); do
        object=${d#"$tests/$1/"}
        object=${object%.d}
        [ ! -f "$object.c" ] ||
            sed 's/\\$//; s/^[^ ]*: //; /:$/d; s|[a-z]*/\.\./||g' "$d" |
            tr ' ' '\n' | grep . | sed "s|^|$object.o |"
    done | sort -u
}

# The objects of core that a test links.
list_links()
{
    $cc $(cat "$tests/$1/flags") "$tests/$1/tests/$2.o" \
        "$tests/$1/libsupport.a" \
        "$tests/$1/libpel.a" -lcmocka -lm -Wl,-M -o "$work/linked" |
        sed -n 's|.*libpel\.a(\([a-z0-9_]*\)\.o).*|\1|p' | sort -u |
        while read -r name; do
            echo core/*/"$name.c" | sed 's/\.c$/.o/'
        done
}

# How many seconds of CPU time an unchanged test may take: 1, 2 or 4. One that
# fails without any change would kill every mutant.
list_limit()
{
    for limit in 1 2 4; do
        ! (ulimit -t $limit && PEL_SCALE=$3 exec "$tests/$1/tests/$2") \
            >"$work/unchanged.txt" 2>&1 || {
            echo $limit
            return
        }
    done 2>/dev/null
    cat "$work/unchanged.txt" >&2
    die "$tests/$1/tests/$2 fails without any change of core, or takes 4 s"
}

# What is known of the tests of the files: OBJECT-s and the limit, for each.
for test in $(for file; do tests_of "$file"; done | tr ' ' '\n' | sort -u); do
    name=${test%%:*} scale=${test##*:}
    name=${name#+}
    [ "$scale" != "$test" ] || scale=100
    [ -f "tests/$name.c" ] || die "tests/$name.c is listed, and does not exist"
    for build in $builds; do
        known=$work/$build/${test#+}
        [ ! "$known.limit" -nt "$tests/$build/tests/$name" ] || continue
        rm -f "$known.limit"
        [ -x "$tests/$build/tests/$name" ] || continue
        mkdir -p "$(dirname "$known")"
        list_links $build "$name" >"$known.links"
        list_limit $build "$name" "$scale" >"$known.new" || exit 1
        mv "$known.new" "$known.limit"
    done
done
for build in $builds; do
    mkdir -p "$work/$build"
    list_depends $build >"$work/$build/depends"
done

# TEST OBJECT for each object of this build that depends on the file and that a
# test of the file links.
reached()
{
    for test in $(tests_of "$2"); do
        known=$work/$1/${test#+}
        [ ! -f "$known.limit" ] || awk -v file="$2" -v test="${test#+}" '
            FNR == NR { linked[$1] = 1; next }
            $2 == file && $1 in linked { print test, $1 }' \
            "$known.links" "$work/$1/depends"
    done
}

# The numbers of the lines that one of the builds compiles.
active_lines()
{
    for build in $builds; do
        object=$(awk -v file="$1" '$2 == file && /^core/ { print $1; exit }' \
            "$work/$build/depends")
        [ -z "$object" ] || $cc -std=c99 -I. $(cat "$tests/$build/flags") \
            -E "${object%.o}.c" | awk -v file="$1" '
            /^# [0-9]+ "/ {
                line = $2
                name = $3
                gsub(/"/, "", name)
                gsub(/[a-z]*\/\.\.\//, "", name)
                next
            }
            { if (name == file && /[^ ]/) print line; line++ }'
    done | sort -nu
}

# All that the results of a file depend on.
sum_of()
{
    {
        cat "$work/new.txt"
        tests_of "$1"
        for build in $builds; do
            for test in $(tests_of "$1"); do
                name=${test%%:*}
                known=$work/$build/${test#+}
                [ ! -f "$known.limit" ] ||
                    (cd "$tests/$build" && cat $(cat "$top/$known.links") \
                        "tests/${name#+}.o" libsupport.a)
            done
        done
    } | cksum
}

top=$PWD
for file; do
    [ -n "$(tests_of "$file")" ] || die "$file is not in mutants_tests.txt"
    active_lines "$file" >"$work/active"
    awk -v active="$work/active" -f $here/mutants.awk "$file" >"$work/new.txt"
    [ -s "$work/new.txt" ] || die "$file is listed, and has nothing to change"
    dir=$work/$(echo "$file" | tr / _)
    sum=$(sum_of "$file")
    [ "$(cat "$dir/sum" 2>/dev/null)" = "$sum" ] || rm -rf "$dir"
    mkdir -p "$dir"
    cp "$work/new.txt" "$dir/list.txt"
    echo "$sum" >"$dir/sum"
    for build in $builds; do
        reached $build "$file" >"$dir/$build"
    done
    cat "$dir"/mutant_* | grep -q . ||
        die "$file is listed, and is in no object that its tests link"
done

# FILE N of the mutants of which nothing is known.
left_over()
{
    for file; do
        dir=$work/$(echo "$file" | tr / _)
        for i in $(seq "$(wc -l <"$dir/list.txt")"); do
            [ -s "$dir/$i" ] || echo "$file $i"
        done
    done
}

left_over "$@" >"$work/left.txt"
echo "$(wc -l <"$work/left.txt") mutants to try"
xargs -P "${PEL_JOBS:-$(nproc)}" -n 2 sh $here/mutants_one.sh "$tests" "$cc" \
    <"$work/left.txt"
[ -z "$(left_over "$@")" ] || die "some mutants were not tried"

for file; do
    dir=$work/$(echo "$file" | tr / _)
    (cd "$dir" && cat $(seq "$(wc -l <list.txt)")) | paste - "$dir/list.txt"
done >"$work/results.txt"
awk -f $here/mutants_report.awk $here/mutants_equivalent.txt \
    "$work/results.txt"
