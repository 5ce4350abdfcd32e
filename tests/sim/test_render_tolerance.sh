#!/bin/sh
# pel render --tolerance: no channel of any pixel is further from the exact
# picture, for every mesh at hand; what was chosen is counted and shown.
# PEL_MESHES names a folder of more meshes.
set -u
. "$(dirname "$0")/lib.sh"
render="$PEL render --shade phong --size 300x300"

# within MESH OPTION...: at tolerances of 0 to 8 steps.
within() {
    $render "$@" -o "$work/exact.ppm" || fail "render $*"
    for steps in 0 1 2 4 8; do
        $render "$@" --tolerance $steps -o "$work/near.ppm" ||
            fail "render $* --tolerance $steps"
        "$PEL" compare "$work/exact.ppm" "$work/near.ppm" --tolerance $steps \
            >"$work/out" || fail "$* --tolerance $steps: $(cat "$work/out")"
    done
}
within builtin:vase
within builtin:vase --interpolation world --eye 0.4,0.9,1.1 --near 0.05
within builtin:vase --order zbuffer --sun 1,2,3:1,0.5,0.25 --ks 1 \
    --shininess 200 --highlights plain --back-highlights off
within builtin:vase --light 1,2,2:1,1,1 --light 0,3,0:0,1,1 --transparency 99

# The floor under the camera, crossing spheres, and others as they are found.
assimp=/usr/share/assimp/models
for mesh in "$assimp/Collada/duck.dae" /usr/share/glmark2/models/bunny.obj \
    "$assimp/OBJ/spider.obj" "$assimp/Collada/sphere.dae" \
    ${PEL_MESHES:+"$PEL_MESHES"/spot/spot_triangulated.obj} \
    ${PEL_MESHES:+"$PEL_MESHES"/suzanne/suzanne.ply} \
    ${PEL_MESHES:+"$PEL_MESHES"/fox/Fox.glb}; do
    [ ! -r "$mesh" ] || within "$mesh" --order zbuffer --turn 0.03,0.1,0
done
printf 'v -50 0 -50\nv 50 0 -50\nv 50 0 50\nv -50 0 50\nf 1 4 3\nf 1 3 2\n' \
    >"$work/floor.obj"
within "$work/floor.obj" --eye 0,1,0 --target 0,0.5,-3 --near 0.1 \
    --light 1,2,-4:1,1,1

# One triangle or pixel is counted once.
$render builtin:vase --tolerance 2 --stats -o "$work/a.ppm" 2>"$work/stats"
grep -qE '^gouraud +[1-9][0-9]* triangles +[1-9][0-9]* pixels$' "$work/stats" ||
    fail "stats: $(cat "$work/stats")"
grep -qE 'largest bound: [0-2]\.[0-9]+ steps' "$work/stats" || fail "bound"
$render builtin:vase --tolerance 2 -o "$work/b.ppm"
cmp -s "$work/a.ppm" "$work/b.ppm" || fail "stats change the picture"
$render "$work/floor.obj" --eye 0,1,0 --target 0,0.5,-3 --near 0.1 \
    --light 1,2,-4:1,1,1 --tolerance 2 --background '#000000' --ambient 1,1,1 \
    --stats -o "$work/a.ppm" 2>"$work/stats"
tail -c +16 "$work/a.ppm" | od -An -v -tu1 -w3 |
    awk '$1 + $2 + $3 > 0 { n++ } END { print n }' >"$work/drawn"
awk '/pixels/ { n += $4 } END { print n }' "$work/stats" | cmp -s - "$work/drawn" ||
    fail "not every pixel is counted once: $(cat "$work/drawn" "$work/stats")"
$render builtin:vase --show-methods -o "$work/a.ppm"
"$PEL" render builtin:vase --size 300x300 --shade flat --unlit \
    --texture none --color '#e02020' -o "$work/b.ppm"
cmp -s "$work/a.ppm" "$work/b.ppm" || fail "exact is not shown red"
for option in --stats --show-methods; do
    refused_command "$option is about --shade phong" render builtin:vase $option
done
refused_command "--tolerance is about --shade phong" \
    render builtin:vase --tolerance 2
refused_command "expected one of them" render builtin:vase --shade phong \
    --stats --show-methods
refused_command "such as 2" render builtin:vase --tolerance 256

# A square that leads away, of black and white vertices: half way in the world
# is grey, but nearer to the far edge on screen.
printf 'v -1 0 0 0 0 0\nv 1 0 0 0 0 0\nv 1 0 -20 1 1 1\nv -1 0 -20 1 1 1\nf 1 2 3\nf 1 3 4\n' \
    >"$work/road.obj"
road="$PEL render $work/road.obj --unlit --shade gouraud --size 99x99 --eye 0,1,1
    --target 0,0,-4 --near 0.1"
$road -o "$work/a.ppm" || fail "road"
$road --interpolation world -o "$work/b.ppm" || fail "road in the world"
"$PEL" compare "$work/a.ppm" "$work/b.ppm" --tolerance 60 >"$work/out" &&
    fail "no perspective of colours: $(cat "$work/out")"
refused_command "expected --interpolation screen" render builtin:vase \
    --shade phong --interpolation world --stats

# Options that another mapping would ignore.
refused_command "expected --mapping perspective" render builtin:vase \
    --texel-tolerance 1 --mapping affine
refused_command "expected --mapping subdivided" render builtin:vase --span 16

# A dim light is left out.
lights="--light 1,2,3:1,1,1 --light 3,2,1:0.002,0.002,0.002"
within builtin:vase $lights
$render builtin:vase $lights --tolerance 4 --stats -o "$work/a.ppm" \
    2>"$work/stats"
grep -qx 'lights left out: 1' "$work/stats" || fail "lights: $(cat "$work/stats")"
