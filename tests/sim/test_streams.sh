#!/bin/sh
# What cannot be written is told with status 2: standard output and error that
# are full or closed, files beyond the size limit, one asset of two. Nothing is
# left behind. Scripts without an end are refused.
set -u
. "$(dirname "$0")/lib.sh"
scene=$(dirname "$0")/../../sim/scenes/cover.pel

printf 'P3 2 1 255  255 0 0  0 255 0' >"$work/a.ppm"
printf 'P3 1 1 255  255 0 0' >"$work/b.ppm"
printf 'P3 2 1 255  255 0 0  0 255 1' >"$work/c.ppm"

full='No space left on device'
for arguments in --help 'run --help' 'view --usage' "run $scene" \
    "compare $work/a.ppm $work/b.ppm" "compare $work/a.ppm $work/c.ppm" \
    'render --print-camera builtin:vase'; do
    # shellcheck disable=SC2086
    "$PEL" $arguments >/dev/full 2>"$work/err"
    [ $? = 2 ] && grep -q "^pel: standard output cannot be written: $full" \
        "$work/err" || fail "pel $arguments, full: $(cat "$work/err")"
    # shellcheck disable=SC2086
    "$PEL" $arguments >&- 2>"$work/err"
    [ $? = 2 ] && grep -q '^pel: standard output cannot be written: Bad file' \
        "$work/err" || fail "pel $arguments, closed: $(cat "$work/err")"
done
"$PEL" render builtin:vase --size 9x9 --time -o "$work/o.ppm" 2>/dev/full
[ $? = 2 ] || fail "standard error is full"
"$PEL" compare "$work/a.ppm" "$work/a.ppm" >&- || fail "nothing to be told"

mkdir "$work/empty" "$work/two" "$work/two/a.h"
(ulimit -f 8 && "$PEL" run "$scene" -o "$work/empty/o.ppm") 2>"$work/err"
[ $? = 2 ] && grep -qF 'empty/o.ppm: cannot be written: File too large' \
    "$work/err" || fail "beyond the size limit: $(cat "$work/err")"
[ -z "$(ls -A "$work/empty")" ] || fail "left: $(ls -A "$work/empty")"

"$PEL" import "$work/a.ppm" -o "$work/two/a.c" 2>"$work/err"
[ $? = 2 ] && grep -qF 'two/a.h: cannot be written: Is a directory' \
    "$work/err" || fail "an .h that is a directory: $(cat "$work/err")"
[ "$(ls -A "$work/two")" = a.h ] || fail "left: $(ls -A "$work/two")"

# endless NAME TEXT: the script on standard input is refused at once, in a short
# line.
endless() {
    timeout 5 "$PEL" run - >/dev/null 2>"$work/err"
    status=$?
    [ $status = 2 ] || fail "$1: status $status"
    [ "$(wc -c <"$work/err")" -lt 300 ] && grep -qF "$2" "$work/err" ||
        fail "$1: no '$2': $(head -c 300 "$work/err")"
}
repeat() { # a letter, for ever
    yes "$1" | tr -d '\n'
}
endless zeroes '(standard input):1: a zero byte: scripts are text' </dev/zero
repeat x | endless 'a line' ':1: a line of over 1048576 bytes'
{ echo 'canvas 8 8 gray8' && repeat 5 | head -c 5000; } |
    endless 'a word' ':2: a word of 5000 bytes: expected up to 4096'
{ echo 'canvas 8 8 gray8' && printf 'text 1 1 "' && repeat 5 |
    head -c 5000 && echo '"'; } | endless 'a text' ':2: a word of 5002 bytes'

# 300,000 glyphs of a byte, each with a code point.
psf() { # FLAGS COUNT GLYPH-BYTES HEIGHT
    printf '\162\265\112\206\0\0\0\0\040\0\0\0%b\0\0\0' "$1"
    printf '%b\0%b\0\0\0%b\0\0\0\010\0\0\0' "$2" "$3" "$4"
}
{ psf '\0' '\340\223\004' '\001' '\001' && head -c 300000 /dev/zero; } \
    >"$work/many.psf"
timeout 5 "$PEL" import "$work/many.psf" --codes 65-90 -o "$work/many.c" ||
    fail "many glyphs: status $?"

[ -e "$work/failed" ] || echo "streams: all is told"
