#!/bin/sh
# atlas_page.sh PAGE : opens the atlas in Chromium and clicks through it
# (atlas_page.js). Fails when that finds something wrong, does not come to its
# end, or when the browser's console has a message.
set -eu
here=$(dirname "$0")
"$here/need.sh" chromium:chromium
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

sed '/<\/body>/,$d' "$1" >"$work/page.html"
{
    sed -n '/<\/body>/s/<\/body>.*//p' "$1"
    echo '<script>'
    cat "$here/atlas_page.js"
    echo '</script></body></html>'
} >>"$work/page.html"

# root may not have a sandbox
sandbox=
[ "$(id -u)" != 0 ] || sandbox=--no-sandbox
timeout 120 chromium --headless $sandbox --disable-gpu --window-size=1200,900 \
    --user-data-dir="$work/profile" --enable-logging=stderr \
    --virtual-time-budget=60000 --dump-dom "file://$work/page.html" \
    >"$work/dom" 2>"$work/messages" || {
    cat "$work/messages" >&2
    echo "atlas: chromium failed on $1" >&2
    exit 1
}
status=0
if grep CONSOLE "$work/messages" >&2; then
    echo "atlas: $1 writes to the console" >&2
    status=1
fi
sed -n 's/.*<pre id="atlas-check">//; s/<\/pre>.*//; /^WRONG/p; /^CHECKED/p' \
    "$work/dom"
grep -q '^CHECKED [0-9]*, 0 wrong\|>CHECKED [0-9]*, 0 wrong' "$work/dom" ||
    status=1
exit $status
