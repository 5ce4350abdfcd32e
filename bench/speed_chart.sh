#!/bin/sh
# usage: speed_chart.sh CSV PNG
# Draws ns per pixel of every workload and method, from the CSV of `make bench`;
# says so when gnuplot is not installed.
set -eu
csv=$1
png=$2
if ! command -v gnuplot >/dev/null; then
    echo "No chart: gnuplot is not installed (Debian package gnuplot-nox)."
    exit 0
fi
data=$(mktemp -d)
trap 'rm -rf "$data"' EXIT

# A file for each method: workload's row, ns per pixel. Rows count downwards.
awk -F, -v out="$data" '
    NR == 1 { next }
    !($2 in row) { row[$2] = ++n; print n, $2 >(out "/names") }
    {
        series = $3 == "pel" ? "pel " $1 : $3
        gsub(/ /, "_", series)
        print row[$2], $4 / $9 >(out "/" series)
    }' "$csv"

gnuplot -e "data='$data'; png='$png'" "$(dirname "$0")/speed_chart.gp"
