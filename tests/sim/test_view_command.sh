#!/bin/sh
# pel view, in a window that nobody sees: its pictures are those of pel render,
# at the start and after some turning, in every look and with any number of
# threads; and what is refused.
set -eu
. "$(dirname "$0")/lib.sh"
dir=$work
export SDL_VIDEODRIVER=dummy

# equal WHAT VIEW-OPTIONS RENDER-OPTIONS OPTIONS-OF-BOTH...
equal() {
    what=$1 view=$2 render=$3
    shift 3
    # shellcheck disable=SC2086
    "$PEL" view builtin:vase $view "$@" -o "$dir/view.ppm" 2>"$dir/told" ||
        fail "$what: $(cat "$dir/told")"
    # shellcheck disable=SC2086
    "$PEL" render builtin:vase $render "$@" -o "$dir/render.ppm"
    "$PEL" compare "$dir/view.ppm" "$dir/render.ppm" ||
        fail "$what: not the picture of pel render"
}

size='--size 160x120'
# shellcheck disable=SC2086
{
    equal "first frame" "--frames 1" "" $size
    equal "still" "--frames 3 --still" "" $size
    equal "steps" "--frames 3 --step 45" "--turn 0,0.25,0" $size
    equal "back" "--frames 2 --step -90" "--turn 0,0.75,0" $size
    equal "turned before" "--frames 2 --step 90 --turn 0.1,0.1,0.2" \
        "--turn 0.1,0.35,0.2" $size
    equal "Phong" "--frames 2 --step 0" "" $size --shade phong \
        --light 2,5,3:1,0.5,0.2 --sun 1,0,1:0.2,0.2,0.9
    equal "flat, z-buffer" "--frames 1 --jobs 3" "" $size --shade flat \
        --order zbuffer --background '#203040'
    equal "orthographic" "--frames 1" "" --size 123x77 \
        --projection orthographic
    equal "a camera" "--frames 1" "" $size --eye 1,4,3 --target 0,0.5,0 \
        --focal 35 --sensor 36x36 --near 0.5
}
"$PEL" view --frames 2 --step 30 --size 99x44 -o "$dir/view.bmp" 2>"$dir/told" ||
    fail "no mesh: $(cat "$dir/told")"
grep -q '^2 frames, [0-9.]* fps, drawing [0-9.]* ms a frame$' "$dir/told" ||
    fail "the rate is not told: $(cat "$dir/told")"

# A window larger than any picture shows one of a legal size, stretched.
cat >"$dir/large.c" <<'END'
int SDL_GetRendererOutputSize(void *renderer, int *width, int *height)
{
    (void)renderer;
    *width = 40000;
    *height = 20;
    return 0;
}
END
${CC:-cc} -shared -fPIC "$dir/large.c" -o "$dir/large.so"
LD_PRELOAD="$dir/large.so" "$PEL" view --frames 1 -o "$dir/view.ppm" \
    2>"$dir/told" || fail "a large window: $(cat "$dir/told")"
head -n 2 "$dir/view.ppm" | grep -q '^16384 20$' || fail "not as large as it may"

# refuse MESSAGE ARGUMENTS...: status 2, and one line on standard error, beside
# argp's own hint.
refuse() {
    message=$1
    shift
    status=0
    "$PEL" view "$@" >"$dir/out" 2>"$dir/told" </dev/null || status=$?
    # shellcheck disable=SC2015
    [ $status = 2 ] && [ ! -s "$dir/out" ] &&
        [ "$(grep -vc "^Try .pel view --help" "$dir/told")" = 1 ] &&
        grep -qF -e "$message" "$dir/told" ||
        fail "pel view $*: status $status: $(cat "$dir/told")"
}

refuse "pel: --frames is '0': expected a whole number from 1" --frames 0
refuse "pel: --frames is 'many': expected a whole number from 1" --frames many
refuse "pel: --step is '400': expected degrees from -360 to 360" --step 400
refuse "pel: 2 arguments: expected [MESH|SCRIPT.pel|figures]" a.obj b.obj
refuse "pel: " "$dir/missing.obj" --frames 1
refuse "turn" --turning --frames 1
refuse "picture.gif" --frames 1 -o picture.gif
echo 'pel2d 0 0' >"$dir/a.pel2d"
refuse "a.pel2d: is projected already and cannot be turned" "$dir/a.pel2d"
refuse "scene.pel: cannot be read" scene.pel
refuse "--headless without -o: expected --frames N -o FOLDER" --headless
refuse "--headless without --frames" --headless -o "$dir/frames"
refuse "--replay is for --headless" --replay "$dir/none"
refuse "expected flat or gouraud without light" --frames 1 \
    --shade phong --unlit
refuse "/dev/null is no framebuffer device" --device fb:/dev/null
SDL_VIDEODRIVER=none refuse "no screen for a window" --frames 1
(
    unset SDL_VIDEODRIVER DISPLAY WAYLAND_DISPLAY
    export XDG_RUNTIME_DIR="$dir" # SDL looks there
    refuse "no screen for a window" --frames 1
)
"$PEL" view --help | grep -q 'f g p *shading: flat, Gouraud, Phong' ||
    fail "--help does not list the keys"
