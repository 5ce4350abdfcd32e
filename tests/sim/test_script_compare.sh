#!/bin/sh
# pel compare: alpha counts, and what is allowed, masked and left out.
set -u
. "$(dirname "$0")/lib.sh"
PEL=$(realpath "$PEL")
cd "$work" || exit 1

pam() { # NAME WIDTH HEIGHT BYTES: a picture of colours and alpha
    printf 'P7\nWIDTH %s\nHEIGHT %s\nDEPTH 4\nMAXVAL 255\nTUPLTYPE RGB_ALPHA\nENDHDR\n' \
        "$2" "$3" >"$1.pam"
    # shellcheck disable=SC2059
    printf "$4" >>"$1.pam"
}
# compared STATUS TEXT ARGUMENT...: what it says, all of it.
compared() {
    status=$1 text=$2
    shift 2
    "$PEL" compare "$@" >out 2>err
    got=$?
    [ $got = "$status" ] || fail "status $got for: $* $(cat err)"
    [ "$(cat out)" = "$text" ] || fail "$*: $(cat out), not $text"
}

# One pixel of alpha 255, 128, and two clear ones.
pam opaque 1 1 '\12\24\36\377'
pam half 1 1 '\12\24\36\200'
pam clear 1 1 '\12\24\36\0'
pam other 1 1 '\377\0\0\0'
compared 0 '' opaque.pam opaque.pam
compared 1 '1 of 1 pixels differ, worst by 127 of 255, first at (0, 0): #0a141e, #0a141e80' \
    opaque.pam half.pam
compared 1 '1 of 1 pixels differ, worst by 128 of 255, first at (0, 0): #0a141e80, #0a141e00' \
    half.pam clear.pam
compared 1 '1 of 1 pixels differ, worst by 128 of 255, first at (0, 0): #0a141e80, #ff000000' \
    half.pam other.pam
compared 0 '' clear.pam other.pam
compared 0 '' --tolerance 127 opaque.pam half.pam
compared 1 '1 of 1 pixels differ, worst by 127 of 255, first at (0, 0): #0a141e, #0a141e80' \
    --tolerance 126 opaque.pam half.pam

# Of 10 x 10 pixels three differ: (2, 1), (3, 1), (9, 9).
grey() { # NAME PLACE...: black, but for those of these numbers
    awk -v places="$2" 'BEGIN { print "P2 10 10 255"; split(places, p, " ")
        for (i in p) on[p[i]] = 1
        for (i = 0; i < 100; i++) print (i in on) ? 200 : 7 }' >"$1.ppm"
}
grey plain ''
grey three '12 13 99'
said='3 of 100 pixels differ, worst by 193 of 255, first at (2, 1): #070707, #c8c8c8'
compared 1 "$said" plain.ppm three.ppm
compared 1 "$said" --allow 2 plain.ppm three.ppm
compared 0 "$said" --allow 3 plain.ppm three.ppm
compared 1 "$said" --allow 2.9% plain.ppm three.ppm
compared 0 "$said" --allow 3% plain.ppm three.ppm
compared 0 "$said" --allow 100% plain.ppm three.ppm
compared 1 '1 of 98 pixels differ, worst by 193 of 255, first at (9, 9): #070707, #c8c8c8' \
    --ignore 2,1,2,1 plain.ppm three.ppm
compared 0 '' --ignore 2,1,2,1 --ignore 9,9,100,100 plain.ppm three.ppm
compared 0 '' --ignore -5,-5,20,20 plain.ppm three.ppm
compared 1 "$said" --ignore 2,1,0,1 plain.ppm three.ppm
awk 'BEGIN { print "P2 10 10 255"; for (i = 0; i < 100; i++) print i == 12 ? 1 : 0 }' \
    >mask.ppm
compared 1 '1 of 1 pixels differ, worst by 193 of 255, first at (2, 1): #070707, #c8c8c8' \
    --mask mask.ppm plain.ppm three.ppm
compared 0 '' --mask mask.ppm --ignore 0,0,3,3 plain.ppm three.ppm
# What is not compared is no difference in the picture of them either.
compared 1 '1 of 1 pixels differ, worst by 193 of 255, first at (2, 1): #070707, #c8c8c8' \
    --mask mask.ppm --diff diff.ppm plain.ppm three.ppm
[ "$(tail -c 300 diff.ppm | od -An -v -tu1 -w3 | awk '$1 > 100' | wc -l)" = 1 ] ||
    fail "--diff shows what is not compared"

for wrong in 3.5 -1 x 101% 3%% ''; do
    refused_command "--allow is '$wrong': expected pixels such as 20" compare \
        --allow "$wrong" plain.ppm three.ppm
done
for wrong in 1,2,3 1,2,3,-1 a 1,2,3,4,5; do
    refused_command "--ignore is '$wrong': expected X,Y,WIDTH,HEIGHT" compare \
        --ignore "$wrong" plain.ppm three.ppm
done
refused_command 'the mask has 1 x 1 pixels: expected the 10 x 10 of plain.ppm' \
    compare --mask opaque.pam plain.ppm three.ppm
[ -e "$work/failed" ] || echo "pictures are compared"
