#!/bin/sh
# Materials of mesh files: what each part shows, and what pel info tells.
set -u
. "$(dirname "$0")/lib.sh"
dir=$work

# A square; four texels, from the top: red of alpha 0, green of 100, blue of 200,
# white of 255.
make_square "$dir"
tga='\0\0\2\0\0\0\0\0\0\0\0\0\2\0\2\0\40\50'
printf "$tga\0\0\377\0\0\377\0\144\377\0\0\310\377\377\377\377" >"$dir/four.tga"

# square MATERIAL [NODE]: the file of a yellow square behind one of the material.
square() {
    cat >"$dir/two.gltf" <<END
{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
 "nodes": [{"mesh": 0, "translation": [0, 0, -1]}, {"mesh": 1 $2}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 2,
                             "material": 0}]},
            {"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1},
                             "indices": 2, "material": 1}]}],
 "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [1, 1, 0, 1]}},
               {"name": "front", $1}],
 "textures": [{"source": 0, "sampler": 0}], "images": [{"uri": "four.tga"}],
 "samplers": [{"wrapS": 33071, "wrapT": 33648}],
 $square_lists}
END
}

# shows PIXELS OPTIONS...: the four pixels of the file, red, green, blue each.
shows() {
    want=$1
    shift
    "$PEL" render "$dir/two.gltf" --size 2x2 --projection orthographic \
        --sensor 1x1 --eye 0.5,0.5,4 --target 0.5,0.5,0 --texture nearest \
        --unlit "$@" -o "$dir/two.ppm" || fail "refused: $*"
    got=$(tail -c 12 "$dir/two.ppm" | od -An -v -tu1 | tr -s ' \n' ' ')
    [ "$got" = " $want " ] || fail "$name $*: $got, not $want"
}

texture='"baseColorTexture": {"index": 0}'
while read -r name pixels material; do
    square "$material" ""
    for order in painter zbuffer; do
        shows "$(echo "$pixels" | tr , ' ')" --order $order
    done
done <<END
opaque 255,0,0,0,255,0,0,0,255,255,255,255 "pbrMetallicRoughness": {$texture}
half 255,255,0,255,255,0,0,0,255,255,255,255 "alphaMode": "MASK", "pbrMetallicRoughness": {$texture}
low 255,255,0,0,255,0,0,0,255,255,255,255 "alphaMode": "MASK", "alphaCutoff": 0.39, "pbrMetallicRoughness": {$texture}
high 255,255,0,255,255,0,255,255,0,255,255,255 "alphaMode": "MASK", "alphaCutoff": 0.8, "pbrMetallicRoughness": {$texture}
dim 255,255,0,255,255,0,255,255,0,255,255,255 "alphaMode": "MASK", "pbrMetallicRoughness": {"baseColorFactor": [1, 1, 1, 0.6], $texture}
blend 255,255,0,155,255,0,55,55,200,255,255,255 "alphaMode": "BLEND", "pbrMetallicRoughness": {$texture}
tint 188,0,0,0,255,0,0,0,255,188,255,255 "pbrMetallicRoughness": {"baseColorFactor": [0.5, 1, 1, 1], $texture}
color 188,0,188,188,0,188,188,0,188,188,0,188 "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0, 0.5, 0.5]}
glass 221,127,94,221,127,94,221,127,94,221,127,94 "alphaMode": "BLEND", "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0, 0.5, 0.5]}
END

# Between texels alpha is mixed, and then cut.
name=linear
square "\"alphaMode\": \"MASK\", \"pbrMetallicRoughness\": {$texture}" ""
"$PEL" info "$dir/two.gltf" >"$dir/info" || fail "info refused"
for line in "parts: 2, triangles: 4, vertices: 8, normals: made" \
    "box: x 0 to 1, y 0 to 1, z -1 to 0" "part 1: 2 triangles, '', #ffff00" \
    "part 2: 2 triangles, 'front', #ffffff, texture 1 (clamp, mirror), cut out below alpha 128" \
    "texture 1: 2 x 2, $dir/four.tga"; do
    grep -qxF "$line" "$dir/info" || fail "no '$line' in: $(cat "$dir/info")"
done

# A node that mirrors keeps the front in front; without its texture a part has
# its own colour, and info and a message say so.
name=mirror
square "\"pbrMetallicRoughness\": {$texture}" \
    ', "scale": [-1, 1, 1], "translation": [1, 0, 0]'
shows "0 255 0 255 0 0 255 255 255 0 0 255" --cull back
rm "$dir/four.tga"
shows "255 255 255 255 255 255 255 255 255 255 255 255" 2>"$dir/err"
grep -q "its texture $dir/four.tga is left out" "$dir/err" || fail "no message"
"$PEL" info "$dir/two.gltf" 2>/dev/null | grep -q "texture 1: missing" ||
    fail "info knows no missing texture"
refused_command "lacks a texture that --format writes" import "$dir/two.gltf" \
    --format rgb888 -o "$dir/two.c"

# Light on both sides: of a sheet seen from behind the ambient part, or all of it.
cat >"$dir/sheet.obj" <<'END'
v 0 0 0
v 0 1 0
v 1 1 0
v 1 0 0
f 1 2 3 4
f 1 1 2
END
"$PEL" info "$dir/sheet.obj" | grep -qx "not seen: 1 triangles without area" ||
    fail "info knows no triangle without area"
for row in front:77 both:255; do
    for shade in flat gouraud phong; do
        "$PEL" render "$dir/sheet.obj" --size 8x8 --projection orthographic \
            --sensor 1x1 --eye 0.5,0.5,4 --target 0.5,0.5,0 --color '#ffffff' \
            --sun 0,0,1:1,1,1 --ks 0 --shade $shade --light-sides "${row%:*}" \
            -o "$dir/sheet.ppm"
        got=$(tail -c 3 "$dir/sheet.ppm" | od -An -tu1 | tr -s ' ')
        level=${row#*:}
        [ "$got" = " $level $level $level" ] || fail "$row $shade: $got"
    done
done

# Flat triangles have their own normals, whatever the mesh has; an edge that is
# no crease is smooth.
for crease in 1 80 100; do
    for shade in flat phong; do
        "$PEL" render builtin:vase-small --size 90x90 --shade $shade \
            --sun 1,1,1:1,1,1 --crease $crease -o "$dir/$shade$crease.ppm"
    done
done
cmp "$dir/flat1.ppm" "$dir/flat100.ppm" || fail "flat light is of the vertices"
if "$PEL" compare "$dir/phong1.ppm" "$dir/phong80.ppm" >/dev/null; then
    fail "--crease 1 is no crease"
fi
