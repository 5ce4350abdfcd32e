#!/bin/sh
# example.sh OUT COMMAND... : runs an example. A picture goes to OUT.ppm, and what
# its comments say is shown; text is shown as it is.
set -eu
out=$1
shift
status=0
"$@" </dev/null >"$out.ppm" || status=$?
if [ "$(head -c 2 "$out.ppm")" = P6 ]; then
    LC_ALL=C sed -n -e '/^# /s///p' -e '/^[0-9]* [0-9]* 255$/q' "$out.ppm"
    echo "the picture: $out.ppm"
else
    cat "$out.ppm"
    rm "$out.ppm"
fi
[ $status = 0 ] || echo "$(basename "$out"): its main returned $status" \
    "(pel_status_name names errors; PEL_ASSERT, docs/use.md, finds the call)" >&2
exit $status
