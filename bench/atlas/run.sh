#!/bin/sh
# run.sh BUILD FOLDER : a CSV of each case of the atlas in FOLDER/csv, by the
# programs in BUILD/bench. Times are measured in several batches, which lie as far
# apart as the run is long, so that their spread covers what changes meanwhile.
# What is there is not measured again, so that a run that was stopped goes on where
# it was; figures of another commit are moved out of the way. QUICK=1 measures
# less, and less often; SHARD=I/N the I-th part of N.
set -eu
build=$1
out=$2/csv
here=$(dirname "$0")
bench=$build/bench
batches=5
repeats=5
quick=
[ -z "${QUICK-}" ] || batches=2 repeats=3 quick=--quick
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

# A line `batch batches case` for each batch of a case of times, in the order of
# the batches; the other cases stand between them, with dashes.
jobs() {
    cases | awk -v batches=$batches -v quick=$quick -v part="${shard%/*}" \
        -v parts="${shard#*/}" '
        (NR - 1) % parts + 1 != part { next }
        quick && /^scene-/ { print 1, NR, 1, 1, $0; next }
        /^(speed-|scene-|matrix|.*-time$)/ {
            for (batch = 1; batch <= batches; batch++)
                print batch, NR, batch, batches, $0
            next
        }
        { print NR % batches + 1, NR, "- -", $0 }' | sort -n -k 1,1 -k 2,2 |
        cut -d ' ' -f 3-
}

# rows KIND COMMAND FILE... : files as rows of the atlas
rows() {
    kind=$1 command=$2
    shift 2
    awk -v kind="$kind" -v name="$name" -v command="$command" \
        -f "$here/csv.awk" "$@"
}

# Qt 5.15 mixes AVX2 fills with SSE code, which costs a transition per row (four
# times slower on recent CPUs); its alpha is better with AVX2. Each in the way
# that suits it.
speed() {
    features=avx2
    compare=
    case $1 in *alpha*) features= ;; esac
    [ "$batch" = 1 ] || compare=--no-coverage
    QT_NO_CPU_FEATURE=$features "$bench/pel-bench" --repeats $repeats \
        --csv "$out/raw" $compare "$1" >"$out/log"
}

# The times of batch $batch of the case $name, in the program's own form.
measure_times() {
    case $name in
    speed-*) speed "${name#speed-}" && cat "$out/raw" ;;
    scene-*) "$bench/pel-bench-scene" "$out/raw" "${name#scene-}" >"$out/log" &&
        cat "$out/raw" ;;
    matrix) "$bench/pel-matrix" ;;
    *) "$bench/pel-atlas" $quick "$name" ;;
    esac
}

# join_times FILE... : the CSV of the case $name, of whose batches these are
join_times() {
    case $name in
    speed-*) rows speed "$bench/pel-bench ${name#speed-}" "$@" ;;
    scene-*) rows scene "$bench/pel-bench-scene CSV ${name#scene-}" "$@" ;;
    matrix) rows matrix "$bench/pel-matrix" "$@" ;;
    *) rows atlas "$bench/pel-atlas${quick:+ $quick} $name" "$@" ;;
    esac
}

# The CSV of the case $name. `set -e` does not hold in a condition.
measure() {
    case $name in
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

# do_job FILE WHAT : what is made by the function of that name
do_job() {
    start=$(date +%s%N)
    rm -f "$out/raw"
    if "$2" >"$out/new" </dev/null; then
        mv "$out/new" "$1"
        took=$((($(date +%s%N) - start) / 100000000))
        printf '[%d/%d] %s %d.%d s\n' $i "$total" "${1##*/}" $((took / 10)) \
            $((took % 10)) >&2
        return
    fi
    echo "[$i/$total] $name failed; its rows are in $out/$name.failed" >&2
    mv "$out/new" "$out/$name.failed"
    status=1
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

jobs >"$out/jobs"
total=$(wc -l <"$out/jobs")
i=0
status=0
while read -r batch of name; do
    i=$((i + 1))
    [ ! -e "$out/$name.csv" ] || continue
    if [ "$batch" = - ]; then
        do_job "$out/$name.csv" measure
        continue
    fi
    [ -e "$out/$name.batch$batch" ] || do_job "$out/$name.batch$batch" measure_times
    set -- "$out/$name".batch*
    [ $# = "$of" ] && [ -e "$1" ] || continue
    join_times "$@" >"$out/new"
    mv "$out/new" "$out/$name.csv"
    rm "$@"
done <"$out/jobs"
rm -f "$out/raw" "$out/log" "$out/jobs"
exit $status
