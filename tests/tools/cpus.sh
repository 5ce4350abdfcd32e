#!/bin/sh
# cpus.sh BUILD : runs build/cpus/NAME/scenes for each line `NAME [EMULATOR]` of
# the input; all must print what tests/golden/scenes.txt says.
set -u
build=$1
golden=tests/golden/scenes.txt
status=0
while read -r name emulator; do
    folder=$build/cpus/$name
    if timeout 300 $emulator "$folder/scenes" >"$folder/scenes.txt" \
        </dev/null && cmp -s "$golden" "$folder/scenes.txt"; then
        echo "equal      $name"
    else
        echo "DIFFERENT  $name"
        diff "$golden" "$folder/scenes.txt" | head -n 5
        status=1
    fi
done
exit $status
