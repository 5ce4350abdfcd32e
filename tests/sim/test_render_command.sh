#!/bin/sh
# pel render: every format and any bands give the same picture, wrong options
# are refused with the valid ones, and nothing is written then.
set -eu
. "$(dirname "$0")/lib.sh"
dir=$work

# Bands, and the formats of 24 bits, change nothing; standard input and output.
# A pel2d file draws what its mesh draws; planes of colours are off by less than
# half a step each, so a colour may be one off.
"$PEL" import builtin:vase --unlit --size 300x200 -o "$dir/vase.pel2d"
for shade in flat gouraud; do
    for mesh in builtin:vase "$dir/vase.pel2d"; do
        "$PEL" render $mesh --size 300x200 --shade $shade -o "$dir/a.ppm"
        for options in "--bands 1" "--bands 7" "--bands 200" \
            "--format rgb888" "--format bgrx8888 --bands 13" "--jobs 3"; do
            "$PEL" render $mesh --size 300x200 --shade $shade $options \
                -o "$dir/b.ppm"
            cmp "$dir/a.ppm" "$dir/b.ppm" || fail "$mesh $shade $options"
        done
        for format in rgb565_be mono1 gray4 mono1_pages; do
            "$PEL" render $mesh --size 300x200 --shade $shade \
                --format $format -o "$dir/c.ppm"
            "$PEL" render $mesh --size 300x200 --shade $shade \
                --format $format --bands 16 -o "$dir/b.ppm"
            cmp "$dir/c.ppm" "$dir/b.ppm" || fail "$mesh $shade $format"
        done
    done
    "$PEL" render - --size 300x200 --shade $shade <"$dir/vase.pel2d" \
        >"$dir/b.ppm"
    cmp "$dir/a.ppm" "$dir/b.ppm" || fail "$shade: standard input"
    "$PEL" render builtin:vase --unlit --order painter --size 300x200 --shade $shade \
        -o "$dir/b.ppm"
    "$PEL" compare --tolerance $([ $shade = flat ] && echo 0 || echo 1) \
        "$dir/a.ppm" "$dir/b.ppm" || fail "$shade: pel2d is not its mesh"
done
"$PEL" render "$dir/vase.pel2d" --size 300x200 >"$dir/a.ppm"
"$PEL" render "$dir/vase.pel2d" --size 300x200 --shade gouraud -o "$dir/b.ppm"
cmp "$dir/a.ppm" "$dir/b.ppm" || fail "gouraud is not the default"

# Times go to standard error.
for mesh in builtin:vase "$dir/vase.pel2d"; do
    "$PEL" render $mesh --size 300x200 --time 2>"$dir/times" >"$dir/b.ppm"
    grep -q '^drawn: [0-9.]* ms$' "$dir/times" || fail "$mesh: no time"
done

# The farthest is drawn first; equal depths in the order of their indices.
pixel() { # X Y: the colour there, as three numbers
    tail -c $((3 * 8 * 8)) "$dir/p.ppm" | od -An -tu1 -v -w3 |
        sed -n "$((8 * $2 + $1 + 1))p" | tr -s ' '
}
overlap() { # DEPTHS of two triangles that cover everything: red, then blue
    {
        echo "pel2d 6 2"
        for k in "-9 -9" "30 -9" "-9 30"; do
            echo "$k 255 0 0 $1 0 0"
        done
        for k in "-9 -9" "30 -9" "-9 30"; do
            echo "$k 0 0 255 $2 0 0"
        done
        echo "0 1 2"
        echo "3 4 5"
    } | "$PEL" render - --size 8x8 --shade flat >"$dir/p.ppm"
    [ "$(pixel 3 3)" = "$3" ] || fail "depths $1 and $2: got$(pixel 3 3)"
}
overlap 1 2 " 255 0 0"
overlap 2 1 " 0 0 255"
overlap 1 1 " 0 0 255"
overlap 1e-30 2e-30 " 255 0 0"
overlap -2 -1 " 255 0 0"

# Three vertices on a line: nothing, or the line in the mean of their colours.
line="pel2d 3 1
1.5 1.5 30 0 0 0 0 0
6.5 6.5 30 0 0 0 0 0
3.5 3.5 30 0 90 0 0 0
0 1 2"
for shade in flat gouraud; do
    echo "$line" | "$PEL" render - --size 8x8 --shade $shade >"$dir/p.ppm"
    [ "$(pixel 4 4)" = " 255 255 255" ] || fail "$shade: a line by default"
    echo "$line" | "$PEL" render - --size 8x8 --shade $shade --collinear line \
        --background '#102030' >"$dir/p.ppm"
    [ "$(pixel 1 1)$(pixel 4 4)$(pixel 6 6)" = " 30 0 30 30 0 30 30 0 30" ] ||
        fail "$shade: no line"
    [ "$(pixel 4 5)$(pixel 7 7)" = " 16 32 48 16 32 48" ] ||
        fail "$shade: the line is too wide or too long"
done

# A texture on a pel2d file: texel floor(u (W - 1)), floor(v (H - 1)), here texel
# by pixel, nearest and bilinear, but for the last column and line.
printf 'P3\n9 7\n255\n' >"$dir/texture.ppm"
awk 'BEGIN { for (i = 0; i < 189; i++) print (i * 89 + i * i * 7) % 256 }' \
    >>"$dir/texture.ppm"
printf 'P3\n8 6\n255\n' >"$dir/part.ppm"
sed 1,3d "$dir/texture.ppm" | paste - - - |
    awk 'NR % 9 != 0 && NR <= 54' >>"$dir/part.ppm"
cat >"$dir/square.pel2d" <<'EOF'
pel2d 4 2
0 0 9 9 9 0 0 0
8 0 9 9 9 0 1 0
8 6 9 9 9 0 1 1
0 6 9 9 9 0 0 1
0 1 2
0 2 3
EOF
for texture in nearest bilinear; do
    for options in "" "--bands 1" "--jobs 3 --shade flat"; do
        "$PEL" render "$dir/square.pel2d" --size 8x6 $options -o "$dir/a.ppm" \
            --texture-file "$dir/texture.ppm" --texture $texture
        "$PEL" compare "$dir/a.ppm" "$dir/part.ppm" || fail "$texture $options"
    done
done
sed 's/ 1 0$/ 2 0/; s/ 1 1$/ 2 1/' "$dir/square.pel2d" |
    "$PEL" render - --size 8x6 --texture-file "$dir/texture.ppm" --wrap clamp \
        --texture nearest -o "$dir/p.ppm"
tail -c 144 "$dir/p.ppm" | od -An -tu1 -v -w3 | sed -n 5p | tr -s ' ' >"$dir/last"
sed 1,3d "$dir/texture.ppm" | paste -d' ' - - - | sed -n 9p | sed 's/^/ /' |
    cmp - "$dir/last" || fail "clamp: $(cat "$dir/last")"

refuse() { # MESSAGE OPTIONS...
    expected=$1
    shift
    status=0
    "$PEL" render "$@" -o "$dir/x.ppm" 2>"$dir/message" || status=$?
    [ $status -eq 2 ] || fail "render $*: status $status"
    grep -qF -e "pel: $expected" "$dir/message" ||
        fail "render $*: $(cat "$dir/message")"
    [ ! -e "$dir/x.ppm" ] || fail "render $*: output"
}
v=builtin:vase
refuse "--shade is 'fancy': expected flat|gouraud|phong" \
    $v --shade fancy
refuse "--format is 'rgb': expected rgb565_le, rgb565_be," $v --format rgb
refuse "--bands is '-1'" $v --bands -1
refuse "--bands is 12: expected a multiple of 8 for mono1_pages" \
    $v --bands 12 --format mono1_pages
refuse "--collinear is 'dot': expected nothing|line" $v --collinear dot
refuse "--size is '12': expected WxH" $v --size 12
refuse "--size is '0x5': expected WxH" $v --size 0x5
refuse "--size is '40000x5': expected WxH" $v --size 40000x5
refuse "--eye is '1,2': expected X,Y,Z" $v --eye 1,2
refuse "--target is '1,2,nan': expected X,Y,Z" $v --target 1,2,nan
refuse "up points along the view" $v --up 0,0,0
refuse "eye and target are one place" $v --eye 1,1,1 --target 1,1,1
refuse "--focal is '0': expected a length in mm" $v --focal 0
refuse "--sensor is '36': expected WxH in mm" $v --sensor 36
refuse "--background is 'red': expected #rrggbb" $v --background red
refuse "0 arguments: expected MESH"
refuse "2 arguments: expected MESH" a b
printf 'ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n' \
    >"$dir/point.ply"
printf 'property float y\nproperty float z\nend_header\n1 2 3\n' \
    >>"$dir/point.ply"
refuse "$dir/point.ply: a mesh file without triangles" "$dir/point.ply"
refuse "$dir/none.obj: cannot be read: No such file" "$dir/none.obj"
refuse "$dir/none.png: cannot be read: No such file" $v --texture-file "$dir/none.png"
for option in "focal 20" "order zbuffer" "mapping affine" "normals-from smooth" \
    print-camera; do
    refuse "$dir/vase.pel2d: is projected and lit already: --${option%% *} is for" \
        "$dir/vase.pel2d" --$option
done
refuse "$dir/vase.pel2d: names no texture" "$dir/vase.pel2d" --texture nearest
sed 's/ 1 1$/ 1e6 1/' "$dir/square.pel2d" >"$dir/far.pel2d"
refuse "vertex 2 lies at u v 1e+06 1: expected less than 2^23 texels" \
    "$dir/far.pel2d" --texture-file "$dir/c.ppm"
echo "pel2d 1 1" >"$dir/short.pel2d"
refuse "$dir/short.pel2d:2: the file ends here" "$dir/short.pel2d"

status=0
"$PEL" render $v --print-camera -o - >"$dir/out" 2>&1 || status=$?
[ $status -eq 2 ] && grep -q 'picture too: expected -o FILE' "$dir/out" ||
    fail "a picture among text"
status=0
"$PEL" render $v --print-camera >/dev/full 2>"$dir/message" || status=$?
[ $status -eq 2 ] || fail "no space for the camera: status $status"
