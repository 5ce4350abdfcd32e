#!/bin/sh
# pel demo: the pictures that every system promises, their times, and what is
# said where a package is missing.
set -u
. "$(dirname "$0")/lib.sh"

# A script's name is a part of a page and of names of files.
odd="$work/<i>\"&.pel"
printf 'canvas 9 8 xrgb8888\nclear #103050\n' >"$odd"
PEL_MODELS=$work "$PEL" demo "$work/demo" "$odd" sim/scenes/meshes.pel \
    docs/pictures/watch.png docs/PRODUCTS.md >"$work/out" || fail "no gallery"
cat "$work/demo/index.html" "$work/demo/lighting.html" >"$work/pages"
grep -q "<i>" "$work/pages" && fail "a name is HTML"
cmp docs/pictures/watch.png "$work/demo/watch.png" || fail "another watch"
grep -q '<img src="watch.png" width="240" height="240"' "$work/pages" ||
    fail "no watch"
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
        "$work/pages" || fail "$name is no link to itself"
    grep -qF "\"$name.ppm\"" "$work/pages" || fail "no $name shown"
    sum=$(cksum <"$work/demo/$name.ppm")
    grep -qxF "$sum" "$work/sums" 2>/dev/null && fail "$name: shown twice"
    echo "$sum" >>"$work/sums"
done
[ "$(grep ' ms$' "$work/out" | cut -d ' ' -f 1 | sort -u | wc -l)" = "$(echo "$names" | wc -w)" ] ||
    fail "other pictures: $(cat "$work/out")"
[ "$(grep -c 'assimp-testmodels is missing' "$work/pages")" = 25 ] ||
    fail "does not say what is missing"
[ "$(grep -c 'texture is a generated board' "$work/pages")" = 23 ] ||
    fail "does not say whose texture it is"

# Every picture has what made it, and its time, or on a board its instructions.
awk 'BEGIN { RS = "</figure>" }
    /<figure/ && (!/(pel (run|render|view|demo)|make (board|device)) / ||
        !/[0-9] (ms,|thousand instructions)/) { print; bad = 1 }
    END { exit bad }' "$work/pages" || fail "no command or time: see above"
row=$(grep 'examples/watch.c' docs/PRODUCTS.md | cut -d '|' -f 10,11 | tr -d ' ')
grep -qF "${row%|*} thousand instructions for the first frame, ${row#*|} for a step" \
    "$work/pages" || fail "other instructions of the watch than docs/PRODUCTS.md"
printf 'no table' >"$work/other.md"
"$PEL" demo "$work/other" docs/pictures/watch.png "$work/other.md" >"$work/out" ||
    fail "a table of nothing"
"$PEL" demo "$work/other" "$work/none.md" 2>"$work/err" && fail "no table is none"
grep -q "none.md" "$work/err" || fail "no word of none.md"

# A command beside a picture draws it.
"$PEL" demo "$work/full" >"$work/out" || fail "no gallery without a script"
commands=0
for page in index lighting; do
    sed -n -e 's/^.*<img src="\([^"]*\)\.[a-z]*".*/name \1/p' \
        -e 's/.*<pre>\(pel render [^<]*\)<.*/\1/p' "$work/full/$page.html" \
        >"$work/commands"
    while read -r word rest; do
        case $word in
        name) name=$rest ;;
        pel)
            eval "\"\$PEL\" $rest -o \"\$work/again.ppm\"" &&
                cmp "$work/full/$name.ppm" "$work/again.ppm" ||
                fail "$name is not what its command draws: pel $rest"
            commands=$((commands + 1))
            ;;
        esac
    done <"$work/commands"
done
if [ -e /usr/share/assimp/models/Collada/duck.dae ] &&
    ! grep -q 'Built without assimp' "$work/full/index.html"; then
    [ $commands = 22 ] || fail "$commands commands of pel render, not 22"
fi
