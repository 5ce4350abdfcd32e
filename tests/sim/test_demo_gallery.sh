#!/bin/sh
# pel demo: the pictures that every system promises, their times, and what is
# said where a package is missing.
set -u
. "$(dirname "$0")/lib.sh"

# A script's name is a part of a page and of names of files.
odd="$work/<i>\"&.pel"
printf 'canvas 9 8 xrgb8888\nclear #103050\n' >"$odd"
PEL_MODELS=$work "$PEL" demo "$work/demo" "$odd" sim/scenes/meshes.pel \
    >"$work/out" || fail "no gallery"
grep -q "<i>" "$work/demo/index.html" && fail "a name is HTML"
names='_i___ meshes formats rules-top-left rules-bottom-left figures figures-flat
figures-corners figures-rings figures-sectors duck-flat duck-gouraud
texture-flat texture-nearest texture-bilinear lighting-texture-vertices
lighting-texture-pixels lighting-gouraud-plain lighting-phong-plain'
for shade in gouraud phong; do
    names="$names lighting-$shade"
    for part in ambient diffuse specular light1 light2 light3; do
        names="$names lighting-$shade-$part"
    done
done
for name in $names; do
    grep -q "^$name  *[0-9]* x [0-9]*  *[0-9.]* ms$" "$work/out" ||
        fail "no time of $name"
    [ -s "$work/demo/$name.ppm" ] || fail "no $name.ppm"
    grep -qE "<a href=\"$name.(png|bmp)\"><img src=\"$name" \
        "$work/demo/index.html" || fail "$name is no link to itself"
    grep -qF "\"$name.ppm\"" "$work/demo/index.html" || fail "no $name shown"
    sum=$(cksum <"$work/demo/$name.ppm")
    grep -qxF "$sum" "$work/sums" 2>/dev/null && fail "$name: shown twice"
    echo "$sum" >>"$work/sums"
done
[ "$(grep -c ' ms$' "$work/out")" = "$(echo "$names" | wc -w)" ] ||
    fail "other pictures: $(cat "$work/out")"
[ "$(grep -c 'assimp-testmodels is missing' "$work/demo/index.html")" = 23 ] ||
    fail "does not say what is missing"
[ "$(grep -c 'texture is a generated board' "$work/demo/index.html")" = 21 ] ||
    fail "does not say whose texture it is"
