#!/bin/sh
# OBJ and MTL as people write them: what each file must show.
set -u
. "$(dirname "$0")/shows.sh"
"$PEL" info $field/ind.obj 2>&1 | grep -q 'without assimp' && exit 0

# Numbers: the triangle is that of vertices 2, 3 and 4.
shows $field/dot7.obj 999999:60,40 000000:40,40 000000:80,50
for number in .5 +.5 5e-1 .5E0 0.5 5.e-1 0.50000000000000000000000 +0005.e-1; do
    printf 'v -%s -%s 0\nv %s -%s 0\nv %s %s 0\nf 1 2 3\n' \
        "${number#+}" "${number#+}" "$number" "${number#+}" "$number" "$number" \
        >"$work/n.obj"
    shows "$work/n.obj" 999999:40,61 999999:61,40 999999:40,61 000000:36,61 000000:40,40
done

# Lines: blanks and tabs anywhere, comments behind data, lines that go on, ends
# of lines of any system, a comment that ends in a backslash.
for file in ind com1; do
    shows $field/$file.obj 999999:30,40 999999:70,70 000000:20,20
done
whole="999999:26,26 999999:26,73 999999:73,26 999999:73,73 000000:24,24"
square='v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n'
row() { # NAME TEXT: the file shows the square
    printf "$2" >"$work/$1.obj"
    # shellcheck disable=SC2086
    shows "$work/$1.obj" $whole
}
row tabs ' v\t-1\t-1 \t0 \nv  1 -1   0\n\t v 1 1 0\t\n v -1 1 0\n\tf\t1 2\t3 \t4 \n'
row joined "v -1 \\\\\n-1 0\nv 1 -1 \\\\  \n \\\\\n0\nv 1 1 0\nv -1 1 0\nf 1 2 \\\\\r\n3 4\n"
row behind "v -1 -1 0#a\nv 1 -1 0 # b\nv 1 1 0\t#\nv -1 1 0\nf 1 2 3 4# c"
row slash "$square# that ends in \\\\\nf 1 2 3 4 # \\\\\n"
row dos "$(printf %s "$square" | sed 's/\\n/\\r\\n/g')f 1 2 3 4\r\n"
row mac "$(printf %s "$square" | sed 's/\\n/\\r/g')f 1 2 3 4\r"
row back "${square}f -4 -3 -2 -1"
row corners "${square}vt 0\nvt 0 0 0\nvn 0 0 1\nf 1/ 2// 3/1 4/2/\n"
row all "${square}vt 0 .5\nvn 0 0 1\nf 1/1/1 2//1 3/-1/-1 4//-1\n"
row weight "v -1 -1 0 1\nv 1 -1 0 2\nv 1 1 0 .5\nv -1 1 0 0\nf 1 2 3 4\n"

# What is wrong is refused with its line.
while read -r text line; do
    printf "$square$line" >"$work/wrong.obj"
    refused_command "wrong.obj:5: $(echo "$text" | tr _ ' ')" info "$work/wrong.obj"
done <<'END'
'1,5'_is_no_number v 1,5 2 3\nf 1 2 3\n
'x'_is_no_number v 1 2 x\nf 1 2 3\n
'1e999'_is_no_number v 1 2 1e999\nf 1 2 3\n
'nan'_is_no_number v 1 2 nan\nf 1 2 3\n
a_vertex_has_2_numbers v 1 2\nf 1 2 3\n
a_vertex_has_8_numbers v 1 2 3 4 5 6 7 8\nf 1 2 3\n
vn_has_2_numbers vn 1 2\nf 1 2 3\n
'0'_is_no_corner f 0 1 2
'1/0/1'_is_no_corner f 1/0/1 1 2
'2/x'_is_no_corner f 1 2/x 3
'1/1/1/1'_is_no_corner f 1/1/1/1 2 3
'99999999999'_is_no_corner f 99999999999 2 3
END

# Colours: vertex 2 is red, 4 is blue; the others have the mesh's.
colors() { # FILE COLORS: of the vertices
    got=$("$PEL" import "$1" --name a -o - 2>"$work/err" |
        awk '/_colors\[/ { p = 1; next } /};/ { p = 0 } p' | tr -d ' \n')
    [ "$got" = "$2" ] || fail "$1: $got, not $2"
}
colors $field/partial.obj \
    "{153,153,153},{255,0,0},{153,153,153},{0,0,255},"
colored() { # COLOR NUMBERS: behind the coordinates of all
    printf 'v -1 -1 0 %s\nv 1 -1 0 %s\nv 1 1 0 %s\nv -1 1 0 %s\nf 1 2 3 4\n' \
        "$2" "$2" "$2" "$2" >"$work/color.obj"
    shows "$work/color.obj" "$1:40,40" "$1:60,60"
}
colored ff0080 '1 0 .5'
colored ff00ff '2 -1 1.5'
colored ff8000 '1 1 .5 0'
for at in '-1 -1' '1 -1' '1 1' '-1 1'; do
    printf 'v %s \\\n 0 0 1 \\\n0\n' "$at"
done >"$work/joined.obj"
echo 'f 1 2 3 4' >>"$work/joined.obj"
shows "$work/joined.obj" 00ff00:40,40 00ff00:60,60
printf 'newmtl m\nKd 0 1 0\n' >"$work/m.mtl"
printf "mtllib m.mtl\nusemtl m\n$square" | sed '4s/$/ 1 0 0/' >"$work/part.obj"
echo 'f 1 2 3 4' >>"$work/part.obj"
colors "$work/part.obj" "{0,255,0},{255,0,0},{0,255,0},{0,255,0},"

# Materials: numbers, options of textures, several libraries, missing ones.
cp $field/t4.png "$work/t4.png"
cp $field/t4.png "$work/my pic.png"
textured() { # LINE PLACES...: of the material
    printf 'newmtl m\n%b\n' "$1" >"$work/t.mtl"
    shift
    {
        printf "mtllib t.mtl\n$square"
        printf 'vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl m\nf 1/1 2/2 3/3 4/4\n'
    } >"$work/t.obj"
    shows "$work/t.obj" "$@"
}
quarters='ff0000:30,30 00ff00:70,30 0000ff:30,70 ffff00:70,70'
twice='ff0000:27,27 00ff00:48,27 0000ff:27,48 ffff00:48,48 ff0000:52,52
    ffff00:73,73'
# shellcheck disable=SC2086
{
    textured 'map_Kd t4.png' $quarters
    textured '\tmap_Kd   t4.png  # comment' $quarters
    textured 'Kd .5 .5 .5\nmap_Kd my pic.png' $quarters
    textured 'map_Kd -s 2 2 1 t4.png' $twice
    textured 'map_Kd -s 2 2 my pic.png' $twice
    textured 'map_kd -blendu on -mm 0 1 -s 2 2 2 -bm 1 t4.png' $twice
    textured 'map_Kd -o .5 0 t4.png' 00ff00:30,30 ff0000:70,30 ffff00:30,70
    textured 'map_Kd -o 0 .5 0 t4.png' 0000ff:30,30 ffff00:70,30 ff0000:30,70
    textured 'map_Kd -s 2 1 1 -o .25 0 0 t4.png' 00ff00:35,30 ff0000:46,30 \
        0000ff:46,70
    textured 'map_Kd -s -1 1 1 t4.png' 00ff00:30,30 ff0000:70,30 ffff00:30,70
    textured 'Kd .5 0 1' 8000ff:40,40
    textured ' Kd   +1. .5 0 ' ff8000:40,40
    textured 'Kd .5' 808080:40,40
    shows $field/o_scale.obj $twice
}
printf "mtllib none.mtl m.mtl\nusemtl m\n${square}f 1 2 3 4" >"$work/two.obj"
shows "$work/two.obj" 00ff00:40,40
told "two.obj:1: its materials none.mtl cannot be read"
printf "mtllib none.mtl\nusemtl m\n${square}f 1 2 3 4" >"$work/m.obj"
shows "$work/m.obj" 00ff00:40,40
told "expected them, and taken are those of $work/m.mtl"
printf 'newmtl a b\nKd 1 0 0\nnewmtl #c\nKd 0 0 1' >"$work/my mat.mtl"
printf "mtllib my mat.mtl\nusemtl a b \n${square}f 1 2 3\nusemtl #c\nf 1 3 4\n" \
    >"$work/names.obj"
shows "$work/names.obj" ff0000:60,70
printf 'Kd 1 0 0\nmap_Kd t4.png\nnewmtl m\nKd 0 1 0\n' >"$work/early.mtl"
printf "mtllib early.mtl\nusemtl m\n${square}f 1 2 3 4" >"$work/early.obj"
shows "$work/early.obj" 00ff00:40,40
told "early.mtl:2: 'map_Kd' before the first newmtl is left out"
printf 'newmtl m\nKd a b c\n' >"$work/wrong.mtl"
printf "mtllib wrong.mtl\n${square}f 1 2 3\n" >"$work/wrong.obj"
refused_command "wrong.mtl:2: Kd has 'a b c': expected numbers" info "$work/wrong.obj"

for curve in 'Ka spectral a.rfl 1' 'Kd xyz .1 .2'; do
    printf 'newmtl m\n%s\nKd 0 1 0\n' "$curve" >"$work/curve.mtl"
    printf "mtllib curve.mtl\nusemtl m\n${square}f 1 2 3 4" >"$work/curve.obj"
    shows "$work/curve.obj" 00ff00:40,40
    told "curve.mtl:2: '$curve' is left out: expected red, green and blue"
done
# Of a long word a message has the beginning.
word=$(printf '%0160d' 1 | tr 01 xy)
first=$(printf %.80s "$word")
for line in "v 1 2 $word" "f 1 2 $word"; do
    printf "$square$line" >"$work/long.obj"
    refused_command "long.obj:5: '$first' is no " info "$work/long.obj"
done

[ -e "$work/failed" ] || echo "OBJ and MTL are read as they are written"
