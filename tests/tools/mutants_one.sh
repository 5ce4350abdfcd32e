#!/bin/sh
# mutants_one.sh TESTS CC N : builds mutant N of TESTS/mutants/list.txt, runs the
# tests of its file and writes to TESTS/mutants/results/N one of
#
#     killed BY | survived | same (code) | refused (by the compiler)
set -u
tests=$1 cc=$2 number=$3
top=$PWD
work=$tests/mutants
ulimit -c 0

line=$(sed -n "${number}p" "$work/list.txt")
file=$(printf '%s' "$line" | cut -f 1)
row=$(printf '%s' "$line" | cut -f 2)
suite=$(sed -n "s|^$file ||p" "$work/tests.txt")

# A tree like this one, but for one line of one file.
tree=$work/tree$number
mkdir -p "$tree"
trap 'rm -rf "$tree"' EXIT
cp -rs "$top/core" "$tree/core"
ln -s "$top/tests" "$tree/tests"
rm "$tree/$file"
printf '%s' "$line" | cut -f 5 >"$tree/new"
sed -e "${row}{r $tree/new" -e 'd}' "$file" >"$tree/$file"

finish()
{
    echo "$*" >"$work/results/$number"
    exit 0
}

# compile OBJECT of build $build into the tree.
compile()
{
    mkdir -p "$tree/$build/$(dirname "$1")"
    (cd "$tree" && $cc -std=c99 -I. -O1 $flags -w -c "${1%.o}.c" \
        -o "$build/$1") 2>/dev/null
}

# The core objects of this build that the change reaches and changes.
compile_core()
{
    changed=
    for o in $(awk -v f="$file" '$2 == f && /^core/ { print $1 }' \
        "$work/$build.deps"); do
        compile "$o" || finish refused
        cmp -s "$tree/$build/$o" "$base/$o" ||
            changed="$changed $tree/$build/$o"
    done
}

# run TEST[:SCALE] : does it notice?
run()
{
    name=${1%%:*}
    scale=${1##*:}
    [ "$scale" != "$1" ] || scale=100
    object=$base/tests/${name#+}.o
    case $name in +*)
        name=${name#+}
        compile "tests/$name.o" || finish refused
        object=$tree/$build/tests/$name.o
        ;;
    esac
    twin=
    case $name in *test_walkers* | *test_fast_writers)
        twin=$tests/portable_core.o
        ;;
    esac
    $cc "$object" $changed $twin "$base/libsupport.a" "$base/libpel.a" \
        -lcmocka -o "$tree/program" || finish refused
    ! PEL_SCALE=$scale timeout -s KILL 20 "$tree/program" >/dev/null 2>&1
}

same=yes
for build in mutant_host mutant_portable; do
    base=$tests/$build
    flags=
    [ $build = mutant_host ] || flags='-DPEL_FAST_64BIT=0 -DPEL_VECTORS=0'
    compile_core
    for test in $suite; do
        plain=${test#+}
        [ -n "$changed" ] || [ "$plain" != "$test" ] || continue
        [ -x "$base/tests/${plain%%:*}" ] || continue
        same=no
        run "$test" && finish "killed ${plain%%:*} ($build)"
    done
done
[ $same = yes ] && finish same
finish survived
