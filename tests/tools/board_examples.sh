#!/bin/sh
# board_examples.sh BUILD : runs BUILD/board/BOARD/EXAMPLE for each line
# `BOARD/EXAMPLE EMULATOR` of the input. It must write what BUILD/examples/EXAMPLE
# does, but for the comments of pictures, in which it counts its instructions.
set -u
build=$1
status=0

# Without the comments of a PPM.
plain() {
    LC_ALL=C sed '1,6{/^# /d}' "$1"
}

while read -r name emulator; do
    out=$build/board/$name.out
    host=$build/examples/${name#*/}
    [ "$host.out" -nt "$host" ] || "$host" >"$host.out"
    icount=
    case $name in m0plus/* | m4/*) icount="-icount shift=6,sleep=off" ;; esac
    if timeout 60 $emulator "$build/board/$name" $icount >"$out" \
        2>"$out.messages" </dev/null && plain "$out" >"$out.plain" &&
        plain "$host.out" | cmp -s - "$out.plain"; then
        echo "equal      $name"
    else
        echo "DIFFERENT  $name"
        cat "$out.messages"
        status=1
    fi
done
exit $status
