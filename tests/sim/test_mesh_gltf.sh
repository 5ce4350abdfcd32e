#!/bin/sh
# glTF 2.0: numbers of every type, textures, colours and nodes, as the
# specification has them; what pel does not have is refused by its name.
set -u
. "$(dirname "$0")/shows.sh"
"$PEL" info $field/pct.gltf 2>&1 | grep -q 'without jansson' && exit 0

quarters='ff0000:30,30 00ff00:70,30 0000ff:30,70 ffff00:70,70'
shows $field/g_tex_vc.gltf ff0000:30,30 00bc00:70,30 0000bc:30,70 ffbc00:70,70
shows $field/g_tt_off.gltf 00ff00:30,30 ff0000:70,30 ffff00:30,70 0000ff:70,70
# shellcheck disable=SC2086
shows $field/uvn8.gltf $quarters
# shellcheck disable=SC2086
shows $field/pct.gltf $quarters
shows $field/q_ushort.gltf ffffff:52,48 ffffff:73,27 000000:48,48 000000:76,40

# Khronos' test of KHR_texture_transform shows that all is passed: three ticks,
# and arrows that point at green ones.
model=${PEL_MODELS:-/usr/share/assimp/models}/glTF2/textureTransform/TextureTransformTest.gltf
[ ! -r "$model" ] ||
    shows "$model" 00c000:14,28 0000c0:50,28 00c0c0:80,28 000000:15,63 \
        ffffff:30,62 e0e0e0:33,55 ffffff:13,74 000000:47,60 ffffff:52,54 \
        e0e0e0:60,54 e0e0e0:40,74 000000:70,58 ffffff:81,60 e0e0e0:67,53

# A square from -1 to 1 in the forms that follow, each at a multiple of 64 bytes:
# 0 positions, floats; 1 uv; 2 indices 0 1 2 0 2 3 as 16 bits, and as 8 bits from
# byte 16, as 32 bits from 32; 3 uv of 8 bits, and of 16 from 16; 4 positions of
# -1 and 1 as 8 bits, 4 bytes each, as 16 bits, 8 bytes each, from 16; 5 colours
# 255, 128, 0 and alpha 128 as 8 bits, as 16 bits from 16; 6 those as floats
# without alpha; 7 deltas that move all by 1 to the right; 8 uv that are turned
# round; 9 two sparse indices of 16 bits, 2 and 3, and from 16 their positions
# (1, 0, 0), (-1, 0, 0); 10 positions 0 and 65,535 of 16 bits as 3 numbers.
o='\0\0\200\77' z='\0\0\0\0' m='\0\0\200\277' h='\0\0\0\77'
fill() { printf "%.0s$z" 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 |
    head -c "$1"; }
{
    printf "$m$m$z$o$m$z$o$o$z$m$o$z" && fill 16
    printf "$z$o$o$o$o$z$z$z" && fill 32
    printf '\0\0\1\0\2\0\0\0\2\0\3\0' && fill 4 && printf '\0\1\2\0\2\3' && fill 10
    printf "$z\1\0\0\0\2\0\0\0$z\2\0\0\0\3\0\0\0" && fill 8
    printf '\0\377\0\0\377\377\0\0\377\0\0\0\0\0\0\0'
    printf '\0\0\377\377\377\377\377\377\377\377\0\0\0\0\0\0' && fill 32
    printf '\377\377\0\0\1\377\0\0\1\1\0\0\377\1\0\0'
    printf '\377\377\377\377\0\0\0\0\1\0\377\377\0\0\0\0'
    printf '\1\0\1\0\0\0\0\0\377\377\1\0\0\0\0\0' && fill 16
    printf '%.0s\377\200\0\200' 1 2 3 4
    printf '%.0s\377\377\200\200\0\0\200\200' 1 2 3 4 && fill 16
    printf "%.0s$o$h$z" 1 2 3 4 && fill 16
    printf "%.0s$o$z$z" 1 2 3 4 && fill 16
    printf "$o$z$z$z$z$o$o$o" && fill 32
    printf '\2\0\3\0' && fill 12 && printf "$o$z$z$m$z$z" && fill 24
    printf '\0\0\0\0\0\0\377\377\0\0\0\0\377\377\377\377\0\0\0\0\377\377\0\0'
    fill 40
} >"$work/a.bin"
cp $field/t4.png "$work/t4.png"

# accessor BYTE TYPE COUNT KIND [MORE]
accessor() {
    printf '{"bufferView": %s, "byteOffset": %s, "type": "%s", "count": %s, "componentType": %s%s},\n' \
        $(($1 / 64)) $(($1 % 64)) "$2" "$3" "$4" "${5:-}"
}
{
    accessor 0 VEC3 4 5126                           # 0
    accessor 64 VEC2 4 5126                          # 1
    accessor 128 SCALAR 6 5123                       # 2
    accessor 144 SCALAR 6 5121                       # 3
    accessor 160 SCALAR 6 5125                       # 4
    accessor 192 VEC2 4 5121 ', "normalized": true'  # 5 (stride 4)
    accessor 208 VEC2 4 5123 ', "normalized": true'  # 6
    accessor 256 VEC3 4 5120                         # 7 (stride 4)
    accessor 272 VEC3 4 5122                         # 8 (stride 8)
    accessor 320 VEC4 4 5121 ', "normalized": true'  # 9
    accessor 336 VEC4 4 5123 ', "normalized": true'  # 10
    accessor 384 VEC3 4 5126                         # 11
    accessor 448 VEC3 4 5126                         # 12
    accessor 512 VEC2 4 5126                         # 13
    accessor 0 VEC3 4 5126 ', "sparse": {"count": 2, "indices": {"bufferView": 9, "componentType": 5123}, "values": {"bufferView": 9, "byteOffset": 16}}' # 14
    accessor 640 VEC3 4 5123 ', "normalized": true'  # 15
    accessor 320 VEC3 4 5121 ', "normalized": true'  # 16 (stride 4)
    accessor 0 VEC3 3 5126                           # 17
    accessor 0 MAT4 4 5121                           # 18
    accessor 128 SCALAR 6 5126                       # 19
} | sed 's/#.*//; $s/,$//' >"$work/accessors"
awk 'BEGIN { for (i = 0; i < 11; i++)
    printf "%s{\"buffer\": 0, \"byteOffset\": %d, \"byteLength\": 64%s}",
        i ? ", " : "", 64 * i, "" }' >"$work/views"
# As 3 and 4, but for their strides.
cat >>"$work/views" <<'END'
, {"buffer": 0, "byteOffset": 192, "byteLength": 64, "byteStride": 4}
, {"buffer": 0, "byteOffset": 256, "byteLength": 64, "byteStride": 4}
, {"buffer": 0, "byteOffset": 256, "byteLength": 64, "byteStride": 8}
, {"buffer": 0, "byteOffset": 320, "byteLength": 64, "byteStride": 4}
END
sed -i '6s/View": 3/View": 11/; 8s/View": 4/View": 12/; 9s/View": 4/View": 13/
    17s/View": 5/View": 14/' "$work/accessors"

# gltf ATTRIBUTES MATERIAL [PRIMITIVE] [NODE] [MESH] [FILE]
gltf() {
    cat >"$work/a.gltf" <<END
{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
 "nodes": [{"mesh": 0 ${4:-}}],
 "meshes": [{"primitives": [{"attributes": {$1}, "material": 0 ${3:-}}] ${5:-}}],
 "materials": [{$2}], "accessors": [$(cat "$work/accessors")],
 "images": [{"uri": "t4.png"}], "textures": [{"source": 0}],
 "buffers": [{"uri": "a.bin", "byteLength": 704}],
 "bufferViews": [$(cat "$work/views")] ${6:-}}
END
}
row() { # PLACES ARGUMENTS of gltf
    places=$1
    shift
    gltf "$@"
    # shellcheck disable=SC2086
    shows "$work/a.gltf" $places
    [ ! -s "$work/err" ] || fail "$*: $(cat "$work/err")"
}
red='"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1]}'
texture='"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}'
base='"baseColorTexture": {"index": 0'
whole='ff0000:26,26 ff0000:73,73 000000:24,30 000000:76,70'
quarter='ff0000:73,26 ff0000:51,48 000000:48,48 000000:49,20'
i=', "indices": 2'

# Indices and positions of every type.
row "$whole" '"POSITION": 0' "$red" "$i"
row "$whole" '"POSITION": 0' "$red" ', "indices": 3'
row "$whole" '"POSITION": 0' "$red" ', "indices": 4'
row "$whole" '"POSITION": 7' "$red" "$i"
row "$whole" '"POSITION": 8' "$red" "$i"
row "$quarter" '"POSITION": 15' "$red" "$i"
row 'ff0000:26,73 ff0000:73,73 000000:26,48 000000:73,48' \
    '"POSITION": 14' "$red" "$i"
row 'ff0000:70,70 000000:30,30' '"POSITION": 0' "$red" ', "mode": 4'
row 'ff0000:73,30 ff0000:50,72 000000:27,50' '"POSITION": 0' "$red" ', "mode": 5'
row "$whole" '"POSITION": 0' "$red" ', "mode": 6'

# Nodes: a move, a turn, a mirror, all in one; shapes at rest, the node's own.
row "$quarter" '"POSITION": 0' "$red" "$i" \
    ', "translation": [0.5, 0.5, 0], "scale": [0.5, 0.5, 1]'
row "$quarter" '"POSITION": 0' "$red" "$i" \
    ', "matrix": [0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1, 0, 0.5, 0.5, 0, 1]'
row 'ff0000:73,73 ff0000:51,51 000000:73,48' '"POSITION": 15' "$red" "$i" \
    ', "rotation": [0, 0, -0.70710678, 0.70710678]'
row "$quarter" '"POSITION": 15' "$red" "$i" \
    ', "scale": [-1, 1, 1], "translation": [1, 0, 0]'
morph="$i"', "targets": [{"POSITION": 12}]'
row 'ff0000:76,30 000000:48,30' '"POSITION": 0' "$red" "$morph" '' ', "weights": [1]'
row 'ff0000:52,30 000000:48,30' '"POSITION": 0' "$red" "$morph" \
    ', "weights": [1]' ', "weights": [0]'
row "$whole" '"POSITION": 0' "$red" "$morph"

# Texture coordinates of every type, of any set, moved by the extension.
for uv in 1 5 6; do
    row "$quarters" "\"POSITION\": 0, \"TEXCOORD_0\": $uv" "$texture" "$i"
done
both='"POSITION": 0, "TEXCOORD_0": 1, "TEXCOORD_1": 13'
round='ffff00:30,30 0000ff:70,30 00ff00:30,70 ff0000:70,70'
used=', "extensionsUsed": ["KHR_texture_transform", "KHR_materials_unlit", "KHR_mesh_quantization", "KHR_materials_emissive_strength"]'
row "$round" "$both" "\"pbrMetallicRoughness\": {$base, \"texCoord\": 1}}" "$i"
while read -r places transform; do
    row "$(echo "$places" | sed 's/;/ /g')" "$both" \
        "\"pbrMetallicRoughness\": {$base, \"extensions\": {\"KHR_texture_transform\": {$transform}}}}" \
        "$i" '' '' "$used"
done <<'END'
00ff00:30,30;ff0000:70,30 "offset": [0.5, 0]
0000ff:30,30;ff0000:30,70 "offset": [0, 0.5]
ff0000:30,30;ff0000:55,55;00ff00:45,30;0000ff:30,45 "scale": [2, 2]
00ff00:30,30;ffff00:30,70 "scale": [0.5, 1], "offset": [0.5, 0]
0000ff:30,30;ff0000:70,30;ffff00:30,70;00ff00:70,70 "rotation": 1.5707963
00ff00:30,30;ffff00:70,30;ff0000:30,70;0000ff:70,70 "rotation": -1.5707963
ffff00:30,30;0000ff:70,30 "rotation": 3.1415927, "offset": [1, 1]
ffff00:30,30;0000ff:70,30;00ff00:30,70;ff0000:70,70 "texCoord": 1
END

# Colours: the product of all, in light, and what shines.
color() { # COLOR COLORS MATERIAL: 0.5 is 188, 128 of 255 the byte 188
    row "$1:40,40 $1:60,60" "\"POSITION\": 0$2" "$3" "$i" '' '' "$used"
}
for c in 9 10 11 16; do
    color 'ffbc00~' ", \"COLOR_0\": $c" '"name": "white"'
    color 'bc8900~' ", \"COLOR_0\": $c" \
        '"pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.5, 0.5, 1]}'
    row 'ff0000:30,30 00bc00~:70,30 000000:30,70 ffbc00~:70,70' \
        "\"POSITION\": 0, \"TEXCOORD_0\": 1, \"COLOR_0\": $c" "$texture" "$i"
    row 'bc0000~:30,30 008900~:70,30 000000:30,70 bc8900~:70,70' \
        "\"POSITION\": 0, \"TEXCOORD_0\": 1, \"COLOR_0\": $c" \
        "\"pbrMetallicRoughness\": {$base}, \"baseColorFactor\": [0.5, 0.5, 0.5, 1]}" "$i"
done
color 'bc0000~' '' '"pbrMetallicRoughness": {"baseColorFactor": [0.5, 0, 0, 1]}'
color '00bcff~' '' '"pbrMetallicRoughness": {"baseColorFactor": [0, 0, 0, 1]}, "emissiveFactor": [0, 0.5, 1]'
color 'bcbc00~' '' '"pbrMetallicRoughness": {"baseColorFactor": [0.25, 0.5, 0, 1]}, "emissiveFactor": [0.25, 0, 0]'
color 'ff0000' '' '"pbrMetallicRoughness": {"baseColorFactor": [0, 0, 0, 1]}, "emissiveFactor": [0.5, 0, 0], "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 2}}'
shining='"emissiveTexture": {"index": 0}, "emissiveFactor": [0.5, 0.5, 0.5]'
row 'bc0000~:30,30 00bc00~:70,30 0000bc~:30,70 bcbc00~:70,70' "$both" \
    "\"pbrMetallicRoughness\": {\"baseColorFactor\": [0, 0, 0, 1]}, $shining" "$i"
row 'ff0000:30,30 00ff00:70,30 0000ff:30,70 ffff00:70,70' "$both" \
    "\"pbrMetallicRoughness\": {$base}, \"baseColorFactor\": [0.5, 0.5, 0.5, 1]}, $shining" "$i"
gltf "$both" "\"pbrMetallicRoughness\": {$base}}, \"emissiveTexture\": {\"index\": 0, \"texCoord\": 1}, \"emissiveFactor\": [1, 1, 1]" "$i"
# shellcheck disable=SC2086
shows "$work/a.gltf" $quarters
told "the emissive texture of '' does not lie as its other one and is left out"

# Colours that vary over a texture: at the corners 000, 100, 110, 010; linear
# between them, .11 and .89 red, .91 and .09 green at these places, times the
# texels, all as light.
vary='"POSITION": 0, "TEXCOORD_0": 1, "COLOR_0": 15'
row '5d0000~:30,30 00f200~:70,30 000000:30,70 f55500~:70,70' "$vary" "$texture" "$i"
row '2e0000~:30,30 008200~:70,30 000000:30,70 832900~:70,70' "$vary" \
    "\"pbrMetallicRoughness\": {$base}, \"baseColorFactor\": [0.25, 0.25, 0.25, 1]}" "$i"
row '070000~:30,30 002400~:70,30 000000:30,70 250600~:70,70' "$vary" \
    "\"pbrMetallicRoughness\": {$base}, \"baseColorFactor\": [0.02, 0.02, 0.02, 1]}" "$i"
# What shines is added behind that: by a factor, and a texture of its own; with
# and without another one; in either mapping.
row 'a28989~:30,30 89ff89~:70,30 898989~:30,70 ff9e89~:70,70' "$vary" \
    "$texture, \"emissiveFactor\": [0.25, 0.25, 0.25]" "$i"
row 'c00000~:30,30 00dd00~:70,30 0000bc~:30,70 debf00~:70,70' "$vary" \
    "\"pbrMetallicRoughness\": {$base}, \"baseColorFactor\": [0.25, 0.25, 0.25, 1]}, $shining" "$i"
"$PEL" render "$work/a.gltf" --size 100x100 --unlit --texture nearest \
    --eye 0,0,5 --target 0,0,0 --projection orthographic --sensor 4x4 \
    --background '#000000' --mapping affine -o "$work/affine.ppm"
cmp "$work/shows.ppm" "$work/affine.ppm" || fail 'what shines lies elsewhere'
"$PEL" import "$work/a.gltf" --format xrgb8888 -o - >"$work/a.c" 2>"$work/err" ||
    fail "import of varying colours: $(cat "$work/err")"
told 'multiply texture 1, which is written as it is'
grep -q '0, 225, 255' "$work/a.c" || fail 'what shines is not in the texture'
row 'cdf200~:30,30 f5ff00~:70,30 5d55bc~:30,70 ffca00~:70,70' "$vary" \
    "\"emissiveTexture\": {\"index\": 0}, \"emissiveFactor\": [0.5, 0.5, 0.5]" "$i"

# What is below the cutoff is not there, with a texture and without one: red is a
# quarter before a square that is cut out, or not where it shows a colour.
masked() { # COLOR ATTRIBUTES MATERIAL
    row "ff0000:73,26 $1:30,30" '"POSITION": 15' \
        "$red}, {\"alphaMode\": \"MASK\", $3" \
        "$i}, {\"attributes\": {\"POSITION\": 0, \"TEXCOORD_0\": 1 $2}, \"material\": 1 $i"
}
pale='"pbrMetallicRoughness": {"baseColorFactor": [0, 0, 1, 0.1]}'
masked 000000 '' "$pale"
masked 0000ff '' "$pale, \"alphaCutoff\": 0.05"
masked 000000 '' '"alphaCutoff": 2'
masked ffffff '' '"alphaCutoff": 1'
masked 000000 '' "$texture, \"alphaCutoff\": 2"
masked ff0000 '' "$texture, \"alphaCutoff\": 1"
masked 000000 ', "COLOR_0": 9' '"alphaCutoff": 0.6'
masked ffbc00~ ', "COLOR_0": 9' '"alphaCutoff": 0.4'
gltf '"POSITION": 0' "\"alphaMode\": \"MASK\", $pale" "$i"
refused_command "a.gltf: shows nothing: expected an alpha that is not below alphaCutoff" \
    info "$work/a.gltf"

# Without light where all is unlit, in the light where not.
unlit='"extensions": {"KHR_materials_unlit": {}}'
gltf '"POSITION": 0' "$red" "$i"
"$PEL" render "$work/a.gltf" --size 9x9 --sensor 1x1 --eye 0,0,5 --target 0,0,0 \
    -o "$work/lit.ppm"
gltf '"POSITION": 0' "$red, $unlit" "$i" '' '' "$used"
"$PEL" render "$work/a.gltf" --size 9x9 --sensor 1x1 --eye 0,0,5 --target 0,0,0 \
    -o "$work/unlit.ppm"
[ "$(tail -c 123 "$work/unlit.ppm" | od -An -tu1 -N3)" = " 255   0   0" ] ||
    fail "an unlit material is in the light"
if cmp -s "$work/lit.ppm" "$work/unlit.ppm"; then
    fail "a material is not in the light"
fi

# An asset holds the product; a message names what is left out.
gltf '"POSITION": 0, "TEXCOORD_0": 13, "COLOR_0": 9' "$texture" "$i"
"$PEL" import "$work/a.gltf" --name a -o - | tr -d ' \n' |
    grep -q 'colors.4..3.={{0,188,0},{255,0,0},{0,0,0},{255,188,0},}' ||
    fail "no product: $("$PEL" import "$work/a.gltf" --name a -o - | grep -A3 colors)"
gltf '"POSITION": 0' "$red" "$i" '' '' \
    ', "extensionsUsed": ["KHR_materials_clearcoat", "EXT_x"]'
shows "$work/a.gltf" ff0000:40,40
told "uses KHR_materials_clearcoat, EXT_x: left out"

# Refused, each with its reason.
refused() { # TEXT ARGUMENTS of gltf
    text=$1
    shift
    gltf "$@"
    refused_command "a.gltf: $text" info "$work/a.gltf"
    [ "$(wc -l <"$work/err")" = 1 ] || fail "more than a line: $(cat "$work/err")"
}
for name in KHR_draco_mesh_compression EXT_meshopt_compression KHR_texture_basisu; do
    refused "requires the extension $name, which pel does not have" \
        '"POSITION": 0' "$red" "$i" '' '' ", \"extensionsRequired\": [\"$name\"]"
done
refused "meshes[0].primitives[0]: index 3 is out of range: the primitive has 3 vertices" \
    '"POSITION": 17' "$red" "$i"
refused "meshes[0].primitives[0]: a primitive has no POSITION" '"NORMAL": 0' "$red" "$i"
refused "nodes[0]: 'translation' is [1,\"a\",0]: expected an array of 3 numbers" \
    '"POSITION": 0' "$red" "$i" ', "translation": [1, "a", 0]'
refused "an index of 'textures' is missing: expected one" '"POSITION": 0' \
    '"pbrMetallicRoughness": {"baseColorTexture": {}}' "$i"
refused "accessors[99] is not there: expected an object" '"POSITION": 99' "$red" "$i"
refused "materials[7] is not there" '"POSITION": 0' "$red" "$i, \"material\": 7"
refused "meshes[0].primitives[0].attributes: POSITION has 2 numbers: expected 3" '"POSITION": 1' "$red" "$i"
refused "meshes[0].primitives[0].attributes: COLOR_0 has 2 numbers: expected 3 or 4" '"POSITION": 0, "COLOR_0": 1' "$red" "$i"
refused "meshes[0].primitives[0].attributes: NORMAL has 3 elements: expected 4 as POSITION has" \
    '"POSITION": 0, "NORMAL": 17' "$red" "$i"
refused "materials[0].pbrMetallicRoughness.baseColorTexture: 'index' is -1: expected a whole number from 0 on" '"POSITION": 0' \
    '"pbrMetallicRoughness": {"baseColorTexture": {"index": -1}}' "$i"
refused "materials[0].pbrMetallicRoughness: 'baseColorFactor' is [1,0,0]: expected an array of 4 numbers" '"POSITION": 0' \
    '"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0]}' "$i"
refused "materials[0]: 'pbrMetallicRoughness' is 5: expected an object" '"POSITION": 0' \
    '"pbrMetallicRoughness": 5' "$i"
refused "nodes[0] of the scene is a child, or there twice: expected a root, once" \
    '"POSITION": 0' "$red" "$i" ', "children": [0]'
refused "nodes[0]: 'children' is 1: expected an array" '"POSITION": 0' "$red" "$i" ', "children": 1'
refused "meshes[0].primitives[0]: a primitive has the mode 7: expected 0 to 6" '"POSITION": 0' "$red" ', "mode": 7'
refused "meshes[0].primitives[0]: 'mode' is -1: expected a whole number from 0 on" \
    '"POSITION": 0' "$red" ', "mode": -1'
for of in 1 5 19; do
    refused "accessors[$of] has no indices: expected SCALAR of componentType 5121, 5123 or 5125" \
        '"POSITION": 0' "$red" ", \"indices\": $of"
done
refused "meshes[0].primitives[0]: 'targets' is 1: expected an array" '"POSITION": 0' "$red" "$i, \"targets\": 1"
gltf '"POSITION": 0' "$red" ', "mode": 1'
refused_command "a.gltf: a mesh file without triangles" info "$work/a.gltf"
grep -q "0 points and 2 lines are left out" "$work/err" || fail "no lines told"
refused "meshes[0].primitives[0].attributes: COLOR_0 has 16 numbers: expected 3 or 4" \
    '"POSITION": 0, "COLOR_0": 18' "$red" "$i"

# What is changed in a file that is read: refused, or shown.
changed() { # SED TEXT ARGUMENTS of gltf
    script=$1 text=$2
    shift 2
    gltf "$@"
    sed -i "$script" "$work/a.gltf"
    refused_command "a.gltf: $text" info "$work/a.gltf"
    [ "$(wc -l <"$work/err")" = 1 ] || fail "more than a line: $(cat "$work/err")"
}
inside='s/"uri": "t4.png"/"bufferView": 0, "mimeType": "image\/png"/'
both='"POSITION": 0, "TEXCOORD_0": 1'
for view in '"byteLength": -1' '"byteLength": 0.5' '"byteOffset": -64'; do
    changed "$inside; s/\(\"byteOffset\": 0, \)\(\"byteLength\": 64\)/\1$view/" \
        "bufferViews[0]: $(echo "$view" | sed "s/\"/'/g; s/:/ is/"): expected a whole number from 0 on" \
        "$both" "$texture" "$i"
done

changed 's/"sparse": {"count": 2/"sparse": {"count": 5/' \
    'accessors[14].sparse: a sparse accessor has 5 elements: expected 1 to 4' \
    '"POSITION": 14' "$red" "$i"
changed 's/"bufferView": 9, "componentType": 5123/"bufferView": 9, "componentType": 5126/' \
    'accessors[14].sparse: a sparse accessor has indices of componentType 5126: expected 5121, 5123 or 5125' \
    '"POSITION": 14' "$red" "$i"
changed 's/"bufferView": 9, "componentType": 5123/"bufferView": 0, "componentType": 5123/' \
    'accessors[14].sparse: a sparse accessor has the index 49024: expected less than 4' \
    '"POSITION": 14' "$red" "$i"

changed 's/"count": 6/"count": 268435456/' \
    'bytes 0 to 536870912 leave bufferViews[2]: expected 64 at most' \
    '"POSITION": 0' "$red" "$i"

# nodes HOW COUNT: that many, of which each is HOW often below the one before.
nodes() {
    gltf '"POSITION": 0' "$red" "$i" "$(awk -v how="$1" -v count="$2" 'BEGIN {
        for (i = 1; i < count; i++)
            printf ", \"children\": [%s%d]}, {\"name\": \"\"",
                how == 2 ? i ", " : "", i }')"
}
deep() { # TEXT ARGUMENTS of nodes
    text=$1
    shift
    nodes "$@"
    refused_command "a.gltf: $text" info "$work/a.gltf" --limit 2,500
}
nodes 1 1001
# shellcheck disable=SC2086
shows "$work/a.gltf" $whole
deep 'nodes[1001] has more than 1000 nodes above it, or is below itself: expected no more' 1 60000
deep 'nodes[1] is a child of nodes[0] and of nodes[0]: expected one parent' 2 40
# A skin whose joints go in a circle.
gltf '"POSITION": 0, "JOINTS_0": 9, "WEIGHTS_0": 9' "$red" "$i" \
    ', "skin": 0}, {"children": [2]}, {"children": [1]' '' \
    ', "skins": [{"joints": [2]}]'
refused_command 'a.gltf: nodes[2] has more than 1000 nodes above it' info "$work/a.gltf"

# A % of a name is no code without two digits, also at its end.
cp "$work/a.bin" "$work/a%5"
cp "$work/t4.png" "$work/t%5g.png"
gltf "$both" "$texture" "$i"
sed -i 's/"a.bin"/"a%5"/; s/t4.png/t%5g.png/' "$work/a.gltf"
# shellcheck disable=SC2086
shows "$work/a.gltf" $quarters

printf '{"asset": {"version": "2.0"}, ' >"$work/a.gltf"
refused_command "a.gltf: line 1: no JSON" info "$work/a.gltf"
gltf '"POSITION": 0' "$red" "$i"
head -c 700 "$work/a.bin" >"$work/b.bin" && mv "$work/b.bin" "$work/a.bin"
refused_command "a.gltf: buffers[0] has 700 bytes: expected 704" info "$work/a.gltf"
rm "$work/a.bin"
refused_command "a.gltf: its buffer $work/a.bin cannot be read: No such file or directory" info "$work/a.gltf"

[ -e "$work/failed" ] || echo "glTF is read as its specification has it"
