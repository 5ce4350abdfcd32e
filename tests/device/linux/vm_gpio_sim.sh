#!/bin/sh
# vm_gpio_sim.sh VERSION FOLDER: makes FOLDER/gpio-sim.ko, the kernel's simulated
# GPIO chips, which Debian's kernel leaves out, from Debian's source of it
# (linux-source) and its headers (linux-headers-amd64).
set -eu
version=$1
folder=$2
build=/usr/src/linux-headers-$version
source=$(find /usr/src -name 'linux-source-*.tar.xz' | sort | tail -n 1)
[ -d "$build" ] && [ -n "$source" ] || {
    echo "vm_gpio_sim.sh: headers or source of Linux $version are missing:" \
        "install the packages linux-headers-amd64 and linux-source" >&2
    exit 2
}
mkdir -p "$folder/gpio-sim"
cd "$folder/gpio-sim"
tar -xJf "$source" --wildcards --transform 's|.*/||' \
    '*/drivers/gpio/gpio-sim.c' '*/drivers/gpio/gpiolib.h' \
    '*/kernel/irq/irq_sim.c'
mv gpio-sim.c gpio_sim_main.c
# What is exported to modules does the same.
sed -i 's/irq_to_desc(irqnum)/irq_data_to_desc(irq_get_irq_data(irqnum))/
    /^MODULE_/d' irq_sim.c
cat > Makefile << 'END_OF_MAKEFILE'
obj-m := gpio-sim.o
gpio-sim-y := gpio_sim_main.o irq_sim.o
END_OF_MAKEFILE
make -s -C "$build" M="$PWD" modules > make.log 2>&1 || {
    cat make.log >&2
    exit 2
}
mv gpio-sim.ko ..
