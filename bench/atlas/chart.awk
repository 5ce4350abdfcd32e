# chart.awk CHART CSV... : a chart as a script of gnuplot. CHART has lines of a
# key and its value (charts.txt), CSVs are those of the atlas.
BEGIN {
    plain = "font \",9\" noenhanced"
    number_form = "^[-+]?[.0-9]+(e[-+]?[0-9]+)?$"
}

FNR == NR {
    key = $1
    sub(/^[^ ]+ +/, "")
    chart[key] = $0
    if (key == "metric") {
        wanted = split($0, metrics, " ")
        if (metrics[wanted] == "bound")
            chart["has_bound"]
    }
    next
}
FNR == 1 { FS = ","; next }

# One row of a CSV, when the chart shows it.
{
    split($0, f, ",")
    for (k = 1; k <= wanted; k++)
        if (f[5] == metrics[k])
            break
    if (k > wanted || f[6] == "" ||
        ("method" in chart && f[2] !~ chart["method"]) ||
        ("only" in chart && f[3] !~ chart["only"]))
        next
    method[++n] = f[2]
    x[n] = f[3]
    y[n] = f[4]
    which[n] = k
    value[n] = f[6]
    unit = f[9]
    low[n] = f[7] == "" ? f[6] : f[7]
    high[n] = f[8] == "" ? f[6] : f[8]
    command = $0
    for (k = 1; k <= 9; k++)
        sub(/^[^,]*,/, "", command)
    gsub(/["'`\\]/, "", command)
    tip[n] = f[1] ": " f[2] (f[3] != "" ? ", " f[3] : "") \
        (f[4] != "" ? ", " f[4] : "") ": " f[6] " " f[9] " (" f[5] ") | " command
    gsub(/&/, "\\&amp;", tip[n])
    gsub(/</, "\\&lt;", tip[n])
}

function log10(v) { return log(v) / log(10) }
function floor(v,    i) { i = int(v); return i > v ? i - 1 : i }
function is_log(axis) { return index(chart["log"], axis) > 0 }

# 2 where most places on the x axis are small powers of two, else 10.
function base_of_x(    i, v, powers)
{
    for (i = 1; i <= n; i++) {
        v = x[i]
        while (v > 1 && v <= 65536)
            v /= 2
        powers += v == 1
    }
    return powers * 2 > n ? 2 : 10
}

# The number of a name in its list.
function place(list, name)
{
    if (!((list, name) in number)) {
        number[list, name] = ++count[list]
        named[list, count[list]] = name
    }
    return number[list, name]
}

# Numbers from the least to the greatest.
function sort_list(list,    i, j, t)
{
    for (i = 1; i <= count[list]; i++) {
        t = named[list, i]
        if (t !~ number_form)
            return
        for (j = i; j > 1 && named[list, j - 1] + 0 > t + 0; j--)
            named[list, j] = named[list, j - 1]
        named[list, j] = t
    }
    for (i = 1; i <= count[list]; i++)
        number[list, named[list, i]] = i
}

# On a logarithmic axis nothing stands at the power of ten below the least value.
function find_zero(axis, v,    i, least)
{
    zero[axis] = 0
    if (!is_log(axis))
        return
    for (i = 1; i <= n; i++)
        if (v[i] > 0 && (least == "" || v[i] + 0 < least))
            least = v[i] + 0
    zero[axis] = least == "" ? 1 : 10 ^ floor(log10(least * .9))
    for (i = 1; i <= n; i++)
        if (v[i] + 0 <= 0) {
            # gnuplot leaves out a tick on the very end of an axis.
            printf "set %stics add (\"0\" %.9g)\n", axis, zero[axis] * 1.0000001
            break
        }
}
function on_axis(axis, v) { return v + 0 > zero[axis] ? v + 0 : zero[axis] }

function tics(axis, list,    i, step, names, name)
{
    step = int((count[list] - 1) / chart["most_" axis]) + 1
    for (i = 1; i <= count[list]; i += step) {
        name = named[list, i]
        if (name ~ number_form)
            name = sprintf("%.4g", name)
        names = names (i > 1 ? ", " : "") "\"" name "\" " i
    }
    print "set " axis "tics (" names ") " plain
}

# A curve's points: x, y, their spread, what is shown above them. Where x goes
# back another line begins.
function point(series, px, py, from, to, label,    i)
{
    i = place("series", series)
    if (chart["kind"] == "lines" && px < last[i])
        data[i] = data[i] "\n"
    last[i] = px
    data[i] = data[i] px "\t" py "\t" from "\t" to "\t" label "\n"
}

# What the pointer asks for lies above all that is seen.
function draw_series(style, spread,    i, plot, above)
{
    if ("has_bound" in chart)
        plot = "NaN with lines linecolor rgb \"#555555\" dashtype 3 title" \
            " \"bounds\", "
    for (i = 1; i <= count["series"]; i++) {
        print "$s" i " << EOD\n" data[i] "EOD"
        plot = plot "$s" i " using " spread " with vectors nohead linetype " i \
            " dashtype 1 notitle, $s" i " using 1:2 with " style " linetype " i \
            " title \"" named["series", i] "\", "
        if (i in bounds) {
            print "$b" i " << EOD\n" bounds[i] "EOD"
            plot = plot "$b" i " using 1:2 with lines linetype " i \
                " linewidth 1.2 dashtype 3 notitle, "
        }
        above = above (i > 1 ? ", " : "") "$s" i " using 1:2:5 with labels" \
            " hypertext point pointtype 7 pointsize 1.3" \
            " linecolor rgb \"#ff000000\" notitle"
    }
    print "plot " plot above
}

function series_of(i)
{
    return method[i] ("series" in chart ? " " y[i] : "") \
        (wanted > 1 && !("has_bound" in chart) ? " " metrics[which[i]] : "")
}

function draw_lines(    i, k)
{
    find_zero("y", value)
    find_zero("x", x)
    for (i = 1; i <= n; i++)
        if (metrics[which[i]] == "bound") {
            k = place("series", series_of(i))
            bounds[k] = bounds[k] on_axis("x", x[i]) "\t" \
                on_axis("y", value[i]) "\n"
        } else
            point(series_of(i), on_axis("x", x[i]), on_axis("y", value[i]),
                on_axis("y", low[i]), on_axis("y", high[i]), tip[i])
    draw_series("linespoints", "1:3:(0):($4-$3)")
}

# The second metric of each method above the first, which is told in times of
# Pel's at the same x.
function draw_pair(    i, across, other)
{
    for (i = 1; i <= n; i++)
        if (which[i] == 1)
            across[method[i], x[i], y[i]] = i
        else
            up[++ups] = value[i]
    for (i = 1; i <= n; i++)
        if (which[i] == 1)
            right[i] = value[i] / value[across["pel", x[i], y[i]]]
    find_zero("y", up)
    for (i = 1; i <= n; i++)
        if (which[i] == 2 && ((method[i], x[i], y[i]) in across)) {
            other = across[method[i], x[i], y[i]]
            point(method[i], right[other], on_axis("y", value[i]),
                on_axis("y", low[i]), on_axis("y", high[i]), value[other] " " metrics[1] "; " tip[i])
        }
    draw_series("points", "1:3:(0):($4-$3)")
}

# Where a row belongs: x, or y, which may have names, or the method.
function row_of(i,    name)
{
    if (chart["row"] == "method")
        return method[i]
    if (chart["row"] != "y")
        return x[i]
    return split(chart["names"], name, ",") > y[i] ? name[y[i] + 1] : y[i]
}

# Marks of equal value lie side by side in their row.
function draw_rows(    i, series, aside)
{
    find_zero("x", value)
    for (i = 1; i <= n; i++) {
        series = chart["row"] == "method" ? metrics[which[i]] : series_of(i)
        aside = ((place("series", series) - 1) % 5 - 2) * .13
        point(series, on_axis("x", value[i]), place("rows", row_of(i)) + aside,
            on_axis("x", low[i]), on_axis("x", high[i]), tip[i])
    }
    tics("y", "rows")
    print "set yrange [" count["rows"] + .7 ":.3]"
    draw_series("points", "3:2:($4-$3):(0)")
}

# Between 0 and 1: how dark the cell is.
function shade(v)
{
    v = on_axis("z", v)
    return is_log("z") ? (log10(v) - log10(least)) / (log10(most) - log10(least)) \
        : (v - least) / (most - least)
}

function find_range(panel,    i, v)
{
    least = most = ""
    for (i = 1; i <= n; i++) {
        if (metrics[which[i]] == "bound" || (panel != "" && method[i] != panel))
            continue
        v = on_axis("z", value[i])
        if (least == "" || v < least)
            least = v
        if (most == "" || v > most)
            most = v
    }
    if (least == most)
        most = least * 10 + 1
}

# Whether the value of a cell is above its bound; what is not there is not.
function is_out(panel, column, row,    key)
{
    key = panel SUBSEP named["columns", column] SUBSEP named["rows", row]
    return (key in cell) && cell[key] > (key in bound ? bound[key] : chart["bound"] + 0)
}

function side(x0, y0, x1, y1) { border = border x0 "\t" y0 "\n" x1 "\t" y1 "\n\n" }

# The line around the cells out of bounds.
function find_border(panel,    c, r)
{
    border = ""
    for (c = 1; c <= count["columns"]; c++)
        for (r = 1; r <= count["rows"]; r++) {
            if (is_out(panel, c, r) != is_out(panel, c + 1, r) &&
                c < count["columns"])
                side(c + .5, r - .5, c + .5, r + .5)
            if (is_out(panel, c, r) != is_out(panel, c, r + 1) &&
                r < count["rows"])
                side(c - .5, r + .5, c + .5, r + .5)
        }
}

function number_of(v)
{
    return sprintf(v >= 100 ? "%.0f" : v >= 10 ? "%.1f" : "%.2f", v)
}

# With the values of the brightest and the darkest cell.
function title_of(panel,    i, from, to)
{
    for (i = 1; i <= n; i++) {
        if (metrics[which[i]] == "bound" || method[i] != panel)
            continue
        if (from == "" || value[i] + 0 < from)
            from = value[i] + 0
        if (to == "" || value[i] + 0 > to)
            to = value[i] + 0
    }
    return panel sprintf(from == to ? ": %.3g %s" : ": %.3g to %.3g %s", from, \
        from == to ? unit : to, unit)
}

function draw_panel(k, panel,    i, plot, v)
{
    if ("each" in chart)
        find_range(panel)
    print "$c" k " << EOD"
    for (i = 1; i <= n; i++) {
        if (method[i] != panel || metrics[which[i]] == "bound")
            continue
        v = shade(value[i])
        print number["columns", x[i]] "\t" number["rows", y[i]] "\t" v "\t" \
            ("text" in chart ? number_of(value[i]) : "") "\t" \
            (v > .55 ? 16777215 : 0) "\t" tip[i]
    }
    print "EOD"
    print "set title \"" ("text" in chart ? panel : title_of(panel)) "\" " \
        plain
    plot = "plot $c" k " using 1:2:(.5):(.5):3 with boxxyerror fillcolor" \
        " palette fillstyle solid noborder notitle, $c" k " using 1:2:4:5" \
        " with labels font \",7\" textcolor rgb variable notitle, $c" k \
        " using 1:2:6 with labels hypertext point pointtype 5 pointsize 1.6" \
        " linecolor rgb \"#ff000000\" notitle"
    if ("bound" in chart) {
        find_border(panel)
        if (border != "") {
            print "$b" k " << EOD\n" border "EOD"
            plot = plot ", $b" k " using 1:2 with lines dashtype 1 linewidth 3.5 linecolor" \
                " rgb \"white\" notitle, $b" k " using 1:2 with lines" \
                " dashtype 1 linewidth 1.8 linecolor rgb \"#d00000\" notitle"
        }
    }
    print plot
}

# A panel for each method: cells of x and y, the greater the darker.
function draw_cells(    i, key)
{
    find_zero("z", value)
    for (i = 1; i <= n; i++) {
        place("columns", x[i])
        place("rows", y[i])
        key = method[i] SUBSEP x[i] SUBSEP y[i]
        if (metrics[which[i]] == "bound")
            bound[key] = value[i] + 0
        else {
            cell[key] = value[i] + 0
            place("panels", method[i])
        }
    }
    sort_list("columns")
    sort_list("rows")
    find_range("")
    tics("x", "columns")
    tics("y", "rows")
    print "set xtics rotate by -45; set rmargin 1"
    if ("text" in chart)
        print "set lmargin 18; unset ylabel"
    print "set cbrange [0:1]; set xrange [.5:" count["columns"] + .5 "]"
    print "set yrange [" ("text" in chart ? count["rows"] + .5 ":.5" : \
        ".5:" count["rows"] + .5) "]"
    print "set multiplot layout " rows_of_panels "," panels_a_row
    for (i = 1; i <= count["panels"]; i++)
        draw_panel(i, named["panels", i])
    print "unset multiplot"
}

# px of the picture
function set_size(    i, width, height)
{
    width = 860
    height = 440
    if (chart["kind"] == "rows") {
        for (i = 1; i <= n; i++)
            place("lines", row_of(i))
        height = 140 + 17 * count["lines"]
    } else if (chart["kind"] == "cells") {
        for (i = 1; i <= n; i++)
            if (metrics[which[i]] != "bound")
                place("sheets", method[i])
        panels_a_row = count["sheets"] < 3 ? count["sheets"] : 3
        rows_of_panels = int((count["sheets"] + panels_a_row - 1) / panels_a_row)
        width = 320 * panels_a_row
        height = ("text" in chart ? 430 : 300) * rows_of_panels
    }
    print "set terminal svg size " width "," height " dynamic font \"sans,11\""
}

END {
    if (n == 0) {
        print "atlas: no row for chart " chart["name"] > "/dev/stderr"
        exit 1
    }
    for (i = 1; i <= n; i++)
        if (method[i] ~ /^[Pp]el/ && chart["row"] != "method")
            place("series", chart["kind"] == "pair" ? method[i] : series_of(i))
    if (!("most_x" in chart)) chart["most_x"] = 12
    if (!("most_y" in chart)) chart["most_y"] = 100
    set_size()
    print "load \"" style "\""
    print "set xlabel \"" chart["x"] "\"; set ylabel \"" chart["y"] "\""
    if (chart["kind"] == "lines")
        print "set autoscale xfix"
    if (is_log("x"))
        print "set logscale x " (chart["kind"] == "lines" ? base_of_x() : 10) \
            "; set format x \"%g\""
    if (is_log("y")) print "set logscale y; set format y \"%g\""
    if (chart["kind"] == "lines") draw_lines()
    if (chart["kind"] == "pair") draw_pair()
    if (chart["kind"] == "rows") draw_rows()
    if (chart["kind"] == "cells") draw_cells()
}
