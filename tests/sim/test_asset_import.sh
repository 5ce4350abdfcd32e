#!/bin/sh
# pel import: C assets compile without a warning as C99 and as C++, are the same
# each time, and draw what the mesh or the picture itself draws.
set -eu
. "$(dirname "$0")/lib.sh"
dir=$work

# same NAME INPUT OPTIONS...: $dir/NAME.c, the same when made again elsewhere.
same() {
    name=$1
    shift
    mkdir -p "$dir/again"
    "$PEL" import "$@" --name asset -o "$dir/$name.c"
    "$PEL" import "$@" --name asset -o "$dir/again/$name.c"
    for ending in c h; do
        cmp "$dir/$name.$ending" "$dir/again/$name.$ending" ||
            fail "$name.$ending: not the same twice"
    done
    if grep -n "$dir" "$dir/$name.c" "$dir/$name.h"; then
        fail "$name: a path in the asset"
    fi
    $CC -std=c99 $WARNINGS -I. $INCLUDE -c "$dir/$name.c" -o "$dir/$name.o"
    if command -v c++ >/dev/null; then
        c++ -x c++ -Wall -Wextra -Werror -I. $INCLUDE -c "$dir/$name.c" \
            -o "$dir/again/$name.o"
    fi
}

# mesh NAME MESH EYE TARGET OPTIONS...: firmware draws the asset as pel render
# draws the mesh. Normals of 8 bits are not exactly those of pel render.
mesh() {
    name=$1 file=$2 eye=$3 target=$4
    shift 4
    same "$name" "$file" "$@"
    $CC -std=c99 -O2 $WARNINGS -DEYE="$eye" -DTARGET="$target" -I. $INCLUDE tests/sim/import_draw.c \
        "$dir/$name.o" "$LIBPEL" -lm -o "$dir/$name"
    for shade in flat gouraud ${1:+phong}; do
        case $shade in
        phong) look='--texture none --color #a0b4c8 --sun 1,2,3:1,1,1' ;;
        *) look="--unlit --texture nearest --mapping ${mapping:-vertices}" ;;
        esac
        "$PEL" render "$file" --shade $shade --format rgb565_le --size 600x600 \
            --order painter --sensor 36x36 --near 0.125 --eye "$eye" --target "$target" $look \
            -o "$dir/$name.ppm"
        "$dir/$name" "$dir/$name.ppm" $shade || fail "$name: $shade differs"
    done
}

# framed NAME MESH OPTIONS...: the same with the camera of --print-camera, of
# the asset that mesh() made.
framed() {
    name=$1 file=$2
    shift 2
    look='--unlit --texture nearest --mapping vertices --shade gouraud'
    "$PEL" render "$file" --order painter --size 600x600 --format rgb565_le "$@" $look \
        --print-camera -o "$dir/framed.ppm" >"$dir/camera.inc"
    "$PEL" render "$file" --size 600x600 "$@" --print-camera |
        cmp - "$dir/camera.inc" || fail "$name: another camera without -o"
    $CC -std=c99 -O2 $WARNINGS -DCAMERA="\"$dir/camera.inc\"" -I. $INCLUDE \
        tests/sim/import_draw.c "$dir/$name.o" "$LIBPEL" -lm -o "$dir/framed"
    "$dir/framed" "$dir/framed.ppm" gouraud || fail "$name: framed differs"
}

# A square with colours of its own, far from the origin, with 2 materials' worth
# of nothing else: what a mesh file needs at least.
cat >"$dir/square.ply" <<'EOF'
ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
property uchar red
property uchar green
property uchar blue
element face 2
property list uchar int vertex_indices
end_header
1000 2000 0 255 0 0
1001 2000 0 0 255 0
1001 2001 -1 0 0 255
1000 2001 0 255 255 0
3 0 1 2
3 0 2 3
EOF

duck=${PEL_MODELS:-/usr/share/assimp/models}/Collada/duck.dae
if [ ! -r "$duck" ]; then
    fail "$duck is missing: the package assimp-testmodels brings it"
else
    mesh duck "$duck" 0.125,0.875,3.5 0.125,0.875,0
    framed duck "$duck"
    framed duck "$duck" --projection orthographic --up 0.2,1,0
    grep -q '^/\* [0-9]* vertices, [0-9]* triangles' "$dir/duck.c" ||
        fail "no figures"
    mesh duck16 "$duck" 0.125,0.875,3.5 0.125,0.875,0 --normals 16
    grep -q 'int16_t asset_normals' "$dir/duck16.c" || fail "no 16-bit normals"
fi
spider=${PEL_MODELS:-/usr/share/assimp/models}/OBJ/spider.obj
if [ ! -r "$spider" ]; then
    fail "$spider is missing: the package assimp-testmodels brings it"
else
    mesh spider "$spider" 64,64,256 0,0,0 --normals 16
    mapping=affine
    mesh textures "$spider" 64,64,256 0,0,0 --normals 16 --format rgb565_le
    mapping=
    grep -q 'asset_texture_4' "$dir/textures.c" || fail "no 4 textures"
fi
mesh square "$dir/square.ply" 1000.5,2000.5,2 1000.5,2000.5,0 --normals 16

# Normals of any length are those of length 1, whatever the size of the mesh; the
# asset of a small mesh is that of a large one, but for its quantum and box.
ramp() { # SIZE LENGTH of the normals
    awk -v OFMT=%.17g -v s="$1" -v n="$2" 'BEGIN {
        for (i = 0; i < 9; i++) {
            print "v", s * (i % 3), s * int(i / 3), s * (i * i % 5) / 8
            print "vn", n * (i % 3 - 1), n * 0.6, n * 0.8
        }
        print "f 1//1 2//2 3//3 6//6 9//9 8//8 7//7 4//4"
        print "f 1//1 2//2 5//5"
    }'
}
arrays() { sed '/units/,/each light/d; /_asset asset = /,/}/d' "$dir/$1.c"; }
ramp 1 1 >"$dir/ramp.obj"
same one "$dir/ramp.obj" --normals 16
for size in "1 1.01" "1 70000" "3.814697265625e-6 0.001" "1073741824 1"; do
    ramp $size >"$dir/ramp.obj"
    same ramp "$dir/ramp.obj" --normals 16
    [ "$(arrays one)" = "$(arrays ramp)" ] || fail "a mesh of size $size"
done

# Pictures: the surface shows the picture, in the steps of its format.
printf 'P3\n5 9\n255\n' >"$dir/picture.ppm"
awk 'BEGIN { for (i = 0; i < 135; i++) print (i * 89 + i * i * 7) % 256 }' \
    >>"$dir/picture.ppm"
for format in rgb565_le rgb565_be bgr565_le xrgb1555_le rgb888 bgr888 xrgb8888 \
    xbgr8888 rgbx8888 bgrx8888 rgb332 gray8 gray4 gray2 mono1 mono1_pages inks2; do
    same $format "$dir/picture.ppm" --format $format
    $CC -std=c99 $WARNINGS -DFORMAT=pel_$format -I. $INCLUDE tests/sim/import_show.c \
        "$dir/$format.o" "$LIBPEL" -o "$dir/show"
    "$dir/show" >"$dir/$format.ppm" || fail "$format: the asset is refused"
done
same_as() {
    "$PEL" compare "$dir/$1.ppm" "$dir/$2.ppm" >/dev/null || fail "$1 is not $2"
}
# runs FORMAT PICTURE OPTIONS...: in runs it shows what $dir/FORMAT.ppm is.
runs() {
    format=$1 picture=$2
    shift 2
    same ${format}_runs "$picture" --format $format --compress "$@"
    grep -qx 'extern const struct pel_runs_asset asset;' "$dir/${format}_runs.h" ||
        fail "$format: $(cat "$dir/${format}_runs.h")"
    shown=pel_$format
    case $format in palette*) shown=asset_palette.format ;; esac
    $CC -std=c99 $WARNINGS -DFORMAT=$shown -I. $INCLUDE tests/sim/import_runs.c \
        "$dir/${format}_runs.o" "$LIBPEL" -o "$dir/show"
    "$dir/show" >"$dir/${format}_runs.ppm" || fail "$format: the runs are refused"
    same_as ${format}_runs $format
}
for format in rgb565_le rgb565_be xrgb1555_le rgb888 xrgb8888 rgb332 gray8 gray4 gray2 mono1 \
    inks2; do
    runs $format "$dir/picture.ppm"
done
for format in rgb888 bgr888 xrgb8888 xbgr8888 rgbx8888 bgrx8888; do
    same_as $format picture
done
same_as rgb565_be rgb565_le
same_as bgr565_le rgb565_le
same_as mono1_pages mono1
"$PEL" compare --tolerance 7 "$dir/rgb565_le.ppm" "$dir/picture.ppm" \
    >/dev/null || fail "rgb565_le is more than a step away"
"$PEL" compare --tolerance 16 "$dir/gray4.ppm" "$dir/gray8.ppm" >/dev/null ||
    fail "gray4 is more than a step away from gray8"

# Palettes, of whose colours there are not too many.
for picture in palette8:picture palette4:gray4; do
    format=${picture%:*}
    same $format "$dir/${picture#*:}.ppm" --format $format
    $CC -std=c99 $WARNINGS -DFORMAT=asset_palette.format -I. $INCLUDE \
        tests/sim/import_show.c "$dir/$format.o" "$LIBPEL" -o "$dir/show"
    "$dir/show" >"$dir/$format.ppm" || fail "$format: the asset is refused"
    same_as $format ${picture#*:}
    runs $format "$dir/${picture#*:}.ppm"
done
"$PEL" import sim/scenes/face.ppm --format palette4 -o "$dir/face.c"
grep -qx 'extern const struct pel_palette face_palette;' "$dir/face.h" ||
    fail "no palette in $(cat "$dir/face.h")"

# Alpha: kept by argb8888 and palettes, blended by the others, which say so. The pixels are
# opaque green, half red, and blue that is not there; a .tga has no checksum.
printf '\0\0\2\0\0\0\0\0\0\0\0\0\3\0\1\0\40\50' >"$dir/alpha.tga"
printf '\0\377\0\377\0\0\377\200\377\0\0\0' >>"$dir/alpha.tga"
alpha() { # BYTES OPTIONS...: what the asset holds, in memory order
    bytes=$1
    shift
    "$PEL" import "$dir/alpha.tga" "$@" --name asset -o "$dir/alpha.c" \
        2>"$dir/message"
    grep -qF "$bytes," "$dir/alpha.c" || fail "alpha $*: $(cat "$dir/alpha.c")"
}
if "$PEL" import "$dir/alpha.tga" -o "$dir/alpha.c" 2>"$dir/message"; then
    alpha "0, 255, 0, 255, 0, 0, 255, 128, 255, 0, 0, 0" --format argb8888
    [ ! -s "$dir/message" ] || fail "alpha is kept: $(cat "$dir/message")"
    alpha "0, 255, 0, 0, 0, 128, 0, 0, 0" --format rgb888
    grep -qF 'transparent is blended onto #000000' "$dir/message" ||
        fail "blended without a word"
    alpha "0, 255, 0, 32, 16, 136, 64, 32, 16" --format rgb888 \
        --background '#102040'
    alpha "4278255360, 2164195328, 255" --format palette8
    same argb8888 "$dir/alpha.tga" --format argb8888
    $CC -std=c99 $WARNINGS -DFORMAT=pel_argb8888 -I. $INCLUDE tests/sim/import_show.c \
        "$dir/argb8888.o" "$LIBPEL" -o "$dir/show"
    "$dir/show" >"$dir/argb8888.ppm" || fail "argb8888: the asset is refused"
else
    grep -qF 'package libsdl2-image-dev' "$dir/message" ||
        fail "alpha: $(cat "$dir/message")"
fi

# The header beside each asset declares it, for C and C++, as often as it is
# included; one that somebody else wrote stays.
"$PEL" import "$dir/square.ply" -o "$dir/square.c"
"$PEL" import "$dir/picture.ppm" -o "$dir/picture.c"
"$PEL" import sim/scenes/fixed_6x13.bdf --name my_letters -o "$dir/letters.c"
cat >"$dir/use.c" <<'EOF'
#include "letters.h"
#include "picture.h"
#include "square.h"
#include "letters.h"

int main(void)
{
    return pel_font_asset_check(&my_letters) != PEL_OK ||
           pel_image_asset_check(&picture, &pel_rgb565_le) != PEL_OK ||
           pel_mesh_asset_check(&square) != PEL_OK;
}
EOF
for asset in square picture letters; do
    $CC -std=c99 $WARNINGS -I. $INCLUDE -c "$dir/$asset.c" -o "$dir/again/$asset.o"
done
assets="$dir/again/square.o $dir/again/picture.o $dir/again/letters.o"
$CC -std=c99 $WARNINGS -I. $INCLUDE "$dir/use.c" $assets "$LIBPEL" -o "$dir/use"
"$dir/use" || fail "an asset of a header is refused"
if command -v c++ >/dev/null; then
    c++ -x c++ -Wall -Wextra -Werror -I. $INCLUDE "$dir/use.c" -x none $assets \
        "$LIBPEL" -o "$dir/use"
    "$dir/use" || fail "an asset of a header is refused in C++"
fi
echo "/* mine */" >"$dir/letters.h"
"$PEL" import sim/scenes/fixed_6x13.bdf -o "$dir/letters.c" 2>"$dir/message"
grep -qF 'letters.h: was not made by pel import and stays as it is; it should say: extern const struct pel_font_asset letters;' \
    "$dir/message" || fail "somebody's header: $(cat "$dir/message")"
[ "$(cat "$dir/letters.h")" = "/* mine */" ] || fail "a header is lost"

# What is wrong is refused, with status 2 and no file.
refuse() {
    expected=$1
    shift
    status=0
    "$PEL" import "$@" >"$dir/out" 2>"$dir/message" || status=$?
    [ $status -eq 2 ] || fail "import $*: status $status"
    grep -qF -e "$expected" "$dir/message" ||
        fail "import $*: $(cat "$dir/message")"
    [ ! -s "$dir/out" ] && [ ! -e "$dir/x.c" ] && [ ! -e "$dir/x.h" ] &&
        [ ! -e "$dir/x.pel2d" ] || fail "import $*: output"
}
refuse "0 arguments: expected MESH" -o "$dir/x.c"
refuse "-o ASSET.c is missing" builtin:vase
for kind in obj png bdf; do
    refuse "none.$kind: cannot be read: No such file" "$dir/none.$kind" -o "$dir/x.c"
done
if "$PEL" render "$dir/square.ply" -o "$dir/a.ppm" 2>/dev/null; then
    refuse "square.c: neither mesh, picture, icon nor font" "$dir/square.c" -o "$dir/y.c"
fi
# Help in groups: what is for fonts, pictures and meshes stands apart.
"$PEL" import --help >"$dir/help"
for group in 'Fonts:chars codes encoding font-size' 'Meshes:normals' \
    'Pictures, and the textures of meshes:dither format key palette resize'; do
    found=$(awk -v heading=" ${group%:*}:" '/^ [A-Z].*:$/ { on = $0 == heading }
        on && match($0, /--[a-z-]+/) && /^ +(-., )?--/ {
            print substr($0, RSTART + 2, RLENGTH - 2) }' "$dir/help")
    for option in ${group##*:}; do
        echo "$found" | grep -qx -e "$option" ||
            fail "--$option is not under ${group%:*}"
    done
done

for kind in psf.gz pcf.gz pcf ttf bdf; do
    echo nonsense >"$dir/x.$kind"
    refuse "x.$kind: is no " "$dir/x.$kind" -o "$dir/y.c"
done
refuse "expected an output .c or .pel2d" builtin:vase -o "$dir/x.h"
refuse "is no identifier of C" builtin:vase --name 3d -o "$dir/x.c"
for name in int delete bool close; do # of C, of C++, a macro, a function
    refuse "'$name' is one that C or C++ has already" builtin:vase \
        -o "$dir/$name.c"
done
refuse "--format is 'rgb': expected one of rgb565_le," "$dir/picture.ppm" \
    --format rgb -o "$dir/x.c"
refuse "expected 8|16" builtin:vase --normals 12 -o "$dir/x.c"

# An option that means nothing for what is made is refused by name.
refuse "has no texture: expected no --format" builtin:vase --format rgb888 \
    -o "$dir/x.c"
refuse "--format of textures is a palette" builtin:vase --format palette8 \
    -o "$dir/x.c"
refuse "picture.ppm: has more than 16 colours: expected a picture with fewer" \
    "$dir/picture.ppm" --format palette4 -o "$dir/x.c"
refuse "--background is for pictures" builtin:vase --background '#123456' -o "$dir/x.c"
refuse "--background is for formats without alpha" "$dir/picture.ppm" \
    --background '#123456' --format argb8888 -o "$dir/x.c"
for option in "--eye 1,2,3" "--light 1,2,3:1,1,1" "--size 5x5" "--color #123456"; do
    refuse "${option%% *} is for an output .pel2d" builtin:vase $option -o "$dir/x.c"
    refuse "${option%% *} is for an output .pel2d" "$dir/picture.ppm" $option -o "$dir/x.c"
done
for option in "--shade phong" "--cull back" "--mapping affine"; do
    for kind in builtin:vase "$dir/picture.ppm" sim/scenes/fixed_6x13.bdf; do
        refuse "${option%% *} is for pel render" $kind $option -o "$dir/x.c"
    done
    refuse "${option%% *} is for pel render" builtin:vase $option -o "$dir/x.pel2d"
done
refuse "--normals is for C assets of meshes" "$dir/picture.ppm" --normals 16 -o "$dir/x.c"
refuse "--codes is for fonts" builtin:vase --codes 32 -o "$dir/x.c"
refuse "--texture-file is for meshes" sim/scenes/fixed_6x13.bdf --texture-file a.ppm -o "$dir/x.c"
refuse "--name is for C assets" builtin:vase --name x -o "$dir/x.pel2d"
refuse "expected builtin:vase, builtin:vase-small, or a file" builtin:cube -o "$dir/x.c"
refuse "no mesh that can be read" "$dir/message" -o "$dir/x.c"
sed 's/^3 0 1 2/3 0 1 4/' "$dir/square.ply" >"$dir/bad.ply"
refuse "face 0 of part 0 names vertex 4; the part has 4" "$dir/bad.ply" -o "$dir/x.c"
if "$PEL" render "$dir/square.ply" -o "$dir/a.ppm" 2>/dev/null; then
    printf '\357\273\277v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >"$dir/marked.obj"
    refuse "begins with a UTF-8 byte order mark" "$dir/marked.obj" -o "$dir/x.c"
    { printf '\357\273\277'; cat "$duck"; } >"$dir/marked.dae"
    "$PEL" import "$dir/marked.dae" --name asset -o "$dir/marked.c" 2>/dev/null ||
        fail "a byte order mark before XML"
fi
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 3\n' >"$dir/bad.off"
refuse "out of range" "$dir/bad.off" -o "$dir/x.c"
ply() { # ELEMENT: of a square, what follows its vertices
    sed '/^element face/,$d' "$dir/square.ply"
    printf '%s\nproperty list int int vertex_indices\nend_header\n' "$1"
    sed '1,/^end_header/d; /^3 /d' "$dir/square.ply"
}
{ ply 'element tristrips 1'; echo '4 0 1 3 2'; } >"$dir/strips.ply"
refuse "strips.ply: has 1 triangle strips" "$dir/strips.ply" -o "$dir/x.c"
{ ply 'element face 3'; printf '2 0 1\n1 3\n3 0 1 2\n'; } >"$dir/mixed.ply"
"$PEL" import "$dir/mixed.ply" --name asset -o "$dir/mixed.c" 2>"$dir/message"
grep -q 'mixed.ply: 1 points and 1 lines are left out' "$dir/message" ||
    fail "lost without a word: $(cat "$dir/message")"
printf 'v %s 0\n' '0 0' '4 0' '4 4' '3 4' '3 1' '1 1' '1 4' '0 4' |
    sed 's/[1-4]/&e-30/g' >"$dir/tiny.obj"
echo 'f 1 2 3 4 5 6 7 8' >>"$dir/tiny.obj"
"$PEL" import "$dir/tiny.obj" --name asset -o "$dir/tiny.c" 2>"$dir/message"
grep -q 'tiny.obj: 2 of 6 triangles are lost' "$dir/message" ||
    fail "triangles lost without a word: $(cat "$dir/message")"
printf 'v %s 0\n' '0 0' '1 0' '0 1' '1 1' >"$dir/zero.obj"
printf 'vn 0 0 1\nvn -0 0 1\nf 1//1 2//1 3//1\nf 2//2 4//2 3//2\n' \
    >>"$dir/zero.obj"
"$PEL" import "$dir/zero.obj" --name asset -o "$dir/zero.c"
grep -q '^/\* 4 vertices' "$dir/zero.c" || fail "-0 is not joined with 0"
"$PEL" import builtin:vase -o "$dir/vase.pel2d"
refuse "is projected already" "$dir/vase.pel2d" -o "$dir/x.c"

# A pel2d file draws what its mesh draws by the painter (test_render_command.sh).
"$PEL" render builtin:vase --order painter -o "$dir/a.ppm"
"$PEL" render "$dir/vase.pel2d" -o "$dir/b.ppm"
"$PEL" compare --tolerance 1 "$dir/a.ppm" "$dir/b.ppm" || fail "the pel2d file draws something else"
