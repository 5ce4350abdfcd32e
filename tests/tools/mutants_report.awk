# Adds up the results of mutants.sh: its first file is mutants_equivalent.txt
# (FILE <tab> LINE <tab> CHANGE <tab> REASON, where CHANGE may be `any`), its
# second the results. Exit status 1 when a survivor has no reason there, or when
# a reason there has no mutant that survives or is the same code.

BEGIN { FS = "\t" }

function trimmed(text)
{
    sub(/^ +/, "", text)
    return text
}

FILENAME == ARGV[1] {
    if (/^#/ || NF == 0)
        next
    if (NF != 4) {
        printf "mutants_equivalent.txt:%d: not four columns\n", FNR
        wrong++
        next
    }
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
    of_file[$2, result]++
    if (!($2 in files))
        file[++file_count] = $2
    files[$2] = 1
    key = $2 SUBSEP trimmed($5) SUBSEP $4
    if (!(key in reason))
        key = $2 SUBSEP trimmed($5) SUBSEP "any"
}

result == "same" { used[key] = 1 }

result == "survived" {
    used[key] = 1
    if (key in reason) {
        equivalent++
        printf "equivalent %s:%d: %s\n    %s\n", $2, $3, $4, reason[key]
    } else {
        unexplained++
        printf "SURVIVED %s:%d: %s\n    %s\n", $2, $3, $4, trimmed($6)
    }
}

END {
    for (i = 1; i <= file_count; i++)
        printf "%-32s %4d killed %4d survived\n", file[i],
               of_file[file[i], "killed"], of_file[file[i], "survived"]
    for (key in reason) {
        split(key, part, SUBSEP)
        if (part[1] in files && !(key in used)) {
            wrong++
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
    exit unexplained + wrong > 0 || total == 0
}
