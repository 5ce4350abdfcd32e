# Entries of mutants_equivalent.txt whose file, or whose line in it, is gone.
# Exit status 1 when there are any.

BEGIN { FS = "\t" }

/^#/ || NF == 0 { next }

!($1 in lines) {
    lines[$1] = 0
    while ((getline line <$1) > 0) {
        sub(/^ +/, "", line)
        there[$1, line] = 1
        lines[$1]++
    }
    close($1)
}

!(($1, $2) in there) {
    printf "%s:%d: %s\n", FILENAME, FNR,
           lines[$1] ? "no line in " $1 ": " $2 : $1 " does not exist"
    stale++
}

END { exit stale > 0 }
