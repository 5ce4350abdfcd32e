#!/bin/sh
# panels.sh TIMES [1] : the table of panels in docs/PANELS.md follows from the
# budgets and from what the program TIMES says; with 1 writes it anew.
set -eu
sizes=tests/link/budgets.tsv
document=docs/PANELS.md

# names FILE... : the chips that they name, a space around each.
names() {
    cat "$@" | grep -o '\(pel_panel_\|MODULE("[^"]*", *\)[a-z0-9_]*' |
        sed 's/pel_panel_//; s/.* //' | sort -u | tr '\n' ' ' | sed 's/^/ /'
}
all=$(names tests/unit/test_drivers_panel.c)
one=$(names tests/unit/test_drivers_panel_gray.c)
qemu=$(names tests/device/lcd/*.c)
pico=$(names tests/device/pico/*.c)

page() {
    cat <<'END'
# Panels

The chips of [drivers/panel.h](../drivers/panel.h), each a const object, and the
modules that their values are meant for. All four rotations are there, but where the
table says otherwise: `tests/unit/test_drivers_panel.c` sends pictures of every
size and place to a model of each chip, written from its data sheet alone, which
has to show them. No model knows all glass: where a module shows another picture,
`inverted`, `swapped`, `left` and `top` of struct pel_panel tell the driver.
"Decoded" are so many rotations; "emulated" is what an emulator that others wrote
has of it: its chip, or the [computer](firmware.md) that sends to it.

Flash and RAM in bytes of a Cortex-M0+ (`make size`): the driver with all that it
needs of drivers/, without the board's bus. RAM is two structs and the stack; the
pixels that the program draws into come to it. Times are
those of the wire, in ms, at the clock of usual modules: from the reset to the
first frame, a frame, and a part of 32 x 32 pixels.

| chip | modules | decoded | emulated | flash | RAM | wire | first frame | frame | 32 x 32 |
|---|---|---:|---|---:|---:|---|---:|---:|---:|
END
    "$1" | awk -F '\t' -v all="$all" -v one="$one" -v qemu="$qemu" \
        -v pico="$pico" '
        function has(names, chip) { return index(names, " " chip " ") }
        function decoded(chip) {
            return has(all, chip) ? 4 : has(one, chip) ? 1 : "-"
        }
        function emulated(chip) {
            return has(qemu, chip) ? "chip (QEMU)" : \
                has(pico, chip) ? "RP2040 (rp2040js)" : "-"
        }
        /^epaper_/ { next }
        FILENAME == "-" {
            k = "cortex-m0plus-Os" SUBSEP "panel_" $1
            print "| `" $1 "` | " $2 " | " decoded($1) " | " emulated($1) \
                " | " text[k] " | " stack[k] + 76 " | " $3 \
                " | " $4 " | " $5 " | " $6 " |"
            next
        }
        { text[$1, $2] = $3; stack[$1, $2] = $5 }' "$sizes" -
    cat <<'END'

E-paper ([drivers/epaper.h](../drivers/epaper.h)), in the same way: its model
(`tests/unit/test_drivers_epaper.c`) is busy after commands, and in a partial
refresh drives what differs alone. Beside the stack a frame of one bit a pixel is
in RAM, of panels with red, yellow or greys two, and two structs, 84 bytes. Times
are in ms at 4 MHz: from the reset, and from a step of 32 x 32 pixels on, until the
glass begins to change. Then the waveform takes 0.3 s (partial) to 30 s (color).

| chip | modules | full, fast, partial | flash | stack | first frame | step |
|---|---|---|---:|---:|---:|---:|
END
    "$1" | awk -F '\t' '
        BEGIN {
            own = "with the maker'"'"'s waveform: full alone without"
            modules["ssd1680"] = "GDEY0213B74, GDEY029T94, GDEY0213Z98 | all"
            modules["ssd1681"] = "GDEY0154D67, GDEY0154Z90 | all"
            modules["il3897"] = "GDEH0213B73 | " own
            modules["uc8151"] = "GDEW029T5, GDEW029Z10 | " own
            modules["uc8179"] = "GDEY075T7, GDEY075Z08 | all"
            modules["ssd1680_gray2"] = "GDEY0213B74, GDEY029T94: 4 greys | full"
            modules["uc8151_gray2"] = "GDEW029T5: 4 greys | full"
            modules["uc8179_gray2"] = "GDEY075T7 since 2023: 4 greys | full"
        }
        FILENAME == "-" && sub(/^epaper_/, "", $1) { first[$1] = $2; step[$1] = $3 }
        $1 == "cortex-m0plus-Os" && sub(/^epaper_/, "", $2) {
            print "| `" $2 "` | " modules[$2] " | " $3 " | " $5 \
                " | " first[$2] " | " step[$2] " |"
        }' - "$sizes"
}

[ -z "${2-}" ] || page "$1" >"$document"
page "$1" | cmp - "$document"
