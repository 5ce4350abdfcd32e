#!/bin/sh
# install.sh BUILD VERSION : what make has built in BUILD goes below
# $DESTDIR$PREFIX. A relative PREFIX begins at the current folder. BUILD has the
# flags and packages that programs with the Linux drivers take.
set -eu
build=$1 version=$2
case $PREFIX in
/*) prefix=$PREFIX ;;
*) prefix=$PWD/$PREFIX ;;
esac
to=${DESTDIR-}$prefix
so=libpel.so.$version

# folder FROM TO : the headers below FROM
headers() {
    (cd "$1" && find . -name '*.h' -o -name '*.inc') | while read -r file; do
        install -D -m 644 "$1/$file" "$to/include/$2/$file"
    done
}

# package NAME DESCRIPTION : NAME.pc, which ends with the lines of the input. In
# quotes, a folder may have a blank.
package() {
    { printf 'prefix=%s\nName: %s\nDescription: %s\nVersion: %s\n' "$prefix" \
        "$1" "$2" "$version"; cat; } >"$to/lib/pkgconfig/$1.pc"
    chmod 644 "$to/lib/pkgconfig/$1.pc"
}

install -d "$to/bin" "$to/lib/pkgconfig" "$to/share/man/man1" \
    "$to/share/man/man3"
headers core pel
headers drivers pel-drivers/drivers
headers port/linux pel-drivers/port/linux
headers port/sdl pel-drivers/port/sdl
install -m 644 "$build/libpel.a" "$build/libpel_linux.a" "$to/lib"
install "$build/$so" "$to/lib"
ln -sf "$so" "$to/lib/${so%.*}"
ln -sf "${so%.*}" "$to/lib/libpel.so"
package pel "Exact shapes, text, pictures and small 3-D scenes in any framebuffer" <<'END'
Cflags: -I"${prefix}/include"
Libs: -L"${prefix}/lib" -lpel
END
package pel-linux "Displays, panels and input of Linux devices for Pel" <<END
Requires: pel $(cat "$build/libpel_linux.packages")
Cflags: -I"\${prefix}/include/pel-drivers" $(cat "$build/libpel_linux.flags")
Libs: -L"\${prefix}/lib" -lpel_linux -pthread
END
if [ -f "$build/libpel_sdl.a" ]; then
    install -m 644 "$build/libpel_sdl.a" "$to/lib"
    package pel-sdl "A window as a display for Pel" <<'END'
Requires: pel sdl2
Cflags: -I"${prefix}/include/pel-drivers"
Libs: -L"${prefix}/lib" -lpel_sdl
END
fi
install "$build/pel" "$to/bin"
install -m 644 "$build/man/pel.1" "$to/share/man/man1"
install -m 644 "$build/man/pel.3" "$to/share/man/man3"
