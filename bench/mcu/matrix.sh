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

gcc at -O2; at -Os, as most firmware is built; and at -Os with PEL_SMALL_CODE
(core/pel_config.h), here "small". All figures of a line are of one build.

Flash and stack in bytes (`make size`) of tests/link/flat.c, a flat triangle on
rgb565; of flat_circle_alpha.c, with circles and alpha on top; of scene.c, a mesh
with light and texture. Instructions in QEMU (`make bench-mcu`) of a random
triangle in a box of 16 and of 64 px, filled on rgb565, and of a pixel more in a
long row. ARM926 runs ARM code; lx106 is the Xtensa of an ESP8266, whose long products
and quotients are in its ROM: counted, but no part of its flash.
END
}

overview() {
    awk -F '\t' '
        FILENAME ~ /link/ { text[$1, $2] = $3; stack[$1, $2] = $5; next }
        /^#/ || NF == 0 { next }
        !($1 in seen) { seen[$1]; cpu[++cpus] = $1 }
        { for (l = 1; l <= 3; l++) count[$1, level[l], $2, $3] = $(4 + l) }
        function cell(v) { return (v == "" ? "-" : v) " | " }
        BEGIN { split("O2 Os small", level, " ") }
        END {
            print "\n| CPU | build | flat: flash | stack | + circle, alpha |" \
                " stack | scene | stack | 16 px | 64 px | flat | alpha |" \
                " Gouraud | nearest | linear | radial | conic |\n" \
                "|---|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|" \
                "---:|---:|---:|---:|---:|"
            for (i = 1; i <= 3 * cpus; i++) {
                c = cpu[int((i + 2) / 3)]
                l = level[(i + 2) % 3 + 1]
                line = "| " c " | " (l == "small" ? l : "-" l) " | "
                n = split("flat flat_circle_alpha scene", program, " ")
                for (k = 1; k <= n; k++)
                    line = line cell(text[c "-" l, program[k]]) \
                        cell(stack[c "-" l, program[k]])
                line = line sprintf("%.0f | %.0f | ", count[c, l, "fill", 16],
                    count[c, l, "fill", 64])
                n = split("flat alpha gouraud nearest linear-sloped radial " \
                    "conic", paint, " ")
                for (k = 1; k <= n; k++)
                    line = line cell(count[c, l, "rgb565/" paint[k], 128])
                sub(/ $/, "", line)
                print line
            }
        }' "$sizes" "$counts"
}

paints() {
    cat <<'END'

## What a pixel costs

Instructions (not cycles) that a pixel more in a long row takes, counted in QEMU
by `make bench-mcu`, at -O2, -Os and small; and what init and drawing of 8 x 8 px
take on rgb565; and flash and stack of a program that fills a rectangle with the
paint (tests/link/paint.c), where `make size` has it. `make bench-mcu ACCEPT=1`
writes this file. No cell takes more than 1.3 times as much at -Os as at -O2; text,
fans, nine slices, patterns, textures, blends and Phong at most 1.6 times: they keep
fewer rows or colors on the stack, of which every shape with every paint takes at
most 384 bytes. Other shapes than rectangles hand on half as many rows: there a
gradient takes up to 2.5 times, as horizontal ones do in rectangles, too, whose rows
are not copied there.
Paints are at the place where bench/mcu/matrix.c has them: 24 to 216 px from the
left of a screen of 240 x 320, eight rows 32 px above its middle, gradients of two
colours from side to side or corner to corner, `alpha` 128 of 255, textures and
opaque copies from the format of the screen, `copy-runs` of 12 px in a run and 4 as
they are (of bytes of mono1), `copy-alpha` from argb8888, the mesh
one triangle under one light, with highlights. Formats of 8 bits a channel need no
dither. A cell in bold is more than four times the least of its row.
END
    awk -F '\t' '
    FILENAME ~ /link/ {
        size[$1, $2] = $3
        stack[$1, $2] = $5
        next
    }
    function three(a, b, c) {
        return a " / " b " / " c
    }
    function cell(c, p, f,    k, least, at) {
        least = pixel[cpu[c], format[1], paint[p], 1]
        for (k = 2; k <= formats; k++)
            if (pixel[cpu[c], format[k], paint[p], 1] + 0 < least + 0)
                least = pixel[cpu[c], format[k], paint[p], 1]
        for (k = 1; k <= 3; k++)
            at[k] = pixel[cpu[c], format[f], paint[p], k]
        if (at[1] > 4 * least + .5)
            at[1] = "**" at[1] "**"
        return three(at[1], at[2], at[3])
    }
    # Flash and stack of the program of tests/link that has the paint.
    function of_program(c, p, which,    name, at, k) {
        name = paint[p]
        sub(/^linear-.*/, "linear", name)
        sub(/^alpha$/, "flat_alpha", name)
        sub(/^dithered-flat$/, "dither", name)
        sub(/^xor-flat$/, "blend", name)
        sub(/-slice$/, "_slice", name)
        name = "paint_" name
        if (!((cpu[c] "-Os", name) in size))
            return ""
        for (k = 1; k <= 3; k++)
            at[k] = which == "flash" ? size[cpu[c] "-" level[k], name] : \
                stack[cpu[c] "-" level[k], name]
        return three(at[1], at[2], at[3])
    }
    BEGIN { split("O2 Os small", level, " ") }
    /^#/ || split($2, name, "/") < 2 { next }
    !($1 in seen_cpu) { seen_cpu[$1]; cpu[++cpus] = $1 }
    !(name[1] in seen_format) { seen_format[name[1]]; format[++formats] = name[1] }
    !(name[2] in seen_paint) { seen_paint[name[2]]; paint[++paints] = name[2] }
    {
        for (k = 1; k <= 3; k++)
            if ($3 == 8)
                small[$1, name[2], k] = sprintf("%.0f", $(4 + k))
            else
                pixel[$1, name[1], name[2], k] = $(4 + k)
    }
    END {
        for (c = 1; c <= cpus; c++) {
            line = "| " cpu[c] " |"
            rule = "|---|"
            for (f = 1; f <= formats; f++) {
                line = line " " format[f] " |"
                rule = rule "---:|"
            }
            print "\n" line " 8 x 8 px | flash | stack |\n" rule "---:|---:|---:|"
            for (p = 1; p <= paints; p++) {
                line = "| " paint[p] " |"
                for (f = 1; f <= formats; f++)
                    line = line " " cell(c, p, f) " |"
                line = line " " three(small[cpu[c], paint[p], 1],
                    small[cpu[c], paint[p], 2], small[cpu[c], paint[p], 3]) " |"
                print line " " of_program(c, p, "flash") " | " \
                    of_program(c, p, "stack") " |"
            }
        }
    }' "$sizes" "$counts"
}

fills() {
    cat <<'END'

## What every screen is made of

Thousand instructions, gcc -O2 / -Os / small (bench/mcu/fills.c): a clear of 128 x
64 px, a box of 100 x 50, three lines of 208 px, 18 letters of 5 x 7, 10 smooth ones
of 9 x 9, and alpha on 64 x 50 px over one colour and over noise. Of formats that
differ by the order of their channels alone one is here.
END
    awk -F '\t' '
    function cell(what,    k) {
        k = cpu[c] SUBSEP what SUBSEP f
        return sprintf(" %.1f / %.1f / %.1f |", o2[k] / 1000, os[k] / 1000,
            small[k] / 1000)
    }
    match($2, /^(clear|box|lines|letters|smooth-letters|alpha-even|alpha-noise)-/) {
        what = substr($2, 1, RLENGTH - 1)
        name = substr($2, RLENGTH + 1)
        if (!($1 in seen)) { seen[$1]; cpu[++cpus] = $1 }
        if (!(name in known)) { known[name]; format[++formats] = name }
        o2[$1, what, name] = $5
        os[$1, what, name] = $6
        small[$1, what, name] = $7
    }
    END {
        for (c = 1; c <= cpus; c++) {
            print "\n| " cpu[c] " | clear | box | lines | letters |" \
                " smooth | alpha | over noise |\n" \
                "|---|---:|---:|---:|---:|---:|---:|---:|"
            for (k = 1; k <= formats; k++) {
                f = format[k]
                print "| " f " |" cell("clear") cell("box") cell("lines") \
                    cell("letters") cell("smooth-letters") \
                    cell("alpha-even") cell("alpha-noise")
            }
        }
    }' "$counts"
}

smooth() {
    cat <<'END'

## Smooth edges

Thousand instructions of a whole shape, gcc -O2 / -Os / small (bench/mcu/smooth.c):
opaque, with alpha, in a sloped gradient and in a nearest texture. A triangle of 64
px, a needle of 100, a line of 2 px and 110 px with round ends, a star of five sides
that cross, discs of radius 50 around any centre and around the corner of a pixel, a
ring of 4 px, an arc of 12 px and radius 100 with round ends, a rounded rectangle
of 100 x 60.
END
    awk -F '\t' '
    function cell(f, k,    at) {
        at = cpu[c] SUBSEP shape[i] SUBSEP kind[k] (f > 1 ? "-" format[f] : "")
        return sprintf(" %.0f / %.0f / %.0f |", o2[at] / 1000, os[at] / 1000,
            small[at] / 1000)
    }
    BEGIN {
        split("rgb565 xrgb8888 gray4", format, " ")
        split("flat alpha linear texture", kind, " ")
    }
    $2 !~ /^smooth-.*-(flat|alpha|linear|texture)(-xrgb8888|-gray4)?$/ { next }
    {
        name = substr($2, 8)
        at = index(name, "-")
        key = substr(name, 1, at - 1) " " $3
        if (!($1 in seen)) { seen[$1]; cpu[++cpus] = $1 }
        if (name ~ /texture$/ && !(key in known)) { known[key]; shape[++n] = key }
        key = $1 SUBSEP key SUBSEP substr(name, at + 1)
        o2[key] = $5
        os[key] = $6
        small[key] = $7
    }
    END {
        for (c = 1; c <= cpus; c++) {
            if (cpu[c] !~ /^(cortex-m0plus|cortex-m4|rv32imc|cortex-a53)$/)
                continue
            line = "| " cpu[c] " |"
            rule = "|---|"
            for (f = 1; f <= 3; f++)
                for (k = 1; k <= 4; k++) {
                    line = line " " format[f] " " kind[k] " |"
                    rule = rule "---:|"
                }
            print "\n" line "\n" rule
            for (i = 1; i <= n; i++) {
                line = "| " shape[i] " |"
                for (f = 1; f <= 3; f++)
                    for (k = 1; k <= 4; k++)
                        line = line cell(f, k)
                print line
            }
        }
    }' "$counts"
}

page() {
    intro
    overview
    paints
    fills
    smooth
}

[ -z "${1-}" ] || page >"$document"
page | cmp - "$document"
