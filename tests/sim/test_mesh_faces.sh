#!/bin/sh
# Colours of faces in PLY, OFF, STL: each face shows its own.
set -u
. "$(dirname "$0")/shows.sh"
"$PEL" info $field/ind.obj 2>&1 | grep -q 'without assimp' && exit 0

# Two triangles of a square: right below, left above.
both='ff0000:70,72 ff0000:73,30 0000ff:27,70 0000ff:30,27'
row() { # NAME: the file shows red and blue
    # shellcheck disable=SC2086
    shows "$work/$1" ${2:-$both}
}
# shellcheck disable=SC2086
shows $field/p_facecol.ply $both

# PLY: names, types, orders of properties and bytes.
head='ply\nformat ascii 1.0\ncomment c\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n'
square='-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n'
list='property list uchar int vertex_indices\n'
rgb() { # TYPE [PREFIX]
    printf 'property %s %sred\\nproperty %s %sgreen\\nproperty %s %sblue\\n' \
        "$1" "${2:-}" "$1" "${2:-}" "$1" "${2:-}"
}
ply() { # NAME PROPERTIES FACES
    printf "${head}element face 2\n$2end_header\n$square$3" >"$work/$1.ply"
    row "$1.ply"
}
ply uchar "$list$(rgb uchar)" '3 0 1 2 255 0 0\n3 0 2 3 0 0 255\n'
ply before "$(rgb uint8)$list" '255 0 0 3 0 1 2\n0 0 255 3 0 2 3'
ply diffuse "property list uint8 uint32 vertex_index\n$(rgb uchar diffuse_)" \
    '3 0 1 2 255 0 0 3 0 2 3 0 0 255\n'
ply float "$list$(rgb float)property float alpha\n" \
    '3 0 1 2 1 0 0 1\n3 0 2 3 0 0 1.0 0.5\n'
ply ushort "property int flags\n$(rgb ushort)${list}property list uchar float texcoord\n" \
    '9 65535 0 0 3 0 1 2 6 0 0 0 0 0 0\n9 0 0 65535 3 0 2 3 0\n'
vertices=$(printf '%s' "$head" | sed 's/$//')"$(rgb uchar)"
printf "${vertices}element edge 1\nproperty int a\nelement face 2\n$list$(rgb uchar)end_header\n" \
    >"$work/own.ply"
printf '%s 0 0 0 255 0\n' '-1 -1' '1 -1' '1 1' '-1 1' | sed 's/ 0 0 255/ 0 255/' |
    awk '{ print $1, $2, 0, 0, 255, 0 }' >>"$work/own.ply"
printf '7\n3 0 1 2 255 0 0\n3 0 2 3 0 0 255\n' >>"$work/own.ply"
row own.ply
printf "${head}element face 1\n$list$(rgb uchar)end_header\n${square}4 0 1 2 3 0 255 0\n" \
    >"$work/quad.ply"
row quad.ply '00ff00:27,27 00ff00:73,73 00ff00:30,70'
sed '1s/ply/PLY 1/; s/end_header/& \t/' "$work/uchar.ply" >"$work/blank.ply"
row blank.ply
o1='\0\0\200\77' m1='\0\0\200\277' o2='\77\200\0\0' m2='\277\200\0\0' z='\0\0\0\0'
for order in little big; do
    {
        printf "${head}element face 2\n${list}$(rgb uchar)end_header\n" |
            sed "s/ascii/binary_${order}_endian/"
        if [ $order = little ]; then
            printf "$m1$m1$z$o1$m1$z$o1$o1$z$m1$o1$z"
            printf "\3$z\1\0\0\0\2\0\0\0\377\0\0\3$z\2\0\0\0\3\0\0\0\0\0\377"
        else
            printf "$m2$m2$z$o2$m2$z$o2$o2$z$m2$o2$z"
            printf "\3$z\0\0\0\1\0\0\0\2\377\0\0\3$z\0\0\0\2\0\0\0\3\0\0\377"
        fi
    } >"$work/$order.ply"
    row $order.ply
    head -c "$(($(wc -c <"$work/$order.ply") - 1))" "$work/$order.ply" \
        >"$work/cut.ply"
    refused_command "cut.ply: ends before its faces do" info "$work/cut.ply"
done
printf "${head}element face 1\n$list$(rgb uchar)end_header\n${square}3 0 1 4 1 2 3\n" \
    >"$work/wrong.ply"
refused_command "wrong.ply:18: a face names a vertex that is out of range" \
    info "$work/wrong.ply"
printf "${head}element face 1\n$list$(rgb uchar)end_header\n${square}3 0 1 x 1 2 3\n" \
    >"$work/wrong.ply"
refused_command "wrong.ply:18: something else than a number" info "$work/wrong.ply"
printf "${head}element face 1\n$list$(rgb uchar)end_header\n${square}-3 0 1 2 1 2 3\n" \
    >"$work/wrong.ply"
refused_command "wrong.ply:18: a list has -3 numbers: expected 0 to 1048576" \
    info "$work/wrong.ply"
printf "ply\nformat ascii 1.0\nelement face 1\n$list$(rgb uchar)element vertex 3\nproperty float x\nend_header\n3 0 1 2 1 2 3\n0\n1\n2\n" \
    >"$work/wrong.ply"
refused_command "wrong.ply:11: has faces before its vertices: expected the vertices" \
    info "$work/wrong.ply"
# A zero byte in the head, which some readers would not leave; a property
# without a name, which assimp leaves out.
printf "${head}comment a\0b\nelement face 1\n$list$(rgb uchar)end_header\n${square}3 0 1 2 1 2 3\n" \
    >"$work/wrong.ply"
refused_command "wrong.ply: has a zero byte in its header: expected lines of text" \
    info "$work/wrong.ply" --limit 5,500
# The same under a name that assimp takes for ply; faces without vertices, which
# end it; OFF and OBJ with a zero byte.
printf 'plY\nformat ascii 1.0\nelement vertex 4\nproperty }loat x\nproperty floa' >"$work/case.ply"
refused_command "case.ply: ends inside of its header" info "$work/case.ply" --limit 5,500
printf "${head}element face 2\n${list}end_header\n${square}0\n3 0 1 2\n" >"$work/none.ply"
refused_command "none.ply: face 0 of part 0 has no vertices" info "$work/none.ply"
for ending in off obj; do
    printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2 \0 255 0\n' >"$work/zero.$ending"
    refused_command "zero.$ending: has a zero byte: expected lines of text" \
        info "$work/zero.$ending"
done
# UTF-16, which XML alone may be.
for order in '\377\376v\0 \0' '\376\377\0v\0 '; do
    printf "$order" >"$work/wide.obj"
    refused_command "wide.obj: is text of UTF-16: expected UTF-8" info "$work/wide.obj"
done
printf "${head}element face 1\n$list$(rgb uchar)property x\nend_header\n${square}3 0 1 2 1 2 3\n" \
    >"$work/nameless.ply"
"$PEL" info "$work/nameless.ply" >"$work/out" 2>&1 ||
    fail "a property without a name: $(cat "$work/out")"

# OFF: heads, counts, colours of faces and of vertices in both ranges.
off() { # NAME HEAD VERTEX-END FACES [PLACES]
    {
        printf "$2\n"
        for at in '-1 -1 0' '1 -1 0' '1 1 0' '-1 1 0'; do
            printf '%s%s\n' "$at" "$3"
        done
        printf "$4"
    } >"$work/$1.off"
    row "$1.off" "${5:-$both}"
}
bytes='3 0 1 2 255 0 0\n3 0 2 3 0 0 255\n'
off bytes 'OFF\n4 2 0' '' "$bytes"
off line '# c\nOFF 4 2 5 # c' '' "$bytes"
off noedges 'OFF\n\n4 2' '' "# a\n3 0 1 2  255 0 0 255 # b\n\n 3 0 2 3 0 0 255 128"
off floats 'OFF\n4 2 0' '' '3 0 1 2 1.0 0 0 1\n3 0 2 3 0 0 1 0.5\n'
off ones 'OFF\n4 2 0' '' '3 0 1 2 1 0 0\n3 0 2 3 0 0 1\n'
off over 'COFF\n4 2 0' ' 0 255 0 255' "$bytes"
off vertex 'COFF\n4 1 0' ' 0 255 0 255' '4 0 1 2 3\n' '00ff00:27,27 00ff00:73,73'
off vertex1 'COFF\n4 1 0' ' 0 1.0 0 1' '4 0 1 2 3\n' '00ff00:27,27 00ff00:73,73'
off unnamed 'OFF\n4 1 0' ' 0 255 0' '4 0 1 2 3\n' '00ff00:27,27 00ff00:73,73'
off normal 'CNOFF\n4 1 0' ' 0 0 1 0 255 0 255' '4 0 1 2 3\n' '00ff00:27,27'
off all 'STCNOFF\n4 1 0' ' 0 0 1 0 255 0 255 .5 .5' '4 0 1 2 3\n' '00ff00:27,27'
off weight '4OFF\n4 2 0' ' 1' "$bytes"
off plain 'OFF\n4 1 0' '' '4 0 1 2 3\n' '999999:27,27 999999:73,73'
off some 'OFF\n4 2 0' '' '3 0 1 2 255 0 0\n3 0 2 3\n' 'ff0000:70,72 999999:30,27'
off table 'OFF\n4 2 0' '' '3 0 1 2 5\n3 0 2 3 255 0 0\n' '999999:70,72 ff0000:30,27'
told '1 faces have a colour of a table: left out'
while read -r text head face; do
    printf "$head\n-1 -1 0\n1 -1 0\n1 1 0\n$face\n" >"$work/wrong.off"
    refused_command "wrong.off$(echo "$text" | tr _ ' ')" info "$work/wrong.off"
done <<'END'
:6:_vertex_3_is_out_of_range OFF\n3\t1\t0 3 0 1 3
:6:_a_face_has_too_few_corners OFF\n3\t1\t0 4 0 1 2
:2:_expected_the_numbers_of_vertices OFF\n0\t1\t0 3
:1:_no_OFF XOFF\n3\t1\t0 3 0 1 2
:1:_a_binary_OFF OFF\tBINARY\n3\t1\t0 3 0 1 2
:_ends_before_its_faces OFF\n3\t2\t0 3 0 1 2
:3:_a_vertex_has_too_few_numbers NOFF\n3\t1\t0 3 0 1 2
END

# STL: red lowest or highest, the colour of the head, none.
stl() { # NAME HEAD BITS BITS PLACES
    {
        printf "$2"
        head -c "$((80 - $(printf "$2" | wc -c)))" /dev/zero
        printf "\2\0\0\0"
        printf "$z$z$o1$m1$m1$z$o1$m1$z$o1$o1$z$3"
        printf "$z$z$o1$m1$m1$z$o1$o1$z$m1$o1$z$4"
    } >"$work/$1.stl"
    row "$1.stl" "$5"
}
magics='COLOR=\0\377\0\377,MATERIAL='
stl viscam solid '\0\374' '\37\200' "$both"
stl viscam2 '' '\0\374' '\37\0' 'ff0000:70,72 ffffff:30,27'
stl viscam3 '' '\20\302' '\340\203' '848484:70,72 00ff00:30,27'
stl magics "$magics" '\37\0' '\0\174' "$both"
stl magics2 "by x $magics" '\37\0' '\0\200' 'ff0000:70,72 00ff00:30,27'
stl magics3 "$magics" '\0\0' '\0\0' '00ff00:70,72 00ff00:30,27'
stl none '' '\0\0' '\37\0' 'ffffff:70,72 ffffff:30,27'

[ -e "$work/failed" ] || echo "faces show their colours"
