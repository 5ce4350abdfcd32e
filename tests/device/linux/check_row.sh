#!/bin/sh
# check_row.sh BUILD CACHE ROW: one virtual machine of rows.txt; then its
# screens are compared with what the host's pel draws. Results go to
# BUILD/rows/ROW/result, the machine's words to log beside it. Status 0: all
# right.
#
# check_row.sh BUILD CACHE ROW KIND WORD...: is a screen of a machine that still
# runs as expected? For vm.c, which waits for that. KIND and words: `picture`
# and a line of the manifest, `view` and a line of views. Status 0: yes.
set -u
here=$(cd "$(dirname "$0")" && pwd)
build=$(cd "$1" && pwd)
cache=$(cd "$2" && pwd)
row=$3
line=$(grep "^$row|" "$here/rows.txt") || {
    echo "check_row.sh: no row $row in rows.txt" >&2
    exit 2
}
modules=$(echo "$line" | cut -d'|' -f2)
append=$(echo "$line" | cut -d'|' -f3)
display=$(echo "$line" | cut -d'|' -f4)
share=$build/rows/$row
result=$share/result

# An emulated processor needs no defence against its own speculation, which
# costs more than half of the time.
fast="mitigations=off no_timer_check"

# The time of a machine is no measure of anything: a loaded host takes several
# times as long as an idle one.
machine() {
    export here build cache row
    # shellcheck disable=SC2016 # the shell that runs it has these variables
    is='exec "$here/check_row.sh" "$build" "$cache" "$row"'
    # shellcheck disable=SC2086
    "$build/vm" "$share" 1200 "$is" qemu-system-x86_64 -accel tcg -m 256 \
        -nodefaults -no-reboot -display none -serial stdio \
        -kernel "$cache/vmlinuz" -initrd "$cache/initramfs" \
        -append "console=ttyS0 quiet $fast mods=$modules $append" \
        -virtfs local,path="$share",mount_tag=host,security_model=none \
        $display
}

bits_of() { # FORMAT
    case $1 in
        rgb332) echo 3 3 2 ;;
        *565*) echo 5 6 5 ;;
        *1555*) echo 5 5 5 ;;
        *) echo 8 8 8 ;;
    esac
}

# To $expected, which is whole or not there.
draw() { # SCENE FORMAT SIZE
    if [ "$1" = mesh ] || [ "$1" = view ]; then
        shade=gouraud
        [ "$1" = mesh ] || shade=phong
        "$build/../pel" render builtin:vase --size "$3" --format "$2" \
            --shade $shade -o "$share/expected.ppm" || return
    else
        sed "s/^canvas .*/canvas $width $height $2/" "$source" \
            > "$share/scene.pel"
        "$build/../pel" run "$share/scene.pel" -o "$share/expected.ppm" ||
            return
    fi
    mv "$share/expected.ppm" "$expected"
}

# The host's picture of a scene, and where Pel has no part in it, the
# reference's.
compare() { # NAME SCENE FORMAT WIDTH HEIGHT DAC_BITS [ANGLE]
    source=$share/scenes/$2.pel
    [ -f "$source" ] || source=$share/$2.pel
    [ -f "$source" ] || source=$share/reference.pel
    width=$4 height=$5
    case $2 in reference_*)
        width=$(echo "$2" | cut -d_ -f2) height=$(echo "$2" | cut -d_ -f3) ;;
    esac
    expected=$share/$1.expected
    [ -s "$expected" ] || draw "$2" "$3" "$4x$5" || return
    "$build/screen_check" "$expected" "$share/$1.ppm" "$6" "${7-0}" ||
        return
    case $2 in reference*)
        # shellcheck disable=SC2046
        "$build/reference" "$width" "$height" $(bits_of "$3") \
            > "$share/reference.ppm"
        "$build/screen_check" "$share/reference.ppm" "$share/$1.ppm" "$6" \
            "${7-0}" || return
        ;;
    esac
}

# A view's pictures and screens are those of its record, drawn again: each is
# written at key w (119), before what else came with the same frame.
replay() { # NAME
    last=$(tail -n 1 "$share/$1/record" | cut -d' ' -f1)
    "$build/../pel" view figures --still --size 160x120 --headless \
        -o "$share/replay" --frames $((last + 1)) \
        --replay "$share/$1/record" || return
    shots=0
    while [ -f "$share/replay/view-00$((shots + 1)).ppm" ]; do
        shots=$((shots + 1))
        mv "$share/replay/view-00$shots.ppm" "$share/$1/shot-$shots.ppm"
        "$build/../pel" compare "$share/$1/shot-$shots.ppm" \
            "$share/$1/view-00$shots".* || return
    done
    rm -r "$share/replay"
    [ "$shots" = "$(grep -c ' key 119 down ' "$share/$1/record")" ] &&
        [ "$shots" = "$(cksum "$share/$1"/view-00* | sort -u -k 1,1 | wc -l)" ]
}

# The screen of a view, with the cross of its pointer.
screen() { # NAME SCREEN SHOT [X Y]
    {
        echo "canvas 640 480 xrgb8888"
        echo "clear #000000"
        echo "paint texture $share/$1/shot-$3.ppm 240 180"
        echo "rect 240 180 160 120"
        [ $# -eq 3 ] || echo "$1" | awk -v x="$4" -v y="$5" '{
            x += 240; y += 180
            print "clip 240 180 400 300\npaint flat #000000"
            print "rect", x - 8, y - 1, 17, 3
            print "rect", x - 1, y - 8, 3, 17
            print "paint flat #ffffff"
            print "rect", x - 7, y, 15, 1
            print "rect", x, y - 7, 1, 15 }'
    } > "$share/scene.pel"
    "$build/../pel" run "$share/scene.pel" -o "$share/expected.ppm" &&
        "$build/screen_check" "$share/expected.ppm" "$share/$1-$2.ppm"
}

# While the machine runs, a picture of a view is what the guest wrote.
if [ $# -gt 3 ]; then
    kind=$4
    shift 4
    case $kind in
        picture) compare "$@" ;;
        view)
            cp "$share/$1/view-00$3".* "$share/$1/shot-$3.ppm" && screen "$@"
            ;;
        *) exit 2 ;;
    esac
    exit
fi

rm -rf "$share"
mkdir -p "$share/scenes"
cp "$here"/guest*.sh "$here/reference.pel" "$share/"
cp "$here"/../../../sim/scenes/*.pel "$share/scenes/"
# The files that scenes name lie where their scripts do, here and in the guest.
for asset in "$here"/../../../sim/scenes/*.ppm "$here"/../../../sim/scenes/*.bdf
do
    cp "$asset" "$share/"
    cp "$asset" "$share/scenes/"
done
for program in pel pel_no_restore pel_no_draw fb_mode console_state faults \
    frames damage touch_device pel_gpiod2 faults_gpiod2 kiosk; do
    ln "$build/guest/$program" "$share/$program" 2> /dev/null ||
        cp "$build/guest/$program" "$share/$program"
done
cp "$cache/panel_mock.ko" "$cache/damage_clips.ko" "$share/"
# The kiosk's picture in the middle of 640 x 480 pixels of its color.
"$build/kiosk" | LC_ALL=C sed '1,6{/^# /d}' > "$share/kiosk.ppm"
printf '%s\n' 'canvas 640 480 xrgb8888' 'clear #f2e8dc' \
    'image 80 80 kiosk.ppm' > "$share/kiosk.pel"
# What a screen shows that is told of the damage of damage.c: first of the red
# frame's, then of the blue one's with it.
damage() { # NAME COLOR WIDTH HEIGHT
    printf '%s\n' 'canvas 640 480 xrgb8888' 'clear #808080' "paint flat $2" \
        "rect 40 30 $3 $4" > "$share/damage_$1.pel"
}
damage red "#ff0000" 100 40
damage blue "#0000ff" 200 170
echo "$row" > "$share/row"
# tty1 is the controlling terminal, standard input and output the serial line.
cat > "$share/run.sh" << 'END'
exec setsid sh -c 'exec 3<> /dev/tty1; exec sh /mnt/guest_run.sh'
END

: > "$result"
begun=$(date +%s)
machine > "$share/log" 2>&1 ||
    echo "FAIL $row: the guest's status is not 0" >> "$result"
grep -E '^FAIL|^vm:|Oops|panic' "$share/log" | sed '/^FAIL/!s/^/FAIL /' \
    >> "$result"
equal=0
pictures=0
while read -r name scene format width height dac angle; do
    pictures=$((pictures + 1))
    compare "$name" "$scene" "$format" "$width" "$height" "$dac" "$angle" \
        > "$share/difference" 2>&1 && equal=$((equal + 1)) &&
        rm "$share/$name.ppm" ||
        echo "FAIL $name ($format): $(cat "$share/difference")" >> "$result"
    rm -f "$share/$name.expected"
done < "$share/manifest"
[ ! -f "$share/panels" ] || while read -r name chip turn width height format; do
    pictures=$((pictures + 1))
    sed "s/^canvas .*/canvas $width $height $format/" \
        "$share/scenes/cover.pel" > "$share/scene.pel"
    { "$build/../pel" run "$share/scene.pel" -o "$share/expected.ppm" &&
        "$build/panel_check" "$chip" "$turn" "$share/expected.ppm" \
            "$share/$name.log"; } > "$share/difference" 2>&1 &&
        equal=$((equal + 1)) ||
        echo "FAIL $name ($format): $(cat "$share/difference")" >> "$result"
done < "$share/panels"
[ ! -f "$share/views" ] || for name in $(cut -d' ' -f1 "$share/views" | uniq)
do
    replay "$name" > "$share/difference" 2>&1 ||
        echo "FAIL $name: $(cat "$share/difference")" >> "$result"
done
[ ! -f "$share/views" ] || while read -r name screen shot x y; do
    pictures=$((pictures + 1))
    # shellcheck disable=SC2086
    screen "$name" "$screen" "$shot" $x $y > "$share/difference" 2>&1 &&
        equal=$((equal + 1)) ||
        echo "FAIL $name-$screen: $(cat "$share/difference")" >> "$result"
done < "$share/views"
passed=$(grep -c '^PASS' "$share/log")
[ $((pictures + passed)) -gt 0 ] ||
    echo "FAIL $row: nothing was tested" >> "$result"
echo "$row: $equal of $pictures screens equal, $passed checks passed," \
    "$(($(date +%s) - begun)) s" >> "$result"
cat "$result"
! grep -q '^FAIL' "$result"
