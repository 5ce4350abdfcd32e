# Panels on panel_mock, a bus that notes what is sent; sourced by guest_rows.sh.

mock=/sys/kernel/debug/panel-mock

pass() { # TEXT
    echo "PASS $row: $*"
}

# A scene on a panel, and what the host has to compare.
shown() { # NAME CHIP ROTATION WIDTH HEIGHT FORMAT DEVICE
    insmod /mnt/panel_mock.ko || fail "$1: no module"
    sed "s/^canvas .*/canvas $4 $5 $6/" /mnt/scenes/cover.pel > /tmp/scene.pel
    start $pel run /tmp/scene.pel --device "panel:$7,rotation=$3"
    if wait_drawn; then
        cat $mock/log > "/tmp/$1.log"
        cp "/tmp/$1.log" /mnt/
        echo "$1 $2 $3 $4 $5 $6" >> /mnt/panels
    else
        fail "$1: $(cat $log)"
    fi
    kill $pid
    wait $pid
    rmmod panel_mock || fail "$1: something is left open"
}

levels_are() { # LEVELS WHEN
    [ "$(cat $mock/levels)" = "$1" ] && pass "lines are $1 $2" ||
        fail "lines are $(cat $mock/levels) $2, not $1"
}

panel_refused() { # TEXT COMMAND...
    text=$1
    shift
    "$@" > /tmp/refused 2>&1 < /dev/null
    grep -qF "$text" /tmp/refused && pass "$text" ||
        fail "no '$text': $(cat /tmp/refused)"
}

# Who holds a line is told, and all are free when the program has ended.
panel_lines() {
    device=panel:st7789,spi=/dev/spidev0.0,size=240x240,dc=DC,reset=RESET,light=LIGHT
    insmod /mnt/panel_mock.ko
    for signal in TERM INT KILL; do
        start $pel run /mnt/reference.pel --device $device
        wait_drawn || fail "$signal: $(cat $log)"
        levels_are 0x00000007 "while the picture is there"
        panel_refused "line DC of /dev/gpiochip0 is held by 'pel'" \
            $pel run /mnt/reference.pel --device $device
        kill -$signal $pid
        wait $pid
    done
    timeout 60 $pel view builtin:vase --frames 2 --device $device > /tmp/end \
        2>&1 || fail "view: $(cat /tmp/end)"
    levels_are 0x00000002 "when the program has ended"
    rmmod panel_mock && pass "no line is held after signals and kill -9" ||
        fail "lines are held after kill -9"
}

panel_messages() {
    insmod /mnt/panel_mock.ko
    panel_refused "no GPIO chip has a line 'GPIO25'" $pel run /mnt/reference.pel \
        --device panel:st7789,spi=/dev/spidev0.0,dc=GPIO25
    start $pel run /mnt/reference.pel --device panel:ssd1306,i2c=$i2c
    wait_drawn || fail "I2C: $(cat $log)"
    cp $mock/log /tmp/before
    panel_refused "another program has the chip at address 0x3c of $i2c" \
        setsid $pel run /mnt/reference.pel --device panel:ssd1306,i2c=$i2c
    cmp /tmp/before $mock/log || fail "I2C: a second program was heard"
    kill $pid
    wait $pid
    panel_refused "no chip answers at address 0x3d of /dev/i2c-" \
        $pel run /mnt/reference.pel --device panel:ssd1306,i2c=$i2c,address=0x3d
    rmmod panel_mock
}

row_panel() {
    mount -t debugfs debugfs /sys/kernel/debug
    cp /mnt/scenes/*.ppm /mnt/scenes/*.bdf /tmp/
    : > /mnt/panels
    insmod /mnt/panel_mock.ko
    i2c=$(ls /dev/i2c-* | tail -n 1)
    rmmod panel_mock
    spi=spi=/dev/spidev0.0,dc=DC,reset=RESET
    shown st7789-0 st7789 0 240 240 rgb565_be st7789,size=240x240,$spi
    shown st7789-90 st7789-135 90 240 135 rgb565_be \
        st7789,size=135x240,$spi,light=gpiochip0:2
    shown ili9341-180 ili9341 180 240 320 rgb565_be ili9341,$spi
    shown ssd1306-0 ssd1306 0 128 64 mono1_pages ssd1306,i2c=$i2c
    shown ssd1306-270 ssd1306 270 64 128 mono1 ssd1306,$spi
    panel_lines
    panel_messages
}
