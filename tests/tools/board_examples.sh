#!/bin/sh
# board_examples.sh BUILD WHOLE STEP : runs BUILD/board/BOARD/EXAMPLE for each line
# `BOARD/EXAMPLE EMULATOR` of the input. It must write what BUILD/examples/EXAMPLE
# does, but for the comments of pictures, in which the gauge counts its
# instructions: on an M0+ at most WHOLE for a frame and STEP for one degree.
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
    [ -f "$host.out" ] || "$host" >"$host.out"
    icount=
    case $name in m0plus/*) icount="-icount shift=6,sleep=off" ;; esac
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
LC_ALL=C sed -n '1,6s/^# //p' "$build/board/m0plus/gauge.out" |
    awk -v most_whole="$2" -v most_step="$3" '{ print }
    /^whole/ { whole = $4 } /^step/ { step = $4 }
    END { exit !(whole && whole <= most_whole && step && step <= most_step) }' ||
    status=1
exit $status
