#!/bin/sh
# vm_panel_mock.sh FOLDER: makes FOLDER/panel_mock.ko for the kernel of
# vm_image.sh, from the headers that belong to it.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
folder=$(cd "$1" && pwd)
[ "$folder/panel_mock.ko" -nt "$here/panel_mock.c" ] &&
    [ "$folder/panel_mock.ko" -nt "$folder/vmlinuz" ] && exit 0

read -r package < "$folder/package"
version=${package#linux-image-}
work=$(mktemp -d "$folder/work.XXXXXX")
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get download -q "linux-headers-$version" \
    "linux-headers-${version%-amd64}-common" \
    "linux-kbuild-$(echo "$version" | cut -d. -f1,2)" > fetch.log 2>&1 || {
    cat fetch.log >&2
    exit 2
}
for deb in *.deb; do
    dpkg-deb -x "$deb" .
done
sed -i "s|/usr/src|$work/usr/src|" "usr/src/linux-headers-$version/Makefile"
mkdir module
cp "$here/panel_mock.c" module/
echo 'obj-m := panel_mock.o' > module/Makefile
env -u MAKEFLAGS -u MFLAGS -u MAKEOVERRIDES make -C "usr/src/linux-headers-$version" M="$work/module" modules \
    > make.log 2>&1 || {
    cat make.log >&2
    exit 2
}
mv module/panel_mock.ko "$folder/panel_mock.ko"
