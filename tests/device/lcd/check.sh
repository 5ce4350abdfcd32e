#!/bin/sh
# check.sh BUILD BOARD... : runs BUILD/lcd/BOARD.elf and compares its screens, one
# for each format or the glass of a panel, with the reference.
set -u
build=$1
shift
export QEMU_AUDIO_DRV=none
status=0
"$build/linux/reference" 640 480 5 6 5 >"$build/lcd/16.ppm"
"$build/linux/reference" 640 480 8 8 8 >"$build/lcd/32.ppm"
"$build/linux/reference" 96 16 1 1 1 224 48 4 >"$build/lcd/lm3s811evb.ppm"
"$build/linux/reference" 128 64 4 4 4 224 48 4 >"$build/lcd/lm3s6965evb.ppm"
for board; do
    bad=0
    screens=$build/lcd/$board
    rm -rf "$screens" && mkdir "$screens"
    "$build/linux/vm" "$screens" 60 false qemu-system-arm -M "$board" -display none \
        -serial stdio -kernel "$build/lcd/$board.elf" 2>"$screens/messages" || {
        echo "check-lcd: $board: status $?" >&2
        cat "$screens/messages"
        bad=1
    }
    # What a chip does not know.
    grep 'ssd03.*error' "$screens/messages" && bad=1
    formats='rgb565_le rgb565_be bgr565_le xrgb8888 xbgr8888 rgbx8888 bgrx8888'
    case $board in lm3s*) formats=glass ;; esac
    for format in $formats; do
        picture=32 widened=8
        case $format in
        *565*) picture=16 widened=565 ;;
        glass) picture=$board ;;
        esac
        "$build/linux/screen_check" "$build/lcd/$picture.ppm" \
            "$screens/$format.ppm" $widened || {
            echo "DIFFERENT  $board $format"
            bad=1
        }
    done
    [ $bad != 0 ] || echo "equal      $board: $formats"
    [ $bad = 0 ] || status=1
done
exit $status
