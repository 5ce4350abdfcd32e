#!/bin/sh
# jobs.sh PEL FOLDER: bands drawn side by side give the bytes of one thread, in
# all scenes and formats with lines of every kind.
set -eu
pel=$1
folder=$2
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$folder"
n=0
for scene in "$here"/../../../sim/scenes/*.pel "$here/reference.pel"; do
    for format in xrgb8888 rgb888 rgb565_le gray4 mono1 mono1_pages; do
        "$pel" run "$scene" --format $format -o "$folder/one.ppm"
        for jobs in 2 3 7; do
            "$pel" run "$scene" --format $format --jobs $jobs \
                -o "$folder/many.ppm"
            cmp "$folder/one.ppm" "$folder/many.ppm" || {
                echo "jobs.sh: $scene in $format with --jobs $jobs differs"
                exit 1
            }
            n=$((n + 1))
        done
    done
done
echo "jobs: $n pictures equal those of one thread"
