#!/bin/sh
# pel run and pel compare: what scripts draw, in bands and in every format; what
# is refused, and how. PEL names the program; scripts lie in sim/scenes.
set -u
. "$(dirname "$0")/lib.sh"
scenes=$(dirname "$0")/../../sim/scenes
checks=0

# status WANTED COMMAND...: runs the command, output to $work/out and err.
status() {
    wanted=$1
    shift
    checks=$((checks + 1))
    "$@" >"$work/out" 2>"$work/err" </dev/null
    got=$?
    [ "$got" = "$wanted" ] || fail "status $got, not $wanted: $*"
}

# said FILE TEXT: is the text in the file?
said() {
    grep -qF -e "$2" "$work/$1" || fail "no '$2' in: $(cat "$work/$1")"
}

# refused LINE TEXT: the script on standard input is refused at that line, with
# that text, with status 2 and no output.
refused() {
    cat >"$work/s.pel"
    rm -f "$work/o.ppm"
    status 2 "$PEL" run "$work/s.pel" -o "$work/o.ppm"
    said err "pel: $work/s.pel:$1: "
    said err "$2"
    [ "$(grep -cv '^    ' "$work/err")" = 1 ] || fail "more than one: $2"
    [ ! -e "$work/o.ppm" ] || fail "output in spite of: $2"
}

formats='rgb565_le rgb565_be bgr565_le xrgb1555_le rgb888 bgr888 xrgb8888
xbgr8888 rgbx8888 bgrx8888 rgb332 gray8 gray4 gray2 mono1 mono1_pages inks2'

# Every scene and format: bands change no byte, or are refused.
for scene in "$scenes"/*.pel; do
    if grep -q '^scroll ' "$scene"; then
        status 2 "$PEL" run "$scene" --bands 8
        said err "scroll: a band of 8 rows has no pixels of the others: expected --bands 0"
        continue
    fi
    for format in $formats; do
        status 0 "$PEL" run "$scene" --format "$format" --bands 0 \
            -o "$work/whole.ppm"
        for rows in 8 56; do
            status 0 "$PEL" run "$scene" --format "$format" --bands $rows \
                -o "$work/bands.ppm"
            cmp "$work/whole.ppm" "$work/bands.ppm" ||
                fail "$scene, $format, bands of $rows"
        done
    done
    status 0 "$PEL" run "$scene" -o "$work/whole.ppm"
    for rows in 1 7 5000; do
        status 0 "$PEL" run "$scene" --bands $rows -o "$work/bands.ppm"
        cmp "$work/whole.ppm" "$work/bands.ppm" || fail "$scene, bands of $rows"
    done
done

# Opaque pictures: the formats with 8 bits a channel agree.
for format in bgr888 xrgb8888 xbgr8888 rgbx8888 bgrx8888; do
    status 0 "$PEL" run "$scenes/polygons.pel" --format rgb888 -o "$work/a.ppm"
    status 0 "$PEL" run "$scenes/polygons.pel" --format $format -o "$work/b.ppm"
    cmp "$work/a.ppm" "$work/b.ppm" || fail "rgb888 and $format differ"
done

# A picture as the script says, pixel for pixel; # as comment and as colour.
cat >"$work/s.pel" <<'END'
# a caption
canvas 4 3 rgb888 # comment
clear #0000ff     # blue
	paint flat #ff000080 #not a colour but a comment
rect 0 0 2 1 #ff0000
paint flat #00ff00ff
triangle 2 0 4 0 4 2
clip 0 2 1 1
clear #FFFFFF
option collinear line
line 0.25 2.75 3.99 2 # clipped to one pixel
END
printf 'P3 4 3 255
128 0 127  128 0 127  0 255 0  0 255 0
0 0 255  0 0 255  0 0 255  0 255 0
0 255 0  0 0 255  0 0 255  0 0 255' >"$work/want.ppm"
status 0 "$PEL" run "$work/s.pel" -o "$work/o.ppm"
status 0 "$PEL" compare "$work/o.ppm" "$work/want.ppm"
"$PEL" run - <"$work/s.pel" | cmp - "$work/o.ppm" || fail "run - to a pipe"
sed 's/$/\r/' "$work/s.pel" | "$PEL" run - -o - | cmp - "$work/o.ppm" ||
    fail "lines that end in CR LF"
{ printf '\357\273\277'; cat "$work/s.pel"; } | "$PEL" run - |
    cmp - "$work/o.ppm" || fail "a byte order mark"

# Collinear triangles: nothing, or a line.
printf 'canvas 8 8 gray8\ntriangle 1 1 6 6 3 3\n' >"$work/s.pel"
status 0 "$PEL" run "$work/s.pel" -o "$work/nothing.ppm"
printf 'canvas 8 8 gray8\noption collinear line\ntriangle 1 1 6 6 3 3\n' \
    >"$work/s.pel"
status 0 "$PEL" run "$work/s.pel" -o "$work/line.ppm"
status 1 "$PEL" compare "$work/nothing.ppm" "$work/line.ppm"
said out '6 of 64 pixels differ, worst by 255 of 255, first at (1, 1): '
said out '#000000, #ffffff'

# What scripts may not say.
refused 1 'no canvas: a script begins with canvas' <<'END'
# nothing
END
refused 1 'clear before the canvas' <<'END'
clear #000000
END
refused 2 'a second canvas' <<'END'
canvas 8 8 rgb888
canvas 8 8 rgb888
END
refused 1 'canvas: rgb565: expected rgb565_le, rgb565_be' <<'END'
canvas 8 8 rgb565
END
refused 1 'canvas: 0: expected a whole number in 1..32767' <<'END'
canvas 0 8 rgb888
END
refused 1 'canvas: 32768: expected a whole number in 1..32767' <<'END'
canvas 8 32768 rgb888
END
refused 1 'canvas: 32767 x 32767 pixels are too many' <<'END'
canvas 32767 32767 mono1
END
refused 1 'canvas: 2 values: expected 3: canvas WIDTH HEIGHT FORMAT' <<'END'
canvas 8 8
END
printf 'canvas 8 8 xrgb8888\n\033[31m\n' >"$work/esc.pel"
"$PEL" run "$work/esc.pel" -o "$work/o.ppm" 2>"$work/err"
grep -q 'unknown command ?\[31m: expected' "$work/err" ||
    fail "an escape: $(cat "$work/err")"
refused 3 'unknown command trinagle: expected canvas' <<'END'
canvas 8 8 rgb888

trinagle 0 0 1 1 2 2
END
refused 2 'unknown command paint plaid: expected' <<'END'
canvas 8 8 rgb888
paint plaid #000000
END
refused 2 'unknown command polygon: expected polygon evenodd, polygon nonzero' <<'END'
canvas 8 8 rgb888
polygon
END
refused 2 'triangle: 5 values: expected 6' <<'END'
canvas 8 8 rgb888
triangle 0 0 1 1 2
END
refused 2 'triangle: 7 values: expected 6' <<'END'
canvas 8 8 rgb888
triangle 0 0 1 1 2 2 3
END
refused 2 'polygon nonzero: 7 values: expected 6 or more, in pairs' <<'END'
canvas 8 8 rgb888
polygon nonzero 0 0 1 1 2 2 3
END
refused 2 'triangle: 1e3: expected pixels in -32768..32767.998, such as' <<'END'
canvas 8 8 rgb888
triangle 0 0 1e3 1 2 2
END
refused 2 'triangle: 32768: expected pixels in -32768..32767.998' <<'END'
canvas 8 8 rgb888
triangle 0 0 32768 1 2 2
END
refused 2 'triangle: -32768.01: expected pixels in' <<'END'
canvas 8 8 rgb888
triangle 0 0 -32768.01 1 2 2
END
refused 2 'circle: -1: expected pixels in 0..32767' <<'END'
canvas 8 8 rgb888
circle 4 4 -1
END
refused 2 'rect: expected a right and a bottom side below 32768' <<'END'
canvas 8 8 rgb888
rect 30000 0 2768 1
END
refused 2 'clip: 1.5: expected a whole number' <<'END'
canvas 8 8 rgb888
clip 0 0 1.5 1
END
refused 2 'clear: #12345: expected a colour, #rrggbb or #rrggbbaa' <<'END'
canvas 8 8 rgb888
clear #12345
END
refused 2 'clear: red: expected a colour' <<'END'
canvas 8 8 rgb888
clear red
END
refused 3 'circle: paint vertex colours triangles' <<'END'
canvas 8 8 rgb888
paint vertex #000000 #000000 #000000
circle 4 4 1
END
refused 2 'bands 12: expected a multiple of 8 for mono1_pages' <<'END'
canvas 8 8 mono1_pages
bands 12
END
printf 'canvas 8 8 rgb888\nclear #0000\00000\n' >"$work/zero"
refused 2 'a zero byte' <"$work/zero"
status 2 "$PEL" run "$work/s.pel" --bands 4 --format mono1_pages
status 2 "$PEL" run "$work/none.pel"
said err "pel: $work/none.pel: cannot be read: No such file"
status 2 "$PEL" run "$work"
printf 'triangle\n' | "$PEL" run - 2>"$work/err" >"$work/out" &&
    fail "standard input was taken"
said err 'pel: (standard input):1: triangle before the canvas'

# The ends of the range are legal.
cat >"$work/s.pel" <<'END'
canvas 32 32 rgb888
triangle -32768 -32768 32767.998 -32768 32767.99609375 32767.99609375
circle 32767.99 -32768 32767
rect -32768 -32768 32767 32767
line -32768 32767.99 32767.99 -32768
polygon evenodd -32768 -32768 32767.99 0 -32768 32767.99
clip -32768 -32768 32767 32767
END
status 0 "$PEL" run "$work/s.pel" -o "$work/o.ppm"

# Wrong arguments.
printf 'canvas 8 8 rgb888\n' >"$work/s.pel"
status 2 "$PEL"
status 2 "$PEL" paint
said err 'pel: unknown command paint: expected run, '
status 2 "$PEL" run
said err 'pel: 0 arguments: expected SCRIPT'
status 2 "$PEL" run "$work/s.pel" "$work/s.pel"
said err 'pel: 2 arguments: expected SCRIPT'
status 2 "$PEL" run "$work/s.pel" --bands x
said err "pel: --bands is 'x': expected a whole number from 0 to 32767"
status 2 "$PEL" run "$work/s.pel" --format rgb
said err "pel: --format is 'rgb': expected rgb565_le, "
status 2 "$PEL" run "$work/s.pel" --fast
said err "pel: unrecognized option '--fast'"
said err "Try \`pel run --help'"
status 2 "$PEL" run "$work/s.pel" -o "$work/o.jpg"
said err 'expected a name that ends in .ppm, .bmp or .png'
status 2 "$PEL" run "$work/s.pel" -o "$work/none/o.ppm"
said err "pel: $work/none/o.ppm: cannot be written: No such file"
"$PEL" run "$work/s.pel" >/dev/full 2>"$work/err" && fail "no space: status 0"
said err 'pel: standard output cannot be written: No space left on device'
status 0 "$PEL" --help
status 0 "$PEL" run --help
said out 'Usage: pel run'
for command in run render view compare import info explain demo console input; do
    "$PEL" $command --help | grep -B 1 '^  *$' && fail "$command --help: a line of spaces"
done

# Compare.
printf 'P3 2 2 255  0 0 0  10 10 10  20 20 20  30 30 30' >"$work/a.ppm"
printf 'P3 2 2 255  0 0 0  10 12 10  20 20 15  30 30 30' >"$work/b.ppm"
printf 'P3 2 1 255  0 0 0  10 10 10' >"$work/c.ppm"
status 0 "$PEL" compare "$work/a.ppm" "$work/a.ppm"
[ ! -s "$work/out" ] || fail "equal pictures, but it said $(cat "$work/out")"
status 1 "$PEL" compare "$work/a.ppm" "$work/b.ppm"
said out '2 of 4 pixels differ, worst by 5 of 255, first at (1, 0): '
said out '#0a0a0a, #0a0c0a'
status 1 "$PEL" compare "$work/a.ppm" "$work/b.ppm" --tolerance 2
said out '1 of 4 pixels differ, worst by 5 of 255, first at (0, 1)'
status 0 "$PEL" compare "$work/a.ppm" "$work/b.ppm" --tolerance 5
status 1 "$PEL" compare "$work/a.ppm" "$work/c.ppm" --diff "$work/d.ppm"
said out "a.ppm has 2 x 2 pixels, $work/c.ppm has 2 x 1"
printf 'P3 2 2 255  0 0 0  3 3 3  0 0 255  0 0 255' >"$work/e.ppm"
status 0 "$PEL" compare "$work/d.ppm" "$work/e.ppm"
status 1 "$PEL" compare "$work/a.ppm" "$work/b.ppm" --diff "$work/d.ppm"
printf 'P3 2 2 255  0 0 0  128 0 0  130 0 0  10 10 10' >"$work/e.ppm"
status 0 "$PEL" compare "$work/d.ppm" "$work/e.ppm"
# shellcheck disable=SC2094
"$PEL" compare - "$work/a.ppm" <"$work/a.ppm" || fail "compare - A"
cp "$work/a.ppm" "$work/a" # without an ending: PPM
status 0 "$PEL" compare "$work/a" "$work/a.ppm"
printf 'canvas 9 5 rgb888\nclear #123456\nrect 1 2 3 2 #fedcba\n' >"$work/s.pel"
for ending in ppm bmp png; do
    "$PEL" run "$work/s.pel" -o "$work/kind.$ending" 2>/dev/null || continue
    status 0 "$PEL" compare "$work/kind.ppm" "$work/kind.$ending"
done
status 2 "$PEL" compare "$work/kind.ppm" "$work/none.png"
status 2 "$PEL" compare - -
status 2 "$PEL" compare "$work/a.ppm"
status 2 "$PEL" compare "$work/a.ppm" "$work/b.ppm" "$work/c.ppm"
status 2 "$PEL" compare "$work/a.ppm" "$work/none.ppm"
said err "pel: $work/none.ppm: cannot be read"
status 2 "$PEL" compare "$work/a.ppm" "$work/b.ppm" --tolerance 256
status 2 "$PEL" compare "$work/a.ppm" "$work/b.ppm" --diff "$work/d.gif"

# A header that promises 800 MB costs no memory.
printf 'P6 32767 8192 255\nabc' >"$work/b.ppm"
checks=$((checks + 1))
# dash, bash, busybox and ksh have it.
# shellcheck disable=SC3045
(ulimit -v 400000 && exec "$PEL" compare "$work/b.ppm" "$work/a.ppm") \
    2>"$work/err"
[ $? = 2 ] || fail "a short file was taken"
said err "b.ppm: byte 21: ends in row 1 of 8192"

[ -e "$work/failed" ] || echo "test_script_run.sh: $checks checks passed"
