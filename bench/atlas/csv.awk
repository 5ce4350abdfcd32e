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

# A figure of one batch, with its quartiles. A row has the median of the batches,
# and its spread goes from the least first quartile to the greatest third one.
function add(method, x, y, metric, unit, value, q1, q3,    key, i)
{
    key = method "," x "," y "," metric
    if (!(key in batches)) {
        keys[++n] = key
        unit_of[key] = unit
        low[key] = q1
        high[key] = q3
    }
    for (i = ++batches[key]; i > 1 && sorted[key, i - 1] > value; i--)
        sorted[key, i] = sorted[key, i - 1]
    sorted[key, i] = value
    if (q1 < low[key])
        low[key] = q1
    if (q3 > high[key])
        high[key] = q3
}

function put_times(    i, key, f)
{
    for (i = 1; i <= n; i++) {
        key = keys[i]
        split(key, f, ",")
        row(f[1], f[2], f[3], f[4], sorted[key, int((batches[key] + 1) / 2)],
            low[key], high[key], unit_of[key])
    }
}

# bench/report_csv.c; ratios are to memset and to the best peer of the same batch.
kind == "speed" && FNR > 1 {
    m = $3 == "pel" ? "Pel " $1 : $3
    add(m, $2, "", "ns_per_pixel", "ns", $4 / $9, $5 / $9, $6 / $9)
    add(m, $2, "", "ratio_to_memset", "times", $7, $7 * $5 / $4, $7 * $6 / $4)
    if ($3 == "pel" && $8 != "")
        add(m, $2, "", "ratio_to_best_peer", "times", $8, $8 * $5 / $4,
            $8 * $6 / $4)
    if ($11 != "")
        add(m, $2, "", "wrong_ppm", "ppm", $11 * 1e4, "", "")
    if ($13 != "")
        add(m, $2, "", "edge_error", "levels", $13, $13, $12)
}

# pel-atlas
kind == "atlas" && FNR > 1 { add($2, $3, $4, $5, $9, $6, $7, $8) }

# bench/scene.c
kind == "scene" && FNR > 1 {
    x["cores"] = $7
    x["mesh"] = $2
    x["triangles"] = $3
    x["pixels"] = $5 * $5
    x["bands"] = $6
    add("Pel " $4, x[$1], "", "ms_per_picture", "ms", $9 / 1e6, $10 / 1e6,
        $11 / 1e6)
    if ($12 > 0)
        add("osmesa for " $4, x[$1], "", "ms_per_picture", "ms", $12 / 1e6,
            $13 / 1e6, $14 / 1e6)
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
kind == "size" && sub(/-Os$/, "", $1) {
    row($1, $2, "", "flash_bytes", $3, "", "", "bytes")
    if ($5 != "-")
        row($1, $2, "", "stack_bytes", $5, "", "", "bytes")
}

# Many rounds of bench/mcu/matrix.c on the host: name, parameter, time, pixels.
kind == "matrix" && FNR == 1 { add_rounds() }
kind == "matrix" && $2 > 8 {
    if (!(rounds[$1]))
        cases[++paints] = $1
    for (i = ++rounds[$1]; i > 1 && time[$1, i - 1] > $3 / 8 / $4; i--)
        time[$1, i] = time[$1, i - 1]
    time[$1, i] = $3 / 8 / $4
}

# The share `q` of the sorted times of case c; none is less than nothing.
function quantile(c, q,    t)
{
    t = time[c, 1 + int(q * (rounds[c] - 1) + .5)]
    return t < 0 ? 0 : t
}

# The rounds of a batch.
function add_rounds(    i, c, paint)
{
    for (i = 1; i <= paints; i++) {
        c = cases[i]
        split(c, paint, "/")
        add("x86-64", paint[1], paint[2], "ns_per_pixel", "ns",
            quantile(c, .5), quantile(c, .25), quantile(c, .75))
        rounds[c] = 0
    }
    paints = 0
}

END {
    add_rounds()
    put_times()
}
