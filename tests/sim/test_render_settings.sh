#!/bin/sh
# pel render, look by look: a texture texel by pixel, wrap modes, lights from
# where they are, terms that add up, depth buffers, bands of every look; and
# what is refused. assimp reads the square, so it has to be there.
set -eu
. "$(dirname "$0")/lib.sh"
dir=$work

render() { # OUTPUT OPTIONS...
    out=$1
    shift
    "$PEL" render "$@" -o "$dir/$out.ppm"
}

same() { # NAME NAME WHAT
    "$PEL" compare "$dir/$1.ppm" "$dir/$2.ppm" || fail "$3"
}

differ() { # NAME NAME WHAT
    if "$PEL" compare "$dir/$1.ppm" "$dir/$2.ppm" >/dev/null; then
        fail "$3"
    fi
}

# bytes NAME: those of the pixels, a number a line.
bytes() {
    size=$(sed -n 2p "$dir/$1.ppm" | awk '{ print 3 * $1 * $2 }')
    tail -c "$size" "$dir/$1.ppm" | od -An -v -tu1 -w1
}

# A square of 8 by 6 units that faces the viewer, with a picture of 8 by 6.
printf 'P3\n8 6\n255\n' >"$dir/texture.ppm"
awk 'BEGIN { for (i = 0; i < 144; i++) print (i * 89 + i * i * 7) % 256 }' \
    >>"$dir/texture.ppm"
square() { # UV: how often the picture lies on it
    cat <<EOF
v -4 -3 0
v 4 -3 0
v 4 3 0
v -4 3 0
vt 0 0
vt $1 0
vt $1 $1
vt 0 $1
f 1/1 2/2 3/3
f 1/1 3/3 4/4
EOF
}
square 1 >"$dir/one.obj"
square 2 >"$dir/two.obj"
view='--projection orthographic --sensor 8x6 --eye 0,0,5 --target 0,0,0'
tile="$view --size 8x6 --unlit --texture-file $dir/texture.ppm"
for mapping in affine subdivided perspective; do
    for texture in nearest bilinear; do
        for order in painter zbuffer16 zbuffer32; do
            render a "$dir/one.obj" $tile --mapping $mapping \
                --texture $texture --order $order
            same a texture "$mapping $texture $order is not the picture"
        done
    done
done

# Twice each way on 16 by 12 pixels. Of wrap modes, the upper left quarter shows
# what lies where v is 1 to 2 and u 0 to 1: v runs up in the file.
quarter() { # NAME X Y: 8 by 6 pixels from there, as P3
    printf 'P3\n8 6\n255\n'
    bytes "$1" | awk -v x="$2" -v y="$3" '{ p = int((NR - 1) / 3)
        if (p % 16 >= x && p % 16 < x + 8 && int(p / 16) >= y &&
            int(p / 16) < y + 6) print }'
}
tile="$view --size 16x12 --unlit --texture-file $dir/texture.ppm"
tile="$tile --texture nearest"
render repeat "$dir/two.obj" $tile --wrap repeat
render mirror "$dir/two.obj" $tile --wrap mirror
render clamp "$dir/two.obj" $tile --wrap clamp
render plain "$dir/two.obj" $tile
same plain repeat "repeat is not the default"
for place in "0 0" "8 0" "0 6" "8 6"; do
    quarter repeat $place >"$dir/q.ppm"
    same q texture "repeat: quarter at $place"
done
quarter mirror 0 6 >"$dir/q.ppm"
same q texture "mirror: the picture itself"
quarter mirror 8 0 >"$dir/q.ppm"
{
    printf 'P3\n8 6\n255\n'
    sed 1,3d "$dir/texture.ppm" | paste - - - | sed '1!G;h;$!d'
} >"$dir/turned.ppm"
same q turned "mirror: turned round both ways"
quarter clamp 0 6 >"$dir/q.ppm"
same q texture "clamp: the picture itself"
quarter clamp 8 0 >"$dir/q.ppm"
{
    printf 'P3\n8 6\n255\n'
    for i in $(seq 48); do
        sed 1,3d "$dir/texture.ppm" | paste - - - | sed -n 8p
    done
} >"$dir/corner.ppm"
same q corner "clamp: the upper right texel"

# 36 times 1,024 texels, four bands of them: pixels lie 2.25 pictures apart, in
# the middles of bands. The same 100 pictures away; much farther is refused.
{
    printf 'P3\n1024 1\n255\n'
    awk 'BEGIN { for (i = 0; i < 3072; i++) print int(i / 768) * 80 }'
} >"$dir/bands.ppm"
square 36 >"$dir/far0.obj"
square 36 | awk '$1 == "vt" { $2 += 100; $3 -= 100 } { print }' >"$dir/far1.obj"
for mapping in affine "subdivided --span 8" perspective; do
    for texture in nearest bilinear; do
        for mesh in far0 far1; do
            for wrap in repeat mirror; do
                render far "$dir/$mesh.obj" $view --size 16x2 --unlit \
                    --texture-file "$dir/bands.ppm" --wrap $wrap \
                    --mapping $mapping --texture $texture
                bytes far | awk -v w=$wrap '{ u = 1.125 + 2.25 * (int((NR - 1) / 3) % 16)
                    want = int(4 * (u % 1))
                    if (w == "mirror" && int(u) % 2) want = 3 - want
                    if ($1 != 80 * want) exit 1 }' ||
                    fail "$mesh.obj: $mapping $texture $wrap"
            done
        done
    done
done

square 9999 >"$dir/far0.obj"
status=0
render farther "$dir/far0.obj" $view --texture-file "$dir/bands.ppm" 2>"$dir/message" ||
    status=$?
[ $status -eq 2 ] && grep -q 'beyond 262144 texels of 1024x1:' \
    "$dir/message" || fail "too far: $(cat "$dir/message")"

# Turned round, the back is seen, mirrored; culled, nothing.
tile="$view --size 8x6 --unlit --texture none --color #204060"
render front "$dir/one.obj" $tile
render back "$dir/one.obj" $tile --turn 0,0.5,0
same front back "the back of the square"
render empty "$dir/one.obj" $tile --transparency 255
render back "$dir/one.obj" $tile --turn 0,0.5,0 --cull back
same empty back "the back is not culled"
render back "$dir/one.obj" $tile --cull front
same empty back "the front is not culled"
for order in painter zbuffer16 zbuffer32; do
    render back "$dir/one.obj" $tile --turn 0,0.5,0 --cull front --order $order
    same front back "$order: the back is culled with the front"
done
render front2 "$dir/one.obj" $tile --cull back
same front front2 "the front is culled"
render half "$dir/one.obj" $tile --transparency 128
[ "$(bytes half | head -3 | tr -s '\n ' ' ')" = " 144 160 176 " ] ||
    fail "half transparent: $(bytes half | head -3 | tr '\n' ' ')"

# Two squares through each other, red and blue: halves of each are seen, and the
# depth buffer, whole or in bands, finds the same line.
cat >"$dir/cross.ply" <<'EOF'
ply
format ascii 1.0
element vertex 8
property float x
property float y
property float z
property uchar red
property uchar green
property uchar blue
element face 4
property list uchar int vertex_indices
end_header
-4 -3 1 255 0 0
4 -3 -1 255 0 0
4 3 -1 255 0 0
-4 3 1 255 0 0
-4 -3 -1 0 0 255
4 -3 1 0 0 255
4 3 1 0 0 255
-4 3 -1 0 0 255
3 0 1 2
3 0 2 3
3 4 5 6
3 4 6 7
EOF
for order in zbuffer zbuffer16 zbuffer32; do
    for rows in 0 1 5; do
        render z "$dir/cross.ply" $view --size 8x6 --order $order --bands $rows
        bytes z | awk '{ p = int((NR - 1) / 3) % 8
            want = (NR % 3 == 1 && p < 4) || (NR % 3 == 0 && p >= 4) ? 255 : 0
            if ($1 != want) exit 1 }' || fail "$order, bands of $rows"
    done
done

# Seen through: two squares as above with a texture of 4 by 2 texels, the left
# ones red, the right ones blue, the upper right one half transparent. What is
# opaque is nearest; after that, the rest is blended.
cat >"$dir/panes.obj" <<'EOF'
v -4 -3 1
v 4 -3 -1
v 4 3 -1
v -4 3 1
v -4 -3 -1
v 4 -3 1
v 4 3 1
v -4 3 -1
vt 0 0
vt 0.5 0
vt 0.5 1
vt 0 1
vt 1 0
vt 1 1
f 5/2 6/5 7/6
f 5/2 7/6 8/3
f 1/1 2/2 3/3
f 1/1 3/3 4/4
EOF
red='\0\0\377\377' blue='\377\0\0\377' pane='\377\0\0\200'
{
    printf '\0\0\2\0\0\0\0\0\0\0\0\0\4\0\2\0\40\50'
    printf "$red$red$blue$pane$red$red$blue$blue"
} >"$dir/panes.tga"
if "$PEL" import "$dir/panes.tga" -o "$dir/panes.c" 2>/dev/null; then
    for order in zbuffer16 zbuffer32; do
        for mapping in affine perspective; do
            render z "$dir/panes.obj" $view --size 8x6 --order $order \
                --unlit --texture-file "$dir/panes.tga" --texture nearest \
                --mapping $mapping --bands 4
            bytes z | paste - - - | awk '{ right = (NR - 1) % 8 >= 4
                want = !right ? "255 0 0" : NR > 24 ? "0 0 255" : "127 0 128"
                if ($1 + 0 " " $2 + 0 " " $3 + 0 != want) exit 1 }' ||
                fail "panes: $order $mapping"
        done
    done
fi

# side NAME: 1 when the left half is brighter, -1 when the right one is.
side() {
    bytes "$1" | awk '{ s[int((NR - 1) / 3) % 60 < 30] += $1 }
        END { print (s[1] > s[0]) - (s[1] < s[0]) }'
}
look='--size 60x60 --color #c0c0c0 --background #000000 --eye 0,1,8'
look="$look --target 0,1,0"
for shade in flat gouraud phong; do
    render l builtin:vase $look --shade $shade --light -9,1,3:1,1,1
    render r builtin:vase $look --shade $shade --sun 9,1,3:1,1,1
    [ "$(side l) $(side r)" = "1 -1" ] || fail "$shade: lights from the side"
    render own builtin:vase $look --shade $shade
    [ "$(side own)" = 1 ] || fail "$shade: the default light"
    render far builtin:vase $look --shade $shade --light 9e6,1e6,3e6:1,1,1
    "$PEL" compare --tolerance 1 "$dir/r.ppm" "$dir/far.ppm" ||
        fail "$shade: a far light is not a sun"
done

# Terms add up, but for rounding, and but for what is clamped: nothing here.
light='--light -5,4,6:0.9,0.6,0.3 --light 6,2,1:0.2,0.5,0.8'
light="$light --ambient 0.5,1,0.7 --ka 0.2 --kd 0.4 --ks 0.2 --shininess 9"
for shade in flat gouraud phong; do
    for term in ambient diffuse specular ambient,diffuse,specular; do
        render $term builtin:vase $look --shade $shade $light --terms $term
        bytes $term >"$dir/$term.bytes"
    done
    render all builtin:vase $look --shade $shade $light
    same all ambient,diffuse,specular "$shade: all terms are the default"
    paste "$dir/ambient.bytes" "$dir/diffuse.bytes" "$dir/specular.bytes" \
        "$dir/ambient,diffuse,specular.bytes" |
        awk '{ d = $1 + $2 + $3 - $4; if (d < -3 || d > 3) exit 1 }' ||
        fail "$shade: the terms do not add up"
done

# Highlights: in the colour of the surface, or plain; on the back, or not.
red='--size 60x60 --color #ff0000 --background #000000 --terms specular'
render coloured builtin:vase $red --sun 0,1,1:1,1,1
render plain builtin:vase $red --sun 0,1,1:1,1,1 --highlights plain
bytes coloured | awk 'NR % 3 != 1 && $1 > 0 { exit 1 }' ||
    fail "coloured highlights are not"
bytes plain | awk 'NR % 3 != 1 { s += $1 } END { exit s > 0 ? 0 : 1 }' ||
    fail "plain highlights are not"
render on builtin:vase $red --sun 0,-1,-1:1,1,1 --shininess 1
render off builtin:vase $red --sun 0,-1,-1:1,1,1 --shininess 1 \
    --back-highlights off
differ on off "highlights on the back"

# Smooth normals, of the faces around, and those of the file: one mesh with wrong ones.
sed 's/^f .*//' "$dir/one.obj" >"$dir/normals.obj"
printf 'vn 1 0 0\nf 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/3/1 4/4/1\n' \
    >>"$dir/normals.obj"
light="$view --size 8x6 --sun 0,0,1:1,1,1 --ka 0 --ks 0 --kd 1 --color #ffffff"
render file "$dir/normals.obj" $light
render smooth "$dir/normals.obj" $light --normals-from smooth
[ "$(bytes file | sort -u | tr -d ' ') $(bytes smooth | sort -u)" = "0  255" ] ||
    fail "normals from file or smooth"

# From inside a closed mesh nothing of the background is seen, whatever the near
# plane and the picture's sides cut.
for target in 1,0,0 -1,0.1,0 0,0,1 0,0,-1 0.1,9,0.2 0.1,-9,0.2; do
    for look in "--shade flat" "--shade phong --ks 0 --order zbuffer16"; do
        for near in 0.2 0.0001; do
            render inside builtin:vase --size 90x70 --eye 0.3,0.7,-0.2 \
                --target $target --sensor 100x78 --near $near $look \
                --color '#808080' --background '#ff00ff'
            bytes inside | paste - - - | awk '$1 == 255 && $2 == 0 { exit 1 }' ||
                fail "a crack: $target $look, near plane $near"
        done
    done
done

# Every look: bands and threads change nothing.
for shade in flat gouraud phong; do
    for texture in "none" "nearest --mapping vertices" \
        "nearest --mapping affine" "bilinear --mapping subdivided --span 8" \
        "bilinear --mapping perspective"; do
        for order in painter zbuffer16 zbuffer32; do
            look="--size 90x70 --shade $shade --texture $texture --order $order"
            look="$look --texture-file $dir/texture.ppm --eye 1,2,3"
            case $texture in none) look=${look%--texture-file*} ;; esac
            render a builtin:vase $look --light 1,3,4:1,1,1
            render b builtin:vase $look --light 1,3,4:1,1,1 --bands 13
            same a b "bands of: $look" >/dev/null
            render b builtin:vase $look --light 1,3,4:1,1,1 --jobs 3
            same a b "threads of: $look" >/dev/null
        done
    done
done

refuse() { # MESSAGE OPTIONS...
    expected=$1
    shift
    status=0
    "$PEL" render builtin:vase "$@" -o "$dir/x.ppm" 2>"$dir/message" ||
        status=$?
    [ $status -eq 2 ] || fail "render $*: status $status"
    grep -qF -e "pel: $expected" "$dir/message" ||
        fail "render $*: $(cat "$dir/message")"
    [ ! -e "$dir/x.ppm" ] || fail "render $*: output"
}
refuse "--texture is 'soft': expected none|nearest|bilinear" --texture soft
refuse "--mapping is 'x': expected vertices|affine|subdivided|perspective" \
    --mapping x
refuse "--wrap is 'x': expected clamp|repeat|mirror" --wrap x
refuse "--order is 'x': expected auto|painter|zbuffer16|zbuffer32|zbuffer" --order x
refuse "--cull is 'x': expected none|back|front" --cull x
refuse "--normals-from is 'x': expected file|smooth" --normals-from x
refuse "--projection is 'x': expected perspective|orthographic" --projection x
refuse "--terms is 'ambient,x': expected a list of ambient, diffuse and specular" --terms ambient,x
refuse "--terms is '': expected a list" --terms ""
refuse "--highlights is 'x': expected coloured|plain" --highlights x
refuse "--light is '1,2,3': expected X,Y,Z:R,G,B" --light 1,2,3
refuse "--light is '1,2:1,1,1': expected X,Y,Z:R,G,B" --light 1,2:1,1,1
refuse "--light is '1,2,3:1,1,16': expected X,Y,Z:R,G,B with colours from 0 to 15.99" --light 1,2,3:1,1,16
refuse "--sun is '0,0,0:1,1,1': expected the direction towards it" --sun 0,0,0:1,1,1
refuse "--light is light 33: expected up to 32" $(seq -f '--light=%g,1,1:1,1,1' 33)
refuse "--ambient is '1': expected R,G,B" --ambient 1
refuse "--kd is '-1': expected a number from 0 to 15.99" --kd -1
refuse "--shininess is '257': expected a whole number from 1 to 256" --shininess 257
refuse "--shininess is '0'" --shininess 0
refuse "--span is '3': expected 2|4|8|16|32|64" --span 3
refuse "--transparency is '256'" --transparency 256
refuse "--turn is '0,2,0': expected X,Y,Z in parts of a turn" --turn 0,2,0
refuse "--turn is '0,0x1p-2,0': expected X,Y,Z in parts of a turn" --turn 0,0x1p-2,0
refuse "--focal is '0x32': expected a length in mm" --focal 0x32
refuse "--focal is ' 50': expected a length in mm" --focal " 50"
refuse "--focal is 'nan': expected a length in mm" --focal nan
refuse "--color is 'red': expected #rrggbb" --color red
refuse "--near is '0': expected a distance above 0" --near 0
refuse "Phong shading is light at every pixel" --shade phong --unlit
refuse "builtin:vase: --collinear is for pel2d files" --collinear line
refuse "focal length 1e+06 and sensor 1e-06x1e-06 make more than 65536" \
    --focal 1e6 --sensor 1e-6x1e-6
