#!/bin/sh
# panels.sh TIMES [1] : the table of panels in docs/PANELS.md follows from the
# budgets and from what the program TIMES says; with 1 writes it anew.
set -eu
sizes=tests/link/budgets.tsv
document=docs/PANELS.md

page() {
    cat <<'END'
# Panels

The chips of [drivers/panel.h](../drivers/panel.h), each a const object, and the
modules that their values are meant for. All four rotations are there, but where the
table says otherwise: `tests/unit/test_drivers_panel.c` sends pictures of every
size and place to a model of each chip, written from its data sheet alone, which
has to show them. No model knows all glass: where a module shows another picture,
`inverted`, `swapped`, `left` and `top` of struct pel_panel tell the driver. An
`st7789` and an `ssd1306` at an emulated RP2040 show [whole programs](firmware.md).

Flash and stack in bytes of a Cortex-M0+ (`make size`): the driver with all that it
needs of drivers/, without the board's bus. Beside the stack a panel takes 76
bytes of RAM, two structs, and the pixels that the program draws into. Times are
those of the wire, in ms, at the clock of usual modules: from the reset to the
first frame, a frame, and a part of 32 x 32 pixels.

| chip | modules | flash | stack | wire | first frame | frame | 32 x 32 |
|---|---|---:|---:|---|---:|---:|---:|
END
    "$1" | awk -F '\t' '
        FILENAME == "-" {
            k = "cortex-m0plus-Os" SUBSEP "panel_" $1
            print "| `" $1 "` | " $2 " | " text[k] " | " stack[k] " | " $3 \
                " | " $4 " | " $5 " | " $6 " |"
            next
        }
        { text[$1, $2] = $3; stack[$1, $2] = $5 }' "$sizes" -
    cat <<'END'

E-paper ([drivers/epaper.h](../drivers/epaper.h)), in the same way: its model
(`tests/unit/test_drivers_epaper.c`) is busy after commands, and in a partial
refresh drives what differs alone. Beside the stack a frame of one bit a pixel is
in RAM, of panels with red, yellow or greys two, and two structs of 84 bytes.

| chip | modules | full, fast, partial | flash | stack |
|---|---|---|---:|---:|
END
    awk -F '\t' '
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
        $1 == "cortex-m0plus-Os" && sub(/^epaper_/, "", $2) {
            print "| `" $2 "` | " modules[$2] " | " $3 " | " $5 " |"
        }' "$sizes"
}

[ -z "${2-}" ] || page "$1" >"$document"
page "$1" | cmp - "$document"
