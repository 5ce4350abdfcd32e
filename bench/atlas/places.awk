# places.awk : Pel's place on each workload, from the rows of the speed-* cases.
# Pel is the build by gcc -O2; the best is the fastest peer; the limit is memset.
BEGIN {
    FS = ","
    print "workload,place,of,pel_ns_per_pixel,best,pel_to_best,pel_to_limit," \
        "pel_spread_percent,command"
}

$5 == "ns_per_pixel" {
    if (!($3 in seen))
        workload[++workloads] = $3
    seen[$3]
    command[$3] = $10
    if ($2 == "Pel gcc -O2") {
        pel[$3] = $6
        spread[$3] = ($8 - $7) / $6 * 100
    } else if ($2 == "memset")
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

END {
    for (i = 1; i <= workloads; i++) {
        w = workload[i]
        place = 1
        for (k = 1; k <= peers[w]; k++)
            place += peer[w, k] + 0 < pel[w] + 0
        print w "," place "," peers[w] + 1 "," pel[w] "," \
            (w in best ? best[w] : "no peer") "," \
            (w in best ? sprintf("%.3f", pel[w] / ns[w]) : "") "," \
            sprintf("%.2f", pel[w] / limit[w]) "," \
            sprintf("%.1f", spread[w]) "," command[w]
    }
}
