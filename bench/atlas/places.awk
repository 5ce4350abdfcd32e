# places.awk TRIED CSV... : Pel's place on each workload, from the rows of the
# speed-* cases, separated by tabs. Pel is the build by gcc -O2; the best is the
# fastest peer; the limit is memset. Where Pel is not the first, TRIED (tried.tsv)
# has to say what was tried.
FNR == NR {
    names = split($1, name, " ")
    for (i = 1; i <= names && $1 !~ /^#/; i++)
        tried[name[i]] = $2
    next
}

FNR == 1 { FS = ","; next }

$2 == "Pel gcc -O2" && $5 == "ratio_to_best_peer" {
    ratio[$3] = $6
    to_best[$3] = sprintf("%.2f\t%.2f\t%.2f", $6, $7, $8)
}

$5 == "ns_per_pixel" {
    if (!($3 in seen))
        workload[++workloads] = $3
    seen[$3]
    command[$3] = $10
    if ($2 == "Pel gcc -O2")
        pel[$3] = $6
    else if ($2 == "memset")
        limit[$3] = $6
    else if ($2 !~ /^Pel /) {
        peers[$3]++
        peer[$3, peers[$3]] = $6
        if (!($3 in best) || $6 + 0 < ns[$3]) {
            best[$3] = $2
            ns[$3] = $6 + 0
        }
    }
}

# The ratio of the batches, not of the medians, tells whether it is the first.
function place_of(w, place, k)
{
    for (place = k = 1; k <= peers[w]; k++)
        place += peer[w, k] + 0 < pel[w] + 0
    return ratio[w] <= 1 ? 1 : place < 2 ? 2 : place
}

function say_tried(w)
{
    if (!(w in tried))
        print "atlas: Pel is not the first on " w ", and tried.tsv does not" \
            " say what was tried" > "/dev/stderr"
    return tried[w]
}

END {
    OFS = "\t"
    print "workload", "place", "of", "best peer", "Pel to best", "from", "to",
        "Pel to memset", "Pel, ns a pixel", "what was tried", "command"
    for (i = 1; i <= workloads; i++) {
        w = workload[i]
        place = place_of(w)
        print w, place, peers[w] + 1, best[w], peers[w] ? to_best[w] : "\t\t",
            sprintf("%.1f", pel[w] / limit[w]), pel[w],
            (place > 1 ? say_tried(w) : ""), command[w]
    }
}
