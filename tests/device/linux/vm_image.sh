#!/bin/sh
# vm_image.sh FOLDER: makes FOLDER/vmlinuz and FOLDER/initramfs from the kernel
# package that linux-image-amd64 depends on, whatever its version. Done once:
# nothing is fetched when both are there and this script, vm_gpio_sim.sh and init
# are older.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
folder=$1
modules="9p 9pnet_virtio virtio_pci i2c-dev cirrusfb cirrus bochs virtio-gpu qxl vfb
    evdev uinput virtio_input psmouse atkbd usbhid hid-generic uhci-hcd
    ehci-pci spidev configfs"

[ "$folder/initramfs" -nt "$0" ] && [ "$folder/initramfs" -nt "$here/init" ] &&
    [ "$folder/initramfs" -nt "$here/vm_gpio_sim.sh" ] &&
    [ -s "$folder/vmlinuz" ] && exit 0

need() { # PROGRAM PACKAGE
    command -v "$1" > /dev/null || {
        echo "vm_image.sh: $1 is missing: install the package $2" >&2
        exit 2
    }
}
PATH=$PATH:/sbin:/usr/sbin
need busybox busybox-static
need depmod kmod
need cpio cpio
need apt-get apt
need dpkg-deb dpkg

mkdir -p "$folder"
work=$(mktemp -d "$folder/work.XXXXXX")
trap 'rm -rf "$work"' EXIT
cd "$work"

package=$(apt-cache depends linux-image-amd64 |
    sed -n 's/^ *Depends: *\(linux-image-[0-9].*\)$/\1/p' | head -n 1)
[ -n "$package" ] || {
    echo "vm_image.sh: linux-image-amd64 names no kernel: apt-get update" >&2
    exit 2
}
apt-get download -q "$package" > fetch.log 2>&1 || {
    cat fetch.log >&2
    exit 2
}
mkdir kernel root root/bin
dpkg-deb --fsys-tarfile "$package"_*.deb |
    tar -x -C kernel --wildcards './boot/vmlinuz-*' './lib/modules/*'
version=$(ls kernel/lib/modules)
depmod -b kernel "$version"

for m in $modules; do
    modprobe -d kernel -S "$version" --show-depends "$m" 2> /dev/null |
        sed -n 's|^insmod .*\(/lib/modules/[^ ]*\).*|\1|p'
done | sort -u > list
while read -r file; do
    mkdir -p "root$(dirname "$file")"
    cp "kernel$file" "root$file"
done < list
"$here/vm_gpio_sim.sh" "$version" "$work"
cp gpio-sim.ko "root/lib/modules/$version/"
for file in modules.builtin modules.builtin.modinfo modules.order; do
    cp "kernel/lib/modules/$version/$file" "root/lib/modules/$version/"
done
depmod -b root "$version"
cp "$(command -v busybox)" root/bin/busybox
cp "$here/init" root/init
chmod 755 root/init
(cd root && find . | cpio -o -H newc --quiet) | gzip -1 > initramfs
mv kernel/boot/vmlinuz-* "$folder/vmlinuz"
mv initramfs "$folder/initramfs"
echo "$package" > "$folder/package"
