#!/bin/sh
# methods.sh PEL-ATLAS PEL: Pel keeps its promises in every regime that takes little
# time, and what is printed is what is promised.
set -eu
atlas=$1 pel=$2
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
failed=0

say()
{
    echo "methods: $*" >&2
    failed=1
}

"$atlas" --list >"$dir/list"
for case in thinness overflow limits color span sampling fighting \
    circle map-circle arctangent dither smooth-discs smooth-needles \
    smooth-seams; do
    grep -qx "$case" "$dir/list" || say "--list has no $case"
    "$atlas" --quick "$case" >"$dir/csv" || say "$case fails"
    awk -F , -v name="$case" '
        NR == 1 { good = $0 == \
            "case,method,x,y,metric,value,low,high,unit,command"; next }
        NF != 10 || $1 != name || $6 !~ /^-?[0-9.e+-]+$/ { good = 0; print }
        END { exit !(good && NR > 1) }' "$dir/csv" >&2 ||
        say "$case is no CSV of the atlas"
done

# A row's command repeats it.
$(tail -n 1 "$dir/csv" | sed "s|.*,build/bench/pel-atlas|$atlas|") |
    cmp - "$dir/csv" || say "the command of a row does not repeat it"

# The smallest triangle that a method draws wrong: a scene that pel draws, and
# whose wrong pixel, on the canvas, it explains.
while read -r case method; do
    "$atlas" --quick --smallest "$method" "$case" >"$dir/wrong.pel" ||
        say "no smallest triangle of $case by $method"
    pixel=$(sed -n 's/.*first wrong pixel is \([0-9]* [0-9]*\)\.$/\1/p' \
        "$dir/wrong.pel")
    "$pel" run "$dir/wrong.pel" -o "$dir/wrong.ppm" ||
        say "pel does not draw $case by $method"
    "$pel" explain --all "$dir/wrong.pel" $pixel | grep -q ' edge 0-1: ' ||
        say "pel does not explain $case by $method"
done <<EOF
damage int32 half-space S=8
thinness 16.16 rounded
overflow float32 barycentric with ties
map-sliver float32 scanline
EOF
"$atlas" --quick --smallest pel thinness 2>&1 | grep -q "no triangle" ||
    say "Pel has a smallest wrong triangle"
"$atlas" --quick --smallest 16.16 thinness 2>/dev/null &&
    say "a method that is not there is no error"

"$atlas" nothing >/dev/null 2>&1 && say "a case that is not there is no error"
exit $failed
