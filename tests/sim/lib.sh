# What the tests of the host program's commands begin with. PEL names the program
# (build/pel unless told); they run from the project's folder.
#
#     . "$(dirname "$0")/lib.sh"
#
# $work is a folder that is gone when the test ends; the test fails when fail was
# called, also in a subshell.
PEL=${PEL:-build/pel}
LIBPEL=$(dirname "$PEL")/libpel.a
INCLUDE=-Iinclude
CC=${CC:-cc}
WARNINGS="-Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow \
    -Wundef -Werror"
work=$(mktemp -d) || exit 1
trap 'status=$?; [ ! -e "$work/failed" ] || status=1; rm -rf "$work"
    exit $status' EXIT

fail() {
    echo "FAILED: $*" >&2
    : >"$work/failed"
}

# refused_script LINE TEXT: after a canvas in line 1, the script on standard input.
refused_script() {
    { echo "canvas 32 32 xrgb8888"; cat; } >"$work/s.pel"
    rm -f "$work/o.ppm"
    "$PEL" run "$work/s.pel" -o "$work/o.ppm" >"$work/out" 2>"$work/err"
    got=$?
    [ $got = 2 ] || fail "status $got, not 2, for: $2"
    grep -qF "pel: $work/s.pel:$1: $2" "$work/err" ||
        fail "no '$1: $2' in: $(cat "$work/err")"
    [ "$(grep -cv '^    ' "$work/err")" = 1 ] || fail "more than one: $2"
    [ ! -e "$work/o.ppm" ] || fail "output in spite of: $2"
}

# refused_command TEXT COMMAND ARGUMENT...: status 2, the text among the errors,
# nothing on standard output.
refused_command() {
    text=$1
    shift
    "$PEL" "$@" >"$work/out" 2>"$work/err"
    got=$?
    [ $got = 2 ] || fail "status $got for: $*"
    grep -qF -- "$text" "$work/err" || fail "no '$text' in: $(cat "$work/err")"
    [ ! -s "$work/out" ] || fail "output: $*"
}

# make_square FOLDER: a square from (0, 0) to (1, 1), its uv and its indices, as
# accessors 0 to 2 of a glTF file there that has $square_lists.
make_square() {
    o='\0\0\200\77' z='\0\0\0\0'
    printf "$z$z$z$o$z$z$o$o$z$z$o$z$z$o$o$o$o$z$z$z\0\0\1\0\2\0\0\0\2\0\3\0" \
        >"$1/square.bin"
}
square_lists='"buffers": [{"uri": "square.bin", "byteLength": 92}],
 "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48},
                 {"buffer": 0, "byteOffset": 48, "byteLength": 32},
                 {"buffer": 0, "byteOffset": 80, "byteLength": 12}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4,
                "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
               {"bufferView": 1, "componentType": 5126, "count": 4,
                "type": "VEC2"},
               {"bufferView": 2, "componentType": 5123, "count": 6,
                "type": "SCALAR"}]'
