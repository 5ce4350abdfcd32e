#!/bin/sh
# pictures.sh BUILD CC [accept] : draws every picture of docs/pictures anew, those
# of docs/pictures/list.txt and those of the blocks of C in the pages, and
# compares each, pixel by pixel; accept: writes those that differ.
set -eu
build=$1
compiler=$2
accept=${3-}
folder=$build/pictures
rm -rf "$folder"
mkdir -p "$folder"
status=0

# A picture without the comments of its head, in which examples count.
plain() {
    LC_ALL=C sed '1,6{/^# /d}'
}

# Keeps or compares NAME.ppm.
settle() {
    kept=docs/pictures/$1.png
    if [ -f "$kept" ] && "$build/pel" compare "$folder/$1.ppm" "$kept" \
        >"$folder/$1.txt" 2>&1; then
        return
    fi
    if [ "$accept" ]; then
        size=$(head -c 64 "$folder/$1.ppm" | tr '\n' ' ' | cut -d ' ' -f 2-3)
        printf 'canvas %s xrgb8888\nimage 0 0 %s.ppm\n' "$size" "$1" \
            >"$folder/$1.pel"
        "$build/pel" run "$folder/$1.pel" -o "$kept"
        echo "written    $kept"
    else
        echo "DIFFERENT  $kept: $(head -n 3 "$folder/$1.txt")"
        status=1
    fi
}

grep -v '^#' docs/pictures/list.txt >"$folder/list"
while read -r name command; do
    command=$(printf '%s\n' "$command" | sed "s,BUILD,$build,g")
    sh -c "$command" </dev/null | plain >"$folder/$name.ppm"
    settle "$name"
done <"$folder/list"

# What the guide has imported, by its own commands.
sed -n "s,^    build/pel \(import .* -o \)\([a-z0-9_]*\.c\)\$,$build/pel \1$folder/\2,p" \
    docs/guide.md | sh -e >/dev/null
for file in "$folder"/*.c; do
    $compiler -std=c99 -Iinclude -c "$file" -o "${file%.c}.o"
done

awk -v folder="$folder" -f tests/tools/doc_blocks.awk README.md docs/guide.md \
    docs/coming-from.md >"$folder/blocks"
while read -r kind name; do
    [ "$kind" = picture ] || continue
    $compiler -std=c99 -Wall -Wextra -Wpedantic -Werror -O1 -I. \
        -Iinclude -I"$folder" "$folder/$name.c" "$folder"/*.o \
        "$build/libpel.a" -o "$folder/$name"
    "$folder/$name" >"$folder/$name.ppm"
    settle "$name"
done <"$folder/blocks"

# No picture without a page or a list that names it, none too large.
for kept in docs/pictures/*.png; do
    name=$(basename "$kept" .png)
    [ -f "$folder/$name.ppm" ] || { echo "nothing draws $kept"; status=1; }
    [ "$(wc -c <"$kept")" -le 40960 ] || { echo "over 40 KiB: $kept"; status=1; }
done
[ "$(cat docs/pictures/*.png | wc -c)" -le 614400 ] ||
    { echo "docs/pictures: over 600 KiB"; status=1; }
[ $status != 0 ] || echo "docs/pictures: all $(ls docs/pictures/*.png | wc -l) are as drawn"
exit $status
