#!/bin/sh
# check.sh BUILD VERSION : builds the projects beside this script outside of the
# tree, each by its own way to Pel. All draw one picture, and their program for a
# device without a display says so.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/sim/lib.sh
here=$PWD/tests/package one=$PWD/$1/amalgamation arduino=$PWD/$1/arduino/Pel
version=$2
unset MAKEFLAGS MAKELEVEL DESTDIR PREFIX FRAMEBUFFER

# run NAME COMMAND...: in a copy of the project NAME, with the tree in pel/
run() {
    project=$work/$1
    [ -d "$project" ] || {
        cp -R "$here/$1" "$project"
        cp "$here/main.c" "$here/panel.c" "$here/desk.c" "$work/kiosk.c" "$project"
        ln -s "$PWD" "$project/pel"
    }
    shift
    (cd "$project" && "$@") >"$work/log" 2>&1 || {
        cat "$work/log"
        fail "$project: $*"
    }
}

# draws FOLDER: the programs of a project
draws() {
    "$1/main" | cmp - "$work/picture" || fail "$1/main draws something else"
    "$1/panel" || fail "$1/panel"
    [ ! -e "$1/kiosk" ] || FRAMEBUFFER=/dev/null "$1/kiosk" 2>&1 </dev/null |
        grep -q '/dev/null is no framebuffer device' || fail "$1/kiosk"
    [ ! -e "$1/desk" ] || SDL_VIDEODRIVER=dummy "$1/desk" || fail "$1/desk"
}

$CC $INCLUDE "$here/main.c" "$LIBPEL" -o "$work/main"
"$work/main" >"$work/picture" && [ -s "$work/picture" ] || fail "no picture"
awk -v folder="$work" -f tests/tools/doc_blocks.awk docs/linux.md >/dev/null
mv "$work/hello.c" "$work/kiosk.c"

# make install, into folders with a blank; a relative PREFIX begins in this one
make -s BUILD="$1" DESTDIR="$work/a root" PREFIX=/opt/pel install &&
    grep -qx prefix=/opt/pel "$work/a root/opt/pel/lib/pkgconfig/pel.pc" ||
    fail "make install DESTDIR="
prefix="$PWD/$(realpath --relative-to=. "$work")/usr local"
make -s BUILD="$1" PREFIX="${prefix#"$PWD/"}" install || fail "make install"

# make and pkg-config, with the shared library
export PKG_CONFIG_PATH="$prefix/lib/pkgconfig"
export LD_LIBRARY_PATH="$prefix/lib"
run make make
draws "$work/make"
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

# CMake: the tree inside a project, which installs it for another. As one
# debugs: gcc sees at -Og what it proves away at -O2.
run cmake_subdirectory cmake -B b -D CMAKE_BUILD_TYPE=Debug \
    -D CMAKE_C_FLAGS_DEBUG="-Og -g -Wall -Wextra -Werror"
run cmake_subdirectory cmake --build b
draws "$work/cmake_subdirectory/b"
run cmake_subdirectory cmake --install b --prefix "$work/usr"
run cmake_installed cmake -B b -D CMAKE_PREFIX_PATH="$work/usr"
run cmake_installed cmake --build b
draws "$work/cmake_installed/b"
cmake -S . -B "$work/bare" -D CMAKE_DISABLE_FIND_PACKAGE_PkgConfig=ON \
    >"$work/log" 2>&1 || fail "CMake without packages"
grep -q '^all:.*pel_linux' "$work/bare/CMakeFiles/Makefile2" &&
    fail "CMake builds pel_linux where no package of it is"
cmake -S . -B "$work/firmware" -D CMAKE_SYSTEM_NAME=Generic >"$work/log" 2>&1 ||
    fail "CMake for a board"
grep -qE 'pel_(sdl|linux)' "$work/firmware/CMakeFiles/Makefile2" &&
    fail "CMake builds for a board what the host has packages of"

# ESP-IDF; Zephyr, with a library of its own name
run cmake_idf cmake -P requirements.cmake
run cmake_idf cmake -B b
run cmake_idf cmake --build b
draws "$work/cmake_idf/b"
run cmake_zephyr cmake -B b -D CONFIG_PEL=y -D CONFIG_PEL_DRIVERS=y \
    -D CONFIG_PEL_SHORT_STACK=y
run cmake_zephyr cmake --build b
draws "$work/cmake_zephyr/b"
[ -f "$work/cmake_zephyr/b/pel/libpel.a" ] || fail "Zephyr: no libpel.a"
run cmake_zephyr cmake -B deep -D CONFIG_PEL=y -D CONFIG_PEL_DRIVERS=y
for folder in b deep; do
    grep -rl --include=flags.make 'C_DEFINES.*PEL_SHORT_STACK=0' \
        "$work/cmake_zephyr/$folder"
done | awk '!/\/deep\// { bad = 1 } END { exit bad || !NR }' ||
    fail "Zephyr: CONFIG_PEL_SHORT_STACK"
run cmake_zephyr cmake -B none
run cmake_zephyr cmake --build none
[ ! -e "$work/cmake_zephyr/none/pel/libpel.a" ] ||
    fail "Zephyr: without CONFIG_PEL there is a libpel.a"
for option in $(grep -o 'CONFIG_[A-Z_]*' CMakeLists.txt | sort -u); do
    grep -qx "config ${option#CONFIG_}" zephyr/Kconfig Kconfig ||
        fail "Kconfig: $option"
done

# PEL_SMALL_CODE, for the library and for what includes its headers
for way in subdirectory/PEL idf/CONFIG_PEL zephyr/CONFIG_PEL; do
    option=${way#*/}_SMALL_CODE way=cmake_${way%/*}
    run $way cmake -B small -D CONFIG_PEL=y -D CONFIG_PEL_DRIVERS=y -D "$option=y"
    run $way cmake --build small
    draws "$work/$way/small"
    find "$work/$way/small" -name flags.make -exec \
        grep -L 'C_DEFINES.*PEL_SMALL_CODE=1' {} + | grep . &&
        fail "$way: without $option, see above"
done

# gauge.c as it is, on a board: its memory is that of two bands
mkdir "$work/gauge"
cp examples/gauge.c "$here/gauge/panel.h" "$work/gauge"
"$PEL" import /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf --font-size 36 --bits 4 \
    --chars "0123456789.° " -o "$work/gauge/digits_36.c" &&
    $CC -std=c99 $WARNINGS -Os -ffunction-sections -fdata-sections -I. $INCLUDE \
        "$work"/gauge/*.c drivers/dirty.c drivers/panel*.c "$LIBPEL" \
        -Wl,--gc-sections -o "$work/gauge/gauge" && "$work/gauge/gauge" ||
    fail "gauge.c with the panel.h of a board"
nm -S "$work/gauge/gauge" | awk '$3 ~ /^[bBdD]$/ && length($2) == 16 {
        if ($2 > "0000000000001e00") { print "more than two bands: " $4; bad = 1 }
    } END { exit bad }' || fail "RAM of the gauge"

# PlatformIO
run platformio cmake -B b -D VERSION="$version"
run platformio cmake --build b
draws "$work/platformio/b"
g++ -fsyntax-only -Icore "$here/sketch.cpp" || fail "a sketch with core/pel.h"

# Arduino: every source below src/ is compiled, which is where headers are found
mkdir "$work/arduino"
for file in $(cd "$arduino/src" && find . -name '*.c'); do
    $CC -std=gnu11 -Os -ffunction-sections -fdata-sections -I"$arduino/src" \
        -c "$arduino/src/$file" -o "$work/arduino/$(basename "$file" .c).o" ||
        fail "Arduino: $file"
done
g++ -std=gnu++11 -Wall -Wextra -Werror -I"$arduino/src" \
    -I"$arduino/examples/board" "$here/arduino.cpp" "$work"/arduino/*.o \
    -Wl,--gc-sections -o "$work/sketch" &&
    "$work/sketch" >"$work/sketch.txt" &&
    $CC $INCLUDE examples/board.c "$LIBPEL" -o "$work/board" &&
    "$work/board" | diff - "$work/sketch.txt" || fail "board.ino"
: >"$work/SPI.h"
g++ -std=gnu++11 -Wall -Wextra -Werror -I"$arduino/src" -I"$work" \
    -I"$arduino/examples/panel" "$here/arduino_panel.cpp" "$work"/arduino/*.o \
    -Wl,--gc-sections -o "$work/panel_sketch" && "$work/panel_sketch" || fail "panel.ino"

# where stack is short: with -Os alone
is_short() {
    printf '#if !PEL_SHORT_STACK\n#error\n#endif\n' | i686-linux-gnu-gcc "$@" \
        -include core/pel_config.h -fsyntax-only -x c - 2>/dev/null
}
is_short -Os && is_short -O2 -DPEL_SHORT_STACK=1 || fail "PEL_SHORT_STACK is not 1"
for options in -O2 "-Os -DARDUINO=10819" "-Os -DESP_PLATFORM" \
    "-Os -DPEL_SMALL_CODE=1" "-Os -DPEL_SHORT_STACK=0"; do
    ! is_short $options || fail "PEL_SHORT_STACK is 1 with $options"
done

# an int of 16 bits is told, not compiled
$CC -U__INT_MAX__ -D__INT_MAX__=32767 $INCLUDE -fsyntax-only "$here/main.c" 2>&1 |
    grep -q 'error.*int of 32 bits' || fail "an int of 16 bits is not refused"

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
for part in HIT IMAGE OUTLINE PATH SMOOTH SCENE PAINT; do
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

# what the schemas of the others require
for key in name author maintainer sentence paragraph category architectures; do
    grep -q "^$key=." "$arduino/library.properties" ||
        fail "library.properties: no $key"
done
grep -E 'example\.(com|org)|=\*$|[=,]avr' "$arduino/library.properties" &&
    fail "library.properties: see above"
grep -qx "version=$version" "$arduino/library.properties" ||
    fail "version of library.properties"
grep -qx "version: \"$version\"" idf_component.yml ||
    fail "version of idf_component.yml"
grep -qx 'name: pel' zephyr/module.yml || fail "zephyr/module.yml"
