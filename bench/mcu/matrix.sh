#!/bin/sh
# matrix.sh [1] : holds docs/MATRIX.md against what follows from the budgets; with
# 1 writes it anew.
set -eu
counts=bench/mcu/budgets.tsv
sizes=tests/link/budgets.tsv
document=docs/MATRIX.md

intro() {
    cat <<'END'
# What Pel costs

Flash and stack in bytes (gcc -Os, `make size`) of tests/link/flat.c, a flat
triangle on rgb565; of flat_circle_alpha.c, with circles and alpha on top; of
scene.c, a mesh with light and texture. Instructions in QEMU (gcc -O2, `make
bench-mcu`) of a random triangle in a box of 16 and of 64 px, filled on rgb565,
and of a pixel more in a long row. ARM926 runs ARM code.
END
}

overview() {
    awk -F '\t' '
        FILENAME ~ /link/ { text[$1, $2] = $3; stack[$1, $2] = $5; next }
        /^#/ || NF == 0 { next }
        !($1 in seen) { seen[$1]; cpu[++cpus] = $1 }
        { count[$1, $2, $3] = $5 }
        function cell(v) { return (v == "" ? "-" : v) " | " }
        END {
            print "\n| CPU | flat: flash | stack | + circle, alpha | stack |" \
                " scene | stack | 16 px | 64 px | flat | alpha | Gouraud |" \
                " nearest |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|" \
                "---:|---:|---:|---:|"
            for (i = 1; i <= cpus; i++) {
                c = cpu[i]
                line = "| " c " | "
                n = split("flat flat_circle_alpha scene", program, " ")
                for (k = 1; k <= n; k++)
                    line = line cell(text[c, program[k]]) \
                        cell(stack[c, program[k]])
                line = line sprintf("%.0f | %.0f | ", count[c, "fill", 16],
                    count[c, "fill", 64])
                n = split("flat alpha gouraud nearest", paint, " ")
                for (k = 1; k <= n; k++)
                    line = line cell(count[c, "rgb565/" paint[k], 128])
                sub(/ $/, "", line)
                print line
            }
        }' "$sizes" "$counts"
}

paints() {
    cat <<'END'

## What a pixel costs

Instructions (not cycles) that a pixel more in a long row takes, counted in QEMU
by `make bench-mcu`, gcc -O2; and what init and drawing of 8 x 8 px take on
rgb565. `make bench-mcu ACCEPT=1` writes this file. Paints are at the place where
bench/mcu/matrix.c has them: 24 to 216 px from the left of a screen of 240 x 320,
eight rows 32 px above its middle, gradients of two colours from side to side or
corner to corner, `alpha` 128 of 255, textures and opaque copies from the format
of the screen, `copy-alpha` from argb8888, the mesh one triangle under one light,
with highlights. Formats of 8 bits a channel need no dither. A cell in bold is
more than four times the least of its row.
END
    awk -F '\t' '
    function cell(c, p, f,    k, least) {
        least = pixel[cpu[c], format[1], paint[p]]
        for (k = 2; k <= formats; k++)
            if (pixel[cpu[c], format[k], paint[p]] + 0 < least + 0)
                least = pixel[cpu[c], format[k], paint[p]]
        k = pixel[cpu[c], format[f], paint[p]]
        return k > 4 * least + .5 ? "**" k "**" : k
    }
    /^#/ || split($2, name, "/") < 2 { next }
    !($1 in seen_cpu) { seen_cpu[$1]; cpu[++cpus] = $1 }
    !(name[1] in seen_format) { seen_format[name[1]]; format[++formats] = name[1] }
    !(name[2] in seen_paint) { seen_paint[name[2]]; paint[++paints] = name[2] }
    $3 == 8 { small[$1, name[2]] = $5; next }
    { pixel[$1, name[1], name[2]] = $5 }
    END {
        for (c = 1; c <= cpus; c++) {
            line = "| " cpu[c] " |"
            rule = "|---|"
            for (f = 1; f <= formats; f++) {
                line = line " " format[f] " |"
                rule = rule "---:|"
            }
            print "\n" line " 8 x 8 px |\n" rule "---:|"
            for (p = 1; p <= paints; p++) {
                line = "| " paint[p] " |"
                for (f = 1; f <= formats; f++)
                    line = line " " cell(c, p, f) " |"
                printf "%s %.0f |\n", line, small[cpu[c], paint[p]]
            }
        }
    }' "$counts"
}

page() {
    intro
    overview
    paints
}

[ -z "${1-}" ] || page >"$document"
page | cmp - "$document"
