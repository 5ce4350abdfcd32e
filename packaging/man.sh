#!/bin/sh
# man.sh PEL VERSION : the manual page of the program, which is what its --help
# says.
set -eu

help() {
    "$@" --help | sed 's/\\/\\e/g; s/-/\\-/g; s/^[.'\'']/\\\&&/'
}

printf '.TH PEL 1 "" "pel %s"\n' "$2"
echo '.SH NAME'
echo 'pel \- draw scenes and meshes, make assets for firmware'
printf '.SH SYNOPSIS\n.nf\n%s\n.fi\n' "$(help "$1")"
for command in $("$1" --help | sed -n 's/^  \([a-z]*\) .*/\1/p'); do
    printf '.SH PEL %s\n.nf\n%s\n.fi\n' "$command" "$(help "$1" "$command")" |
        sed '1y/abcdefghijklmnopqrstuvwxyz/ABCDEFGHIJKLMNOPQRSTUVWXYZ/'
done
printf '.SH SEE ALSO\n.BR pel (3)\n'
