#!/bin/sh
# need.sh PROGRAM:PACKAGE... : fails when a program is not on this machine, and
# names the Debian package that brings it.
status=0
for pair; do
    program=${pair%%:*}
    command -v "$program" >/dev/null && continue
    echo "missing: $program, of the Debian package ${pair#*:};" \
        "\`make setup\` installs it" >&2
    status=1
done
exit $status
