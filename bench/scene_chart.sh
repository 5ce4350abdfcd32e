#!/bin/sh
# usage: scene_chart.sh CSV PNG
# Draws how the time of a picture in 3-D grows with triangles and with pixels,
# from the CSV of `make bench-scene`; says so when gnuplot is not installed.
set -eu
csv=$1
png=$2
if ! command -v gnuplot >/dev/null; then
    echo "No chart: gnuplot is not installed (Debian package gnuplot-nox)."
    exit 0
fi
data=$(mktemp -d)
trap 'rm -rf "$data"' EXIT

awk -F, -v out="$data" '
    $1 == "triangles" { print $3, $7 / 1e6 >(out "/triangles_" $4) }
    $1 == "pixels" { print $5 * $5, $7 / 1e6 >(out "/pixels_" $4) }' "$csv"

gnuplot -e "data='$data'; png='$png'" "$(dirname "$0")/scene_chart.gp"
