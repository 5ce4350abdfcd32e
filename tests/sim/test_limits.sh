#!/bin/sh
# Files that make libraries crash, hang or take all memory, and files without an
# end: each is refused in time, by name, in one line, with status 2, and nothing
# is written.
set -u
. "$(dirname "$0")/lib.sh"
PEL=$(realpath "$PEL")
models=${PEL_MODELS:-/usr/share/assimp/models}

# refused TEXT FILE COMMAND...: pel COMMAND... FILE, which may take 10 s and 8
# GB. The message names FILE and holds TEXT.
refused() {
    text=$1 file=$2
    shift 2
    rm -f "$work/out.c"
    (ulimit -v 8000000 && timeout 10 "$PEL" "$@" "$file" -o "$work/out.c") \
        >"$work/out" 2>"$work/err" </dev/null
    status=$?
    [ $status = 2 ] || fail "$file: status $status"
    grep -qF -e "pel: $file: " "$work/err" && grep -qF -e "$text" "$work/err" ||
        fail "$file: no '$text': $(head -c 300 "$work/err")"
    [ "$(wc -lc <"$work/err" | awk '{ print ($1 == 1 && $2 < 600) }')" = 1 ] ||
        fail "$file: not one line: $(head -c 300 "$work/err")"
    [ ! -s "$work/out" ] && [ ! -e "$work/out.c" ] || fail "$file: output"
}

# Meshes that assimp 5.2 does not bear.
crashed='the library that reads it crashed: '
for model in RAW/WithColor.raw RAW/WithTexture.raw; do
    refused "${crashed}Segmentation fault" "$models/$model" import
done
# Its step that places nodes would abort on these; pel places them itself.
for model in OpenGEX/camera.ogex OpenGEX/collada.ogex; do
    "$PEL" info "$models/$model" >"$work/out" || fail "$model is refused"
done
# Headers of .ply without an end: assimp would stay in them.
for cut in 'ply\n' 'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n' \
    'ply\r\nformat ascii 1.0\r\nend_header_' 'ply\nformat ascii 1.0\nend_heade' \
    'ply\nformat ascii 1.0\nEnd_header\n' 'Ply a\nformat ascii 1.0\nenD_header\n'; do
    # shellcheck disable=SC2059
    printf "$cut" >"$work/cut.ply"
    refused 'ends inside of its header: expected a line end_header' \
        "$work/cut.ply" import --limit 5,500
done
{
    printf 'ply\nformat ascii 1.0\nelement vertex 900000000\nproperty float x\n'
    printf 'property float y\nproperty float z\nelement face 1\n'
    printf 'property list uchar int vertex_indices\nend_header\n0 0 0\n'
} >"$work/many.ply"
refused 'took more than 2048 MB: expected less, or a higher --limit' \
    "$work/many.ply" import

# Pictures: sizes are claimed, data is missing.
large='a picture of 30000 x 30000 pixels: expected 1 to 32767 each way, 268435456 in all'
short='ends before its picture does: expected a whole file'
bmp() { # COUNT SIZE: a head of 54 bytes with that width and height
    printf 'BM\066\0\0\0\0\0\0\0\066\0\0\0\050\0\0\0%b%b\001\0\030\0' "$1" "$1"
    head -c 24 /dev/zero
}
tga() { # TYPE SIZE: a head of 18 bytes
    printf '\0\0%b\0\0\0\0\0\0\0\0\0%b%b\030\0' "$1" "$2" "$2"
}
png() { # SIZE: a signature and a head
    printf '\211PNG\r\n\032\n\0\0\0\015IHDR%b%b\010\0\0\0\0' "$1" "$1"
}
bmp '\060\165\0\0' >"$work/large.bmp"
tga '\012' '\060\165' >"$work/large.tga"
png '\0\0\165\060' >"$work/large.png"
{ tga '\002' '\004\0' && printf 'ten bytes.'; } >"$work/cut.tga"
{ tga '\012' '\004\0' && printf 'ten bytes.'; } >"$work/packed.tga"
head -c 8000 "$models/IRRMesh/crackedground_1-6.jpg" >"$work/cut.jpg"
{ png '\0\0\0\001' && printf '\072\176\233\125\0\0\0\007tIME\0\0\0'; } \
    >"$work/time.png"
for file in large.bmp large.tga large.png; do
    refused "$large" "$work/$file" import
done
for file in cut.tga packed.tga cut.jpg time.png; do
    refused "$short" "$work/$file" import
done
tga '\002' '\0\020' >"$work/4096.tga"
refused 'took more than 40 MB: ' "$work/4096.tga" import --limit 9,40
printf 'canvas 8 8 gray8\nimage 0 0 large.png\n' >"$work/s.pel"
(ulimit -v 8000000 && timeout 10 "$PEL" run "$work/s.pel") >"$work/out" 2>"$work/err"
grep -qF "pel: $work/s.pel:2: $work/large.png: $large" "$work/err" ||
    fail "a script's picture: $(cat "$work/err")"

# Pipes that nobody writes to, for whatever reads: in time.
cd "$work" || exit 1
late='took more than 1 s: expected less, or a higher --limit'
piped() { # FILE COMMAND ARGUMENT...
    rm -f out.c out.ppm
    mkfifo "$1" 2>/dev/null
    name=$1
    shift
    timeout 10 "$PEL" "$@" --limit 1,500 >out 2>err </dev/null
    status=$?
    [ $status = 2 ] || fail "$name: status $status"
    grep -qF "pel: $name: reading it $late" err || fail "$name: $(cat err)"
}
for name in pipe.ppm pipe.png pipe.bdf pipe.psf pipe.bmp; do
    piped $name import $name -o out.c
done
piped pipe.ppm compare pipe.ppm pipe.ppm
piped pipe.pel run pipe.pel -o out.ppm
piped pipe.pel explain pipe.pel 1 1
piped pipe.pel2d render pipe.pel2d -o out.ppm
piped pipe view figures --headless --frames 1 -o frames --replay pipe
# Meshes are refused as pipes, of which assimp would stay in one.
for name in pipe.obj pipe.stl pipe.glb pipe.3mf /dev/null; do
    case $name in pipe.*) mkfifo "$name" ;; esac
    timeout 10 "$PEL" info "$name" --limit 1,500 >out 2>err </dev/null
    status=$?
    [ $status = 2 ] && grep -qF \
        "pel: $name: is a pipe or a device: expected a regular file" err ||
        fail "$name: status $status, $(cat err)"
done
mkfifo open
# Held open until pel has ended, however long it takes to start.
sleep 120 >open &
holder=$!
timeout 60 "$PEL" run - --limit 1,500 <open >out 2>err &&
    fail "standard input without an end"
kill $holder
grep -qF "pel: (standard input): reading it $late" err ||
    fail "standard input: $(cat err)"

# What is larger than the limit.
too_large='reading it took more than 1 MB: expected less, or a higher --limit'
yes '# a comment' | head -c 1500000 >large.pel
{ echo 'STARTFONT 2.1' && yes 'COMMENT x' | head -c 1500000; } >large.bdf
{ echo P6 1000 1000 255 && head -c 3000000 /dev/zero; } >large.ppm
{ echo pel2d 900000 0 && yes '0 0 0 0 0 0 0 0' | head -c 1500000; } >large.pel2d
limited() { # FILE COMMAND ARGUMENT...
    name=$1
    shift
    timeout 10 "$PEL" "$@" --limit 9,1 >out 2>err </dev/null
    status=$?
    [ $status = 2 ] && grep -qF "pel: $name: $too_large" err ||
        fail "$name: status $status, $(cat err)"
}
limited large.pel run large.pel -o out.ppm
limited large.bdf import large.bdf -o out.c
limited large.ppm import large.ppm -o out.c
limited large.pel2d render large.pel2d -o out.ppm
# A picture that ends at the limit inside of a pixel; one that stalls there, and
# one that never begins; one of too many pixels, before those are read.
{ echo P6 200 20000 65535 && head -c 24000000 /dev/zero; } >wide.ppm
timeout 20 "$PEL" import wide.ppm -o out.c --limit 20,18 >out 2>err &&
    fail "wide.ppm is read"
grep -qF "pel: wide.ppm: reading it took more than 18 MB: " err ||
    fail "wide.ppm: $(cat err)"
rm wide.ppm
mkfifo stalls.ppm
for start in 'P6 2 2 255\nabc' 'P3 2 2 255 1 2 ' 'P1 2 2 1' 'P4 9 9\n' \
    'P7\nWIDTH 2\n' P; do
    # shellcheck disable=SC2059
    { printf "$start" && sleep 3; } >stalls.ppm &
    timeout 10 "$PEL" import stalls.ppm -o out.c --limit 1,100 >out 2>err
    grep -qF "pel: stalls.ppm: reading it $late" err && [ "$(wc -l <err)" = 1 ] ||
        fail "stalls after $start: $(cat err)"
done
echo P5 32767 9000 255 >many.ppm
timeout 10 "$PEL" import many.ppm -o out.c 2>err && fail "many.ppm is read"
grep -qF 'pel: many.ppm: a picture of 32767 x 9000 pixels: expected 1 to' err ||
    fail "many.ppm: $(cat err)"

# What has no end, as a mesh, a font, a picture and a buffer of glTF.
for name in zero.obj zero.ply zero.bdf zero.png; do
    ln -s /dev/zero $name
    rm -f out.c
    timeout 10 "$PEL" import $name -o out.c --limit 60,50 >out 2>err
    status=$?
    [ $status = 2 ] && [ "$(wc -l <err)" = 1 ] && grep -qF "pel: $name: " err ||
        fail "$name: status $status, $(cat err)"
done
printf '{"asset": {"version": "2.0"}, "buffers": [{"uri": "/dev/zero", "byteLength": 36}], "bufferViews": [{"buffer": 0, "byteLength": 36}], "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}], "scene": 0}' \
    >zero.gltf
timeout 10 "$PEL" info zero.gltf --limit 60,50 >out 2>err
status=$?
[ $status = 2 ] || fail "a buffer without an end: status $status, $(cat err)"

# A name - in a file is that of a file, and no standard input.
printf 'P3 1 1 255 255 0 0\n' >red.ppm
printf 'canvas 8 8 xrgb8888\nimage 0 0 -\n' >dash.pel
"$PEL" run dash.pel -o out.ppm <red.ppm 2>err && fail "- of a script is read"
cp red.ppm ./-
timeout 5 "$PEL" run dash.pel -o out.ppm </dev/null || fail "a file named -"
rm ./-
make_square .
square() { # URI: a glTF file of two squares, red and white, with that texture
    cat <<END
{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
 "nodes": [{"mesh": 0}],
 "meshes": [{"primitives": [
    {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0},
    {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 1}]}],
 "materials": [
    {"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1],
                              "baseColorTexture": {"index": 0}}},
    {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
 "textures": [{"source": 0}], "images": [{"uri": "$1"}],
 $square_lists}
END
}
square - >dash.gltf
timeout 10 "$PEL" info dash.gltf <red.ppm >out 2>err || fail "- of a glTF"
grep -q '^texture 1: missing, ' out || fail "- of a glTF is read: $(cat out)"

# A picture that is named twice is read once: a pipe has it once.
mkfifo once.ppm
printf 'canvas 8 8 xrgb8888\nimage 0 0 once.ppm\nimage 4 4 once.ppm\n' >once.pel
square once.ppm >once.gltf
for command in 'run once.pel -o out.ppm' 'info once.gltf'; do
    cat red.ppm >once.ppm &
    writer=$!
    # shellcheck disable=SC2086
    timeout 20 "$PEL" $command --limit 9,500 >out 2>err ||
        fail "$command: $(cat err)"
    kill $writer 2>/dev/null
    wait $writer 2>/dev/null
done
grep -q '^texture 1: 1 x 1, once.ppm' out || fail "of a glTF: $(cat out)"
grep -q 'left out' err && fail "read twice: $(cat err)"

# So is a mesh, unless what is made of it differs: it tells once what is missing.
{
    printf 'canvas 8 8 xrgb8888\nmesh dash.gltf\nshade flat\nmesh dash.gltf\n'
    printf 'mesh builtin:vase\nmesh builtin:vase\n'
} >mesh.pel
"$PEL" run mesh.pel -o out.ppm 2>err || fail "two meshes: $(cat err)"
[ "$(grep 'left out' err)" = \
    'pel: mesh.pel:2: dash.gltf: its texture - is left out' ] ||
    fail "a mesh is read twice: $(cat err)"
printf 'option mesh normals smooth\nmesh dash.gltf\n' >>mesh.pel
"$PEL" run mesh.pel -o out.ppm 2>err || fail "other normals: $(cat err)"
[ "$(grep -c 'left out' err)" = 2 ] || fail "other normals are not made: $(cat err)"

# A large canvas: it and the file are all that there is.
printf 'canvas 8192 8192 xrgb8888\nclear #102030\n' >canvas.pel
for ending in ppm bmp; do
    (ulimit -v 450000 && "$PEL" run canvas.pel -o out.$ending) 2>err ||
        fail "a canvas of 268 MB takes more than 450 MB: $(cat err)"
    rm -f out.$ending
done

[ -e "$work/failed" ] || echo "libraries are kept in their limits"
