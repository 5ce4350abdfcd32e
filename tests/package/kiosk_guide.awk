# The program hello.c of docs/linux.md.
index($0, "`hello.c`") { on = 1; next }
on && /^    cc / { exit }
on && (/^    / || /^$/) { sub(/^    /, ""); print }
