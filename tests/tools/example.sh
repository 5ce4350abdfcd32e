#!/bin/sh
# example.sh OUT COMMAND... : runs an example. A picture goes to OUT.ppm, on a board
# to OUT.png, too, where there is a pel that writes it, and what its comments say is
# shown; text is shown as it is.
set -eu
out=$1
shift
status=0
# In a folder of a build, board/BOARD/EXAMPLE.
write_png() {
    rm -f "$out.png"
    {
        LC_ALL=C sed -n '/^\([0-9]* [0-9]*\) 255$/{s//canvas \1 rgb888/p;q;}' "$out.ppm"
        echo "image 0 0 $out.ppm"
    } | "$(dirname "$out")/../../pel" run - -o "$out.png" 2>/dev/null
}
"$@" </dev/null >"$out.ppm" || status=$?
if [ "$(head -c 2 "$out.ppm")" = P6 ]; then
    LC_ALL=C sed -n -e '/^# /s///p' -e '/^[0-9]* [0-9]* 255$/q' "$out.ppm"
    case $out in */board/*/*) write_png && ending=png ;; esac
    echo "the picture: $out.${ending:-ppm}"
else
    cat "$out.ppm"
    rm "$out.ppm"
fi
[ $status = 0 ] || echo "$(basename "$out"): its main returned $status" \
    "(pel_status_name names errors; PEL_ASSERT, docs/use.md, finds the call)" >&2
exit $status
