#!/bin/sh
# Scripts with curved shapes, outlines, texts and pictures: what is refused and
# with which words, and that files are found beside the script. What is drawn is
# core's; that bands change nothing is tested with all scenes (test_script_run.sh).
set -u
. "$(dirname "$0")/lib.sh"

# same FIRST SECOND: two scripts after a canvas draw the same, and something.
same() {
    for i in 1 2; do
        { echo "canvas 48 32 xrgb8888"; printf '%b\n' "$1"; } >"$work/s.pel"
        "$PEL" run "$work/s.pel" -o "$work/$i.ppm" || fail "refused: $1"
        shift
    done
    cmp "$work/1.ppm" "$work/2.ppm" || fail "the pair before differs"
    echo "canvas 48 32 xrgb8888" | "$PEL" run - -o "$work/0.ppm"
    ! cmp -s "$work/0.ppm" "$work/1.ppm" || fail "nothing was drawn"
}

same 'circle 16 16 10' 'ring 16 16 4 10\ncircle 16 16 4'
same 'circle 16 16 10' 'sector 16 16 10 0.1 0.6\nsector 16 16 10 0.6 0.1'
same 'ring 16 16 5 9' 'arc 16 16 5 9 0 0.5\narc 16 16 5 9 0.5 1'
same 'ring 16 16 5 9' 'arc 16 16 5 9 0 1'
same 'circle 16 16 10' 'ellipse 16 16 10 10'
same 'rect 3 4 20 10' 'roundrect 3 4 20 10 0'
same 'rect 3 4 20 10' 'thickline 3 9 23 9 10'
same 'rect 3 4 20 10\npaint flat #000000\nrect 4 5 18 8' 'outline rect 3 4 20 10'
same 'outline circle 16 16 9' \
    'outline arc 16 16 9 0 0.25\noutline arc 16 16 9 0.25 0'
same 'outline triangle 2 3 30 6 9 28' \
    'outline polygon evenodd 2 3 30 6 9 28'

same 'stroke line 4 4 9 30 9' 'thickline 4 9 30 9 4'
same 'option cap square\nstroke line 4 6 9 28 9' 'thickline 4 9 30 9 4'
same 'option cap butt\nstroke line 4 4 9 16 9 30 9' 'rect 4 7 26 4'
same 'option cap round\nstroke line 8 9 9 9 9' 'circle 9 9 4'
same 'dash 4 4 0\nstroke line 4 4 9 16 9' 'rect 4 7 4 4\nrect 12 7 4 4'
same 'dash 4 4 6\ndash 0 0 0\nstroke line 4 4 9 16 9' 'rect 4 7 12 4'
same 'option join miter\nstroke loop 2 4 4 20 4 20 14 4 14' \
    'rect 3 3 18 12\npaint flat #000000\nrect 5 5 14 8'
same 'path evenodd 3 4 10 4 16 4 23 4 23 7 23 11 23 14 16 14 10 14 3 14 3 11 3 7 3 4' \
    'rect 3 4 20 10'
same 'stroke curve 4 4 9 10 9 20 9 30 9' 'rect 4 7 26 4'
same 'paint flat #ffffff80\nstroke line 4 4 9 30 9 4 9' \
    'paint flat #ffffff80\nstroke line 4 4 9 30 9'

echo 'stroke line 4 0 32766 9 9' |
    refused_script 2 'stroke line: expected points twice the width away'
echo 'stroke curve 4 1 2 3 4 5 6 7 8 9 10' |
    refused_script 2 'stroke curve: expected a point, and three more for each'
echo 'path nonzero 1 2 3 4 5 6 7 8 9 10' |
    refused_script 2 'path nonzero: expected a point, and three more for each'

# more sides in a row than there is room for, of curves that are nearly level
awk 'BEGIN {
    printf "canvas 40 40 rgb888\noption smooth on\npath nonzero -16000 10"
    for (i = 0; i < 2000; i++)
        printf " %d 10.9 %d 10.1 %d 10.5", a = i % 2 ? -16000 : 16000, a, a
    print ""
}' >"$work/s.pel"
"$PEL" run "$work/s.pel" -o "$work/o.ppm" 2>"$work/err" &&
    fail "drawn without room"
grep -q 's.pel:3: path nonzero: a row of pixels has more than 65536 sides' \
    "$work/err" || fail "no room: $(cat "$work/err")"
echo 'dash 0.5 0.25 0' | refused_script 2 'dash: expected a dash and a gap of 1'
echo 'option cap flat' | refused_script 2 'option cap: flat: expected butt'
echo 'sector 16 16 9 0.5 0.5' |
    refused_script 2 'sector: FROM and TO are the same angle: 0 1 is the whole'
echo 'arc 16 16 4 9 1 0' | refused_script 2 'arc: FROM and TO are the same angle'
echo 'sector 16 16 9 0 1.1' | refused_script 2 'sector: 1.1: expected a part of a turn'
echo 'sector 16 16 9 0' | refused_script 2 'sector: 4 values: expected 5'
echo 'ring 16 16 -1 9' | refused_script 2 'ring: -1: expected pixels in 0..32767'
echo 'thickline 0 32767 9 32767 4' |
    refused_script 2 'thickline: expected ends half the width away'
echo 'roundrect 30000 0 9000 5 2' | refused_script 2 'roundrect: expected a right and a'
echo 'outline star 1 2 3' |
    refused_script 2 'unknown command outline star: expected'
echo 'star 1 2 3' | refused_script 2 'unknown command star: expected'
grep -q ' star: expected canvas, clear, clip, bands, ' "$work/err" || fail "no list: star"
[ "$(tr -s ' ,' '\n\n' <"$work/err" | grep -c '^option$')" -eq 1 ] ||
    fail "a command twice: star"
awk 'length > 80 && NR > 1 { exit 1 }' "$work/err" || fail "a long list: star"
echo 'circel 1 2 3' | refused_script 2 'unknown command circel: expected canvas, clear'
echo 'outlin arc 1 2' |
    refused_script 2 'unknown command outlin: expected canvas'
printf 'paint vertex #ff0000 #00ff00 #0000ff\nring 16 16 4 9\n' |
    refused_script 3 'ring: paint vertex colours triangles'

mkdir "$work/a folder"
cat >"$work/a folder/f.bdf" <<'EOF'
STARTFONT 2.1
FONTBOUNDINGBOX 2 2 0 0
DWIDTH 3 0
CHARS 2
STARTCHAR x
ENCODING 120
BITMAP
C0
C0
ENDCHAR
STARTCHAR quote
ENCODING 34
BITMAP
80
00
ENDCHAR
ENDFONT
EOF
printf 'P3 2 2 255  255 0 0  0 0 0  0 0 0  0 255 0\n' >"$work/p.ppm"
same 'rect 4 5 2 2\nrect 7 5 2 2\nrect 4 7 2 2\nrect 10 5 1 1' \
    'font "a folder/f.bdf"\ntext 4 5 "xx\\"\\nx" # a comment'
dejavu=/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf
if "$PEL" import "$dejavu" --outline -o "$work/o.c" >/dev/null 2>"$work/err"; then
    # its l reaches from 193 to 377 units of 2,048, and is 1,556 high
    same 'rect 8.5078125 2.609375 1.4375 12.15625' \
        "font outline $dejavu\\ntext outline 7 14.765625 16 0 \"l\""
    same 'rect 2 7.1171875 12.15625 1.4375' \
        "font outline $dejavu\\ntext outline 14.15625 10.0625 16 0.75 \"l\""
    # each has an advance of 569
    same 'rect 11.4140625 2.609375 1.4375 12.15625\nrect 6.96875 2.609375 1.4375 12.15625' \
        "font outline $dejavu\\noption align center\\ntext outline 9.90625 14.765625 16 0 \"ll\""
    for format in xrgb8888 mono1_pages; do
        for rows in 0 56; do
            "$PEL" run sim/scenes/fonts/type.pel --bands $rows \
                --format $format -o "$work/$rows.ppm" || fail "type.pel"
        done
        cmp "$work/0.ppm" "$work/56.ppm" || fail "type.pel in bands, $format"
    done
else
    grep -q libfreetype-dev "$work/err" || fail "$dejavu: $(cat "$work/err")"
fi
same 'paint flat #ff0000\nrect 4 5 1 1\npaint flat #00ff00\nrect 5 6 1 1' \
    'image 4 5 p.ppm'
same 'clear #808080\npaint flat #ff0000\nrect 4 5 1 1\npaint flat #00ff00\nrect 5 6 1 1' \
    'clear #808080\nimage key 4 5 #000000 p.ppm'
same 'paint flat #ff000080\nrect 4 5 1 1\npaint flat #00ff0080\nrect 5 6 1 1' \
    'image alpha 4 5 128 p.ppm'

corner='paint flat #ff0000\nrect' black='paint flat #000000\nrect'
same "$corner 4 5 2 2\nrect 9 12 2 2" \
    "$corner 4 5 3 3\nclip 4 5 7 9\nscroll 0 0 32 32 5 7\n$black 6 5 1 3\n\
$black 4 7 3 1"
same "$corner 4 5 3 3\nrect 9 12 3 3" "$corner 4 5 3 3\nscroll 4 5 8 10 5 7"
same "$corner 4 5 4 3\nrect 1 5 1 1" "$corner 4 5 4 3\nscroll 1 3 4 3 -3 0"
same "$corner 4 5 3 3\nrect 9 12 3 3" \
    "bands 5\n$corner 4 5 3 3\nbands 0\nscroll 4 5 8 10 5 7"
echo 'scroll 1 2 3 4 5' |
    refused_script 2 'scroll: 5 values: expected 6: scroll X Y WIDTH HEIGHT DX DY'
echo 'scroll 1 2 -3 4 5 6' |
    refused_script 2 'scroll: -3: expected a whole number in 0..32767'
echo 'scroll 1 2 3 4 5 0.5' |
    refused_script 2 'scroll: 0.5: expected a whole number in -32768..32767'
printf 'bands 8\nscroll 1 2 3 4 5 6\n' |
    refused_script 3 'scroll: a band of 8 rows has no pixels of the others: expected bands 0'
"$PEL" run "$work/s.pel" --bands 0 -o "$work/o.ppm" || fail "scroll, --bands 0"
sed -i 's/bands 8/bands 0/' "$work/s.pel"
"$PEL" run "$work/s.pel" --bands 9 2>"$work/err" && fail "scroll, --bands 9"
grep -qF "s.pel:3: scroll: a band of 9 rows" "$work/err" || fail "no line: scroll"

echo 'text outline 1 2 3 0 "x"' |
    refused_script 2 'text without outlines: expected font outline FILE before it'
echo 'text 1 2 "x"' | refused_script 2 'text without a font: expected font FILE before it'
printf 'font "a folder/f.bdf"\ntext 1 2 x\n' |
    refused_script 3 'text: x: expected a text in quotes'
printf 'font "a folder/f.bdf"\ntext 1 2 "x\n' | refused_script 3 'expected a text that ends'
printf 'font "a folder/f.bdf"\ntext 1 2 "x"y\n' | refused_script 3 'expected a text that ends'
printf '%s\n' 'font "a folder/f.bdf"' 'text 1 2 "x\tx"' | refused_script 3 'expected a text that ends'
printf 'font "a folder/f.bdf"\ntext 1 2 "xHx"\n' |
    refused_script 3 'text: the font has no H (U+0048), and no glyph for what it lacks'
printf 'font "a folder/f.bdf"\ntext 1 2 "\303\274"\n' |
    refused_script 3 'text: the font has no ü (U+00FC)'
echo 'font none.bdf' | refused_script 2 "font: $work/none.bdf cannot be read (No such"
echo 'image 1 2 none.ppm' | refused_script 2 "image: $work/none.ppm cannot be read"
echo 'P6 2' >"$work/bad.ppm"
echo 'image 1 2 bad.ppm' | refused_script 2 "$work/bad.ppm:2: ends before the height"
echo 'font bad.ppm' | refused_script 2 "$work/bad.ppm: is no "
echo 'image alpha 1 2 256 p.ppm' |
    refused_script 2 'image alpha: 256: expected a whole number in 0..255'

[ ! -e "$work/failed" ]
