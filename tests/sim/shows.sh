# Of a mesh file, what it shows at places of a picture of 100 x 100 pixels that
# is 4 units wide, seen from the front and without light.
#
#     shows FILE COLOR:X,Y...: rrggbb, or rrggbb~ within 2 of it
. "$(dirname "$0")/lib.sh"
field=tests/sim/field

shows() {
    shown=$1
    shift
    "$PEL" render "$shown" --size 100x100 --unlit --texture nearest \
        --eye 0,0,5 --target 0,0,0 --projection orthographic --sensor 4x4 \
        --background '#000000' -o "$work/shows.ppm" 2>"$work/err" ||
        fail "$shown is refused: $(cat "$work/err")"
    for at in "$@"; do
        x=${at#*:} color=${at%:*}
        y=${x#*,} x=${x%,*}
        got=$(tail -c "$((30000 - 300 * y - 3 * x))" "$work/shows.ppm" |
            od -An -tu1 -N3 | tr -s ' ')
        want=$(printf ' %d %d %d' "0x$(echo "$color" | cut -c1-2)" \
            "0x$(echo "$color" | cut -c3-4)" "0x$(echo "$color" | cut -c5-6)")
        case $color in
        *~) near=2 ;;
        *) near=0 ;;
        esac
        echo "$got $want" | awk -v near=$near '{
            for (i = 1; i <= 3; i++)
                if ($i - $(i + 3) > near || $(i + 3) - $i > near) exit 1
        }' || fail "$shown shows$got, not $color, at $x, $y"
    done
}

# told TEXT: shows, or info, had a message with that text.
told() {
    grep -qF -- "$1" "$work/err" || fail "$shown: no '$1': $(cat "$work/err")"
}
