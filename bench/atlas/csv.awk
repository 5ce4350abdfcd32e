# csv.awk : what the programs of bench/ and the budgets say, as rows of the atlas.
# `kind` is what is read, `name` the case's own, `command` repeats it.
BEGIN {
    FS = kind == "mcu" || kind == "size" ? "\t" : kind == "matrix" ? " " : ","
    print "case,method,x,y,metric,value,low,high,unit,command"
}

function row(method, x, y, metric, value, low, high, unit)
{
    print name "," method "," x "," y "," metric "," value "," low "," high \
        "," unit "," command
}

/^#/ || NF == 0 { next }

# bench/report_csv.c
kind == "speed" && FNR > 1 {
    method = $3 == "pel" ? "Pel " $1 : $3
    row(method, $2, "", "ns_per_pixel", $4 / $9, $5 / $9, $6 / $9, "ns")
    row(method, $2, "", "ratio_to_memset", $7, $5 / $4 * $7, $6 / $4 * $7,
        "times")
    if ($11 != "")
        row(method, $2, "", "wrong_ppm", $11 * 1e4, "", "", "ppm")
}

# bench/scene.c
kind == "scene" && FNR > 1 {
    x["cores"] = $7
    x["mesh"] = $2
    x["triangles"] = $3
    x["pixels"] = $5 * $5
    x["bands"] = $6
    row("Pel " $4, x[$1], "", "ms_per_picture", $9 / 1e6, $10 / 1e6, $11 / 1e6,
        "ms")
}

# bench/instructions.sh
kind == "instructions" && FNR > 1 {
    row("Pel " $1, $2, "", "instructions_per_shape", $3, "", "", "instructions")
}

# bench/mcu/budgets.tsv
kind == "mcu" {
    if (split($2, paint, "/") < 2)
        row($1, $3, $2, "instructions_per_call", $5, "", "", "instructions")
    else if ($3 > 8)
        row($1, paint[1], paint[2], "instructions_per_pixel", $5, "", "",
            "instructions")
    else
        row($1, "", paint[2], "instructions_8x8", $5, "", "", "instructions")
}

# tests/link/budgets.tsv
kind == "size" {
    row($1, $2, "", "flash_bytes", $3, "", "", "bytes")
    if ($5 != "-")
        row($1, $2, "", "stack_bytes", $5, "", "", "bytes")
}

# Many rounds of bench/mcu/matrix.c on the host: name, parameter, time, pixels.
kind == "matrix" && $2 > 8 {
    if (!(($1, 1) in time))
        order[++cases] = $1
    for (i = ++times[$1]; i > 1 && time[$1, i - 1] > $3 / 8 / $4; i--)
        time[$1, i] = time[$1, i - 1]
    time[$1, i] = $3 / 8 / $4
}

# The share `q` of the sorted times of case c; none is less than nothing.
function quantile(c, q,    t)
{
    t = time[c, 1 + int(q * (times[c] - 1) + .5)]
    return t < 0 ? 0 : t
}

END {
    for (i = 1; i <= cases; i++) {
        c = order[i]
        split(c, paint, "/")
        row("x86-64", paint[1], paint[2], "ns_per_pixel", quantile(c, .5),
            quantile(c, .25), quantile(c, .75), "ns")
    }
}
