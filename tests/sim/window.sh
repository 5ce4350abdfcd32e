# An X server that shows nothing, for tests of windows; after lib.sh:
#
#     . "$(dirname "$0")/window.sh"
#
# What it would show is in $work/server/Xvfb_screen0. PEL may be named from any
# folder then.
tests/tools/need.sh Xvfb:xvfb xdotool:xdotool || exit 1
PEL=$(realpath "$PEL")
mkdir "$work/server"
# Without -noreset the server starts anew whenever a program ends, and the next one
# may find none.
Xvfb -noreset -displayfd 3 -screen 0 1024x768x24 -fbdir "$work/server" \
    3>"$work/display" 2>"$work/xvfb" &
server=$!
trap 'status=$?; kill $server 2>/dev/null; wait $server 2>/dev/null
    [ ! -e "$work/failed" ] || status=1; rm -rf "$work"; exit $status' EXIT

until_true() { # COMMAND...: up to a minute
    for i in $(seq 600); do
        "$@" >/dev/null 2>&1 && return
        sleep 0.1
    done
    fail "not within a minute: $*"
    return 1
}
until_true test -s "$work/display"
DISPLAY=:$(cat "$work/display")
export DISPLAY
unset SDL_VIDEODRIVER
