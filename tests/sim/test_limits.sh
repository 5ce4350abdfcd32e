#!/bin/sh
# Files that make libraries crash, hang or take all memory, and files without an
# end: each is refused in time, by name, in one line, with status 2, and nothing
# is written.
set -u
. "$(dirname "$0")/lib.sh"
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
printf 'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n' \
    >"$work/cut.ply"
refused 'took more than 1 s: expected less, or a higher --limit' \
    "$work/cut.ply" import --limit 1,500
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

[ -e "$work/failed" ] || echo "libraries are kept in their limits"
