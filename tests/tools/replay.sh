#!/bin/sh
# replay.sh PROGRAM...: property tests can be replayed. Each fails, as PEL_FAIL
# asks it to, and prints what its case is made of, and a command; that command
# passes, and prints the same.
set -u
log=$(mktemp -d)
trap 'rm -r "$log"' EXIT
failed=0

# The lines that begin with a kind of shape.
parts() {
    sed -n '/^[a-z][a-z ]* [(0-9-]/p' "$1"
}

for program in "$@"; do
    PEL_SEED=7 PEL_FAIL=1 "$program" >"$log/out" 2>"$log/failing"
    [ $? -ne 0 ] && command=$(grep -m 1 "^PEL_SEED=7 PEL_CASE=0 " \
        "$log/failing") || {
        echo "$program: PEL_FAIL=1: no failure, or no command"
        failed=1
        continue
    }
    sh -c "$command" >"$log/out" 2>"$log/again" || {
        echo "$command: fails alone: $(grep -m 3 -h 'ERROR\|LINE' \
            "$log/again" "$log/out")"
        failed=1
    }
    parts "$log/failing" >"$log/parts"
    parts "$log/again" | grep -vxFf - "$log/parts" >"$log/missing" && {
        echo "$command: does not show: $(cat "$log/missing")"
        failed=1
    }
    [ -s "$log/parts" ] || case $program in
    */test_drivers_* | *_numbers | *_palette | *_mask) ;;
    *)
        echo "$program: a failure prints no shape"
        failed=1
        ;;
    esac
done
[ $failed -eq 0 ] && echo "replay: $# programs show a case again"
exit $failed
