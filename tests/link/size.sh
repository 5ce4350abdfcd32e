#!/bin/sh
# size.sh FOLDER : what core costs on microcontrollers, as TSV, for each line
# `CPU-LEVEL PROGRAM...` of the input, a build in FOLDER: a row for every object
# of core, whose stack is its largest frame, one for the objects that a flat
# triangle needs, neither at -O2, and one for every program of tests/link, linked.
# A program's text and data are without start-up code, its bss holds its own
# pixels; its stack is that of the deepest call from main, by the call graph, and
# beside it what was used when the program ran on a board. Of CPUs other than
# Cortex-M what was used stands for both. The text of panel_CHIP and epaper_CHIP
# is what the program has of drivers/.
set -eu
folder=$1
here=$(dirname "$0")
. "$here/board.sh"
formats=$(basename -s .c core/format/*.c | tr '\n' ' ')

fail() {
    echo "size: $*" >&2
    exit 1
}

# object BUILD OBJECT
object_row() {
    frame=-
    [ -z "$graph" ] || frame=$("$tools-objdump" -d --no-show-raw-insn "$2" |
        awk -f "$here/stack.awk")
    "$tools-size" "$2" | awk -v cpu="$1" -v stack="$frame" \
        -v name="${2#"$folder/mcu/$1/"}" 'BEGIN { OFS = "\t" }
        NR == 2 { print cpu, name, $1, $2, $3, stack, "-" }'
}

# The walker and the fill of a flat triangle in RGB565: two objects, and what
# they link of two others.
flat_row() {
    objects=
    for name in raster/triangle raster/paint_flat format/fill \
        format/rgb565_le; do
        objects="$objects $folder/mcu/$1/core/$name.o"
    done
    "$tools-size" -A $objects | awk -v cpu="$1" 'BEGIN { OFS = "\t" }
        / *:$/ { part = /format/ }
        /^\.(text|s?rodata)/ && (!part || $1 ~ /\.(pel_fill16|pack)$/ ||
            $1 ~ /_fill$/) { text += $2 }
        END { print cpu, "walker+fill", text, 0, 0, "-", "-" }'
}

stack_used() {
    run_on_board "$1" "$2" | sed -n 's/^stack //p'
}

# Two numbers: the deepest path from main, and main's own part of it.
stack_deepest() {
    {
        arm-none-eabi-objdump -s "$1"
        cat "$1.map"
        arm-none-eabi-objdump -d --no-show-raw-insn "$1"
    } | awk -f "$here/stack.awk" -v formats="$formats" \
        -v pointers="$here/pointers.txt"
}

# What a linked program has of drivers/, by the linker's map.
driver_text() {
    sum=0
    for bytes in $(awk '/^Linker script and memory map/ { linked = 1 }
        /^ \.[^ ]+/ { section = $1 }
        linked && section ~ /^\.(text|rodata)/ && /libdrivers\.a\(/ {
            print $(NF - 1)
        }' "$1.map"); do
        sum=$((sum + bytes))
    done
    echo $sum
}

program_row() {
    text=
    case $2 in */panel_* | */epaper_*) text=$(driver_text "$2") ;; esac
    used=$(stack_used "$1" "$2")
    [ -n "$used" ] || fail "$2 failed on $(board "$1")"
    deepest="$used 0"
    [ -z "$graph" ] || deepest=$(stack_deepest "$2")
    own=${deepest#* }
    deepest=${deepest% *}
    [ "$used" -le "$deepest" ] ||
        fail "$2 used $used bytes of stack, its call graph has only $deepest"
    "$tools-size" -A "$2" | awk -v cpu="$1" \
        -v name="$(basename "$2" .elf)" -v stack=$((deepest - own)) \
        -v used=$((used - own)) -v text="$text" 'BEGIN { OFS = "\t" }
        { size[$1] = $2 }
        END { print cpu, name, text == "" ? size[".text"] + 0 : text, size[".data"] + 0,
                    size[".bss"] + 0, stack, used }'
}

printf 'cpu\tfeature\ttext\tdata\tbss\tstack\tstack_used\n'
while read -r build programs; do
    case $build in
    rv32*) tools=riscv64-unknown-elf graph= ;;
    lx106*) tools=xtensa-lx106-elf graph= ;;
    arm926*) tools=arm-none-eabi graph= ;;
    *) tools=arm-none-eabi graph=yes ;;
    esac
    case $build in
    *-O2) ;;
    *)
        for source in core/*/*.c; do
            object_row "$build" "$folder/mcu/$build/${source%.c}.o"
        done
        flat_row "$build"
        ;;
    esac
    for name in $programs; do
        program_row "$build" "$folder/link/$build/$name.elf"
    done
done
