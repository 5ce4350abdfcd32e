#!/bin/sh
# check.sh BUILD ROOT VERSION : builds the projects beside this script outside of
# the tree, each by its own way to Pel, which `make install` has put below ROOT
# with the prefix /opt/pel. All draw one picture.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/sim/lib.sh
here=$PWD/tests/package one=$PWD/$1/amalgamation prefix=$2/opt/pel version=$3
unset MAKEFLAGS MAKELEVEL DESTDIR
export PKG_CONFIG_SYSROOT_DIR="$2" PKG_CONFIG_LIBDIR="$prefix/lib/pkgconfig"
export LD_LIBRARY_PATH="$prefix/lib"

# run NAME COMMAND...: in a copy of the project NAME, with the tree in pel/
run() {
    project=$work/$1
    [ -d "$project" ] || {
        cp -R "$here/$1" "$project"
        cp "$here/main.c" "$project"
        ln -s "$PWD" "$project/pel"
    }
    shift
    (cd "$project" && "$@") >"$work/log" 2>&1 || {
        cat "$work/log"
        fail "$project: $*"
    }
}

# draws PROGRAM: the picture of all projects
draws() {
    "$1" | cmp - "$work/picture" || fail "$1 draws something else"
}

$CC $INCLUDE "$here/main.c" "$LIBPEL" -o "$work/main"
"$work/main" >"$work/picture" && [ -s "$work/picture" ] || fail "no picture"

# make and pkg-config, with the shared library
run make make main
draws "$work/make/main"
[ "$(pkg-config --modversion pel)" = "$version" ] || fail "version of pel.pc"
library=$prefix/lib/libpel.so.$version
readelf -d "$work/make/main" | grep -q "NEEDED.*libpel\.so\.${version%.*}]" ||
    fail "the soname of libpel.so"
nm -D --defined-only "$library" | grep -v ' pel_' && fail "names not of pel"
"$prefix/bin/pel" --help | grep -q '^Usage: pel' || fail "bin/pel"
for page in man1/pel.1 man3/pel.3; do
    page=$prefix/share/man/$page
    { grep '^\.SH NAME' "$page" && groff -K utf8 -T utf8 -man -ww -z "$page" 2>&1; } |
        sed 1d | grep . && fail "$page: see above"
    grep -q "pel $version" "$page" || fail "$page: no version"
done

# CMake: the tree inside a project, which installs it for another
run cmake_subdirectory cmake -B b -D CMAKE_BUILD_TYPE=Debug
run cmake_subdirectory cmake --build b
draws "$work/cmake_subdirectory/b/main"
run cmake_subdirectory cmake --install b --prefix "$work/usr"
run cmake_installed cmake -B b -D CMAKE_PREFIX_PATH="$work/usr"
run cmake_installed cmake --build b
draws "$work/cmake_installed/b/main"

# ESP-IDF and Zephyr: main.c finds the headers
for framework in idf zephyr; do
    rm -rf "$work/cmake_framework"
    run cmake_framework cmake -B b -D FRAMEWORK=$framework
    run cmake_framework cmake --build b --target main.o
done

# one source: freestanding, by two compilers, each part left out, from C++
for cc in gcc clang; do
    $cc -std=c99 $WARNINGS -O2 -fno-pie -ffreestanding -c "$one/pel.c" \
        -o "$work/pel.o" || fail "$cc pel.c"
    $cc $INCLUDE -I. tests/golden/scenes.c "$work/pel.o" -no-pie -o "$work/scenes" &&
        "$work/scenes" | diff - tests/golden/scenes.txt ||
        fail "pel.c draws other scenes by $cc"
    tests/tools/layers_objects.sh size nm "$work/pel.o" || fail "pel.o by $cc"
done
all="-DPEL_FAST_FILLS=0"
for part in HIT IMAGE OUTLINE SCENE PAINT; do
    all="$all -DPEL_WITH_$part=0"
    $CC -std=c99 $WARNINGS $all -fno-pie -c "$one/pel.c" -o "$work/less.o" &&
        tests/tools/layers_objects.sh size nm "$work/less.o" || fail "$all"
done
$CC -I"$one" -DPEL_WITH_PAINT=0 -fsyntax-only "$one/pel.c" 2>/dev/null &&
    fail "PEL_WITH_PAINT=0 alone is taken"
g++ -std=c++11 -Wall -Wextra -Wpedantic -Wold-style-cast -Werror -I"$one" \
    "$here/sketch.cpp" "$work/pel.o" -no-pie -o "$work/sketch" && "$work/sketch" ||
    fail "a sketch in C++"

# drivers, examples and assets beside the one source
mkdir "$work/asset"
for source in builtin:vase-small sim/scenes/face.ppm sim/scenes/fixed_6x13.bdf; do
    "$PEL" import "$source" --name asset -o "$work/asset/${source##*[:.]}.c" ||
        fail "import $source"
done
for file in drivers/*.c examples/board.c "$work"/asset/*.c; do
    case $file in *linux*) ;; *)
        $CC -std=c99 $WARNINGS -I"$one" -fsyntax-only "$file" || fail "$file" ;;
    esac
done

# PlatformIO: the folder of sources is that of the headers
cmake -D VERSION="$version" -P "$here/library_json.cmake" || fail "library.json"
g++ -fsyntax-only -Icore "$here/sketch.cpp" || fail "a sketch with core/pel.h"

# what the schemas of the others require
for key in name author maintainer sentence paragraph category url \
    architectures; do
    grep -q "^$key=." "$one/library.properties" ||
        fail "library.properties: no $key"
done
grep -qx "version=$version" "$one/library.properties" ||
    fail "version of library.properties"
grep -qx "version: \"$version\"" idf_component.yml ||
    fail "version of idf_component.yml"
grep -qx 'name: pel' zephyr/module.yml || fail "zephyr/module.yml"
