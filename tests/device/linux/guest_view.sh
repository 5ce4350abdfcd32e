# pel view figures on a device, by all that a user has; sourced by guest_run.sh.

. /mnt/guest_input.sh

# Key w, or what presses it, writes picture $shots.
shot() { # COMMAND...
    shots=$((shots + 1))
    "$@"
    becomes grep -q "^written: view-00$shots" $log || fail "no picture $shots"
    wait_drawn
}

# Shows the picture that was written last; check_row.sh draws it with the cross
# of a pointer at X Y of it.
screen() { # NAME [X Y]
    told="$name $1 $shots $2 $3"
    echo "$told" >> /mnt/views
    dump_expected "$name-$1" view "$told"
}

# How many lines of the record hold $1 is $2: they are there at once.
recorded() { # PATTERN COUNT
    [ "$(grep -c "$1" record)" -ge "$2" ]
}

# Until the view has heard of it: devices are read one after the other, so a key
# that is pressed later could be heard before.
clicks=0
click_left() {
    clicks=$((clicks + 1))
    click left true
    click left false
    becomes recorded " button 1 up " $clicks || fail "$name: no click $clicks"
}

# The screen is no longer what was dumped as $1.
changes() { # NAME
    dump "$name-now"
    ! cmp -s "/mnt/$1.ppm" "/mnt/$name-now.ppm"
}

# The host draws what was recorded once more: all pictures and screens.
figures() {
    name=$row-${device%%:*}
    shots=0 clicks=0
    mkdir -p "/mnt/$name"
    cd "/mnt/$name" || exit 2
    wait_devices
    tablet 0 0
    start $pel view figures --still --size 160x120 --device $device \
        --record record --buttons "$chip:5=tab,6=w,17/27=wheel"
    wait_drawn || fail "$name: $(cat $log)"
    shot press w
    press 2
    press tab
    press 4
    shot press w
    screen keys
    tablet 16384 16384
    click_left
    shot press w
    screen tablet 80 60
    send '{"type":"rel","data":{"axis":"x","value":-40}},
        {"type":"rel","data":{"axis":"y","value":-20}}'
    click_left
    shot press w
    screen mouse 40 40
    tap 5
    pull 27 0 17 0 27 1 17 1
    shot tap 6
    screen rests 40 40
    press spc
    becomes changes "$name-rests" || fail "$name: nothing moves"
    press spc
    rm "/mnt/$name-now.ppm"
    shot press w
    press f3
    press o
    shot press w
    press o
    press x
    press x
    press m
    shot press w
    screen magnifier 40 40
    press q
    wait $pid
    status=$?
    [ $status = 0 ] || fail "$name: status $status: $(cat $log)"
    cd /mnt || exit 2
}

# Another view on the same terminal and device is refused, and takes nothing.
second() {
    before=$(state)
    start $pel view figures --still --device $device
    wait_drawn || fail "second: no first: $(cat $log)"
    during=$(state)
    $pel view figures --device $device <&3 > /tmp/second 2>&1
    status=$?
    [ $status = 2 ] && [ "$(state)" = "$during" ] ||
        fail "second: status $status: $(cat /tmp/second): $during: $(state)"
    kill $pid
    wait $pid
    state_becomes "$before" && pass "second: $(cat /tmp/second)" ||
        fail "second: before: $before, after: $(state)"
}
