#!/bin/sh
# pel compare --shrink: the smallest script that fails as the whole does.
set -u
. "$(dirname "$0")/lib.sh"
export PEL

dir="$work/a 'folder'"
mkdir "$dir"
cp sim/scenes/shapes.pel "$dir/s.pel"

# Of 56 lines one ring and its paint are needed for this pixel.
"$PEL" compare --shrink "$dir/s.pel" -o "$work/small.pel" \
    --command '! "$PEL" explain "$1" 40 40 | grep -q "ring: .* gives #f2cf45"' \
    2>"$work/err" || fail "$(cat "$work/err")"
cat >"$work/want.pel" <<'END'
canvas 480 320 xrgb8888
clear #f4f1e8
paint flat #f1c40fc0
ring 70.5 70.5 35 50
END
cmp "$work/want.pel" "$work/small.pel" || fail "another script"
grep -q 'pel: .*s.pel: 4 of 56 lines are left, after [0-9]* runs' "$work/err" ||
    fail "no report: $(cat "$work/err")"

# Another failure than the whole script's does not count.
"$PEL" compare --shrink "$dir/s.pel" \
    --command 'grep -q ^sector "$1" || exit 1; grep -q ^arc "$1" && exit 3' \
    >"$work/small.pel" || fail "no script"
[ "$(grep -c . "$work/small.pel")" = 2 ] && grep -q ^sector "$work/small.pel" ||
    fail "not sector and arc: $(cat "$work/small.pel")"
[ -z "$(find "$dir" -name '.pel*')" ] || fail "a file is left behind"

refused_command 'the command does not fail' compare --shrink "$dir/s.pel" --command true
refused_command 'did not end: Killed' compare --shrink "$dir/s.pel" --command 'kill -9 $$'
refused_command 'cannot be read' compare --shrink "$dir/none" --command false
refused_command 'expected A B ' compare --shrink "$dir/s.pel"
refused_command 'expected A B ' compare a.ppm
refused_command 'expected A B ' compare a.ppm a.ppm -o "$work/diff.ppm"
refused_command 'or --shrink SCRIPT' compare --shrink "$dir/s.pel" --command false --tolerance 1

# An interrupted run leaves what it has reached.
"$PEL" compare --shrink "$dir/s.pel" -o "$work/part.pel" --command \
    '[ "$(wc -l <"$1")" -gt 20 ] && exit 1; kill -9 $$' 2>"$work/err" &&
    fail "a killed command counts"
[ "$(wc -l <"$work/part.pel")" -lt 56 ] ||
    fail "what was reached is lost: $(cat "$work/err")"

# A signal ends the command; what was reached is written, and the script that the
# command was given is gone. A second one ends pel.
for signal in TERM HUP PIPE ALRM XCPU; do
    rm -f "$work/part.pel"
    "$PEL" compare --shrink "$dir/s.pel" -o "$work/part.pel" --command \
        '[ "$(wc -l <"$1")" -gt 20 ] && exit 1; exec sleep 30' 2>"$work/err" &
    program=$!
    for i in $(seq 600); do
        pgrep -P $program -x sleep >/dev/null && break
        sleep 0.1
    done
    kill -$signal $program
    wait $program
    status=$?
    [ $status = 2 ] || fail "$signal: status $status"
    grep -q 'did not end: ' "$work/err" || fail "$signal: $(cat "$work/err")"
    [ -s "$work/part.pel" ] && [ "$(wc -l <"$work/part.pel")" -lt 56 ] ||
        fail "$signal: what was reached is lost"
    [ -z "$(find "$dir" -name '.pel*')" ] || fail "$signal: a file is left behind"
done

# Nobody can catch KILL: the file is gone all the same.
"$PEL" compare --shrink "$dir/s.pel" --command 'exec sleep 30' 2>"$work/err" &
program=$!
for i in $(seq 600); do
    sleep=$(pgrep -P $program -x sleep) && break
    sleep 0.1
done
kill -KILL $program
wait $program 2>/dev/null
for i in $(seq 600); do
    [ -z "$(find "$dir" -name '.pel*')" ] && break
    sleep 0.1
done
kill "$sleep"
[ -z "$(find "$dir" -name '.pel*')" ] || fail "KILL: a file is left behind"

# The example of --help is a command as it is printed: bands are as the whole.
cp "$dir/s.pel" "$work/BAD.pel"
"$PEL" compare --help | sed -n '/^  pel compare/,$p' |
    (PATH=$(cd "${PEL%/*}" && pwd):$PATH && cd "$work" && sh 2>&1) |
    grep -q 'BAD.pel: the command does not fail' || fail "the example of --help"
