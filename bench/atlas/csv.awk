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

# bench/report_csv.c, of several processes: memory lies elsewhere in each, so the
# spread goes from the least first quartile to the greatest third one.
kind == "speed" && $4 + 0 > 0 {
    m = $3 == "pel" ? "Pel " $1 : $3
    if (!(m in runs))
        method[++methods] = m
    workload = $2
    add(m, $4 / $9, $5 / $9, $6 / $9)
    if ($11 != "")
        wrong[m] = $11 * 1e4
}

function add(m, ns, q1, q3,    i)
{
    for (i = ++runs[m]; i > 1 && middle[m, i - 1] > ns; i--)
        middle[m, i] = middle[m, i - 1]
    middle[m, i] = ns
    if (!(m in low) || q1 < low[m])
        low[m] = q1
    if (!(m in high) || q3 > high[m])
        high[m] = q3
}

function median_of(m) { return middle[m, int((runs[m] + 1) / 2)] }

function put_speeds(    i, m, ns, limit)
{
    limit = median_of("memset")
    for (i = 1; i <= methods; i++) {
        m = method[i]
        ns = median_of(m)
        row(m, workload, "", "ns_per_pixel", ns, low[m], high[m], "ns")
        row(m, workload, "", "ratio_to_memset", ns / limit,
            low[m] / high["memset"], high[m] / low["memset"], "times")
        if (m in wrong)
            row(m, workload, "", "wrong_ppm", wrong[m], "", "", "ppm")
    }
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
    if ($12 > 0)
        row("osmesa for " $4, x[$1], "", "ms_per_picture", $12 / 1e6, "", "",
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
    put_speeds()
    for (i = 1; i <= cases; i++) {
        c = order[i]
        split(c, paint, "/")
        row("x86-64", paint[1], paint[2], "ns_per_pixel", quantile(c, .5),
            quantile(c, .25), quantile(c, .75), "ns")
    }
}
