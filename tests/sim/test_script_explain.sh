#!/bin/sh
# pel explain: the commands that touch a pixel, and the reasons. What the last
# one leaves is what pel run draws.
set -u
. "$(dirname "$0")/lib.sh"

explains() { # X Y TEXT...
    "$PEL" explain --all "$work/s.pel" "$1" "$2" >"$work/out" 2>"$work/err" ||
        fail "$1 $2: $(cat "$work/err")"
    at="$1 $2"
    shift 2
    for text; do
        grep -qF -- "$text" "$work/out" || fail "$at: no '$text' in: $(cat "$work/out")"
    done
}

cat >"$work/s.pel" <<'END'
canvas 16 16 rgb565_le
clear #102030
paint flat #ff000080
triangle 2.5 2.5 12.5 2.5 2.5 12.5
clip 0 0 8 16
paint flat #00ff00
circle 8.5 8.5 3
rect 1 1 2 2
paint linear 0 0 #000000 16 0 #ffffff
polygon evenodd 10 10 14 10 14 14 10 14
clip 0 0 16 16
ring 8.5 8.5 2 4
sector 8.5 8.5 4 0 0.25
arc 8.5 8.5 2 4 0.5 0.75
ellipse 8 8 4 2
thickline 0 4 16 4 2
line 0 0 15 15
outline ellipse 8 8 4 2
outline arc 8.5 8.5 4 0.25 0.5
END
explains 2 2 'line 4: triangle: paint flat (line 3), #ff0000 alpha 128 over' \
    'edge 0-1: the centre lies on it, a top one: inside' \
    'edge 2-0: the centre lies on it, a left one: inside' \
    'line 8: rect: paint flat (line 6), #00ff00 over' 'pixel value 0x07e0'
explains 7 7 'edge 1-2: the centre lies on it, a right one: outside' \
    'line 7: circle: paint flat (line 6)' 'of the radius 589824'
explains 9 8 'line 7: circle: outside of the clip of line 5'
explains 5 8 'px2: 589824, of the radius 589824'
explains 12 12 'line 10: polygon evenodd: outside of the clip' \
    'through it: 0 down, 1 up: winding -1, odd'
explains 10 10 'line 12: ring: paint linear' \
    'px2: 524288, of the radius 262144 and 1048576' \
    'line 13: sector: paint' 'at 0.125000 turns, of 0.000000 up to, not including, 0.250000' \
    'line 14: arc: not covered' 'of 0.500000 up to, not including, 0.750000' \
    'line 15: ellipse: not covered' '0.390625 + 1.562500 = 1.953125, inside up to 1' \
    'line 17: line: paint' 'from pixel 0 0 to 15 15' \
    'line 18: outline ellipse: not covered' 'pixels with one outside' \
    'line 19: outline arc: not covered' 'of 0.250000 up to, not including, 0.500000'
explains 8 4 'line 16: thickline: paint' 'winding 1, odd'
explains 15 0 'line 2: clear: #102030 over #000000 gives #102031'

cat >"$work/s.pel" <<'END'
canvas 16 16 xrgb8888
option smooth on
paint flat #ff0000
rect 1.25 1 2 2
ellipse 12 12 2.5 1.5
option smooth off
rect 5.25 1 2 2
END
explains 1 1 'line 4: rect: paint flat (line 3), #ff0000 alpha 191 over #000000 gives #bf0000' \
    'covers 191 / 255 of the pixel'
explains 3 2 'covers 64 / 255 of the pixel'
explains 2 3 'line 4: rect: not covered' 'covers 0 / 255 of the pixel'
explains 12 10 'line 5: ellipse: paint flat (line 3), #ff0000 alpha 117 over' \
    'covers 117 / 255 of the pixel'
explains 5 1 'line 7: rect: paint flat (line 3), #ff0000 over'

cat >"$work/s.pel" <<'END'
canvas 16 16 xrgb8888
clear #102030
option blend xor
paint flat #ff000080
rect 1 1 4 4
END
explains 2 2 'line 5: rect: paint flat (line 4), blended, #ef2030 alpha 128 over #102030 gives #802030'
explains 6 2 'line 5: rect: not covered'

# After every script of the gallery: the same pixel as in the picture.
for scene in sim/scenes/*.pel; do
    "$PEL" run "$scene" --format xrgb8888 -o "$work/o.ppm" || fail "$scene"
    size=$(sed -n '2p;2q' "$work/o.ppm")
    width=${size% *} height=${size#* }
    head=$(printf 'P6\n%s\n255\n' "$size" | wc -c)
    for part in 17 41 63 88; do
        x=$((width * part / 100)) y=$((height * (101 - part) / 100))
        want=$(tail -c +$((head + 1 + 3 * (y * width + x))) "$work/o.ppm" |
            head -c 3 | od -An -tx1 | tr -d ' ')
        got=$("$PEL" explain --format xrgb8888 "$scene" $x $y |
            sed -n 's/.* gives #\([0-9a-f]*\),.*/\1/p' | tail -n 1)
        [ "${got:-000000}" = "$want" ] || fail "$scene $x $y: $got, not $want"
    done
done

refused_command "X is '16': expected a pixel in 0..15" explain "$work/s.pel" 16 0
refused_command "Y is '-1': expected a pixel in 0..15" explain "$work/s.pel" -- 0 -1
refused_command '2 arguments: expected SCRIPT X Y' explain "$work/s.pel" 1
refused_command 'cannot be read' explain "$work/none.pel" 1 1
