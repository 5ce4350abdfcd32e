#!/bin/sh
# pel import --view: what it writes stays within the tolerance in every view, by
# pel render and pel compare, and the next cheaper way does not; firmware draws so.
set -u
. "$(dirname "$0")/lib.sh"
dir=$work
sun=--sun=1,2,3:1,1,1

# Shadings from the cheapest on, as pel render names them.
ways='pel_shade_lit_flat:flat:screen pel_shade_lit_gouraud:gouraud:screen
    pel_perspective_lit_gouraud:gouraud:world pel_shade_phong:phong:screen
    pel_perspective_phong:phong:world'

# within N WAY: every view of views.txt, drawn so, is within N steps.
within() {
    shade=${2#*:}
    while read -r turn eye; do
        "$PEL" render builtin:vase --size 120x120 "$sun" --turn "$turn" --eye "$eye" \
            --shade "${shade%:*}" --interpolation "${shade#*:}" -o "$dir/way.ppm"
        "$PEL" render builtin:vase --size 120x120 "$sun" --turn "$turn" --eye "$eye" \
            --shade phong --interpolation world -o "$dir/exact.ppm"
        "$PEL" compare --tolerance "$1" "$dir/way.ppm" "$dir/exact.ppm" \
            >"$dir/compared" || return 1
    done <"$dir/views.txt"
}

printf '0,0,0 0,1,6\n0.1,0.3,0 0,0,5\n0,0.7,0.2 1,0,4\n' >"$dir/views.txt"
for tolerance in 0 1 3 8 24 90 255; do
    "$PEL" import builtin:vase "$sun" --size 120x120 --normals 16 --name asset \
        --view "$dir/views.txt" --tolerance $tolerance -o "$dir/vase.c" >"$dir/table"
    taken=$(sed -n 's/^    &\(pel_[a-z_]*\);$/\1/p' "$dir/vase.c")
    cheaper=
    for way in $ways; do
        [ "${way%%:*}" = "$taken" ] && break
        cheaper=$way
    done
    [ "${way%%:*}" = "$taken" ] || fail "no shading in vase.c: $taken"
    within $tolerance "$way" || fail "$taken is not within $tolerance"
    [ -z "$cheaper" ] || ! within $tolerance "$cheaper" ||
        fail "$cheaper is within $tolerance, and cheaper than $taken"
    echo "$tolerance $taken" >>"$dir/all"
done
[ "$(cut -d' ' -f2 "$dir/all" | sort -u | wc -l)" -ge 3 ] ||
    fail "one shading for all tolerances: $(cat "$dir/all")"
$CC -std=c99 $WARNINGS -I. $INCLUDE -c "$dir/vase.c" -o "$dir/vase.o"

# Parts and textures: each has a method of its own, and firmware is within the
# tolerance and the steps of RGB565.
spider=${PEL_MODELS:-/usr/share/assimp/models}/OBJ/spider.obj
look="$sun --size 600x600 --sensor 36x36 --near 0.125 --target 0,0,0 --texture nearest"
if [ ! -r "$spider" ]; then
    fail "$spider is missing: the package assimp-testmodels brings it"
else
    echo "0,0,0 64,64,256 0,0,0 # the one view of import_draw" >"$dir/one.txt"
    "$PEL" import "$spider" --normals 16 --format rgb565_le --name asset $look \
        --view "$dir/one.txt" --tolerance 12 -o "$dir/spider.c" >"$dir/table"
    grep -q 'asset_shadings\[' "$dir/spider.c" || fail "one shading for all parts"
    $CC -std=c99 -O2 $WARNINGS -DMEASURED -DEYE=64,64,256 -DTARGET=0,0,0 -I. $INCLUDE \
        tests/sim/import_draw.c "$dir/spider.c" "$LIBPEL" -lm -o "$dir/spider"
    "$PEL" render "$spider" $look --eye 64,64,256 --order painter --format rgb565_le \
        --shade phong --interpolation world -o "$dir/spider.ppm"
    "$dir/spider" "$dir/spider.ppm" measured 20 || fail "firmware is not within 12"
    ! "$dir/spider" "$dir/spider.ppm" measured 0 >"$dir/compared" ||
        fail "no method is cheaper than the exact one"
fi

# A number of views, from all sides.
"$PEL" import builtin:vase-small "$sun" --view 7 --tolerance 4 -o "$dir/cube.c" >"$dir/table"
grep -q '^errors in 7 views of 240 x 240 px' "$dir/table" || fail "$(cat "$dir/table")"

echo "0,0" >"$dir/wrong.txt"
: >"$dir/empty.txt"
refused_command "$dir/wrong.txt:1: no view: expected X,Y,Z" import builtin:vase-small \
    --view "$dir/wrong.txt" -o "$dir/cube.c"
refused_command "$dir/empty.txt: has no view" import builtin:vase-small \
    --view "$dir/empty.txt" -o "$dir/cube.c"
refused_command "--view is '0': expected a number from 1 to 10000" import builtin:vase-small \
    --view 0 -o "$dir/cube.c"
refused_command "--tolerance is for --view" import builtin:vase-small --tolerance 3 \
    -o "$dir/cube.c"
refused_command "--shade is for pel render" import builtin:vase-small --view 3 --shade flat \
    -o "$dir/cube.c"
