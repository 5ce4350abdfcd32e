#!/bin/sh
# examples/scope.c on a chip that scrolls by itself: every frame is the one that
# moving the pixels of a frame makes.
set -u
. "$(dirname "$0")/lib.sh"
"$PEL" import sim/scenes/fixed_6x13.bdf --name sans_15 -o "$work/sans_15.c" \
    >"$work/out" || fail "no font"

# scope NAME OPTION... : what it shows in the end.
scope() {
    name=$1
    shift
    $CC -std=c99 -O1 $WARNINGS -I. $INCLUDE -I"$work" "$@" examples/scope.c \
        "$work/sans_15.c" "$LIBPEL" -lcmocka -o "$work/$name" ||
        fail "$name: not compiled"
    "$work/$name" >"$work/$name.out" || fail "$name: status $?"
    LC_ALL=C sed '1,6{/^# /d}' "$work/$name.out" >"$work/$name.ppm"
}
scope memory
scope chip '-DPANEL_HEADER="tests/sim/scope_panel.h"' drivers/panel*.c \
    tests/support/bus_log.c tests/support/panel_glass.c
cmp "$work/memory.ppm" "$work/chip.ppm" || fail "the chip shows another scope"
