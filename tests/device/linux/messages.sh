#!/bin/sh
# messages.sh BUILD FOLDER: what a stranger is told on a machine without a
# display, and the program of docs/linux.md, compiled as that says. Nothing here
# opens a display that this machine may have.
set -u
pel=$1/pel
folder=$2
build=$1
here=$(cd "$(dirname "$0")" && pwd)
root=$here/../../..
failures=0
mkdir -p "$folder"
unset FRAMEBUFFER

# Status 2, nothing on standard output, one line that holds the text.
refused() { # TEXT COMMAND...
    text=$1
    shift
    "$@" > "$folder/out" 2> "$folder/err" < /dev/null
    status=$?
    [ $status = 2 ] && [ ! -s "$folder/out" ] &&
        [ "$(wc -l < "$folder/err")" = 1 ] &&
        grep -qF -e "$text" "$folder/err" && return
    echo "FAIL messages: status $status, no '$text': $(cat "$folder/err")"
    failures=$((failures + 1))
}

shown() { # TEXT DEVICE
    refused "pel: $1" "$pel" run "$here/reference.pel" --device "$2"
}

shown "/dev/null is no framebuffer device" fb:/dev/null
shown "/dev/null is no framebuffer device" /dev/null
shown "cannot open /dev: Is a directory" fb:/dev
shown "cannot open /dev/none: No such file or directory; is the driver loaded? \
ls /dev/fb*" fb:/dev/none
shown "unknown device 'fb0', asked for; use fb:/dev/fb0" fb0
shown "unknown device 'fb:/dev/null,quick', asked for" fb:/dev/null,quick
shown "unknown device 'drm:/dev/null,pages', asked for" drm:/dev/null,pages
shown "unknown device '', asked for" ""
shown "cannot open /dev/none: No such file or directory; is I2C on? \
dtparam=i2c_arm=on in config.txt of a Pi, and modprobe i2c-dev" \
    panel:ssd1306,i2c=/dev/none
shown "line 1 is of which chip? expected gpiochip0:1" \
    panel:st7789,spi=/dev/none,dc=1
shown "panel: '45': expected a rotation, 0, 90, 180 or 270" \
    panel:st7789,spi=/dev/none,dc=1,rotation=45
FRAMEBUFFER=nonsense
export FRAMEBUFFER
shown "unknown device 'nonsense', named by FRAMEBUFFER; use" auto
FRAMEBUFFER=/dev/null
shown "/dev/null is no framebuffer device" auto
if pkg-config --exists libdrm; then
    shown "/dev/null is no DRM device with a display: " drm:/dev/null
    shown "cannot open /dev/none: No such file or directory; is the driver \
loaded? ls /dev/dri/card*" drm:/dev/none
else
    shown "/dev/null: this program was built without DRM" drm:/dev/null
fi
refused "pel: nothing to do: expected pel console --reset" "$pel" console
refused "pel: /dev/null is not a virtual terminal; give one with --tty" \
    "$pel" console --reset --tty /dev/null
refused "pel: cannot open /dev/none: No such file or directory; has this \
machine virtual terminals?" "$pel" console --reset --tty /dev/none

# The programs of the guide, each in the file that its command compiles.
# FRAMEBUFFER is /dev/null here too.
guide=$root/docs/linux.md
program() { # TEXT THAT IT SAYS, NAME
    rm -f "$folder/$2"
    awk -v head="<!-- program: $2 -->" '$0 == head { found = 1; next }
        found && /^```/ { if (on++) exit; next }
        on' "$guide" >"$folder/$2.c"
    command=$(sed -n "s/^    \\(cc .* $2.c .*\\)/\\1/p" "$guide" |
        sed "s|build/|$build/|g; s| $2| $folder/$2|g")
    (cd "$root" && sh -c "$command") || {
        echo "FAIL messages: docs/linux.md: $command"
        failures=$((failures + 1))
    }
    refused "$1" "$folder/$2"
}
program "/dev/null is no framebuffer device" hello
program "no GPIO chip has a line 'GPIO25'" panel

[ $failures = 0 ] && echo "messages: all said as they should be"
