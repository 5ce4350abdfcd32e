#!/bin/sh
# What files, their names and arguments have does not command the terminal:
# whatever comes to people, on either stream, is lines of at most 500 bytes
# without controls.
set -u
. "$(dirname "$0")/lib.sh"
PEL=$(realpath "$PEL")
cd "$work" || exit 1

# Bold, C1's CSI as a byte and as UTF-8, a new line, a tab, a turned direction.
bad=$(printf '\033[1m\233\302\233X\n  \tpel: fake\342\200\256')
long=$(head -c 9000 /dev/zero | tr '\0' 'x')
shown='?[1m??X?  ?pel: fake?'

# told TEXT COMMAND ARGUMENT...: what the command says is clean and has the text.
told() {
    text=$1
    shift
    LC_ALL=C "$PEL" "$@" >"$work/out" 2>&1 </dev/null
    LC_ALL=C grep -qa "$(printf '[\001-\011\013-\037\177\233]')" "$work/out" &&
        fail "controls of: $* $(cat -v "$work/out" | head -c 900)"
    iconv -f UTF-8 -t UTF-8 "$work/out" >/dev/null || fail "no UTF-8: $*"
    [ "$(LC_ALL=C awk 'length > 500' "$work/out")" = '' ] ||
        fail "a line of over 500 bytes: $*"
    grep -qaF -e "$text" "$work/out" ||
        fail "no '$text': $(cat -v "$work/out" | head -c 900)"
}

# Names of files, of every kind.
printf 'P3 1 1 255 0 0 0' >"a$bad.ppm"
printf 'P3 2 1 255 0 0 0 0 0 0' >a.ppm
for command in run render view info 'import -o o.c' 'compare a.ppm'; do
    # shellcheck disable=SC2086
    told "$shown.ppm: cannot" $command "none$bad.ppm"
    # shellcheck disable=SC2086
    told ' ... ' $command "$long"
done
told "unknown command $shown" "$bad"
told "unknown option '--$shown'" render "--$bad"
told "unknown option '--$shown=$shown'" render "--$bad=$bad"
told "unknown option '-?[1m" render "-$bad"
told "--size is '$shown'" render --size "$bad"

# What is in them.
{ echo 'canvas 8 8 gray8' && printf '\033]0;title\007 1 2\n'; } >c.pel
told '2: unknown command ?]0;title?: expected' run c.pel
{ echo 'canvas 8 8 gray8' && printf 'fill "%s\\n    pel: fake"\n' "$bad"; } |
    tr -d '\n' | sed 's/gray8/&\n/' >n.pel
told 'n.pel:2: unknown command fill' run n.pel
printf 'canvas 8 8 gray8\nimage 0 0 %s\n' "$long" >l.pel
told 'l.pel:2: a word of 9000 bytes' run l.pel
printf 'STARTFONT 2.1\nFONTBOUNDINGBOX \033[31m\n' >f.bdf
told 'f.bdf:2: ' import f.bdf -o o.c
printf '\033pel2d' >p.pel2d
told 'p.pel2d:1: ' render p.pel2d -o o.ppm
printf 'solid \033[31m\n facet normal 0 0 1\n outer loop\n vertex 1 \033 %s\n' \
    "$long" >s.stl
told 's.stl: ' info s.stl
printf '{"asset": {"version": "\033[1m%s"}}' "$long" >g.gltf
told 'g.gltf: ' info g.gltf
printf 'mtllib m.mtl\nusemtl %b\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' \
    'a\033[31mb' >o.obj
printf 'newmtl %b\nmap_Kd %b.png\n' 'a\033[31mb' 'tex\033[1m\302\233' >m.mtl
told "'a?[31mb'" info o.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n' | {
    printf 'mtllib m.mtl\nusemtl a\033[31mb\n'
    cat
} >t.obj
told 'texture 1: missing, tex?[1m?.png' info t.obj
told 'sizes differ: a.ppm has 2 x 1 pixels, a?[1m' compare a.ppm "a$bad.ppm"
told 'lines are left' compare --shrink c.pel --command false -o shrunk
[ -e "$work/failed" ] || echo "messages: nothing reaches the terminal"
