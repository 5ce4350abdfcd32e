#!/bin/sh
# pel view in a window of an X server that shows nothing, driven as a user does:
# keys, clicks and sizes do what the help says. What was recorded, drawn once
# more without a window, has every picture that was written.
set -u
. "$(dirname "$0")/lib.sh"
. "$(dirname "$0")/window.sh"

found() {
    window=$(xdotool search --onlyvisible --pid $program --name 'pel view')
    [ -n "$window" ]
}
start() { # ARGUMENT...
    (cd "$work" && exec "$PEL" view "$@" 2>err) &
    program=$!
    until_true found
    xdotool windowfocus --sync "$window"
}

# What was done is in the record as soon as the view has heard of it.
recorded() { # PATTERN
    until_true grep -q "$1" "$work/record"
}

written=0
picture() { # what follows a key w
    xdotool key --window "$window" w
    written=$((written + 1))
    until_true grep -q "written: view-0*$written\\." "$work/err"
}

# The program is gone before the key is up, which the server would remember.
quit() {
    xdotool key --window "$window" q 2>/dev/null
    xdotool keyup q
}

start figures --size 320x240 --record record
xdotool mousemove --window "$window" 160 120
recorded ' point 0 up 160 120$'
picture
xdotool click 1
recorded ' button 1 up '
picture
xdotool key --window "$window" space 2 minus minus
picture
xdotool key --window "$window" Tab 4
picture
xdotool windowsize "$window" 250 200
recorded ' size 250 200$'
xdotool key --window "$window" F3 o
picture
xdotool key --window "$window" o x x m d
picture
xdotool key --window "$window" m d x x F2 Return b
picture
xdotool key --window "$window" b h
picture
xdotool key --window "$window" h 0 Left
xdotool click 4 click 4 click 5 click 5 click 5
picture
quit
wait $program || fail "status $? after q: $(tail -n 5 "$work/err")"
last=$(tail -n 1 "$work/record" | cut -d ' ' -f 1)
"$PEL" view figures --size 320x240 --headless --frames $((last + 1)) \
    -o "$work/frames" --replay "$work/record" || fail "no replay"
for i in $(seq $written); do
    picture=$(ls "$work/view-$(printf %03d "$i")".*)
    "$PEL" compare "$work/frames/view-$(printf %03d "$i").ppm" "$picture" ||
        fail "picture $i is another one in the replay"
    cksum <"$picture" >>"$work/sums"
done
[ "$(sort -u "$work/sums" | wc -l)" = $written ] || fail "two pictures are one"

# A mesh: a drag turns it, and so do keys.
start builtin:vase --size 320x240 --still
rm -f "$work"/view-* "$work/sums"
written=0
picture
xdotool mousemove --window "$window" 100 100 mousedown 1
xdotool mousemove_relative --sync 40 10 mouseup 1
picture
xdotool key --window "$window" Right Up plus
picture
quit
wait $program || fail "status $? after q: $(tail -n 5 "$work/err")"
for picture in "$work"/view-*; do
    cksum <"$picture" >>"$work/sums"
done
[ "$(sort -u "$work/sums" | wc -l)" = 3 ] || fail "a mesh does not turn"

# A script, whose shapes can be picked too.
rm "$work/record"
start "$(realpath sim/scenes/shapes.pel)" --size 480x320 --record record
xdotool mousemove --window "$window" 70 30
written=0
rm -f "$work"/view-00*
picture
xdotool click 1
recorded ' button 1 up '
picture
"$PEL" run sim/scenes/shapes.pel -o "$work/plain.ppm"
"$PEL" compare "$work/plain.ppm" "$(ls "$work"/view-002.*)" >/dev/null &&
    fail "nothing was picked"
kill -TERM $program
wait $program

# What was done is in the record, however the program ends; a record that there
# was stays while there is nothing to write.
for signal in KILL HUP TERM; do
    echo old >"$work/record"
    start figures --size 320x240 --record record --still
    xdotool key --window "$window" Tab 4
    until_true grep -q 'key 52 down' "$work/record"
    kill -$signal $program
    wait $program
    grep -q '^[0-9]* size 320 240$' "$work/record" &&
        grep -q 'key 52 down' "$work/record" || fail "$signal loses the record"
done
echo old >"$work/record"
DISPLAY=:none "$PEL" view figures --record "$work/record" 2>/dev/null &&
    fail "a window without a screen"
[ "$(cat "$work/record")" = old ] || fail "the record is cut before it begins"
