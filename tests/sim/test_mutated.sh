#!/bin/sh
# Files that were changed at random, of every format that pel reads itself or
# writes anew: each ends in status 0 or 2, within limits and without a crash of
# the process that reads it, with short messages of printable characters. MUTATIONS=2000 of each;
# seeds from SEED on; FILES: of these alone.
set -u
. "$(dirname "$0")/lib.sh"
field=tests/sim/field
each=${MUTATIONS:-25}
$CC -O1 -Wall tests/sim/mutate.c -o "$work/mutate" || exit 1

# What the formats are mutated from.
cp $field/*.obj $field/*.mtl $field/*.gltf $field/*.ply $field/*.png $field/*.jpg \
    $field/*.bmp $field/*.3mf "$work"
printf 'v -1 -1 0 1 0 0\nv 1 -1 0\nvt .5 .5\nvn 0 0 1\nv 1 1 0\nmtllib o_scale.mtl\nf 1/1/1 2//1 3\n' \
    >"$work/all.obj"
printf 'STCNOFF\n3 2 0\n' >"$work/a.off"
for at in '0 0 0' '1 0 0' '1 1 0'; do
    echo "$at 0 0 1 255 0 0 255 .5 .5" >>"$work/a.off"
done
printf '3 0 1 2 255 0 0\n3 0 2 1 0 1.5 0 0.5\n' >>"$work/a.off"
{
    printf 'COLOR=\0\377\0\377' && head -c 70 /dev/zero && printf '\1\0\0\0'
    printf '\0\0\0\0%.0s' 1 2 3 4 5 6 && printf '\0\0\200\77%.0s' 1 1
    printf '\0\0\0\0%.0s' 1 2 && printf '\0\0\200\77%.0s' 1 2 && printf '\37\0'
} >"$work/a.stl"
printf 'P7\nWIDTH 2\nHEIGHT 2\nDEPTH 4\nMAXVAL 127\nENDHDR\n0123456789abcdef' \
    >"$work/a.pam"
printf 'P1\n# c\n3 2\n101\n0 1 0\n' >"$work/a.pbm"
cp $field/p6_max65535.ppm "$work/a.ppm"
json=$(tr '\n' ' ' <$field/g_tex_vc.gltf)
json=$json$(printf '%*s' $((3 - (${#json} + 3) % 4)) '')
le() { printf "\\$(printf %o $(($1 & 255)))\\$(printf %o $(($1 >> 8 & 255)))\0\0"; }
{
    printf 'glTF\2\0\0\0' && le $((${#json} + 20)) && le ${#json} &&
        printf 'JSON%s' "$json"
} >"$work/a.glb"
{
    printf 'BM\0\0\0\0\0\0\0\0\102\0\0\0\050\0\0\0\4\0\0\0\2\0\0\0\1\0\010\0\1\0\0\0'
    printf '\0\0\0\0\0\0\0\0\0\0\0\0\3\0\0\0\0\0\0\0'
    printf '\1\2\3\0\4\5\6\0\7\010\011\0\2\1\0\0\0\3\1\2\0\0\0\1'
} >"$work/rle.bmp"

cat >"$work/a.svg" <<'EOF'
<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 16 12" width="16px">
<linearGradient id="a"><stop offset="0" stop-color="#f00"/><stop offset="1"/></linearGradient>
<g transform="rotate(5) scale(.9,.8)" opacity=".5"><path
style="fill:url(#a);fill-rule:evenodd" d="M1 1h9.5v3A4 2 30 0 1 3-4q1 2 3 4t1 2c1,1 2e1-2 3 3zs1 1 2 2"/></g>
<rect x="2" y="1pt" width="50%" height="4" rx="1" fill="none" stroke="navy" stroke-width=".5"/>
<radialGradient id="b" r=".4" fx="30%" spreadMethod="reflect" href="#a"/>
<circle cx="9" cy="7" r="3" fill="url(#b)"/><polygon points="1,2 3,4 5,1"/></svg>
EOF

count=0
one() { # FILE SEED
    ending=${1##*.}
    "$work/mutate" "$work/$1" "$work/m.$ending" "$2" || exit 1
    target=m.$ending
    case $ending in
    mtl)
        cp "$work/m.mtl" "$work/o_scale.mtl"
        target=o_scale.obj ending=obj
        ;;
    esac
    case $ending in
    png | jpg | bmp | ppm | pam | pbm | svg) set -- import "$work/$target" -o - ;;
    *) set -- info "$work/$target" ;;
    esac
    (ulimit -v 8000000 && timeout 20 "$PEL" "$@" --limit 10,1500) \
        >"$work/out" 2>"$work/err" </dev/null
    got=$?
    [ $got = 0 ] || [ $got = 2 ] || fail "$file $seed: status $got"
    [ $got = 0 ] || [ -s "$work/err" ] || fail "$file $seed: no message"
    grep -aE 'crashed: |took more than [0-9]+ s:|Sanitizer|runtime error' \
        "$work/err" >"$work/ill" && fail "$file $seed: $(cat "$work/ill")"
    [ "$(awk '{ if (length($0) > n) n = length($0) } END { print n + 0 }' \
        "$work/err")" -le 500 ] || fail "$file $seed: a long message"
    LC_ALL=C tr -d '\n\40-\176\200-\377' <"$work/err" >"$work/control"
    [ ! -s "$work/control" ] || fail "$file $seed: control characters"
    count=$((count + 1))
}
cp $field/o_scale.mtl "$work/from.mtl"
files='all.obj partial.obj from.mtl g_tex_vc.gltf q_ushort.gltf a.glb
    p_facecol.ply a.off a.stl m_bm.3mf
    k8.png t4.png cmyk.jpg w565.bmp rle.bmp a.ppm a.pam a.pbm a.svg'
for file in ${FILES:-$files}; do
    cp "$work/$file" "$work/base.${file##*.}"
    case $file in
    *.png | *.jpg | *.bmp | *.p?m | *.svg) "$PEL" import "$work/base.${file##*.}" -o - ;;
    *.mtl) : ;;
    *) "$PEL" info "$work/base.${file##*.}" ;;
    esac >"$work/out" 2>"$work/err" || fail "$file itself: $(cat "$work/err")"
    seed=${SEED:-1}
    end=$((seed + each))
    while [ $seed -lt $end ]; do
        one $file $seed
        seed=$((seed + 1))
    done
done

[ -e "$work/failed" ] || echo "$count changed files are read or refused"
