#!/bin/sh
# one.sh FOLDER : each line of the input is `CPU-LEVEL PROGRAM...`, linked with
# separate files in FOLDER/CPU-LEVEL and with the amalgamation in its folder one.
# The smallest program takes the same bytes of flash of both, but for 4 where the
# linker aligns them; others a few more or less, as the compiler sees fit, and all
# together no more.
set -eu
folder=$1

flash() {
    size "$1" | awk 'NR == 2 { print $1 + $2 }'
}

while read -r build programs; do
    for program in $programs; do
        echo "$build $program $(flash "$folder/$build/$program.elf")" \
            "$(flash "$folder/$build/one/$program.elf")"
    done
done | awk '{
        files[$1] += $3
        one[$1] += $4
        if ($4 > ($2 == "flat" ? $3 + 4 : $3 * 1.04)) {
            print $0 ": the amalgamation is larger"
            bad = 1
        }
    }
    END {
        for (build in one) {
            print build " " files[build] " bytes from files, " one[build] " from one"
            bad = bad || one[build] > files[build]
        }
        exit bad || NR == 0
    }'
