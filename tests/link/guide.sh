#!/bin/sh
# guide.sh FOLDER COMPILER ARGUMENT... : the program of docs/firmware.md, written
# into FOLDER, compiles and links with these arguments.
set -eu
folder=$1
compiler=$2
shift 2
mkdir -p "$folder"
awk -v folder="$folder" -f tests/tools/doc_blocks.awk docs/firmware.md >/dev/null
"$compiler" "$folder/firmware.c" "$@"
