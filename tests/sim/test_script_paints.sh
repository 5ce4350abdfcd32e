#!/bin/sh
# Scripts with gradients, textures and dither: what is refused and with which
# words, pairs that must draw the same, and colours that are known.
set -u
. "$(dirname "$0")/lib.sh"

# draw SCRIPT OUT
draw() {
    { echo "canvas 32 32 xrgb8888"; printf '%b\n' "$1"; } >"$work/s.pel"
    "$PEL" run "$work/s.pel" -o "$2" || fail "refused: $1"
}

# same FIRST SECOND: two scripts draw the same; differ: not the same.
same() {
    draw "$1" "$work/1.ppm"
    draw "$2" "$work/2.ppm"
    cmp -s "$work/1.ppm" "$work/2.ppm" || fail "not the same: $1 / $2"
}
differ() {
    draw "$1" "$work/1.ppm"
    draw "$2" "$work/2.ppm"
    ! cmp -s "$work/1.ppm" "$work/2.ppm" || fail "the same: $1 / $2"
}

# pixel SCRIPT X Y RRGGBB: of a 32 x 32 picture, whose PPM header has 13 bytes.
pixel() {
    draw "$1" "$work/p.ppm"
    got=$(od -An -tx1 -j $((13 + 3 * (32 * $3 + $2))) -N 3 "$work/p.ppm" |
        tr -d ' ')
    [ "$got" = "$4" ] || fail "$1: pixel $2 $3 is $got, not $4"
}

all='rect 0 0 32 32'
halves='0 #ff0000 0.5 #ff0000 0.5 #0000ff 1 #0000ff'
enlarged='paint texture map t.ppm 0 0 0 0 32 0 2 0 0 32 0 2'
pixel "paint linear 8 0 #112233 24 0 #ffffff\n$all" 3 9 112233
pixel "paint linear 8 0 #112233 24 0 #ffffff\n$all" 30 9 ffffff
pixel "paint linear stops 0 0 32 0 $halves\n$all" 15 3 ff0000
pixel "paint linear stops 0 0 32 0 $halves\n$all" 16 3 0000ff
pixel "paint radial 16 16 10 0 #00ff00 1 #0000ff\n$all" 0 0 0000ff
pixel "paint conic 16 16 0.25 $halves\n$all" 3 16 ff0000
pixel "paint conic 16 16 0.25 $halves\n$all" 30 16 0000ff
pixel "paint wheel 16.5 16.5 0 255 255\n$all" 30 16 ff0000
pixel "paint wheel 16.5 16.5 0 255 255\n$all" 2 16 00ffff
pixel "paint linear 0 0 #00ff0000 32 0 #00ff0000\n$all" 5 5 000000

same "paint fan 0 0 #ff0000 32 0 #00ff00 32 32 #0000ff 0 32 #ffffff\n$all" \
    "paint fan 0 32 #ffffff 32 32 #0000ff 32 0 #00ff00 0 0 #ff0000\n$all"
same "paint radial 16 16 5 0 #ffffff 1 #000000\nrect 0 0 9 32\nrect 9 0 23 32" \
    "paint radial 16 16 5 0 #ffffff 1 #000000\n$all"
differ "paint radial 16 16 5 0 #ffffff 1 #000000\n$all" \
    "option spread repeat\npaint radial 16 16 5 0 #ffffff 1 #000000\n$all"
differ "option phase 0.5\npaint radial 16 16 5 0 #ffffff 1 #000000\n$all" \
    "paint radial 16 16 5 0 #ffffff 1 #000000\n$all"
differ "option cells 64\npaint radial 16 16 64 0 #000000 1 #ffffff\n$all" \
    "paint radial 16 16 64 0 #000000 1 #ffffff\n$all"
same "option dither on\npaint linear 0 0 #000000 32 0 #ffffff\n$all" \
    "paint linear 0 0 #000000 32 0 #ffffff\n$all"

pixel "paint checker 3 2 4 5 #ff0000 #0000ff\n$all" 3 2 ff0000
pixel "paint checker 3 2 4 5 #ff0000 #0000ff\n$all" 2 2 0000ff
pixel "paint checker 3 2 4 5 #ff0000 #0000ff\n$all" 2 1 ff0000
pixel "paint hatch 1 1 2 7 3 #ff0000 #0000ff\n$all" 4 1 ff0000
pixel "paint hatch 1 1 2 7 3 #ff0000 #0000ff\n$all" 4 4 0000ff
under='paint flat #102030\nrect 0 0 32 32\npaint flat #8090f0'
pixel "$under\noption blend xor\n$all" 5 5 90b0c0
pixel "$under\noption blend xor\n$all\n$all" 5 5 102030
pixel "$under\noption blend add\n$all" 5 5 90b0ff
pixel "$under\noption blend multiply\n$all" 5 5 08122d
pixel "$under\noption blend add\noption blend none\n$all" 5 5 8090f0
same "$under\noption dither on\noption blend add\n$all" \
    "$under\noption blend add\n$all"

printf 'P6 3 3 255\n\1\1\1\2\2\2\3\3\3\4\4\4\5\5\5\6\6\6\7\7\7\10\10\10\11\11\11' \
    >"$work/9.ppm"
slices='paint slices 9.ppm 1 1 1 1 4 5 20 10'
pixel "$slices\n$all" 4 5 010101
pixel "$slices\n$all" 23 5 030303
pixel "$slices\n$all" 22 6 050505
pixel "$slices\n$all" 23 14 090909
pixel "$slices\n$all" 24 14 000000
same "option wrap repeat\n$slices\n$all" "$slices\n$all"
differ "option wrap repeat\npaint slices 9.ppm 0 0 2 2 0 0 32 32\n$all" \
    "paint slices 9.ppm 0 0 2 2 0 0 32 32\n$all"

printf 'P6 2 2 255\n\377\0\0\0\377\0\0\0\377\377\377\377' >"$work/t.ppm"
pixel "paint texture t.ppm 4 5\n$all" 5 5 00ff00
pixel "paint texture t.ppm 4 5\n$all" 30 30 ffffff
pixel "option wrap repeat\npaint texture t.ppm 4 5\n$all" 6 5 ff0000
pixel "option wrap mirror\npaint texture t.ppm 4 5\n$all" 6 5 00ff00
pixel "$enlarged\n$all" 15 15 ff0000
pixel "$enlarged\n$all" 16 15 00ff00
differ "option filter bilinear\n$enlarged\n$all" \
    "$enlarged\n$all"

echo 'paint linear 3 4 #000000 3 4 #ffffff' |
    refused_script 2 'paint linear: expected two points that are not the same'
echo 'paint linear stops 3 4 9 4 0.5 #000000 0.4 #ffffff' |
    refused_script 2 'paint linear stops: expected stops in ascending order'
echo 'paint linear stops 3 4 9 4 0.5 #000000 1.1 #ffffff' |
    refused_script 2 'paint linear stops: 1.1: expected a position from 0 to 1'
echo 'paint radial 3 4 0.5 0 #000000 1 #ffffff' |
    refused_script 2 'paint radial: expected a radius of 1 or more'
echo 'paint radial 3 4 5 0 #000000' |
    refused_script 2 'paint radial: 5 values: expected 7 or more, in pairs'
echo 'paint fan 0 0 #ff0000 9 0 #00ff00' |
    refused_script 2 'paint fan: 6 values: expected 9 or more, in threes'
echo 'paint fan 0 0 #ff0000 9 0 #00ff00 9 9 #00ff00 1' |
    refused_script 2 'paint fan: 10 values: expected 9 or more, in threes'
echo 'paint fan 0 0 #ff0000 9 0 #00ff00 18 0 #00ff00' |
    refused_script 2 'paint fan: expected points that go around their middle once'
echo 'paint texture nothing.ppm 0 0' |
    refused_script 2 "paint texture: $work/nothing.ppm cannot be read (No such file"
echo 'P6 2' >"$work/bad.ppm"
echo 'paint texture bad.ppm 0 0' |
    refused_script 2 "$work/bad.ppm:2: ends before the height"
echo 'option spread more' | refused_script 2 'option spread: more: expected pad|repeat|reflect'
echo 'option cells 100' | refused_script 2 'option cells: 100: expected 2048|1024|512|256|128|64'
echo 'paint hatch 256 0 0 5 5 #000000 #000000' | refused_script 2 \
    'paint hatch: expected DX and DY in -255..255, and a width up to the period'
echo 'paint hatch 1 0 0 5 6 #000000 #000000' | refused_script 2 'paint hatch: expected'
echo "paint slices $work/9.ppm 1 1 1 1 32767 0 2 2" |
    refused_script 2 'paint slices: expected a box up to 32767'
echo 'option blend screen' |
    refused_script 2 'option blend: screen: expected none|xor|add|multiply'
echo 'option dither maybe' | refused_script 2 'option dither: maybe: expected off|on'
echo 'paint flat' | refused_script 2 'paint flat: 0 values: expected 1'

[ -e "$work/failed" ] || echo "paints in scripts: all right"
