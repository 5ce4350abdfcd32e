#!/bin/sh
# index.sh BUILD CC [accept] : makes docs/index.md anew from the public headers and
# compares; accept: writes it.
set -eu
mkdir -p "$1"
{
    cat <<'END'
# Index

Every function, type, macro and object of the public headers, with the first
sentence of its comment; the headers tell the rest. Written by `make index`.
END
    awk -f tests/tools/index.awk $(tests/tools/public_headers.sh "$2")
} >"$1/index.md"
[ -z "${3-}" ] || cp "$1/index.md" docs/index.md
diff docs/index.md "$1/index.md" ||
    { echo "docs/index.md: not what the headers say: make index"; exit 1; }
