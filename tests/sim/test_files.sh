#!/bin/sh
# Small files as people have them (tests/sim/field): what each must show.
set -u
. "$(dirname "$0")/lib.sh"
field=tests/sim/field

# texels FILE PIXELS: as aarrggbb.
texels() {
    got=$("$PEL" import "$1" --format argb8888 --name a -o - | awk '
        /pixels = / { inside = 1; next }
        /^}/ { inside = 0 }
        inside { gsub(",", ""); for (i = 1; i <= NF; i++) byte[n++] = $i }
        END { for (i = 0; i < n; i += 4) printf "%s%02x%02x%02x%02x",
            i ? " " : "", byte[i + 3], byte[i + 2], byte[i + 1], byte[i] }')
    [ "$got" = "$2" ] || fail "$1: $got, not $2"
}
texels $field/k8.png "ff000000 00ffffff"
texels $field/w565.bmp "ffffffff"
texels $field/p6_max65535.ppm \
    "ffff0000 ff00ff00 ff0000ff ffffffff ff000000 ffffff00"
texels $field/t4.png "$(printf 'ffff0000 ffff0000 ff00ff00 ff00ff00 %.0s' 1 2
    printf 'ff0000ff ff0000ff ffffff00 ffffff00%.0s ' 1 2 | sed 's/ $//')"
half() { printf "$1%.0s " 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16; }
texels $field/cmyk.jpg "$(for row in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16; do
    half ffff0000
    half ff0000ff
done | sed 's/ $//')"

[ -e "$work/failed" ] || echo "files of the field are right"
