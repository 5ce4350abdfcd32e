#!/bin/sh
# products.sh BUILD [1] : what the products of examples/ cost on two CPUs, as the
# table of docs/PRODUCTS.md, for each name on standard input. It fails when a
# figure is above the one that the page has; with 1 the page is written anew.
# Instructions are in thousands, from what the boards wrote (board_examples.sh).
set -eu
build=$1
accept=${2-}
page=docs/PRODUCTS.md
new=$build/products.md
. tests/link/board.sh

# cost CPU NAME : flash, RAM, stack, and instructions of a frame and of a step
cost() {
    elf=$build/link/cortex-$1-O2/product_$2.elf
    stack=$(run_on_board cortex-m4-O2 "$elf" | sed -n 's/^stack //p')
    arm-none-eabi-size -A "$elf" | awk -v stack="$stack" '{ size[$1] = $2 }
        END { print size[".text"] + size[".data"], size[".data"] + size[".bss"],
              stack }'
    LC_ALL=C sed -n '1,6s/^# .* \([0-9]*\) instructions$/\1/p' \
        "$build/board/$1/$2.out" | awk '{ printf "%.0f\n", $1 / 1000 }'
}

sed '/^|/,$d' "$page" >"$new"
cat >>"$new" <<'END'
| product | flash M0+ | flash M4 | RAM | stack M0+ | stack M4 | first frame M0+ | step M0+ | first frame M4 | step M4 |
|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|
END
while read -r name; do
    set -- $(cost m0plus "$name") $(cost m4 "$name")
    [ $# = 10 ] || { echo "$name: counted only: $*" >&2; exit 1; }
    echo "| <img src=\"pictures/$name.png\" width=\"96\" alt=\"\"><br>[$name](../examples/$name.c) | $1 | $6 | $2 | $3 | $8 | $4 | $5 | $9 | ${10} |"
done >>"$new"
sed '1,/^|---/d; /^|/d' "$page" >>"$new"
grep '^|' "$new"
if [ "$accept" ]; then
    cp "$new" "$page"
    exit
fi
awk -F ' *[|] *' '
    FNR == 1 { pages++ }
    !/^\|/ || /^\|-/ { next }
    { sub(/.*\[/, "", $2); sub(/\].*/, "", $2) }
    pages == 1 { for (i = 3; i < NF; i++) was[$2, i] = $i; next }
    $2 == "product" { for (i = 3; i < NF; i++) head[i] = $i; next }
    {
        for (i = 3; i < NF; i++)
            if (!(($2, i) in was) || $i + 0 > was[$2, i] * (i > 7 ? 1.002 : 1)) {
                print $2 ": " head[i] ": " $i ", was " was[$2, i] > "/dev/stderr"
                failed = 1
            }
    }
    END {
        if (failed)
            print "products: a growth that is meant: make products ACCEPT=1" \
                > "/dev/stderr"
        exit failed
    }' "$page" "$new"
