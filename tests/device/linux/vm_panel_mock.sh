#!/bin/sh
# vm_panel_mock.sh FOLDER: makes FOLDER/panel_mock.ko for the kernel of
# vm_image.sh, with its headers (linux-headers-amd64).
set -eu
here=$(cd "$(dirname "$0")" && pwd)
folder=$(cd "$1" && pwd)
[ "$folder/panel_mock.ko" -nt "$here/panel_mock.c" ] &&
    [ "$folder/panel_mock.ko" -nt "$folder/vmlinuz" ] && exit 0

read -r package < "$folder/package"
build=/usr/src/linux-headers-${package#linux-image-}
[ -d "$build" ] || {
    echo "vm_panel_mock.sh: $build is missing: install the package" \
        "linux-headers-amd64" >&2
    exit 2
}
work=$(mktemp -d "$folder/work.XXXXXX")
trap 'rm -rf "$work"' EXIT
cp "$here/panel_mock.c" "$work/"
echo 'obj-m := panel_mock.o' > "$work/Makefile"
env -u MAKEFLAGS -u MFLAGS -u MAKEOVERRIDES \
    make -s -C "$build" M="$work" modules > "$work/log" 2>&1 || {
    cat "$work/log" >&2
    exit 2
}
mv "$work/panel_mock.ko" "$folder/panel_mock.ko"
