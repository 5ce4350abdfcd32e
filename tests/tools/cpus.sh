#!/bin/sh
# cpus.sh BUILD : runs build/cpus/NAME/scenes for each line `NAME [EMULATOR]` of
# the input; all must print what tests/golden/scenes.txt says, or golden.txt
# beside them.
set -u
build=$1
status=0
while read -r name emulator; do
    folder=$build/cpus/$name
    golden=$folder/golden.txt
    [ -f "$golden" ] || golden=tests/golden/scenes.txt
    if timeout 300 $emulator "$folder/scenes" >"$folder/scenes.txt" \
        2>"$folder/messages.txt" </dev/null && cmp -s "$golden" "$folder/scenes.txt"; then
        echo "equal      $name"
    else
        echo "DIFFERENT  $name"
        cat "$folder/messages.txt"
        diff "$golden" "$folder/scenes.txt" | head -n 5
        status=1
    fi
done
exit $status
