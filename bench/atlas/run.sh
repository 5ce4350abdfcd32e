#!/bin/sh
# run.sh BUILD FOLDER : a CSV of each case of the atlas in FOLDER/csv, by the
# programs in BUILD/bench. A case whose CSV is there is left alone, so that a run
# that was stopped goes on where it was; those of another commit are moved out of
# the way. QUICK=1 measures less, and less often; SHARD=I/N the I-th part of N.
set -eu
build=$1
out=$2/csv
here=$(dirname "$0")
bench=$build/bench
runs='1 2 3'
repeats=9
quick=
[ -z "${QUICK-}" ] || runs=1 repeats=3 quick=--quick
shard=${SHARD:-1/1}
case $shard in
[1-9]*/[1-9]*) ;;
*)
    echo "atlas: SHARD is I/N, as 2/8, not $shard" >&2
    exit 2
    ;;
esac

cases() {
    "$bench/pel-atlas" --list
    "$bench/pel-bench" --list | sed 's/^/speed-/' |
        if [ "$quick" ]; then grep -v -e -565-; else cat; fi
    printf 'scene-%s\n' cores mesh triangles pixels bands
    [ "$quick" ] || echo instructions
    printf '%s\n' matrix mcu size damage-mcu
}

# rows KIND COMMAND [FILE] : standard input, or the file, as rows of the atlas
rows() {
    awk -v kind="$1" -v name="$name" -v command="$2" -f "$here/csv.awk" \
        ${3+"$3"}
}

# Qt 5.15 mixes AVX2 fills with SSE code, which costs a transition per row (four
# times slower on recent CPUs); its alpha is better with AVX2. Each in the way
# that suits it.
speed() {
    features=avx2
    case $1 in *alpha*) features= ;; esac
    compare=
    for run in $runs; do
        QT_NO_CPU_FEATURE=$features "$bench/pel-bench" --repeats $repeats \
            --append --csv "$out/raw" $compare "$1" >&2 || return 1
        compare=--no-coverage
    done
    rows speed "$bench/pel-bench $1" "$out/raw"
}

# The CSV of the case $name. `set -e` does not hold in a condition.
measure() {
    rm -f "$out/raw"
    case $name in
    speed-*) speed "${name#speed-}" 2>"$out/log" ;;
    scene-*)
        "$bench/pel-bench-scene" "$out/raw" "${name#scene-}" >"$out/log" &&
            rows scene "$bench/pel-bench-scene CSV ${name#scene-}" "$out/raw"
        ;;
    matrix)
        "$bench/pel-matrix" >"$out/raw" &&
            rows matrix "$bench/pel-matrix" "$out/raw"
        ;;
    instructions)
        bench/instructions.sh "$bench/pel-count" "$out/raw" >"$out/log" &&
            rows instructions 'make bench-instructions' "$out/raw"
        ;;
    damage-mcu) cat "$bench/atlas/damage-mcu.csv" ;;
    mcu) rows mcu 'make bench-mcu' bench/mcu/budgets.tsv ;;
    size) rows size 'make size' tests/link/budgets.tsv ;;
    *) "$bench/pel-atlas" $quick "$name" ;;
    esac
}

commit=$(git describe --always --dirty 2>/dev/null || echo unknown)
before=$(cat "$out/commit" 2>/dev/null || echo "$commit")
if [ "$before" != "$commit" ]; then
    echo "atlas: $out is of $before, this is $commit: moved to $out-$before" >&2
    rm -rf "$out-$before"
    mv "$out" "$out-$before"
fi
mkdir -p "$out"
echo "$commit" >"$out/commit"
{
    echo "machine: $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1)," \
        "$(nproc) CPUs, $(uname -srm)"
    echo "compilers: $(gcc --version | head -n 1); $(clang --version | head -n 1)"
    echo "date: $(date -u +'%F %R UTC')${quick:+, a quick run}"
    echo "commit: $commit"
} >"$out/$(hostname).run"

cases >"$out/cases"
total=$(wc -l <"$out/cases")
i=0
status=0
while read -r name; do
    i=$((i + 1))
    [ $(((i - 1) % ${shard#*/} + 1)) = "${shard%/*}" ] || continue
    [ ! -e "$out/$name.csv" ] || continue
    start=$(date +%s%N)
    if measure >"$out/new" </dev/null; then
        mv "$out/new" "$out/$name.csv"
        printf '[%d/%d] %s %d.%d s\n' $i "$total" "$name" \
            $((($(date +%s%N) - start) / 1000000000)) \
            $((($(date +%s%N) - start) / 100000000 % 10)) >&2
    else
        echo "[$i/$total] $name failed; its rows are in $out/$name.failed" >&2
        mv "$out/new" "$out/$name.failed"
        status=1
    fi
done <"$out/cases"
rm -f "$out/raw" "$out/log" "$out/cases"
exit $status
