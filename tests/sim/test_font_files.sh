#!/bin/sh
# pel import of fonts: C assets compile without a warning as C99 and as C++, are
# the same each time, and show what the font file holds. Unifont is imported from
# the console's PSF file and from X's font as BDF: both show the same.
set -eu
. "$(dirname "$0")/lib.sh"
dir=$work

# font NAME FILE OPTIONS...: $dir/NAME shows a text.
font() {
    name=$1
    shift
    mkdir -p "$dir/again"
    "$PEL" import "$@" --name asset -o "$dir/$name.c"
    "$PEL" import "$@" --name asset -o "$dir/again/$name.c"
    cmp "$dir/$name.c" "$dir/again/$name.c" || fail "$name: not the same twice"
    if grep -n "$dir" "$dir/$name.c"; then
        fail "$name: a path in the asset"
    fi
    if command -v c++ >/dev/null; then
        c++ -x c++ -Wall -Wextra -Werror -I. $INCLUDE -c "$dir/$name.c" -o /dev/null
    fi
    $CC -std=c99 -O1 $WARNINGS -I. $INCLUDE tests/sim/font_show.c "$dir/$name.c" \
        "$LIBPEL" -o "$dir/$name"
}

# shows NAME TEXT: the picture is that of standard input.
shows() {
    "$dir/$1" "$2" >"$dir/got"
    cat >"$dir/expected"
    diff "$dir/expected" "$dir/got" || fail "$1: '$2' looks different"
}

# refused WORDS OPTIONS...
refused() {
    words=$1 status=0
    shift
    "$PEL" import "$@" -o "$dir/refused.c" 2>"$dir/message" || status=$?
    [ $status = 2 ] || fail "$*: status $status, not 2"
    grep -a "^pel: .*$words" "$dir/message" | grep -q ": expected " ||
        fail "$*: '$words' is not in: $(cat "$dir/message")"
    [ ! -e "$dir/refused.c" ] || fail "$*: left a file"
}

cat >"$dir/hand.bdf" <<'EOF'
STARTFONT 2.1
FONT hand
FONTBOUNDINGBOX 4 5 0 -1
CHARS 3
STARTCHAR a
ENCODING 97
DWIDTH 4 0
BBX 4 5 0 -1
BITMAP
00
60
A0
60
00
ENDCHAR
STARTCHAR j
ENCODING 106
DWIDTH 3 0
BBX 3 5 -1 -1
BITMAP
20
00
20
20
C0
ENDCHAR
STARTCHAR question
ENCODING 63
DWIDTH 2 0
BBX 1 5 0 -1
BITMAP
80
80
00
80
00
ENDCHAR
ENDFONT
EOF
font hand "$dir/hand.bdf"
shows hand 'aj?b' <<'EOF'
P2
11 5
1
00000101010
01100001010
10100100000
01100101010
00011000000
EOF

{ printf '\357\273\277'; cat "$dir/hand.bdf"; } >"$dir/marked.bdf"
font marked "$dir/marked.bdf"
"$dir/hand" 'aj?b' >"$dir/hand.pgm"
shows marked 'aj?b' <"$dir/hand.pgm"

font few "$dir/hand.bdf" --codes 97,0x3f-0x3F
shows few 'j' <<'EOF'
P2
2 5
1
10
10
00
10
00
EOF
"$PEL" import "$dir/hand.bdf" --codes a,?-? --name asset -o "$dir/chars.c"
cmp "$dir/few.c" "$dir/chars.c" || fail "characters in --codes"
"$PEL" import "$dir/hand.bdf" --chars 'a?a' --name asset -o "$dir/chars.c"
cmp "$dir/few.c" "$dir/chars.c" || fail "--chars"
refused 'lacks 1 of --codes and --chars: U+20AC: expected' "$dir/hand.bdf" --chars 'a€'
for chars in '' "$(printf 'a\303')"; do
    refused "--chars is '${chars:+a?}': expected UTF-8" "$dir/hand.bdf" --chars "$chars"
done

# The table of what it takes in flash is what a compiler makes of it.
as_told() { # STRUCT OF THE ASSET, TABLE; the asset is asset.c
    sed -i "s/^extern const struct $1 asset;\$/__attribute__((used))/" "$dir/asset.c"
    command -v arm-none-eabi-gcc >/dev/null || return 0
    arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb $INCLUDE -Iinclude -c "$dir/asset.c" \
        -o "$dir/asset.o" || fail "$1: asset.c does not compile"
    made=$(arm-none-eabi-size -A "$dir/asset.o" |
        awk '/^\.(rodata|data)/ { n += $2 } END { print n }')
    told=$(awk '/bytes in flash: 3 glyphs/ { print $1 }' "$2")
    parts=$(awk '!/in flash/ { n += $1 } END { print n }' "$2")
    [ "$told" = "$parts" ] && [ $((made - told)) -ge 0 ] && [ $((made - told)) -lt 4 ] ||
        fail "told $told of $parts, made $made: $(cat "$2")"
}
"$PEL" import "$dir/hand.bdf" --name asset -o "$dir/asset.c" >"$dir/table" ||
    fail "no table"
as_told pel_font_asset "$dir/table"
grep -q -- --codes "$dir/table" && fail "--codes for 3 glyphs"

# Outlines: what has none is refused, and so is what makes pictures of them.
outlines=/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf
[ -r "$outlines" ] || fail "$outlines is missing: fonts-dejavu-core brings it"
refused 'has pictures of glyphs, no outlines: expected no --outline' \
    "$dir/hand.bdf" --outline
if "$PEL" import "$outlines" --outline --name asset --chars 'aV?' \
    -o "$dir/asset.c" >"$dir/table" 2>"$dir/err"; then
    for option in '--bits 4' '--hinting full' '--font-size 9' '--next more'; do
        refused "is for pictures of glyphs, --outline" \
            "$outlines" --outline $option
    done
    as_told pel_outline_font_asset "$dir/table"
    for way in --outline '--font-size 9'; do
        "$PEL" import "$outlines" $way -o "$dir/all.c" |
            grep -q -- '--codes 32-126 would' || fail "all of a font: no word of --codes"
    done
else
    grep -q libfreetype-dev "$dir/err" || fail "$outlines: $(cat "$dir/err")"
fi

# A box stands for what is missing where the font has no glyph for that.
font box sim/scenes/fixed_6x13.bdf --chars 'i'
shows box 'xi' <<'EOF'
P2
12 13
1
111110000000
100010000000
100010000000
100010001000
100010000000
100010011000
100010001000
100010001000
100010001000
100010001000
111110011100
000000000000
000000000000
EOF
refused 'no character of 200-300' "$dir/hand.bdf" --codes 200-300
refused 'no character of é' "$dir/hand.bdf" --chars é

# What the font lacks is named: an error, or a note where a range has gaps.
refused 'lacks 2 of --codes and --chars: U+0062 U+00E4:' "$dir/hand.bdf" --codes ä,a,b
"$PEL" import "$dir/hand.bdf" --codes a-k --name asset -o "$dir/gaps.c" \
    2>"$dir/message" || fail "a range with gaps"
grep -q 'hand.bdf: lacks 9 of --codes and --chars: U+0062-0069 U+006B$' "$dir/message" ||
    fail "gaps: $(cat "$dir/message")"
for codes in '' ab a- 1- 1-2, 2-1 b-a ,1 -1 1,,2 0x110000 "$(printf '\303')"; do
    refused "--codes is '$(echo "$codes" | LC_ALL=C tr '\303' '?')'" "$dir/hand.bdf" --codes "$codes"
done
sed '/^ENDCHAR/,$d' "$dir/hand.bdf" >"$dir/cut.bdf"
refused 'the file ends here: expected ENDCHAR' "$dir/cut.bdf"
for field in nochars noend longrow usascii; do
    "$PEL" import "$(dirname "$0")/field/$field.bdf" --name asset -o "$dir/$field.c" \
        2>"$dir/$field.err" || fail "$field.bdf: $(cat "$dir/$field.err")"
    sed 1d "$dir/$field.c" >"$dir/$field.text"
done
for field in nochars noend longrow; do
    cmp "$dir/$field.text" "$dir/usascii.text" || fail "$field.bdf: another font"
done
grep -q 'is read in spite of: 1 missing or wrong CHARS$' "$dir/nochars.err" &&
    grep -q 'of: 1 missing ENDFONT$' "$dir/noend.err" &&
    grep -q 'of: 3 rows longer or shorter than wide$' "$dir/longrow.err" &&
    [ ! -s "$dir/usascii.err" ] || fail "field: $(cat "$dir"/*.err)"

# Outlines, drawn in one bit: lines are no higher than what is asked for.
if "$PEL" import "$outlines" --codes A --font-size 16 -o "$dir/outline.c" 2>"$dir/err"; then
    font outline "$outlines" --codes A,g --font-size 16 --bits 1
    shows outline 'Ag' <<'EOF'
P2
17 16
1
00000000000000000
00000000000000000
00000000000000000
00001000000000000
00010100000000000
00010100000111110
00100010001100110
00100010001000010
01111111001000010
01000001001000010
01000001001100110
10000000100111110
00000000000000010
00000000000100110
00000000000011100
00000000000000000
EOF
    font smooth "$outlines" --codes A,V,g --font-size 16
    shows smooth 'AVg' <<'EOF'
P2
25 16
1
0000000000000000000000000
0000000000000000000000000
0000000000000000000000000
0001100011000001100000000
0001110001000001000000000
0001010001000011000111010
0011011001100010001100110
0010001000100010001000010
0110001000110110001000010
0111111100010100001000010
0100000100011100001100110
1100000110011000000111010
0000000000000000000000010
0000000000000000000000110
0000000000000000000111100
0000000000000000000000000
EOF
    font smooth "$outlines" --codes A,V --font-size 28 --bits 4
    grep -q 'pel_font_pair smooth\|pel_font_pair asset' "$dir/smooth.c" ||
        fail "no pairs of A and V"
    refused "is '3'" "$outlines" --bits 3
    script() { # LINE
        printf '%s\n' 'canvas 90 40 xrgb8888' "$@" 'paint flat #ffffff' \
            'text 2 4 "AVg"' >"$dir/smooth.pel"
    }
    script "font smooth 28 $outlines"
    "$PEL" run "$dir/smooth.pel" -o "$dir/whole.ppm"
    script 'bands 7' "font smooth 28 $outlines" "font smooth 28 $outlines"
    "$PEL" run "$dir/smooth.pel" -o "$dir/bands.ppm"
    "$PEL" compare "$dir/whole.ppm" "$dir/bands.ppm" >/dev/null ||
        fail "a smooth text differs in bands"
    "$PEL" explain "$dir/smooth.pel" 7 18 | grep -q 'alpha [1-9]' ||
        fail "no edge in $("$PEL" explain "$dir/smooth.pel" 7 18)"
    script "font smooth 0 $outlines"
    if "$PEL" run "$dir/smooth.pel" -o "$dir/none.ppm" 2>"$dir/err" ||
        ! grep -q 'expected 1 to 255 px' "$dir/err"; then
        fail "a font of 0 px: $(cat "$dir/err")"
    fi
    refused 'no outlines' "$dir/hand.bdf" --bits 4
    refused 'has the characters of Unicode' "$outlines" --encoding koi8-r
    for size in 8 11 24 100 255; do
        lines=$("$PEL" import "$outlines" --codes 32-126 --font-size $size \
            -o "$dir/outline.c" 2>"$dir/err" | sed -n 's/.*lines of \([0-9]*\) px$/\1/p')
        [ "$lines" -le $size ] && [ "$lines" -ge $((size - size / 8 - 1)) ] ||
            fail "$outlines of $size px: lines of $lines"
        [ ! -s "$dir/err" ] || fail "what is not wanted is told: $(cat "$dir/err")"
    done
else
    grep -q libfreetype-dev "$dir/err" || fail "$outlines: $(cat "$dir/err")"
fi

psf=/usr/share/consolefonts/Unifont-APL8x16.psf.gz
pcf=/usr/share/fonts/X11/misc/unifont.pcf.gz
[ -r "$psf" ] || fail "$psf is missing: the package psf-unifont brings it"
[ -r "$pcf" ] || fail "$pcf is missing: the package xfonts-unifont brings it"
command -v pcf2bdf >/dev/null || fail "pcf2bdf is missing: its package is pcf2bdf"
if [ ! -e "$work/failed" ]; then
    gzip -cd "$psf" >"$dir/console.psf"
    gzip -cd "$pcf" >"$dir/window.pcf"
    pcf2bdf -o "$dir/window.bdf" "$dir/window.pcf"
    font console "$dir/console.psf"
    font window "$dir/window.bdf" --codes 32-0xFF,0x391-0x3C9
    # FreeType and pel's own readers see the same pixels; packed files, too.
    "$PEL" import "$pcf" --codes 32-0xFF,0x391-0x3C9 --name asset \
        -o "$dir/pcf.c" 2>"$dir/err" || grep -q libfreetype-dev "$dir/err" ||
        fail "$pcf: $(cat "$dir/err")"
    if [ -s "$dir/pcf.c" ]; then
        for kind in pcf window; do
            sed '1d; /glyph of what is missing/d' "$dir/$kind.c" >"$dir/$kind.text"
        done
        cmp "$dir/pcf.text" "$dir/window.text" || fail "a PCF and its BDF differ"
        cp "$psf" "$dir/packed.psf.gz"
        "$PEL" import "$dir/packed.psf.gz" --name asset -o "$dir/packed.c" &&
            sed 1d "$dir/packed.c" >"$dir/packed.text" &&
            sed 1d "$dir/console.c" | cmp - "$dir/packed.text" ||
            fail "a packed PSF"
        head -c 3000 "$psf" >"$dir/cut.psf.gz"
        refused 'cannot be unpacked: expected a whole file' "$dir/cut.psf.gz"
    fi
    for text in 'Hamburgefonstiv 0123456789' '!"#$%&()*+,./:;<=>?@[\]^{|}~' \
        'ÄÖÜäöüß éèêñç §°µ' 'π²½÷×'; do
        "$dir/console" "$text" >"$dir/console.pgm"
        shows window "$text" <"$dir/console.pgm"
    done
fi
