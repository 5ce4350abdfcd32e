#!/bin/sh
# What pel import does to pictures: size, key, palettes, dither; and the table of
# bytes that it prints.
set -u
. "$(dirname "$0")/lib.sh"

# bytes FILE OPTIONS...: of the pixels, a number a line.
bytes() {
    "$PEL" import "$@" --name a -o - 2>"$work/err" |
        awk '/pixels = \{\{/ { p = 1; next } /^\}/ { p = 0 } p' | tr -d ' \n' |
        tr ',' '\n'
}
equal() { # WHAT WANTED: standard input on one line
    got=$(tr '\n' ' ')
    [ "$got" = "$2 " ] || fail "$1: $got, not $2; $(cat "$work/err")"
}
colors() { # FILE OPTIONS...: of the palette, as aarrggbb
    "$PEL" import "$@" --name a -o - 2>"$work/err" |
        awk '/a_colors\[/ { p = 1; next } /^\}/ { p = 0 } p' | tr -d ' \n' |
        tr ',' '\n' | awk '{ printf "%08x\n", $1 }'
}

# A board of single pixels has no pattern in a smaller size; of one colour, or in
# its own size, a picture stays; a gradient stays one.
awk 'BEGIN { print "P2 64 64 255"; for (y = 0; y < 64; y++)
    for (x = 0; x < 64; x++) print (x + y) % 2 * 255 }' >"$work/board.pgm"
for size in 15x15 7x31 16x16 1x1 31x9; do
    bytes "$work/board.pgm" --format gray8 --resize $size >"$work/b"
    [ "$(wc -l <"$work/b")" = $((${size%x*} * ${size#*x})) ] || fail "$size: size"
    awk '$1 < 125 || $1 > 129 { exit 1 }' "$work/b" || fail "$size: a pattern"
done
bytes "$work/board.pgm" --format gray8 >"$work/b"
bytes "$work/board.pgm" --format gray8 --resize 64x64 | cmp - "$work/b" ||
    fail "its own size changes a picture"
printf 'P3 2 2 255 9 80 255 9 80 255 9 80 255 9 80 255' >"$work/one.ppm"
for size in 1x1 5x3 100x1; do
    bytes "$work/one.ppm" --format rgb888 --resize $size | sort -n | uniq |
        equal "one colour, $size" "9 80 255"
done
printf 'P2 4 1 255 0 80 160 240' >"$work/ramp.pgm"
bytes "$work/ramp.pgm" --format gray8 --resize 8x1 >"$work/b"
sort -n "$work/b" | cmp -s - "$work/b" || fail "a gradient: $(cat "$work/b")"
printf 'P2 8 1 255 0 0 0 0 255 255 255 255' >"$work/edge.pgm"
bytes "$work/edge.pgm" --format gray8 --resize 2x1 |
    awk 'NR == 1 && $1 > 25 || NR == 2 && $1 < 230 { exit 1 }' || fail "an edge"

# Clear pixels: of a key, exactly; they have no part in colours.
printf 'P3 4 1 255 255 0 255  10 20 30  254 0 255  255 0 255' >"$work/key.ppm"
bytes "$work/key.ppm" --format argb8888 --key '#ff00ff' |
    equal key "0 0 0 0 30 20 10 255 255 0 254 255 0 0 0 0"
printf 'P3 4 1 255 255 0 255  0 255 0  0 255 0  255 0 255' >"$work/key.ppm"
bytes "$work/key.ppm" --format argb8888 --key '#ff00ff' --resize 2x1 |
    awk 'NR % 4 == 1 && $1 > 0 || NR % 4 == 2 && $1 < 255 ||
        NR % 4 == 3 && $1 > 0 { exit 1 }' || fail "a key in colours"
bytes "$work/key.ppm" --format rgb888 --key '#ff00ff' --background '#0000ff' |
    equal background "255 0 0 0 255 0 0 255 0 255 0 0"

# Alpha as an image of its own: nothing is blended.
printf 'P7\nWIDTH 4\nHEIGHT 1\nDEPTH 4\nMAXVAL 255\nENDHDR\n' >"$work/soft.pam"
printf '\377\0\0\377\0\377\0\200\0\0\377\100\377\377\377\0' >>"$work/soft.pam"
for row in "gray8 255 128 64 0" "gray4 248 64" "mono1 192"; do
    format=${row%% *}
    bytes "$work/soft.pam" --format rgb888 --alpha "$format" | equal "alpha $format" \
        "0 0 255 0 255 0 255 0 0 255 255 255 ${row#* }"
    [ ! -s "$work/err" ] || fail "alpha is blended: $(cat "$work/err")"
done
"$PEL" import "$work/soft.pam" --alpha gray4 --name soft -o "$work/soft.c" >"$work/out"
$CC -std=c99 $WARNINGS -I. $INCLUDE -c "$work/soft.c" -o "$work/soft.o" || fail "soft.c"
grep -qx 'extern const struct pel_image_asset soft_alpha;' "$work/soft.h" ||
    fail "soft.h: $(cat "$work/soft.h")"
grep -qxF '/* Its format: &pel_rgb565_le. */' "$work/soft.h" || fail "soft.h: no format"
grep -qx '         2  bytes in flash: 4 x 1 pixels' "$work/out" || fail "$(cat "$work/out")"

# Palettes: all colours where they fit; else some that stand for all.
awk 'BEGIN { print "P3 48 48 255"; for (y = 0; y < 48; y++) for (x = 0; x < 48; x++)
    print int(x / 3) * 17, int(y / 3) * 17, (int(x / 3) + int(y / 3)) % 4 * 85 }' \
    >"$work/icon.ppm"
awk 'BEGIN { print "P3 20 15 255"; for (i = 0; i < 300; i++)
    print i % 20 * 13, int(i / 20) * 18, (i * 7) % 256 }' >"$work/300.ppm"
refused_command "has more than 256 colours: expected a picture with fewer, --palette 256" \
    import "$work/300.ppm" --format palette8 -o "$work/x.c"
"$PEL" import "$work/300.ppm" --format palette8 --palette 256 -o "$work/x.c" \
    >"$work/out" || fail "300 colours are refused"
grep -qxF '/* Its format: &x_palette.format. */' "$work/x.h" || fail "x.h: no format"
shown() { # FILE NUMBER OPTIONS: mean and worst error of a channel, 0 to 255
    file=$1 n=$2
    shift 2
    colors "$file" --format palette8 --palette $n "$@" >"$work/p"
    bytes "$file" --format palette8 --palette $n "$@" >"$work/i"
    tail -n +2 "$file" | awk -v p="$work/p" -v i="$work/i" '
        function hex(s,  v, k) { v = 0
            for (k = 1; k <= 2; k++)
                v = 16 * v + index("0123456789abcdef", substr(s, k, 1)) - 1
            return v }
        BEGIN { while ((getline c < p) > 0) palette[n++] = c }
        { getline at < i; c = palette[at]
          for (k = 1; k <= 3; k++) { d = $k - hex(substr(c, 1 + 2 * k, 2))
              if (d < 0) d = -d
              sum += d; if (d > worst) worst = d } }
        END { printf "%.2f %d\n", sum / NR / 3, worst }'
}
below() { # WHAT MEAN WORST: of standard input
    read -r mean worst
    awk -v a="$mean" -v b="$2" -v c="$worst" -v d="$3" \
        'BEGIN { exit !(a <= b && c <= d) }' || fail "$1: $mean, $worst"
}
shown "$work/icon.ppm" 256 | below "256 colours of 256" 0 0
shown "$work/300.ppm" 256 | below "256 colours of 300" 1.5 20
shown "$work/300.ppm" 64 | below "64 colours of 300" 10 60
# More colours than are looked at one by one, and white, which stays.
awk 'BEGIN { print "P3 256 288 255"; for (y = 0; y < 288; y++) for (x = 0; x < 256; x++)
    print y < 256 ? x " " y " " (x * 7 + y * 13) % 256 : "255 255 255" }' >"$work/many.ppm"
shown "$work/many.ppm" 256 | below "256 colours of 65,537" 9 40
colors "$work/many.ppm" --format palette8 --palette 256 | grep -c ffffffff | equal white 1
colors "$work/300.ppm" --format palette4 --palette 5 | grep -vc 00000000 |
    equal "5 colours" 5
printf 'P3 3 1 255 255 0 255 10 20 30 10 20 30' >"$work/key.ppm"
colors "$work/key.ppm" --format palette4 --palette 2 --key '#ff00ff' | head -2 | sort |
    equal "a clear colour" "00000000 ff0a141e"

# The file's own order; also of colours that it does not use.
{
    printf 'BM\0\0\0\0\0\0\0\0\106\0\0\0\050\0\0\0\2\0\0\0\1\0\0\0\1\0\010\0'
    printf '\0\0\0\0\4\0\0\0\0\0\0\0\0\0\0\0\4\0\0\0\0\0\0\0'
    printf '\1\2\3\0\4\5\6\0\7\010\011\0\012\013\014\0\3\1\0\0'
} >"$work/own.bmp"
colors "$work/own.bmp" --format palette4 | head -3 |
    equal "without own" "ff0c0b0a ff060504 00000000"
colors "$work/own.bmp" --format palette4 --palette own | head -5 |
    equal own "ff030201 ff060504 ff090807 ff0c0b0a 00000000"
bytes "$work/own.bmp" --format palette8 --palette own | equal "own indices" "3 1"
refused_command "has no palette of its own: expected a PNG or BMP with one" \
    import "$work/300.ppm" --format palette8 --palette own -o "$work/x.c"

# Dither: the mean is that of the picture, of one bit and of five; levels stay.
for gray in 0 1 40 100 128 200 254 255; do
    awk -v g=$gray 'BEGIN { print "P2 64 64 255"; for (i = 0; i < 4096; i++) print g }' \
        >"$work/g.pgm"
    for way in ordered diffusion; do
        bytes "$work/g.pgm" --format mono1 --dither $way | awk -v g=$gray '
            { for (n = $1; n > 0; n = int(n / 2)) set += n % 2 }
            END { mean = set / 4096 * 255
                  exit !(mean - g <= 2.1 && g - mean <= 2.1) }' ||
            fail "$way of $gray in mono1"
        bytes "$work/g.pgm" --format gray4 --dither $way | awk -v g=$gray '
            { sum += int($1 / 16) * 17 + $1 % 16 * 17 }
            END { mean = sum / 4096
                  exit !(mean - g <= 0.4 && g - mean <= 0.4) }' ||
            fail "$way of $gray in gray4"
        bytes "$work/g.pgm" --format rgb565_le --dither $way | awk -v g=$gray '
            NR % 2 { low = $1; next }
            { v = low + 256 * $1; r = int(v / 2048); b = v % 32
              red += 8 * r + int(r / 4); blue += 8 * b + int(b / 4) }
            END { red /= 4096; blue /= 4096
                  exit !(red - g <= 0.4 && g - red <= 0.4 &&
                         blue - g <= 0.4 && g - blue <= 0.4) }' ||
            fail "$way of $gray in rgb565_le"
    done
done
awk 'BEGIN { print "P2 64 64 255"; for (i = 0; i < 4096; i++) print i % 64 * 4 }' \
    >"$work/ramp.pgm"
for way in ordered diffusion; do
    bytes "$work/ramp.pgm" --format palette8 --palette 2 --dither $way |
        awk '{ n += $1 != last; last = $1 } END { exit n < 400 }' ||
        fail "a palette of 2 is not dithered: $way"
done

# Inks: the four colours are theirs, others have the mean of what is dithered.
printf 'P3 4 1 255 255 255 255 0 0 0 255 0 0 255 255 0\n' >"$work/inks.ppm"
bytes "$work/inks.ppm" --format inks2 | equal inks 27
for color in '255 100 0' '90 90 90' '200 160 80' '255 30 0'; do
    awk -v c="$color" 'BEGIN { print "P3 64 64 255"
        for (i = 0; i < 4096; i++) print c }' >"$work/c.ppm"
    bytes "$work/c.ppm" --format inks2 --dither diffusion |
        awk -v c="$color" '
            { n = $1 + 0
              for (k = 0; k < 4; k++) { count[n % 4]++; n = int(n / 4) } }
            END { split(c, want, " ")
                  mean[1] = count[0] + count[2] + count[3]
                  mean[2] = count[0] + count[3]
                  mean[3] = count[0]
                  for (i = 1; i <= 3; i++) {
                      off = mean[i] / 4096 * 255 - want[i]
                      if (off > 3 || off < -3) exit 1
                  } }' || fail "$color in inks"
done

# What has no meaning is refused.
while read -r text options; do
    # shellcheck disable=SC2086
    refused_command "$(echo "$text" | tr _ ' ')" import "$work/one.ppm" $options \
        -o "$work/x.c"
done <<'END'
--palette_is_for_--format_palette4 --palette 5
--palette_is_'1':_expected --format palette4 --palette 1
--palette_is_'257':_expected --format palette8 --palette 257
--palette_is_'x':_expected --format palette8 --palette x
expected_16_at_most --format palette4 --palette 17
--alpha_is_for_formats_without --format argb8888 --alpha gray8
--alpha_is_for_formats_without --format palette8 --alpha mono1
--compress_is_not_for --format mono1_pages --compress
--compress_is_for_pictures_that_are_copied --compress --alpha gray8
--dither_has_no_use --format rgb888 --dither ordered
--dither_of_a_palette_needs_--palette --format palette8 --dither ordered
expected_none|ordered|diffusion --dither x
expected_WxH --resize 0x5
END
refused_command "is for pictures" import builtin:vase --resize 5x5 -o "$work/x.c"

# The table: what it takes, and what it would take.
"$PEL" import "$work/icon.ppm" -o "$work/x.c" >"$work/out" || fail "no table"
for line in "      4608  bytes in flash: 48 x 48 pixels" "            with --compress: 1120" \
    "            in others: rgb888 6912, xrgb8888 9216, rgb332 2304, gray4 1152, mono1 288, inks2 576, palette4 1216, palette8 3328"; do
    grep -qxF "$line" "$work/out" || fail "no '$line': $(cat "$work/out")"
done
# 16 rows that differ, of 16 runs of 4 bytes each, and where 48 rows begin.
"$PEL" import "$work/icon.ppm" --compress -o "$work/x.c" >"$work/out" || fail "no runs"
for line in "      1120  bytes in flash: 48 x 48 pixels, in runs" \
    "            without --compress: 4608"; do
    grep -qxF "$line" "$work/out" || fail "no '$line': $(cat "$work/out")"
done
"$PEL" import builtin:vase-small -o "$work/x.c" >"$work/out" || fail "no table"
vertices=$(sed -n 's/^.* \([0-9]*\) vertices, 220 triangles/\1/p' "$work/out")
awk -v n="$vertices" '/bytes in flash/ { all = $1; next } { sum += $1 }
    / positions/ { if ($1 != 6 * n) exit 1 } / indices/ { if ($1 != 1320) exit 1 }
    END { if (sum != all) exit 1 }' "$work/out" || fail "$(cat "$work/out")"
[ -z "$("$PEL" import builtin:vase-small -o - | grep 'in flash')" ] ||
    fail "a table in the asset"

[ -e "$work/failed" ] || echo "pictures are changed as the options say"
