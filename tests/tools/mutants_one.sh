#!/bin/sh
# mutants_one.sh TESTS CC FILE N : builds mutant N of FILE (a line of list.txt in
# its folder, see mutants.sh), runs the tests of the file and writes one of these
# to N in that folder:
#
#     killed BY | survived | same (code) | refused (by the compiler)
set -u
tests=$1 cc=$2 file=$3 number=$4
top=$PWD
work=$tests/mutants
dir=$work/$(echo "$file" | tr / _)
ulimit -c 0

line=$(sed -n "${number}p" "$dir/list.txt")
row=$(printf '%s' "$line" | cut -f 2)

# A tree like this one, but for one line of one file.
tree=$work/tree.$$
mkdir -p "$tree"
trap 'rm -rf "$tree"' EXIT
cp -rs "$top/core" "$tree/core"
ln -s "$top/tests" "$tree/tests"
rm "$tree/$file"
printf '%s' "$line" | cut -f 5 >"$tree/new"
sed -e "${row}{r $tree/new" -e 'd}' "$file" >"$tree/$file"

finish()
{
    echo "$*" >"$dir/$number"
    exit 0
}

# compile OBJECT of build $build into the tree, once.
compile()
{
    [ ! -f "$tree/$build/$1" ] || return 0
    mkdir -p "$tree/$build/$(dirname "$1")"
    (cd "$tree" && $cc -std=c99 -I. $flags -w -c "${1%.o}.c" \
        -o "$build/$1") 2>/dev/null || finish refused
}

# The objects that the change reaches and makes different.
compile_changed()
{
    changed=
    for o in $(sed -n "s|^$plain ||p" "$dir/$build"); do
        compile "$o"
        cmp -s "$tree/$build/$o" "$base/$o" ||
            changed="$changed $tree/$build/$o"
    done
}

# Does the test notice? Three times its own time is too long, and ten times that
# by the clock, since a program whose memory is broken may hang without working.
notices()
{
    $cc $flags "$object" $changed "$base/libsupport.a" "$base/libpel.a" \
        -lcmocka -lm -o "$tree/program" || finish refused
    scale=${plain##*:}
    [ "$scale" != "$plain" ] || scale=100
    limit=$((3 * $(cat "$work/$build/$plain.limit")))
    ! (ulimit -t $limit && PEL_SCALE=$scale exec timeout -s KILL \
        $((10 * limit)) "$tree/program") >/dev/null 2>&1
}

same=yes
for build in mutant_host mutant_portable mutant_stack; do
    base=$tests/$build
    flags=$(cat "$base/flags")
    for test in $(sed -n "s|^$file ||p" "$work/tests.txt"); do
        plain=${test#+}
        name=${plain%%:*}
        [ -f "$work/$build/$plain.limit" ] || continue
        compile_changed
        object=$base/tests/$name.o
        if [ "$plain" != "$test" ]; then
            compile "tests/$name.o"
            cmp -s "$tree/$build/tests/$name.o" "$object" ||
                changed="$changed "
            object=$tree/$build/tests/$name.o
        fi
        [ -n "$changed" ] || continue
        same=no
        ! notices 2>/dev/null || finish "killed $name ($build)"
    done
done
[ $same = yes ] && finish same
finish survived
