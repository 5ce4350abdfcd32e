#!/bin/sh
# doc_blocks.sh BUILD CC LIBRARY... : compiles, links with these and runs the C of
# the pages that draws no picture (doc_blocks.awk): programs, with the file of
# tests/docs that has their name, if there is one, and parts inside of theirs.
# pictures.sh does those with a picture.
set -u
build=$1
compiler=$2
shift 2
folder=$build/docs
status=0
rm -rf "$folder"
mkdir -p "$folder"

# C without a word to compile it is found, however it is marked.
for text in '    pel_clear(&s, 0);' '\t#include <pel/pel.h>' '```\nint x;\n```' \
    '~~~cpp\n}\n~~~' '```c\nint x;\n```' '<!-- part: x -->\n    int x;'; do
    printf '# Page\n\n%b\n' "$text" >"$folder/page.md"
    awk -v folder="$folder" -f tests/tools/doc_blocks.awk "$folder/page.md" \
        >"$folder/out" 2>&1 && { echo "not found: $text"; status=1; }
done

awk -v folder="$folder" -f tests/tools/doc_blocks.awk README.md docs/*.md \
    tests/README.md port/README.md sim/scenes/README.md CHANGELOG.md \
    >"$folder/blocks" || exit 1

while read -r kind name; do
    file=tests/docs/$name.c
    case $kind in
    picture) continue ;;
    program)
        [ -f "$file" ] || file=
        file="$folder/$name.c $file"
        ;;
    esac
    wanted=0 text=
    while read -r program number message; do
        [ "$program" != "$name" ] || { wanted=$number text=$message; }
    done <tests/docs/expected.txt
    $compiler -std=c99 -Wall -Wextra -Wpedantic -Werror -O1 -I. -Iinclude \
        -I"$folder" $file "$@" -o "$folder/$name" || { status=1; continue; }
    FRAMEBUFFER=/dev/null SDL_VIDEODRIVER=dummy timeout 60 "$folder/$name" \
        </dev/null >"$folder/$name.out" 2>&1
    got=$?
    if [ $got != "$wanted" ] ||
        { [ "$text" ] && ! grep -qF "$text" "$folder/$name.out"; }; then
        echo "$name ended with $got:"
        cat "$folder/$name.out"
        status=1
    fi
done <"$folder/blocks"
exit $status
