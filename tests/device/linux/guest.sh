# Functions of the guest's scripts; sourced. The host's folder is /mnt; `pel`
# runs on the virtual terminal tty1, whose descriptor 3 is.

pel=/mnt/pel
failures=0
angle=0 # of pictures

fail() { # TEXT
    echo "FAIL $row: $*"
    failures=$((failures + 1))
}

dump() { # NAME
    echo "@dump $1"
    read -r answer
}

# Takes the screen until it is what check_row.sh expects, or too long: the kernel
# may show what was stored with a delay. What stays wrong check_row.sh tells.
dump_expected() { # NAME KIND WORDS
    echo "@screen $*"
    read -r answer
    [ -z "$answer" ]
}

# Until $1 holds, at most half a minute and what its calls take.
becomes() { # COMMAND...
    becomes_n=0
    until "$@"; do
        usleep 50000
        becomes_n=$((becomes_n + 1))
        [ $becomes_n -lt 600 ] || return 1
    done
}

monitor() { # COMMAND of the emulator's monitor
    echo "@monitor $1"
    read -r answer
}

press() { # KEYS
    monitor "sendkey $1"
}

# Runs a command on tty1 in the background; $pid is its process, $log gets what
# it prints. It is empty at once: the background process may open it later, and
# what the last command told is no answer of this one.
log=/tmp/log
start() { # COMMAND...
    : > $log
    /mnt/console_state -default "$@" <&3 > $log 2>&1 &
    pid=$!
}

# Until the command has told what it draws on or listens to and waits in poll(2),
# which is what pel does when the picture is complete, or has ended. Before it
# tells that it may wait so for the process that reads a file.
wait_drawn() {
    n=0
    while [ -d /proc/$pid ] &&
        ! { [ -s $log ] && grep -q '^7 ' /proc/$pid/syscall; }; do
        usleep 20000
        n=$((n + 1))
        [ $n -lt 3000 ] || return 1
    done 2> /dev/null
    [ -d /proc/$pid ]
}

# Shows one scene and notes what the host has to compare.
picture() { # NAME FORMAT DAC_BITS COMMAND...
    name=$row-$1 format=$2 dac=$3
    shift 3
    start "$@"
    if wait_drawn; then
        grep -q ", $format," $log || fail "$name: not $format: $(cat $log)"
        told="$name $scene $format $width $height $dac $angle"
        echo "$told" >> /mnt/manifest
        dump_expected "$name" picture "$told"
    else
        fail "$name: $(cat $log)"
    fi
    kill $pid 2> /dev/null
    wait $pid
}

# All scenes in the mode that is set, on a canvas of the screen's size; one more
# with a canvas of its own, which is smaller or larger.
pictures() { # NAME FORMAT DAC_BITS DEVICE
    width=$(mode_field 1) height=$(mode_field 2)
    cp /mnt/scenes/*.ppm /mnt/scenes/*.bdf /tmp/
    for file in $scenes; do
        scene=$(basename "$file" .pel)
        sed "s/^canvas .*/canvas $width $height $2/" "$file" > /tmp/scene.pel
        picture "$1-$scene" "$2" "$3" $pel run /tmp/scene.pel --device "$4" \
            --jobs 2
    done
}

# The same, turned to every side, drawn by one thread and by two.
turned_pictures() { # NAME FORMAT DAC_BITS DEVICE
    across=$(mode_field 1) down=$(mode_field 2)
    for angle in 90 180 270; do
        width=$across height=$down
        [ $angle = 180 ] || { width=$down height=$across; }
        for file in $scenes; do
            scene=$(basename "$file" .pel)
            sed "s/^canvas .*/canvas $width $height $2/" "$file" \
                > /tmp/scene.pel
            picture "$1-$angle-$scene" "$2" "$3" $pel run /tmp/scene.pel \
                --device "$4,rotate=$angle" --jobs $((angle / 90 % 2 + 1))
        done
    done
    angle=0
}

# "mode NAME 640x480 virtual 800x600 ...": the two numbers before `virtual`.
mode_field() { # 1 OR 2
    /mnt/fb_mode | sed -n 's/.* \([0-9]*\)x\([0-9]*\) virtual .*/\'"$1"'/p'
}

# A mode, then its pictures. Status 1: the kernel has no such mode.
mode() { # NAME FORMAT DAC_BITS DEVICE fb_mode's arguments...
    m_name=$1 m_format=$2 m_dac=$3 m_device=$4
    shift 4
    /mnt/fb_mode "$@" > /tmp/mode || {
        fail "$m_name: mode $*"
        return
    }
    echo "$row: $(cat /tmp/mode)"
    pictures "$m_name" "$m_format" "$m_dac" "$m_device"
}
