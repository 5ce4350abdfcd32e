#!/bin/sh
# What pel import makes of icons: C that firmware draws as scripts do, pictures,
# the table of bytes; and that only what has a meaning is taken.
set -u
. "$(dirname "$0")/lib.sh"
icons=docs/pictures

cat >"$work/draw.c" <<'EOF'
#include "a.h"
#include <stdio.h>

int main(int argc, char **argv)
{
    static uint8_t pixels[64 * 64 * 4];
    static uint64_t scratch[ASSET_SCRATCH(256) / 8 + 1];
    const struct pel_rect bounds = {0, 0, 64, 64};
    struct pel_icon_shape shape = {.icon = &asset,
                                   .color = PEL_RGB(200, 30, 70)};
    struct pel_surface surface;
    (void)argv;
    shape.kind = asset.strokes ? argc > 1 ? &pel_icon_aliased_strokes
                                          : &pel_icon_smooth_strokes
                 : argc > 1    ? &pel_icon_aliased
                               : &pel_icon_smooth;
    if (pel_icon_asset_check(&asset) != PEL_OK)
        return 1;
    pel_surface_init(&surface, &pel_xrgb8888, pixels, sizeof pixels, &bounds);
    for (int size = 5; size <= 256; size += 17) {
        pel_icon_place(&shape, PEL_PX(size), size * 999,
                       (struct pel_point){8000, 8100});
        if (pel_icon(&surface, &shape, scratch, ASSET_SCRATCH(size)) != PEL_OK)
            return 1;
    }
    pel_clear(&surface, PEL_RGB(255, 255, 255));
    pel_icon_place(&shape, PEL_PX(48), 7000, (struct pel_point){8000, 8100});
    if (pel_icon(&surface, &shape, scratch, ASSET_SCRATCH(48)) != PEL_OK)
        return 1;
    printf("P6 64 64 255\n");
    for (int i = 0; i < 64 * 64; i++)
        printf("%c%c%c", pixels[4 * i + 2], pixels[4 * i + 1], pixels[4 * i]);
    return 0;
}
EOF

for name in weather bell wifi battery gear; do
    "$PEL" import $icons/icon_$name.svg --name asset -o "$work/a.c" >"$work/table" ||
        fail "$name is not imported"
    $CC -std=c99 -O1 $WARNINGS -I. $INCLUDE "$work/draw.c" "$work/a.c" "$LIBPEL" \
        -o "$work/draw" || fail "$name does not compile"
    cp $icons/icon_$name.svg "$work/icon.svg"
    for smooth in on off; do
        { [ $smooth = off ] || echo "option smooth on"; } >"$work/how"
        {
            echo "canvas 64 64 xrgb8888" && cat "$work/how" && echo "clear #ffffff"
            echo "icon 31.25 31.640625 48 0.1068115 #c81e46 icon.svg"
        } >"$work/s.pel"
        "$PEL" run "$work/s.pel" -o "$work/script.ppm" || fail "$name: no script"
        "$work/draw" $([ $smooth = on ] || echo aliased) >"$work/own.ppm" ||
            fail "$name is not drawn"
        "$PEL" compare "$work/own.ppm" "$work/script.ppm" >"$work/out" ||
            fail "$name, smooth $smooth: $(head -3 "$work/out")"
    done
    grep -q 'bytes in flash, for pel_icon_smooth' "$work/table" ||
        fail "$name: $(cat "$work/table")"
done

# The table is what the C takes; the struct has six pointers.
cat >"$work/size.c" <<'EOF'
#include <pel/pel.h>
#include <stdio.h>

int main(void)
{
    printf("%zu\n", sizeof(struct pel_icon_asset) - 6 * (sizeof(void *) - 4));
    return 0;
}
EOF
$CC -std=c99 $WARNINGS -I. $INCLUDE "$work/size.c" -o "$work/size"
"$PEL" import $icons/icon_gear.svg --name asset -o "$work/a.c" >"$work/table"
flash=$(sed -n 's/^ *\([0-9]*\)  bytes in flash.*/\1/p' "$work/table")
cells=$(sed -n 's/.*_verbs\[\([0-9]*\)\].*/1 \1/p; s/.*_points\[\([0-9]*\)\].*/2 \1/p
    s/.*_parts\[\([0-9]*\)\].*/16 \1/p; s/.*_gradients\[\([0-9]*\)\].*/32 \1/p
    s/.*_stops\[\([0-9]*\)\].*/8 \1/p' "$work/a.c" |
    awk -v struct="$("$work/size")" '{ n += $1 * $2 } END { print n + struct }')
[ "$flash" = "$cells" ] || fail "the table has $flash bytes, the C $cells"
grep -q '^            4-bit mask  16 px   128 ' "$work/table" &&
    grep -q '^            palette8 .* 48 px  3328 ' "$work/table" ||
    fail "pictures: $(cat "$work/table")"

# Pictures have the longer side that was asked for, and alpha; of a symbolic icon
# the shapes take the program's colour.
printf '<svg xmlns="http://www.w3.org/2000/svg" width="20" height="10"><path d="M0 0h10v10H0z" fill="#f00"/></svg>' \
    >"$work/half.svg"
"$PEL" import "$work/half.svg" --icon-size 4 --name a -o - >"$work/c"
got=$(awk '/pixels = \{\{/ { p = 1; next } /^\}/ { p = 0 } p' "$work/c" | tr -d ' \n')
red=0,0,255,255,0,0,255,255, clear=0,0,0,0,0,0,0,0,
[ "$got" = "$red$clear$red$clear" ] || fail "the picture is $got"
"$PEL" import "$work/half.svg" --icon-size 4 --format rgb565_le --alpha gray4 --name a \
    -o - 2>&1 | grep -q 'pel_image_asset a_alpha' || fail "no mask"
"$PEL" import "$work/half.svg" --symbolic --name a -o - |
    grep -q '{0xffff0000, 5, 4, 1, 254, ' || fail "symbolic"
for row in "gray4 255,0,255,0," "gray8 255,255,0,0,255,255,0,0," "mono1 192,192,"; do
    "$PEL" import "$work/half.svg" --icon-size 4 --symbolic --format "${row% *}" \
        --name a -o - >"$work/c" 2>"$work/err"
    got=$(awk '/pixels = \{\{/ { p = 1; next } /^\}/ { p = 0 } p' "$work/c" | tr -d ' \n')
    [ "$got" = "${row#* }" ] || fail "the mask in ${row% *} is $got"
    [ ! -s "$work/err" ] || fail "a mask: $(cat "$work/err")"
done
"$PEL" import "$work/half.svg" --icon-size 4 --symbolic --name a -o - |
    grep -q '/\* gray4 \*/' || fail "a mask is not gray4"
for option in "--format argb8888" "--alpha gray4"; do
    refused_command "--symbolic makes a mask: expected" import "$work/half.svg" \
        --icon-size 4 --symbolic $option -o "$work/x.c"
done
refused_command "--icon-size is for icons; this is a picture" import \
    sim/scenes/face.ppm --icon-size 4 -o "$work/x.c"
refused_command "--format is for pictures and textures; this is an icon" import \
    "$work/half.svg" --format gray8 -o "$work/x.c"
refused_command "a pel2d file holds a mesh" import "$work/half.svg" -o "$work/x.pel2d"

# Explain tells of an icon's pixels; one that is no icon is refused in its line.
printf 'canvas 20 10 xrgb8888\nicon 10 5 20 0 #000000 half.svg\n' >"$work/s.pel"
"$PEL" explain "$work/s.pel" 3 3 >"$work/out"
grep -q 'line 2: icon: #ff0000 over #000000 gives #ff0000' "$work/out" ||
    fail "explain: $(cat "$work/out")"
"$PEL" explain "$work/s.pel" 13 3 | grep -q 'no command touches' || fail "explain 13"
echo '<svg/>' >"$work/none.svg"
echo "icon 1 1 9 0 #000000 none.svg" | refused_script 2 "$work/none.svg:1: is no SVG"

# One with more sides in a row than there is room for is told of, in its line.
awk 'BEGIN {
    printf "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"48\" height=\"48\">"
    printf "<path d=\"M0 24"
    for (i = 0; i < 2100; i++)
        printf "C%d 24.002 %d 24.001 %d 24", a = i % 2 ? 0 : 48, a, a
    print "\"/></svg>"
}' >"$work/level.svg"
printf 'canvas 40 40 rgb888\noption smooth on\nicon 10 10 32000 0 #000000 level.svg\n' \
    >"$work/s.pel"
"$PEL" run "$work/s.pel" -o "$work/o.ppm" 2>"$work/err" && fail "drawn without room"
grep -q 's.pel:3: icon: a row of pixels has more than 65536 sides' "$work/err" ||
    fail "no room: $(cat "$work/err")"
[ -e "$work/failed" ] || echo "icons are imported as they are drawn"
