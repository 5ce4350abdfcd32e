# How programs end, and what they leave; sourced by guest_run.sh.

device=fb:/dev/fb0
shown="run /mnt/scenes/cover.pel"

pass() { # TEXT
    echo "PASS $row: $*"
}

state() {
    /mnt/console_state /dev/tty1 <&3
}

state_of_terminal() {
    state | sed 's/\( nonblocking [01]\) .*/\1/'
}

state_is() { # STATE
    [ "$(state)" = "$1" ]
}

# A guardian works beside the program.
state_becomes() { # STATE
    becomes state_is "$1"
}

active_is() { # TERMINAL
    state | grep -q " active $1 "
}

active_becomes() { # TERMINAL
    becomes active_is "$1"
}

# No signal waits for the program any more.
signals_taken() {
    ! grep -q '^S[ih][gd]Pnd:.*[1-9a-f]' /proc/$pid/status
}

dump_equals() { # NAME OTHER
    dump "$1"
    cmp -s "/mnt/$1.ppm" "/mnt/$2.ppm"
}

dump_differs() { # NAME OTHER
    ! dump_equals "$1" "$2"
}

# No process of pel's is left, not even a guardian.
all_ended() {
    ! grep -l pel /proc/[0-9]*/comm > /dev/null 2>&1
}

# Away to tty2 and back: the program lets go, waits, and draws all again. The
# signals of a switch, sent by somebody else, neither stop it nor let it draw.
switch_away_and_back() {
    kill -USR1 $pid
    becomes signals_taken && wait_drawn || return 1
    # What the host draws of the scene, on a screen of its own size.
    format=$(sed -n 's/^pel: .*, \([a-z]*[0-9][a-z0-9_]*\),.*/\1/p' $log)
    dac=8
    [ "$format" != rgb332 ] || dac=6
    size=$(sed -n 's/^canvas \([0-9]* [0-9]*\) .*/\1/p' /mnt/scenes/cover.pel)
    dump_expected "$row-before-switch" picture "$row-before-switch cover" \
        "$format $size $dac" || return 1
    timeout 30 chvt 2 || return 1
    active_becomes 2 || return 1
    echo "another terminal" > /dev/tty2
    becomes dump_differs "$row-away" "$row-before-switch" || return 1
    kill -USR2 $pid
    becomes signals_taken && wait_drawn || return 1
    # Nothing is to come: the longest delay of a kernel's copy, and some.
    usleep 200000
    dump_differs "$row-away" "$row-before-switch" || return 1
    timeout 30 chvt 1 || return 1
    active_becomes 1 || return 1
    becomes dump_equals "$row-back" "$row-before-switch" || return 1
    rm "/mnt/$row-before-switch.ppm" "/mnt/$row-before-switch.expected" \
        "/mnt/$row-back.ppm" "/mnt/$row-away.ppm"
}

# Ends the program in one of the ways.
end() { # HOW
    case $1 in
        key) press spc ;;
        switch)
            switch_away_and_back || fail "$1: picture or terminal is wrong"
            press spc
            ;;
        *) kill -"$1" $pid ;;
    esac
    wait $pid
    echo $? > /tmp/status
}

status_of() { # HOW
    case $1 in
        HUP) echo 129 ;;
        INT) echo 130 ;;
        QUIT) echo 131 ;;
        ABRT) echo 134 ;;
        KILL) echo 137 ;;
        SEGV) echo 139 ;;
        TERM) echo 143 ;;
        *) echo 0 ;;
    esac
}

# One way to end: the state during differs, the state after does not.
end_case() { # HOW
    before=$(state)
    start $pel $shown --device $device
    wait_drawn || fail "$1: not drawn: $(cat $log)"
    /mnt/console_state -scramble <&3 || fail "$1: cannot scramble"
    during=$(state)
    echo "$during" | grep -q \
        '^graphics 1 keyboard 0 switching 1 .* nonblocking 1' ||
        fail "$1: the console was not taken: $during"
    end "$1"
    [ "$(cat /tmp/status)" = "$(status_of "$1")" ] ||
        fail "$1: status $(cat /tmp/status): $(cat $log)"
    state_becomes "$before"
}

ways="key INT TERM SEGV ABRT HUP QUIT KILL switch"

kill_matrix() {
    for how in $ways; do
        if end_case $how; then
            pass "$how on $device: all as before"
        else
            fail "$how on $device: before: $before"
            fail "$how on $device: after:  $(state)"
        fi
        becomes all_ended || fail "$how: a process is left"
    done
}

# Ended while another terminal is shown: what a program there has set stays.
away_case() { # HOW
    /mnt/fb_mode 16 640 480 > /tmp/mode
    before=$(state_of_terminal)
    start $pel run /mnt/scenes/cover.pel --device $device
    wait_drawn || fail "away, $1: not drawn: $(cat $log)"
    timeout 30 chvt 2 && active_becomes 2 || fail "away, $1: tty2 is not shown"
    /mnt/fb_mode 24 640 480 > /tmp/mode_set
    kill -"$1" $pid
    wait $pid
    becomes all_ended || fail "away, $1: a process is left"
    /mnt/fb_mode > /tmp/mode_left
    /mnt/fb_mode 16 640 480 > /tmp/mode
    timeout 30 chvt 1 && active_becomes 1 || fail "away, $1: tty1 is not shown"
    if [ "$(state_of_terminal)" != "$before" ]; then
        fail "away, $1: before: $before, after: $(state_of_terminal)"
    elif ! cmp -s /tmp/mode_set /tmp/mode_left; then
        fail "away, $1: $(cat /tmp/mode_set) became $(cat /tmp/mode_left)"
    else
        pass "$1 while tty2 is shown: its mode stays"
    fi
}

# A crash of its own, with no stack left for the handler.
overflow_case() {
    before=$(state)
    start /mnt/frames $device -1
    wait $pid
    status=$?
    if [ $status = 139 ] && state_becomes "$before"; then
        pass "stack overflow on $device: all as before"
    else
        fail "stack overflow: status $status: $before, $(state)"
    fi
}

# The same without the restore must fail, every time; and pel console --reset
# must repair what is left.
no_restore_matrix() {
    pel=/mnt/pel_no_restore
    ways="key INT TERM SEGV ABRT KILL"
    state_becomes() { # what is to come has come when all have ended
        becomes all_ended && state_is "$1"
    }
    /mnt/fb_mode > /tmp/mode_before
    for how in $ways; do
        if end_case $how; then
            fail "$how: nothing was restored, and the test did not see it"
        else
            pass "$how without restore is noticed"
        fi
        /mnt/pel console --reset || fail "pel console --reset: $?"
        ! state | grep -q ' nonblocking 0 ' ||
            fail "$how: standard input was restored"
        state | grep -q '^graphics 0 keyboard 3 switching 0 ' ||
            fail "pel console --reset left: $(state)"
    done
    pel=/mnt/pel
    exec 3<> /dev/tty1
    pass "pel console --reset repairs"
}

# A picture that cannot be drawn is an error, with one thread and with more.
no_draw_case() { # JOBS
    before=$(state)
    start /mnt/pel_no_draw run /mnt/reference.pel --device $device --jobs "$1"
    ! wait_drawn || {
        fail "not drawn with --jobs $1: pel shows it all the same"
        kill $pid
    }
    wait $pid
    status=$?
    if [ $status = 2 ] && state_becomes "$before"; then
        pass "a failed picture with --jobs $1 ends with status 2"
    else
        fail "not drawn with --jobs $1: status $status: $(cat $log)"
    fi
}

# How often the device is asked for its vertical blank in 5 frames, and that
# a second display is refused.
session_case() { # DEVICE EXPECTED
    before=$(state)
    start /mnt/frames "$1" 5
    wait $pid
    status=$?
    if [ $status = 0 ] && [ "$(cat $log)" = "$2" ] && state_becomes "$before"
    then
        pass "$1: $2"
    else
        fail "$1: session: status $status: $(cat $log); not: $2"
    fi
}

# Who is not in the group video is told so; who is, draws.
access() {
    printf 'root:x:0:\nvideo:x:44:member\nplain:x:1000:\nmember:x:1001:\n' \
        > /etc/group
    printf 'root::0:0::/:/bin/sh\nplain::1000:1000::/:/bin/sh\n' > /etc/passwd
    echo 'member::1001:1001::/:/bin/sh' >> /etc/passwd
    chgrp 44 /dev/fb0
    chmod 660 /dev/fb0
    chmod 755 /mnt /tmp
    expected="pel: cannot open /dev/fb0: Permission denied; the group 'video' \
may: sudo usermod -aG video \$USER, then log in again"
    su plain -c '/mnt/pel run /mnt/reference.pel --device auto' > /tmp/out 2>&1
    status=$?
    if [ $status = 2 ] && [ "$(cat /tmp/out)" = "$expected" ]; then
        pass "$(cat /tmp/out)"
    else
        fail "plain user: status $status: $(cat /tmp/out)"
    fi
    before=$(state)
    start su member -c 'exec /mnt/pel run /mnt/reference.pel --device auto'
    member_case "on a terminal" '^graphics 1 ' '^pel: /dev/fb0'
    start setsid su member -c \
        'exec /mnt/pel run /mnt/reference.pel --device auto < /dev/null'
    member_case "without one" '^graphics 0 ' '^pel: not on a virtual terminal'
}

# Who sits at a console may repair it.
reset_case() {
    /mnt/console_state -scramble <&3
    start su member -c 'exec /mnt/pel console --reset'
    wait $pid
    status=$?
    if [ $status = 0 ] && state | grep -q '^graphics 0 keyboard 3 '; then
        pass "a user repairs the console"
    else
        fail "a user's reset: status $status: $(cat $log): $(state)"
    fi
    exec 3<&- 3<> /dev/tty1
}

# What is taken when nothing is named, and what is said.
choice_case() { # PATTERN
    if wait_drawn && grep -q "$1" $log; then
        pass "$(head -n 1 $log)"
    else
        fail "choice: $1: $(cat $log)"
    fi
    kill $pid
    wait $pid
}

choice() {
    auto="$pel run /mnt/reference.pel --device auto"
    start $auto
    choice_case '^pel: /dev/fb0 .*: the first framebuffer$'
    FRAMEBUFFER=/dev/dri/card0 start $auto
    choice_case '^pel: /dev/dri/card0 .*: named by FRAMEBUFFER$'
    mv /dev/fb0 /dev/other
    start $auto
    choice_case '^pel: /dev/dri/card0 .*: there is no /dev/fb0$'
    start $pel run /mnt/reference.pel --device fb:/dev/other,shadow
    choice_case '^pel: /dev/other .* a shadow, copied): asked for$'
    mv /dev/dri/card0 /dev/card
    $auto > $log 2>&1
    if [ $? = 2 ] && grep -q '^pel: no display: ' $log; then
        pass "$(cat $log)"
    else
        fail "no display: $(cat $log)"
    fi
    mv /dev/card /dev/dri/card0
    mv /dev/other /dev/fb0
}

member_case() { # WHERE STATE MESSAGE
    wait_drawn || fail "member of video, $1: $(cat $log)"
    state | grep -q "$2" || fail "member of video, $1: $(state)"
    grep -q "$3" $log || fail "member of video, $1: $(cat $log)"
    kill $pid
    wait $pid
    if state_becomes "$before"; then
        pass "member of video, $1: $(tail -n 1 $log)"
    else
        fail "member of video, $1: $before, $(state)"
    fi
}

faults() { # DEVICE [PROGRAM]
    before=$(state)
    "${2-/mnt/faults}" "$1" <&3 > /tmp/faults 2>&1 || fail "faults on $1"
    sed "s/^PASS/PASS $row:/" /tmp/faults
    state_becomes "$before" || fail "faults: $before, $(state)"
}

# Another program sets another mode while frames are drawn: that ends them.
mode_case() { # fb_mode's arguments...
    /mnt/fb_mode 16 640 480 > /tmp/mode
    before=$(state)
    start /mnt/frames fb:/dev/fb0
    becomes grep -q '^frames: drawing' $log || fail "mode $*: nothing is drawn"
    /mnt/fb_mode "$@" > /tmp/mode || fail "mode $*: not set"
    wait $pid
    status=$?
    if [ $status = 2 ] && grep -q 'another program changed' $log &&
        state_becomes "$before"; then
        pass "mode $*: $(tail -n 1 $log)"
    else
        fail "mode $*: status $status: $(cat $log): $before: $(state)"
    fi
}

process_ended() {
    [ ! -d /proc/$pid ]
}

frames_run() {
    grep -q '^frames: drawing' $log
}

# The terminal is for graphics, and the screen moves.
view_runs() {
    state | grep -q '^graphics 1 ' || return 1
    dump "$row-frame"
    usleep 50000
    dump_differs "$row-next" "$row-frame"
}

# Terminals are switched to and fro while frames are drawn, faster than anybody
# answers; then the frames go on, and the terminal is as it was.
storm_case() { # DEVICE
    before=$(state)
    start /mnt/frames "$1"
    becomes frames_run || fail "storm on $1: nothing is drawn: $(cat $log)"
    n=0
    while [ $n -lt 25 ]; do
        timeout 30 chvt 2 &
        timeout 30 chvt 1 &
        usleep 7000
        n=$((n + 1))
    done
    for storm in $(jobs -p); do
        [ "$storm" = $pid ] || wait "$storm"
    done
    timeout 30 chvt 1
    active_becomes 1 && becomes view_runs ||
        fail "storm on $1: no frames: $(state): $(cat $log)"
    kill $pid
    wait $pid
    state_becomes "$before" && pass "a storm of switches on $1" ||
        fail "storm on $1: $before: $(state)"
}

# All devices go to sleep and wake, by the kernel's own test, while frames are
# drawn. The host's folder does not wake, so what is needed is in memory, and the
# machine ends here.
suspend_case() { # DEVICE
    cp /mnt/frames /mnt/console_state /tmp/
    state() {
        /tmp/console_state /dev/tty1 <&3
    }
    before=$(state)
    /tmp/console_state -default /tmp/frames "$1" <&3 > $log 2>&1 &
    pid=$!
    becomes frames_run || fail "suspend on $1: nothing is drawn: $(cat $log)"
    umount -l /mnt
    echo devices > /sys/power/pm_test && echo freeze > /sys/power/state ||
        fail "suspend on $1: refused"
    becomes frames_go_on || fail "suspend on $1: no frames: $(cat $log)"
    kill $pid
    wait $pid
    state_becomes "$before" && pass "$1 slept and woke" ||
        fail "suspend on $1: $before: $(state)"
    echo "@done $failures"
    poweroff -f
}

time_of_process() {
    cut -d" " -f14 /proc/$pid/stat
}

# The program's time grows: it draws.
frames_go_on() {
    spent=$(time_of_process)
    sleep 1
    [ "$(time_of_process)" -gt "$spent" ]
}

take_away() {
    echo "$pci" > /sys/bus/pci/drivers/bochs-drm/unbind
}

bring_back() {
    echo "$pci" > /sys/bus/pci/drivers/bochs-drm/bind
}

# The driver is taken away while a command draws frames.
vanish_case() { # DEVICE PATTERN DRAWING COMMAND...
    vanished=$1 pattern=$2 drawing=$3
    shift 3
    before=$(state_of_terminal)
    start "$@"
    becomes "$drawing" || fail "$vanished: nothing is drawn"
    take_away
    becomes process_ended
    kill -9 $pid 2> /dev/null
    wait $pid
    status=$?
    after=$(state_of_terminal)
    if [ $status = 2 ] && grep -q "$pattern" $log &&
        [ "$before" = "$after" ]; then
        pass "$vanished vanished: $(tail -n 1 $log)"
    else
        fail "$vanished vanished: status $status: $(cat $log): $before: $after"
    fi
    bring_back
    becomes test -e /dev/fb0 && becomes test -e /dev/dri/card0 ||
        fail "$vanished: it does not come back"
}

vanish() {
    pci=$(basename /sys/bus/pci/drivers/bochs-drm/0000*)
    for vanishing in fb:/dev/fb0 drm:/dev/dri/card0; do
        vanish_case $vanishing '^frames: [1-9][0-9]* frames, then: .' \
            frames_run /mnt/frames $vanishing
        vanish_case $vanishing '^pel: ' view_runs \
            $pel view figures --device $vanishing
    done
}

# The card itself is pulled out, and another one is put in. Its driver may leave
# at once; the card only when nobody has it open any more. A slot whose card has
# left stays taken in the emulator.
unplug() {
    card=1
    take_away() {
        monitor "device_del card$card"
    }
    bring_back() {
        becomes test ! -e "/sys/bus/pci/drivers/bochs-drm/$pci" ||
            fail "$vanished: the card is not let go"
        card=$((card + 1))
        monitor "device_add bochs-display,id=card$card,addr=0x1$card,xres=640,yres=480"
        becomes plugged > /dev/null
        pci=$(plugged)
    }
    plugged() {
        ls /sys/bus/pci/drivers/bochs-drm | grep '^0000'
    }
    vanish
}
