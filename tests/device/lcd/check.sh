#!/bin/sh
# check.sh BUILD BOARD... : runs BUILD/lcd/BOARD.elf and compares its screens, one
# for each format, with the reference.
set -u
build=$1
shift
export QEMU_AUDIO_DRV=none
status=0
"$build/linux/reference" 640 480 5 6 5 >"$build/lcd/16.ppm"
"$build/linux/reference" 640 480 8 8 8 >"$build/lcd/32.ppm"
for board; do
    screens=$build/lcd/$board
    rm -rf "$screens" && mkdir "$screens"
    "$build/linux/vm" "$screens" 60 qemu-system-arm -M "$board" -display none \
        -serial stdio -kernel "$build/lcd/$board.elf" 2>"$screens/messages" || {
        cat "$screens/messages"
        echo "check-lcd: $board: status $?" >&2
        status=1
    }
    for format in rgb565_le rgb565_be bgr565_le xrgb8888 xbgr8888 rgbx8888 \
        bgrx8888; do
        bits=32 widened=8
        case $format in *565*) bits=16 widened=565 ;; esac
        "$build/linux/screen_check" "$build/lcd/$bits.ppm" \
            "$screens/$format.ppm" $widened || {
            echo "DIFFERENT  $board $format"
            status=1
        }
    done
    [ $status != 0 ] || echo "equal      $board, 7 formats on its screen"
done
exit $status
