#!/bin/sh
# public_headers.sh CC : the headers that programs include, in the order in which
# pel.h does: those of core that it needs, then of drivers and ports. Left out are
# those that only Pel's own files include.
set -eu
{
    echo '#include <pel/pel.h>' | $1 -Iinclude -M -x c - | tr ' \\' '\n\n' |
        sed -n 's,^include/pel/\.\./\.\./,,; /^core.*\.h$/p' | while read -r file; do
        realpath --relative-to=. "$file"
    done
    ls drivers/*.h port/linux/*.h port/sdl/*.h
} | awk '!seen[$0]++' | grep -vx -e core/base/inline.h -e core/base/multiply.h \
    -e drivers/linux_io.h -e 'drivers/console_linux_.*' -e port/linux/gpio_lib.h \
    -e port/sdl/display_sdl_draw.h
