# What each virtual machine does, by its name in rows.txt.

. /mnt/guest_panel.sh

row_cirrusfb() {
    mode 8 rgb332 6 fb:/dev/fb0 8 640 480
    mode 16 rgb565_le 8 fb:/dev/fb0 16 640 480
    mode 24 rgb888 8 fb:/dev/fb0 24 640 480
    scenes="/mnt/scenes/cover.pel /mnt/reference.pel"
    mode 16-padded rgb565_le 8 fb:/dev/fb0,pages 16 640 480 800
    mode 24-padded rgb888 8 fb:/dev/fb0,pages 24 640 480 704
    scenes=/mnt/reference.pel
    mode 16-shadow rgb565_le 8 fb:/dev/fb0,shadow 16 640 480
    mode 24-direct rgb888 8 fb:/dev/fb0,direct 24 640 480
    mode 8-shadow rgb332 6 fb:/dev/fb0,shadow 8 640 480
    turned_pictures 8-turned rgb332 6 fb:/dev/fb0,shadow
    mode 16-800 rgb565_le 8 fb:/dev/fb0 16 800 600
    if /mnt/fb_mode 32 2> /dev/null; then
        fail "32 bits: cirrusfb was expected to refuse them"
    fi
    own_sizes rgb565_le fb:/dev/fb0
}

row_cirrus_16() {
    mode 16 rgb565_le 8 fb:/dev/fb0
    scenes=/mnt/reference.pel
    pictures drm rgb565_le 8 drm:/dev/dri/card0
    turned_pictures turned rgb565_le 8 fb:/dev/fb0
    insmod /mnt/damage_clips.ko || fail "no module"
    for angle in 0 90 180 270; do
        damage
    done
    angle=0
    turned_pictures drm-turned rgb565_le 8 drm:/dev/dri/card0
}

# A screen that is told which part of it changes shows that part alone.
damage() {
    start /mnt/damage "drm:/dev/dri/card0,rotate=$angle"
    wait_drawn || fail "damage: $(cat $log)"
    size=$(sed -n 's/.* \([0-9]*\)x\([0-9]*\), rgb565_le.*/\1 \2/p' $log | head -n 1)
    width=${size% *} height=${size#* }
    echo "$row: $(cat $log)"
    for scene in damage_red damage_blue; do
        told="$row-$scene-$angle $scene rgb565_le $width $height 8 $angle"
        echo "$told" >> /mnt/manifest
        dump_expected "${told%% *}" picture "$told"
        press spc
    done
    wait $pid
    status=$?
    [ $status = 0 ] || fail "damage: status $status: $(cat $log)"
}

row_cirrus_24() {
    mode 24 rgb888 8 fb:/dev/fb0
    scenes=/mnt/reference.pel
    turned_pictures turned rgb888 8 fb:/dev/fb0
}

row_cirrus_32() {
    mode 32 xrgb8888 8 fb:/dev/fb0
}

row_vesafb_301() {
    mode 8 rgb332 8 fb:/dev/fb0
}

row_vesafb_310() {
    mode 15 xrgb1555_le 5 fb:/dev/fb0
}

row_vesafb_311() {
    mode 16 rgb565_le 8 fb:/dev/fb0
}

row_vesafb_312() {
    mode 24 rgb888 8 fb:/dev/fb0
}

row_vesafb_318() {
    mode 24 rgb888 8 fb:/dev/fb0
}

row_vesafb_341() {
    mode 32 xrgb8888 8 fb:/dev/fb0
}

row_bochs() {
    mode 32 xrgb8888 8 fb:/dev/fb0
    pictures drm xrgb8888 8 drm:/dev/dri/card0
    put_ignored
    own_sizes xrgb8888 fb:/dev/fb0
    turned_pictures turned xrgb8888 8 fb:/dev/fb0
    turned_pictures drm-turned xrgb8888 8 drm:/dev/dri/card0
}

# A screen that does not say what it is.
row_bochs_no_edid() {
    scenes=/mnt/reference.pel
    pictures drm xrgb8888 8 drm:/dev/dri/card0
}

row_access() {
    . /mnt/guest_console.sh
    access
    reset_case
    choice
    device=drm:/dev/dri/card0
    ways="key TERM SEGV KILL switch"
    kill_matrix
    session_case fb:/dev/fb0,shadow "5 waits for the vertical blank: done"
    session_case drm:/dev/dri/card0 "0 waits for the vertical blank"
    storm_case drm:/dev/dri/card0
    storm_case fb:/dev/fb0,shadow
    vanish
}

row_unplug() {
    . /mnt/guest_console.sh
    unplug
}

row_suspend() {
    . /mnt/guest_console.sh
    suspend_case drm:/dev/dri/card0
}

row_faults() {
    . /mnt/guest_console.sh
    faults fb:/dev/fb0
    faults fb:/dev/fb0,shadow
    mode_case 24 640 480
    mode_case 16 800 480
    mode_case 16 640 480 640 480 1
    $pel console --reset --tty /dev/tty1 || fail "pel console --reset"
    faults /dev/tty1
}

row_faults_drm() {
    . /mnt/guest_console.sh
    insmod /mnt/damage_clips.ko || fail "no module"
    faults drm:/dev/dri/card0
}

row_virtio() {
    mode 32 xrgb8888 8 fb:/dev/fb0
    mesh fb:/dev/fb0
    view fb:/dev/fb0
    . /mnt/guest_input.sh
    view_by_hand fb:/dev/fb0
    calibration drm:/dev/dri/card0
    kiosk fb:/dev/fb0
    kiosk drm:/dev/dri/card0
    pictures drm xrgb8888 8 drm:/dev/dri/card0
}

row_qxl() {
    mode 32 xrgb8888 8 fb:/dev/fb0
    scenes=/mnt/reference.pel
    pictures drm xrgb8888 8 drm:/dev/dri/card0
}

row_figures() {
    . /mnt/guest_view.sh
    make_chip
    modprobe evdev
    for device in fb:/dev/fb0 drm:/dev/dri/card0; do
        figures
        second
        shown="view figures --size 160x120"
        ways="INT TERM KILL"
        kill_matrix
    done
}

row_input() {
    . /mnt/guest_input.sh
    devices
    buttons /mnt/pel pel
    buttons /mnt/pel_gpiod2 "the kernel"
}

row_faults_input() {
    . /mnt/guest_input.sh
    make_chip
    faults input
    faults "buttons:$chip:5=left,17/27=wheel"
    faults "buttons:$chip:5=left,17/27=wheel" /mnt/faults_gpiod2
    faults buttons:the-button=left
}

# No screen: what is visible in its memory is the picture.
row_vfb() {
    dump_expected() {
        /mnt/fb_mode -read "/mnt/$1.ppm"
    }
    mode 16 bgr565_le 8 fb:/dev/fb0 16 640 480
    mode 24 bgr888 8 fb:/dev/fb0 24 640 480
    mode 32 xbgr8888 8 fb:/dev/fb0 32 640 480
    scenes=/mnt/reference.pel
    mode 16-pages bgr565_le 8 fb:/dev/fb0,pages 16 640 480 640 960
    mode 16-padded bgr565_le 8 fb:/dev/fb0 16 640 480 700
    scenes=/mnt/scenes/cover.pel
    mode 1 mono1 8 fb:/dev/fb0 1 640 480
    turned_pictures 1-turned mono1 8 fb:/dev/fb0
    refused
    alone
}

# A layout that is none of Pel's: its values are told, and nothing is changed.
refused() {
    /mnt/fb_mode 16 640 480 640 480 1 > /tmp/mode
    $pel run /mnt/reference.pel --device fb:/dev/fb0 > $log 2>&1
    status=$?
    if [ $status = 2 ] &&
        grep -q 'layout: .*red 0/5 green 5/5 blue 10/5' $log; then
        echo "PASS $row: $(cat $log)"
    else
        fail "bgr555: status $status: $(cat $log)"
    fi
}

# Who has no virtual terminal draws beside nobody.
alone() {
    /mnt/fb_mode 32 640 480 > /tmp/mode
    start $pel run /mnt/reference.pel --device fb:/dev/fb0
    wait_drawn || fail "alone: $(cat $log)"
    setsid $pel run /mnt/reference.pel --device fb:/dev/fb0 > /tmp/second 2>&1 \
        < /dev/null
    status=$?
    kill $pid
    wait $pid
    if [ $status = 2 ] && grep -q 'another program draws on' /tmp/second; then
        echo "PASS $row: $(cat /tmp/second)"
    else
        fail "alone: status $status: $(cat /tmp/second)"
    fi
}

row_console() {
    . /mnt/guest_console.sh
    kill_matrix
    overflow_case
    away_case TERM
    away_case KILL
    session_case fb:/dev/fb0,pages "1 wait for the vertical blank: ENOTTY"
    session_case fb:/dev/fb0,shadow "1 wait for the vertical blank: ENOTTY"
    session_case fb:/dev/fb0,direct "0 waits for the vertical blank"
    no_draw_case 1
    no_draw_case 2
    no_restore_matrix
}

# A small and a large picture, centred.
own_sizes() { # FORMAT DEVICE
    width=own height=own
    for size in "301 223" "1000 900"; do
        scene="reference:$size"
        sed "s/^canvas .*/canvas $size $1/" /mnt/reference.pel > /tmp/scene.pel
        scene=$(echo "reference $size" | tr ' ' '_')
        picture "$scene" "$1" 8 $pel run /tmp/scene.pel --device "$2"
    done
}

# A mesh, drawn by pel render.
mesh() { # DEVICE
    scene=mesh
    picture mesh xrgb8888 8 $pel render builtin:vase \
        --size "${width}x$height" --device "$1" --jobs 3
}

# A view that keys turned into another picture: once 'w' is told, so is all that
# came before; then one that turns and ends by itself.
view() { # DEVICE
    scene=view name=$row-view
    cd /tmp || exit 2
    start $pel view builtin:vase --still --device "$1" --jobs 2
    wait_drawn
    press right
    press r
    press p
    press w
    becomes grep -q '^written: view-001' $log
    wait_drawn || fail "$name: $(cat $log)"
    told="$name $scene xrgb8888 $width $height 8"
    echo "$told" >> /mnt/manifest
    dump_expected "$name" picture "$told"
    press q
    wait $pid
    status=$?
    [ $status = 0 ] && grep -q 'triangles, Phong, lit' $log ||
        fail "$name: status $status: $(cat $log)"
    start $pel view builtin:vase --frames 3 --step 30 --device "$1" --jobs 2
    wait $pid
    status=$?
    [ $status = 0 ] && grep -q '^3 frames' $log ||
        fail "$name: status $status: $(cat $log)"
    cd /mnt || exit 2
}

# The kernel says yes to 16 bits and changes nothing: what it then tells counts.
put_ignored() {
    /mnt/fb_mode 16 > /tmp/mode 2>&1
    echo "$row: asked for 16 bits: $(cat /tmp/mode)"
    scenes=/mnt/reference.pel
    pictures asked-16 xrgb8888 8 fb:/dev/fb0
}
