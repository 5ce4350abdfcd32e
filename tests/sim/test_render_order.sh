#!/bin/sh
# `--order auto` is right: the picture of a depth buffer of 32 bits, byte for
# byte. PEL_ORDER_ALL=1 takes every mesh in the folders PEL_MODELS, of which the
# list here is a part.
. "$(dirname "$0")/lib.sh"
models=${PEL_MODELS:-/usr/share/assimp/models}

# differs MESH OPTION...: draws both; true when they differ. $how tells the way.
differs() {
    if ! "$PEL" render "$@" --order zbuffer32 -o "$work/z.ppm" 2>/dev/null; then
        [ -n "${PEL_ORDER_ALL:-}" ] && return 1
        fail "$*: not drawn"
    fi
    loaded=$((loaded + 1))
    "$PEL" render "$@" --order auto --time -o "$work/a.ppm" 2>"$work/how" ||
        return 0
    how=$(grep -E 'proven|depths' "$work/how")
    ! cmp -s "$work/z.ppm" "$work/a.ppm"
}

check() {
    ! differs "$@" || fail "$*: $how"
}

loaded=0
if [ -n "${PEL_ORDER_ALL:-}" ]; then
    find $models -type f | LC_ALL=C sort >"$work/all"
    while read -r mesh; do
        check "$mesh" --size 1200x1200 --shade flat
    done <"$work/all"
    echo "$loaded meshes"
    [ $loaded -ge 200 ] || fail "only $loaded meshes could be drawn"
    exit
fi

first=${models%% *}
for mesh in 3DS/fels.3ds 3MF/box.3mf AC/Wuson.ac OBJ/spider.obj \
    3DS/cubes_with_alpha.3DS 3DS/TargetCameraAnim.3ds; do
    mesh=$first/$mesh
    check "$mesh" --size 800x800
    check "$mesh" --size 801x799 --shade flat --bands 50 --cull back
    check "$mesh" --size 800x800 --projection orthographic --sensor 9x9
    check "$mesh" --size 800x800 --transparency 99
done
# What was taken: the painter's order for two squares side by side, with depths
# where two cross, and depths alone where a texture or Phong costs more.
cat >"$work/squares.obj" <<'END'
v -4 -3 1
v 4 -3 -1
v 4 3 -1
v -4 -3 -1
v 4 -3 1
v 4 3 1
v 14 -3 -1
v 14 3 -1
f 2 7 8
f 2 8 3
END
cp "$work/squares.obj" "$work/cross.obj"
printf 'f 1 2 3\nf 4 5 6\n' >>"$work/cross.obj"
taken() { # TEXT OPTION...
    text=$1
    shift
    check "$@"
    [ "$how" = "$text" ] || fail "$*: expected $text, got $how"
}
side="--size 200x100 --eye 5,0,9 --projection orthographic --sensor 20x10"
taken "painter's order, proven but for 0x0 px with depths" \
    "$work/squares.obj" $side
taken "painter's order, proven but for 39x30 px with depths" \
    "$work/cross.obj" $side
taken "depths of 32 bits" "$work/cross.obj" $side --shade phong
taken "depths of 32 bits" "$work/squares.obj" $side --size 80x40

# The painter says what it may have wrong.
"$PEL" render "$work/cross.obj" $side --order painter --time \
    -o "$work/p.ppm" 2>"$work/how"
grep -q "painter's order: at most [0-9]* pixels are wrong, of 2 triangles" \
    "$work/how" || fail "the painter says: $(cat "$work/how")"
