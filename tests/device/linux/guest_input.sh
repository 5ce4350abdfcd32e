# Keys, pointers, touch and buttons, as pel input tells them; sourced by
# guest_run.sh.

. /mnt/guest_console.sh
sim=/sys/kernel/config/gpio-sim/test
seen=0

# What pel input has told since the last check, without the times.
told() {
    sed 's/^[0-9.]* //' $log | tail -n +$((seen + 1))
}

arrange=cat # or sort, where the order means nothing
is_told() { # LINES
    [ "$(told | $arrange)" = "$1" ]
}

# These lines and no others come. One too many that comes late is told by the
# next call, or by this one where it comes soon.
expect() { # WHAT LINE...
    what=$1
    shift
    wanted=$(printf '%s\n' "$@")
    if becomes is_told "$wanted" && usleep 100000 && is_told "$wanted"; then
        pass "$what"
        [ -z "$wanted" ] || seen=$((seen + $(echo "$wanted" | wc -l)))
    else
        fail "$what: told $(told | tr '\n' ';'), expected $(echo "$wanted" |
            tr '\n' ';')"
        seen=$(wc -l < $log)
    fi
}

listen() { # OPTIONS...
    : > $log
    $pel input "$@" > $log 2>&1 &
    pid=$!
    seen=0
    wait_drawn || fail "pel input $*: $(cat $log)"
}

end_input() { # SIGNAL
    kill -"$1" $pid
    wait $pid
}

send() { # JSON of QMP's input-send-event
    echo "@input [$1]" | tr -d '\n'
    echo
    read -r answer
}

key() { # KEY true|false
    send '{"type":"key","data":
        {"down":'$2',"key":{"type":"qcode","data":"'$1'"}}}'
}

click() { # BUTTON true|false
    send '{"type":"btn","data":{"button":"'$1'","down":'$2'}}'
}

tablet() { # X Y, of 32768
    send '{"type":"abs","data":{"axis":"x","value":'$1'}},
        {"type":"abs","data":{"axis":"y","value":'$2'}}'
}

# The first eventN whose name holds $1.
event_of() { # NAME
    grep -l "$1" /sys/class/input/event*/device/name | head -n 1 |
        sed 's/.*\(event[0-9]*\).*/\1/'
}

there_is() { # NAME
    event=$(event_of "$1")
    [ -n "$event" ] && [ -e "/dev/input/$event" ]
}

wait_devices() {
    for device_name in keyboard Mouse Tablet; do
        becomes there_is $device_name || fail "no $device_name"
    done
}

last_told() { # LINE
    [ "$(told | tail -n 1)" = "$1" ]
}

devices() {
    wait_devices
    listen --size 1000x500
    seen=$(wc -l < $log)
    press a
    expect "a key" "key a down" "key a up"
    press shift-f12
    expect "keys without a character" "key shift down" "key f12 down" \
        "key f12 up" "key shift up"
    send '{"type":"rel","data":{"axis":"x","value":10}},
        {"type":"rel","data":{"axis":"y","value":-5}}'
    expect "the mouse moves" "move 10 -5"
    tablet 16384 8192
    expect "the tablet points" "point 500 125"
    click left true
    click left false
    click right true
    click right false
    expect "buttons" "button 1 down" "button 1 up" "button 3 down" \
        "button 3 up"
    click wheel-up true
    click wheel-up false
    click wheel-down true
    click wheel-down false
    expect "the wheel" "wheel 0 1" "wheel 0 -1"
    overrun
    replug
    touch_screen
    end_input TERM
}

# More than the kernel keeps while the program stands still: that is told, and
# what is still held.
overrun() {
    kill -STOP $pid
    key q true
    for i in $(seq 20); do
        key a true
        key a false
    done
    kill -CONT $pid
    becomes grep -q ' lost$' $log || fail "a full queue was not told"
    becomes last_told "key q down" ||
        fail "what is held after the loss: $(told | tr '\n' ';')"
    seen=$(wc -l < $log)
    key q false
    press c
    expect "after the loss" "key q up" "key c down" "key c up"
}

# Taken away while a button is held, and plugged in again.
replug() {
    virtio=/sys/bus/virtio/drivers/virtio_input
    device=$(basename $virtio/virtio*)
    event=$(event_of Tablet)
    click left true
    expect "held" "button 1 down"
    echo "$device" > $virtio/unbind
    expect "unplugged" "button 1 up" "$event gone"
    echo "$device" > $virtio/bind
    event=$(event_of Tablet)
    expect "plugged in" "$event here"
    click left false
    tablet 0 32767
    expect "points again" "point 0 499"
}

# A touch screen of uinput's: it comes, two fingers touch it, it goes.
touch_screen() {
    /mnt/touch_device > /tmp/touch &
    touch_pid=$!
    becomes grep -q here $log
    wait $touch_pid || fail "touch_device: status $?"
    event=$(told | sed -n '1s/ here//p')
    expect "touch" "$event here" "touch 0 at 100 50 down" \
        "touch 1 at 750 250 down" "touch 0 at 200 50 again" \
        "touch 0 at 200 50 up" "touch 1 at 750 250 up" "$event gone"
}

# The outside pulls lines: 0 closes a contact to ground.
pull() { # LINE LEVEL LINE LEVEL...
    while [ $# -gt 0 ]; do
        level=down
        [ "$2" = 0 ] || level=up
        echo pull-$level > "$lines_of_chip/sim_gpio$1/pull"
        shift 2
    done
}

# A chip of 32 lines comes, or goes.
chip_comes() {
    echo 1 > $sim/live
    chip=$(cat $sim/bank/chip_name)
    lines_of_chip=/sys/devices/platform/$(cat $sim/dev_name)/$chip
    becomes test -e "/dev/$chip"
}

make_chip() {
    modprobe gpio-sim
    if [ -d $sim ]; then
        echo 0 > $sim/live
    else
        mount -t configfs config /sys/kernel/config
        mount -t debugfs debug /sys/kernel/debug
    fi
    mkdir -p $sim/bank/line5
    echo 32 > $sim/bank/num_lines
    echo the-button > $sim/bank/line5/name
    chip_comes || fail "no simulated chip"
}

# ms; several times what the most bounces below take where the host is loaded:
# contacts that rest longer between two of them are no bounces.
debounce=400

# With each version of libgpiod.
buttons() { # PEL WHO_DEBOUNCES
    pel=$1
    make_chip
    listen --only-buttons \
        --buttons "$chip:5=left,6=enter,17/27=wheel,debounce=$debounce"
    seen=1 # buttons here
    pull 5 0
    expect "a press" "key left down"
    pull 5 1
    expect "a release" "key left up"
    pull 5 0 5 1 5 0 5 1 5 0
    expect "a press that bounces" "key left down"
    pull 6 0 5 1 5 0 5 1 6 1 6 0
    # Which of the two comes first is not promised: the kernel's timers of lines
    # that it debounces may end in the wrong order when they are that near.
    arrange=sort
    expect "bounces of two" "key enter down" "key left up"
    arrange=cat
    pull 5 0 5 1
    pull 6 1 6 0 6 1
    expect "a touch that is too short" "key enter up"
    encoder "$2"
    held
    vanish_chip
    freed
    debounced "$2"
}

# The kernel debounces buttons, where libgpiod can ask it to: what its lines tell
# is what pel would tell.
debounced() {
    listen --only-buttons --buttons "$chip:5=left,debounce=$debounce"
    seen=1
    pull 5 0 5 1 5 0 5 1 5 0
    expect "bounces, debounced by $1" "key left down"
    pull 5 1 5 0 5 1
    expect "a release that bounces, debounced by $1" "key left up"
    pull 5 0 5 1
    usleep $((debounce * 1500)) # what rests so long counts
    expect "too short, debounced by $1" ""
    pull 5 0
    expect "pressed, debounced by $1" "key left down"
    pull 5 1
    expect "released, debounced by $1" "key left up"
    end_input TERM
}

encoder() {
    pull 17 0 27 0 17 1 27 1 # A first
    pull 17 0 17 1 17 0 27 0 17 1 27 1
    expect "clockwise" "wheel 0 1" "wheel 0 1"
    pull 27 0 17 0 27 1 17 1
    expect "counter-clockwise" "wheel 0 -1"
    pull 17 0 27 0 27 1 17 1
    expect "half way and back" ""
    turns=24
    if [ "$1" = "the kernel" ]; then # libgpiod 2: 512 edges are kept
        kill -STOP $pid
        for i in $(seq $turns); do
            pull 17 0 27 0 17 1 27 1
        done
        kill -CONT $pid
        expect "96 edges at once" \
            "$(for i in $(seq $turns); do echo wheel 0 1; done)"
        turns=140
    fi
    kill -STOP $pid
    for i in $(seq $turns); do
        pull 17 0 27 0 17 1 27 1
    done
    kill -CONT $pid
    becomes grep -q ' lost$' $log || fail "lost edges were not told"
    wait_drawn # all has been read
    seen=$(wc -l < $log)
    pull 27 0 17 0 27 1 17 1
    expect "a detent after lost ones" "wheel 0 -1"
}

held() {
    $pel input --only-buttons --buttons "$chip:4=a,5=b" > /tmp/held 2>&1
    status=$?
    if [ $status = 2 ] &&
        grep -q "line 5 of /dev/$chip is held by 'pel'" /tmp/held; then
        pass "a held line: $(cat /tmp/held)"
    else
        fail "a held line: status $status: $(cat /tmp/held)"
    fi
    $pel input --only-buttons --buttons "$chip:4=a,99=b" > /tmp/held 2>&1
    grep -q "/dev/$chip has no line '99'" /tmp/held ||
        fail "line 99: $(cat /tmp/held)"
}

# The chip goes while a button is held, and comes back.
vanish_chip() {
    pull 5 0
    expect "held" "key left down"
    echo 0 > $sim/live
    expect "the chip is gone" "key left up" "buttons gone"
    chip_comes
    expect "the chip is back" "buttons here"
    pull 5 0
    expect "a press after that" "key left down"
    pull 5 1
    expect "a release after that" "key left up"
}

is_free() {
    ! grep -q 'pel' /sys/kernel/debug/gpio
}

# The lines are free whatever the end, and a line's name is enough.
freed() {
    for how in TERM KILL; do
        grep -q pel /sys/kernel/debug/gpio || fail "$how: no line is held"
        end_input $how
        becomes is_free && pass "$how: the lines are free" ||
            fail "$how: $(cat /sys/kernel/debug/gpio)"
        listen --only-buttons --buttons the-button=left,pull-down
        seen=1
    done
    pull 5 1
    expect "a line by its name, pulled down" "key left down"
    pull 5 0
    expect "the same, released" "key left up"
    end_input TERM
    $pel input --only-buttons --buttons "$chip:5=left" --seconds 0.2 > $log 2>&1 ||
        fail "pel input: $(cat $log)"
    is_free && pass "the end: the lines are free" || fail "lines held"
}

# Each level rests much longer than pel's 5 ms of debouncing: a load only makes
# that longer.
tap() { # LINE
    pull "$1" 0
    usleep 80000
    pull "$1" 1
    usleep 80000
}

# Writes the view's picture number $1.
take() { # NUMBER
    wait_drawn
    tap 6
    becomes grep -q "^written: view-00$1" $log || fail "no picture $1"
}

# A button, an encoder and a finger turn a view; back is the first picture.
view_by_hand() { # DEVICE
    make_chip
    modprobe uinput
    modprobe evdev
    cd /tmp || exit 2
    rm -f view-*
    start $pel view builtin:vase --still --device "$1" --jobs 2 \
        --buttons "$chip:5=right,6=w,7=q,17/27=wheel-x"
    take 1
    tap 5
    take 2
    pull 27 0 17 0 27 1 17 1
    take 3
    /mnt/touch_device
    take 4
    tap 7
    wait $pid
    status=$?
    if [ $status = 0 ] && cmp -s view-001.* view-003.* &&
        ! cmp -s view-001.* view-002.* && ! cmp -s view-001.* view-004.*; then
        pass "a view turned by hand"
    else
        fail "a view turned by hand: status $status: $(cat $log)"
    fi
    cd /mnt || exit 2
}

# From nothing to a hit: crosses are touched on a glass that is swapped, inverted
# and out of place; then taps are where they were, within two pixels.
calibration() { # DEVICE
    modprobe uinput
    modprobe evdev
    rm -f /tmp/touch.matrix
    start $pel input --calibrate /tmp/touch.matrix --device "$1"
    wait_drawn || fail "calibration: $(cat $log)"
    /mnt/touch_device 640 480 76 57 563 240 320 422 480 96
    wait $pid
    status=$?
    [ $status = 0 ] && grep -q MATRIX /tmp/touch.matrix ||
        fail "calibration: status $status: $(cat $log)"
    echo "$row: $(cat $log /tmp/touch.matrix | tr '\n' ' ')"
    start $pel input --touch /tmp/touch.matrix --size 640x480
    wait_drawn || fail "calibrated: $(cat $log)"
    /mnt/touch_device 640 480 3 5 600 30
    /mnt/touch_device 640 480 320 240 11 470
    kill $pid
    wait $pid
    sed -n 's/.*touch 0 at \([0-9]*\) \([0-9]*\) down/\1 \2/p' $log |
        awk -v at="3 5 600 30 320 240 11 470" 'BEGIN { split(at, want, " ") }
            {
                x = $1 - want[++n]; y = $2 - want[++n]
                if (x < -2 || x > 2 || y < -2 || y > 2)
                    bad = 1
            }
            END { exit bad || n != 8 }' &&
        pass "calibrated touch within two pixels" ||
        fail "calibrated touch: $(cat $log)"
}

# Keys and a finger choose in the kiosk of examples/.
kiosk() { # DEVICE
    name=$row-kiosk-${1%%:*}
    export FRAMEBUFFER="$1"
    start /mnt/kiosk
    unset FRAMEBUFFER
    wait_drawn || fail "$name: $(cat $log)"
    press right
    /mnt/touch_device
    told="$name kiosk xrgb8888 $width $height 8"
    echo "$told" >> /mnt/manifest
    dump_expected "$name" picture "$told"
    press esc
    wait $pid
    status=$?
    [ $status = 0 ] && pass "the kiosk on $1" ||
        fail "$name: status $status: $(cat $log)"
}
