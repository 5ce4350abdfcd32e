# Adds up the results of mutants.sh: its first file is mutants_equivalent.txt
# (FILE <tab> LINE <tab> CHANGE <tab> REASON, where CHANGE may be `any`), its
# second the results. Exit status 1 when a survivor has no reason there, or a
# reason there has no survivor.

BEGIN { FS = "\t" }

function trimmed(text)
{
    sub(/^ +/, "", text)
    return text
}

FILENAME == ARGV[1] {
    if (/^#/ || NF < 4)
        next
    key = $1 SUBSEP trimmed($2) SUBSEP $3
    reason[key] = $4
    where[key] = FNR
    next
}

# result, file, line, change, old, new
{
    result = $1
    sub(/ .*/, "", result)
    count[result]++
    exact = $2 SUBSEP trimmed($5) SUBSEP $4
    any = $2 SUBSEP trimmed($5) SUBSEP "any"
}

result == "survived" {
    key = exact in reason ? exact : any
    used[key] = 1
    if (key in reason) {
        equivalent++
    } else {
        unexplained++
        printf "SURVIVED %s:%d: %s\n    %s\n", $2, $3, $4, trimmed($6)
    }
}

{ files[$2] = 1 }

END {
    for (key in reason) {
        split(key, part, SUBSEP)
        if (part[1] in files && !(key in used)) {
            stale++
            printf "mutants_equivalent.txt:%d: no such survivor\n", where[key]
        }
    }
    printf "%d killed, %d survived (%d of them equivalent, %d unexplained), " \
           "%d of the same code, %d refused by the compiler\n",
           count["killed"], count["survived"], equivalent, unexplained,
           count["same"], count["refused"]
    total = count["killed"] + unexplained
    printf "score: %d of %d, %.2f %%\n", count["killed"], total,
           total ? 100 * count["killed"] / total : 0
    exit unexplained + stale > 0 || total == 0
}
