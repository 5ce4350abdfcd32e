#!/bin/sh
# check_make.sh : goals of make together, a goal alone, and a tree in a folder
# whose name has a blank and an apostrophe.
set -u
cd "$(dirname "$0")/../.." || exit 1
. tests/sim/lib.sh
unset MAKEFLAGS MAKELEVEL
object=core/base/divide.o

# clean is done first, in whatever order the goals are named
for goals in "clean $work/b/$object" "$work/b/$object clean"; do
    make -s BUILD="$work/b" "$work/b/$object" &&
        : >"$work/b/stale" &&
        make -s -j4 BUILD="$work/b" $goals || fail "make $goals"
    [ -f "$work/b/$object" ] && [ ! -e "$work/b/stale" ] ||
        fail "make -j4 $goals: the object is gone, or what was there is not"
done

# what a command has half written does not pass for the whole
printf '#!/bin/sh\necho "static int half;"\nexit 1\n' >"$work/b/pel"
chmod +x "$work/b/pel"
make -s -o "$work/b/pel" BUILD="$work/b" BENCH_FONT=README.md \
    "$work/b/bench/fonts.h" >/dev/null 2>&1 && fail "README.md is a font"
[ ! -e "$work/b/bench/fonts.h" ] || fail "half of fonts.h is left"

# a goal alone makes what it needs
make -n BUILD="$work/none" check-linux 2>&1 </dev/null |
    grep -q 'rcs .*/libpel_linux\.a' ||
    fail "make check-linux does not make libpel_linux.a"

# the linker's warnings are seen: of names that are defined twice, too
grep -rnE --include=Makefile --include='*.mk' -e '-Wl,(--no-warn|-w\b)' \
    Makefile core drivers port sim bench packaging page tests &&
    fail "linker warnings are hidden, see above"

# and the program links with -flto, however the compiler parts it
odd="$work/it's a tree"
mkdir "$odd"
tar -c --exclude=./build --exclude=./.git . | tar -x -C "$odd"
make -s -C "$odd" -j2 BUILD=b CFLAGS='-O1 -flto=auto' all b/vendored/user_paint amalgamation ||
    fail "make in $odd"
