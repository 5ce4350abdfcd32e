#!/bin/sh
# check.sh PROGRAM SCREEN : a program in the window of display_sdl.h, on an X
# server that shows nothing, driven as a user does: what is on the screen is what
# the panel was sent, pixel by pixel, and what it was painted by.
set -u
. "$(dirname "$0")/../sim/lib.sh"
program=$(realpath "$1") screen=$(realpath "$2")
. "$(dirname "$0")/../sim/window.sh"

found() {
    window=$(xdotool search --onlyvisible --pid $pid --name 'window test')
    [ -n "$window" ]
}
start() { # ARGUMENT...
    (cd "$work" && exec "$program" "$work" "$@" >out 2>err) &
    pid=$!
    until_true found
    xdotool windowfocus --sync "$window"
}
key() { xdotool key --window "$window" "$@"; }

# sees ZOOM [left top]: the panel, in the middle of the window
sees() {
    eval "$(xdotool getwindowgeometry --shell "$window")"
    "$screen" "$work/server/Xvfb_screen0" $((X + (WIDTH - 60 * $1) / 2)) \
        $((Y + (HEIGHT - 40 * $1) / 2)) 60 40 "$1" >"$work/seen.ppm"
}
shows() { # ZOOM PICTURE
    sees "$1" && "$PEL" compare "$work/seen.ppm" "$work/$2"
}
covered() { # ZOOM: something is over the picture
    ! shows "$1" picture.ppm
}

start
until_true shows 8 picture.ppm
key F4
until_true shows 8 heat.ppm
key F4
until_true shows 8 picture.ppm
key F5
until_true covered 8
sees 8
# the first band is brighter, the second as it was
rows() { tail -c 7200 "$1" | head -c $((180 * $3)) | tail -c $((180 * $2)) | cksum; }
[ "$(rows "$work/seen.ppm" 8 16)" = "$(rows "$work/picture.ppm" 8 16)" ] ||
    fail "band 2 has changed"
[ "$(rows "$work/seen.ppm" 8 8)" != "$(rows "$work/picture.ppm" 8 8)" ] ||
    fail "band 1 has not changed"
for k in F6 F7; do
    key F5
    until_true shows 8 picture.ppm
    key $k
    until_true covered 8
    key $k F5
done
key F5
until_true shows 8 picture.ppm
key F2 F2 F2
until_true shows 5 picture.ppm
xdotool windowsize "$window" 700 500
key F3
until_true shows 6 picture.ppm
key F8
until_true grep -q 'written: pel-001.ppm' "$work/err"
cmp "$work/pel-001.ppm" "$work/picture.ppm" || fail "F8 writes another picture"
grep -q "^1 " "$work/out" && fail "keys of the window reach the program"

# events, in pixels of the panel: (700 - 360) / 2 and (500 - 240) / 2 px beside it
heard() { until_true grep -qx "$1" "$work/out"; }
xdotool mousemove --window "$window" $((170 + 6 * 12 + 3)) $((130 + 6 * 7 + 1))
heard '4 0 0 12 7'
xdotool click 3
heard '2 1 3 12 7'
heard '2 0 3 12 7'
xdotool click 4
heard '6 0 0 0 1'
key a
heard '1 1 97 0 0'
heard '1 0 97 0 0'
key Left
heard '1 1 256 0 0'
xdotool mousemove --window "$window" 2 499
heard '4 0 0 0 39'
kill -TERM $pid
wait $pid && fail "a closed window is no error"
grep -qx 'ended -16' "$work/out" || fail "closed: $(tail -n 1 "$work/out")"

start touch
xdotool mousemove --window "$window" 81 83
xdotool mousedown 1
heard '5 1 0 10 10'
xdotool mousemove --window "$window" 90 83
heard '5 2 0 11 10'
xdotool mouseup 1
heard '5 0 0 11 10'
grep -q '^[24] ' "$work/out" && fail "a finger that is a mouse"
key q 2>/dev/null
xdotool keyup q
wait $pid || fail "q: $(cat "$work/out")"
grep -qx 'ended 0' "$work/out" || fail "q does not end it"

# nothing is waited for where there is no window
DISPLAY=:none timeout 10 "$program" "$work" >"$work/out"
[ $? = 1 ] || fail "a window without a screen"
grep -q 'no screen for a window' "$work/out" || fail "$(cat "$work/out")"
