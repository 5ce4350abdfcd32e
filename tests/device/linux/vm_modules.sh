#!/bin/sh
# vm_modules.sh FOLDER: makes the modules panel_mock.ko and damage_clips.ko in
# FOLDER for the kernel of vm_image.sh, with its headers (linux-headers-amd64).
set -eu
here=$(cd "$(dirname "$0")" && pwd)
folder=$(cd "$1" && pwd)
modules="panel_mock damage_clips"

made=yes
for module in $modules; do
    [ "$folder/$module.ko" -nt "$here/$module.c" ] &&
        [ "$folder/$module.ko" -nt "$folder/vmlinuz" ] || made=no
done
[ $made = no ] || exit 0

read -r package < "$folder/package"
build=/usr/src/linux-headers-${package#linux-image-}
[ -d "$build" ] || {
    echo "vm_modules.sh: $build is missing: install the package" \
        "linux-headers-amd64" >&2
    exit 2
}
work=$(mktemp -d "$folder/work.XXXXXX")
trap 'rm -rf "$work"' EXIT
for module in $modules; do
    cp "$here/$module.c" "$work/"
    echo "obj-m += $module.o" >> "$work/Makefile"
done
env -u MAKEFLAGS -u MFLAGS -u MAKEOVERRIDES \
    make -s -C "$build" M="$work" modules > "$work/log" 2>&1 || {
    cat "$work/log" >&2
    exit 2
}
for module in $modules; do
    mv "$work/$module.ko" "$folder/$module.ko"
done
