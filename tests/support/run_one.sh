#!/bin/sh
# Runs one test of run.sh: `run_one.sh DIR "NAME<TAB>COMMAND"`. A cmocka program
# counts as many tests as it ran; anything else is one test, passed when it
# exits with 0. A crash or a time-out (PEL_TIMEOUT seconds, 1,800 unless told) is
# a failed test. Tests whose name begins with `make ` share objects: one of them
# runs at a time, and waiting is not its time. The last lines of a failed test's
# output are shown, and of all tests how many have ended.
set -u
dir=$1
name=${2%%	*}
command=${2#*	}
log=$dir/$(echo "$name" | tr '/ ' '__').log

case $name in
    make\ *)
        exec 9>"$dir/make.lock"
        flock 9
        ;;
esac
start=$(date +%s%N)
timeout "${PEL_TIMEOUT:-1800}" sh -c "$command" >"$log" 2>&1 </dev/null 9>&-
status=$?
milliseconds=$((($(date +%s%N) - start) / 1000000))

passed=$(grep -c '^\[       OK \]' "$log")
failed=$(sed -n 's/^\[  FAILED  \] \([0-9]*\) test(s).*/\1/p' "$log" |
    awk '{ n += $1 } END { print n + 0 }')
if ! grep -q '^\[==========\] Running' "$log"; then
    passed=$((status == 0))
fi
if [ $status -ne 0 ] && [ "$failed" -eq 0 ]; then
    failed=1
fi
word=ok
if [ "$failed" -gt 0 ]; then
    word=FAILED
fi
echo "$passed $failed $milliseconds $name" >"${log%.log}.count"
ended=$(find "$dir" -name '*.count' | wc -l)
printf '%3d of %d  %-6s %4d.%03d s %4d passed %3d failed  %s\n' "$ended" \
    "$(wc -l <"$dir/list")" $word \
    $((milliseconds / 1000)) $((milliseconds % 1000)) "$passed" "$failed" \
    "$name"
if [ "$failed" -gt 0 ]; then
    [ $status -eq 124 ] && echo "    timed out"
    tail -n 40 "$log" | sed 's/^/    /'
fi
