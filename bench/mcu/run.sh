#!/bin/sh
# run.sh FOLDER CPUS : runs FOLDER/mcu/CPU.elf twice and writes the counts as
# TSV. The two runs must agree to the last instruction.
set -eu
folder=$1

count() {
    timeout 100 qemu-system-arm -M mps2-an386 -display none -monitor none \
        -serial none -icount shift=6,sleep=off -chardev stdio,id=out \
        -semihosting-config enable=on,target=native,chardev=out \
        -kernel "$1" </dev/null
}

printf 'cpu\tcase\tparameter\tinstructions\n'
for cpu in $2; do
    elf=$folder/mcu/$cpu.elf
    count "$elf" >"$elf.counts"
    count "$elf" | cmp -s - "$elf.counts" || {
        echo "bench-mcu: two runs of $elf gave different counts" >&2
        exit 1
    }
    # case, parameter, ticks, and how many calls or pixels they are for
    awk -v cpu="$cpu" '{
        printf "%s\t%s\t%d\t%.2f\n", cpu, $1, $2, $3 / 1.6 / $4
    }' "$elf.counts"
done
