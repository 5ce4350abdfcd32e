#!/bin/sh
# page.sh FOLDER [1] : draws the charts of charts.txt from FOLDER/csv, as
# FOLDER/*.svg, and writes FOLDER/index.html, one page that needs nothing else:
# charts, and tables of all rows. A chart whose CSV is not there is left out, and
# named. With 1 the table of places in docs/ATLAS.md becomes this one.
set -eu
folder=$1
csv=$folder/csv
here=$(dirname "$0")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

awk -v out="$work" '/^name / { file = out "/" $2; print $2 >(out "/names") }
    NF { print >file }' "$here/charts.txt"

# field CHART KEY
field() { sed -n "s/^$2 //p" "$work/$1"; }

# draw CHART : its picture, or what is missing
draw() {
    files=
    for case in $(field "$1" case); do
        for file in "$csv"/$case.csv; do
            [ ! -e "$file" ] || files="$files $file"
        done
    done
    rm -f "$folder/$1.svg"
    if [ -z "$files" ]; then
        echo "atlas: chart $1 is left out: there is no $csv/$(field "$1" case).csv" >&2
        return
    fi
    awk -v style="$here/style.gp" -f "$here/chart.awk" "$work/$1" $files \
        >"$work/script" || return 0
    gnuplot "$work/script" >"$work/svg"
    mv "$work/svg" "$folder/$1.svg"
}

escape() { sed 's/&/\&amp;/g; s/</\&lt;/g'; }

# Pictures in one page share the shapes of their points, which are the same.
figure() {
    echo "<figure id=\"$1\">"
    echo "<h3>$1. $(field "$1" title | escape)</h3>"
    if [ -e "$folder/$1.svg" ]; then
        sed -e '1,/^>$/{/^<svg/,/^>$/!d;}' -e '/<title>.*<\/title>/s///' \
            -e 's/onload="[^"]*"//' "$folder/$1.svg"
    else
        echo "<p class=\"missing\">Left out: there is no row of it in" \
            "$(field "$1" case).csv.</p>"
    fi
    echo "<figcaption>$(field "$1" says | escape)</figcaption>"
    echo "</figure>"
}

# table FILE [ATTRIBUTE] : of values between commas, or of .tsv between tabs
table() {
    name=$(basename "${1%.?sv}")
    between=,
    [ "$1" = "${1%.tsv}" ] || between='\t'
    echo "<details id=\"table-$name\"${2-}><summary>$name," \
        "$(($(wc -l <"$1") - 1)) rows</summary><table>"
    escape <"$1" | awk -F "$between" '
        NR == 1 {
            columns = NF
            printf "<thead><tr>"
            for (i = 1; i <= NF; i++)
                printf "<th>%s</th>", $i
            print "</tr></thead><tbody>"
            next
        }
        {
            printf "<tr>"
            for (i = 1; i < columns; i++)
                printf "<td>%s</td>", $i
            for (i = columns + 1; i <= NF; i++)
                $columns = $columns "," $i
            print "<td>" $columns "</td></tr>"
        }'
    echo "</tbody></table></details>"
}

# The table in docs/ATLAS.md, between its two marks.
accept_places() {
    sed '/^<!-- places -->$/q' docs/ATLAS.md
    cat "$csv"/*.run | sed -n 's/^machine: \(.*\)/Of one run on \1: ratios of times, less than 1 where Pel is faster./p'
    awk -F '\t' '
        NR == 1 {
            print "\n| workload | place | best peer | Pel to best |" \
                " Pel to memset | what was tried |\n|---|---|---|---|---|---|"
            next
        }
        {
            print "| " $1 " | " $2 " of " $3 " | " $4 " | " \
                ($4 ? $5 " (" $6 " to " $7 ")" : "") " | " $8 " | " $10 " |"
        }
        END { print "" }' "$folder/places.tsv"
    sed -n '/^<!-- end of places -->$/,$p' docs/ATLAS.md
} >"$work/document"

while read -r name; do
    draw "$name"
done <"$work/names"
# A part of a run may have no times.
find "$csv" -name 'speed-*.csv' | sort |
    xargs awk -F '\t' -f "$here/places.awk" "$here/tried.tsv" >"$folder/places.tsv"
if [ "${2-}" ]; then
    accept_places
    mv "$work/document" docs/ATLAS.md
fi

{
    cat "$here/head.html"
    echo '<section id="run"><h2>What ran where</h2><pre>'
    cat "$csv"/*.run | escape
    echo '</pre></section>'
    cat "$here/choose.html"
    echo '<section id="charts"><h2>Charts</h2>'
    while read -r name; do
        figure "$name"
    done <"$work/names"
    echo '</section><section id="tables"><h2>Tables</h2>'
    table "$folder/places.tsv" ' open'
    for file in "$csv"/*.csv; do
        table "$file"
    done
    echo '</section>'
    echo '<script>'
    cat "$here/page.js"
    echo '</script></body></html>'
} >"$work/page"
mv "$work/page" "$folder/index.html"
echo "atlas: $folder/index.html"
