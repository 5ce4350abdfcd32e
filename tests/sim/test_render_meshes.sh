#!/bin/sh
# Meshes in scene scripts: the picture is that of pel render with the same
# settings, state stays in force, files are found beside the script, and what is
# wrong is refused with its line.
set -u
. "$(dirname "$0")/lib.sh"

printf 'P3 2 2 255  255 0 0  0 255 0  0 0 255  255 255 255' >"$work/four.ppm"

# as OPTIONS...: the script on standard input, after a white canvas, draws what
# pel render draws of the vase.
as() {
    { printf 'canvas 90 70 rgb888\nclear #ffffff\n'; cat; } >"$work/s.pel"
    "$PEL" run "$work/s.pel" -o "$work/s.ppm" || fail "refused: $*"
    "$PEL" render builtin:vase --size 90x70 "$@" -o "$work/r.ppm" ||
        fail "render $*"
    "$PEL" compare "$work/s.ppm" "$work/r.ppm" || fail "differs: $*"
    "$PEL" run "$work/s.pel" --bands 9 -o "$work/b.ppm"
    "$PEL" compare "$work/s.ppm" "$work/b.ppm" || fail "bands: $*"
}
as <<'END'
mesh builtin:vase
END
as --eye 1,2,4.5 --target 0,1,0 --up 0.25,1,0 --focal 35 --sensor 36x28 \
    --near 0.5 --shade flat <<'END'
camera eye 1 2 4.5
camera target 0 1 0
camera up 0.25 1 0
camera focal 35
camera sensor 36 28
camera near 0.5
shade flat
mesh builtin:vase
END
as --projection orthographic --shade phong --light 2,3,4:1,0.5,0.25 \
    --sun -1,0,0.5:0.125,0.25,1 --ambient 1,0.75,0.5 --ka 0.25 --kd 0.5 \
    --ks 0.75 --shininess 40 <<'END'
light none # before any
camera projection orthographic
shade phong
light point 2 3 4 1 0.5 0.25
light sun -1 0 0.5 0.125 0.25 1
ambient 1 0.75 0.5
material 0.25 0.5 0.75 40
mesh builtin:vase
END
as --shade phong --tolerance 4 <<'END'
shade phong
option mesh tolerance 4
mesh builtin:vase
END
as --texture-file "$work/four.ppm" --texel-tolerance 255.5 <<'END'
texture four.ppm
option mesh texel_tolerance 255.5
mesh builtin:vase
END
for term in ambient diffuse specular; do
    as --shade gouraud --terms $term --highlights plain --back-highlights off \
        --sun 1,0,-1:1,1,1 --order zbuffer16 --cull back <<END
option mesh terms $term
option mesh highlights plain
option mesh backhighlights off
light sun 1 0 -1 1 1 1
option mesh order zbuffer16
option mesh cull back
mesh builtin:vase
END
done
as --texture-file "$work/four.ppm" --texture nearest --mapping subdivided \
    --span 4 --wrap mirror --normals-from smooth --transparency 60 \
    --turn 0.125,0.25,0.5 <<'END'
texture four.ppm
option mesh texture nearest
option mesh mapping subdivided
option mesh span 4
option mesh wrap mirror
option mesh normals smooth
option mesh transparency 60
option mesh turn 0.125 0.25 0.5
mesh builtin:vase
END
as --turn 0.3,0.3,0.5 <<'END'
option mesh turn 0.3 0.3 0.5
mesh builtin:vase
END
as --color '#204060' --unlit <<'END'
texture four.ppm
texture own
option mesh color #20406080
option mesh color own
option mesh color #204060
option mesh light off
mesh builtin:vase
END
as --shade gouraud <<'END'
camera eye 9 9 9
camera target 3 3 3
camera near 4
camera frame
light point 1 2 3 1 1 1
light none
shade phong
shade gouraud
mesh builtin:vase
END

# Two viewports of one canvas are two pictures side by side; nothing outside
# changes, and the clip holds.
cat >"$work/s.pel" <<'END'
canvas 120 50 rgb888
clear #ffffff
camera viewport 10 0 40 50
mesh builtin:vase
camera viewport 60 0 50 50
shade phong
mesh builtin:vase
clip 0 0 10 50
camera viewport 0 0 120 50
mesh builtin:vase
END
"$PEL" run "$work/s.pel" -o "$work/s.ppm" || fail "two viewports"
cat >"$work/t.pel" <<'END'
canvas 120 50 rgb888
clear #ffffff
image 10 0 a.ppm
image 60 0 b.ppm
clip 0 0 10 50
image 0 0 c.ppm
END
"$PEL" render builtin:vase --size 40x50 -o "$work/a.ppm"
"$PEL" render builtin:vase --size 50x50 --shade phong -o "$work/b.ppm"
"$PEL" render builtin:vase --size 120x50 --shade phong -o "$work/c.ppm"
"$PEL" run "$work/t.pel" -o "$work/t.ppm" || fail "side by side"
"$PEL" compare "$work/s.ppm" "$work/t.ppm" || fail "viewports differ"

# refused LINE TEXT: the script on standard input, after the canvas line.
refused() {
    { echo 'canvas 8 8 rgb888'; cat; } >"$work/s.pel"
    rm -f "$work/o.ppm"
    "$PEL" run "$work/s.pel" -o "$work/o.ppm" 2>"$work/err"
    [ $? = 2 ] || fail "status of: $2"
    grep -qF -e "pel: $work/s.pel:$1: $2" "$work/err" ||
        fail "no '$2' in: $(cat "$work/err")"
    [ "$(grep -cv '^    ' "$work/err")" = 1 ] || fail "more than one: $2"
    [ ! -e "$work/o.ppm" ] || fail "output in spite of: $2"
}
refused 2 "mesh: $work/none.obj cannot be read (No such file" <<'END'
mesh none.obj
END
refused 2 "builtin:cube: no mesh that is built in: expected builtin:vase, builtin:vase-small, or" <<'END'
mesh builtin:cube
END
refused 2 "texture: $work/none.png cannot be read" <<'END'
texture none.png
END
echo 'P6 2' >"$work/bad.ppm"
refused 3 "$work/bad.ppm:2: ends before the height" <<'END'
texture bad.ppm
mesh builtin:vase
END
refused 2 "camera eye: 2 values: expected 3: camera eye X Y Z" <<'END'
camera eye 1 2
END
refused 2 "camera eye: 16385: expected a decimal in -16384..16384" <<'END'
camera eye 1 2 16385
END
refused 2 "camera focal: 0: expected a decimal above 0" <<'END'
camera focal 0
END
refused 2 "camera viewport: expected all of it within" <<'END'
camera viewport 32000 0 800 600
END
refused 2 "camera projection: flat: expected perspective|orthographic" <<'END'
camera projection flat
END
refused 2 "unknown command camera: expected" <<'END'
camera
END
refused 2 "light point: 16: expected a decimal from 0 to less than" <<'END'
light point 1 2 3 1 1 16
END
refused 2 "light sun: expected the direction towards it" <<'END'
light sun 0 0 0 1 1 1
END
refused 2 "material: 257: expected a whole number in 1..256" <<'END'
material 1 1 1 257
END
refused 2 "shade: fancy: expected flat|gouraud|phong" <<'END'
shade fancy
END
refused 2 "option mesh span: 3: expected 2|4|8|16|32|64" <<'END'
option mesh span 3
END
refused 4 "eye and target are one place" <<'END'
camera eye 0 1 0
camera target 0 1 0
mesh builtin:vase
END
refused 4 "Phong shading is light at every pixel" <<'END'
shade phong
option mesh light off
mesh builtin:vase
END
seq -f 'light point %g 1 1 1 1 1' 33 >"$work/lights"
refused 34 "light 33: expected up to 32" <"$work/lights"
