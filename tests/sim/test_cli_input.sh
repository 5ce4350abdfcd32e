#!/bin/sh
# pel input: what it refuses, on a machine that need not have a line.
set -eu
. "$(dirname "$0")/lib.sh"

# refuse MESSAGE BUTTONS: status 2 and this line.
refuse() {
    status=0
    "$PEL" input --only-buttons --buttons "$2" >"$work/out" 2>"$work/told" ||
        status=$?
    # shellcheck disable=SC2015
    [ $status = 2 ] && [ ! -s "$work/out" ] &&
        grep -qF -e "pel: $1" "$work/told" ||
        fail "$2: status $status: $(cat "$work/told")"
}

key="expected a key: left, enter, f1, space, a, ..."
word="expected LINE=KEY, A/B=wheel, pull-up, pull-down, floating"
refuse "buttons: 'lft': $key" gpiochip0:5=lft
refuse "buttons: 'f25': $key" 5=f25
refuse "buttons: 'pullup': $word" gpiochip0:5=left,pullup
refuse "buttons: '': $word" gpiochip0:5=left,,6=right
refuse "buttons: 'turn': expected wheel or wheel-x" gpiochip0:17/27=turn
refuse "buttons: '': expected a line's number or name before =" gpiochip0:=a
refuse "buttons: '': expected a line's number or name before =" gpiochip0:5/=wheel
refuse "buttons: debounce=: expected 0 to 1000" gpiochip0:debounce=
for states in '' 3 5 24; do
    refuse "buttons: '$states': expected states=2 or states=4" \
        "gpiochip0:5=a,states=$states"
done
refuse "buttons: 'pull-down': expected gpiochip0:5=left" pull-down
refuse "buttons: '32': expected at most 32 lines" \
    "gpiochip0:$(seq 0 32 | sed 's/$/=a/' | paste -sd,)"
if pkg-config --exists libgpiod; then
    refuse "line 5 is of which chip? expected gpiochip0:5" 5=left
    refuse "cannot open /dev/none: No such file or directory; and no chip has" \
        none:5=left
else
    refuse "built without libgpiod" 5=left
fi
"$PEL" input --only-buttons --seconds 0.01 || fail "no buttons: status $?"
