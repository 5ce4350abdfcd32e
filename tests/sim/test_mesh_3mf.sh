#!/bin/sh
# 3MF: colours of triangles and corners, objects where the build places them.
set -u
. "$(dirname "$0")/shows.sh"
"$PEL" info $field/m_bm.3mf 2>&1 | grep -q 'without' && exit 0
shows $field/m_bm.3mf ff0000:70,72 ff0000:73,30 0000ff:27,70 0000ff:30,27

bytes() { # VALUE COUNT: from the lowest
    v=$1 n=$2
    while [ "$n" -gt 0 ]; do
        printf "\\$(printf %o $((v & 255)))"
        v=$((v >> 8)) n=$((n - 1))
    done
}
# entry NAME FILE: appends to $work/zip, and to its directory.
entry() {
    at=$(wc -c <"$work/zip") size=$(wc -c <"$2")
    {
        printf '\24\0\0\0\0\0\0\0\41\0'
        gzip -c "$2" | tail -c 8 | head -c 4
        bytes "$size" 4
        bytes "$size" 4
        bytes ${#1} 2
        bytes 0 2
    } >"$work/head"
    {
        printf 'PK\3\4'
        cat "$work/head"
        printf %s "$1"
        cat "$2"
    } >>"$work/zip"
    {
        printf 'PK\1\2\24\0'
        cat "$work/head"
        bytes 0 10
        bytes "$at" 4
        printf %s "$1"
    } >>"$work/directory"
    entries=$((entries + 1))
}
package() { # MODEL [ATTRIBUTES]: writes a.3mf
    printf '<Relationships><Relationship Type="http://x/3dmodel" Target="/3D/a.model" Id="r"/></Relationships>' \
        >"$work/rels"
    printf '<?xml version="1.0"?><model xmlns="c" %s>%s</model>' "${2:-}" "$1" \
        >"$work/model"
    : >"$work/zip"
    : >"$work/directory"
    entries=0
    entry _rels/.rels "$work/rels"
    entry 3D/a.model "$work/model"
    entry 3D/Textures/t4.png $field/t4.png
    {
        cat "$work/zip" "$work/directory"
        printf 'PK\5\6\0\0\0\0'
        bytes $entries 2
        bytes $entries 2
        bytes "$(wc -c <"$work/directory")" 4
        bytes "$(wc -c <"$work/zip")" 4
        bytes 0 2
    } >"$work/a.3mf"
}
vertices='<vertices><vertex x="-1" y="-1" z="0"/><vertex x="1" y="-1" z="0"/><vertex x="1" y="1" z="0"/><vertex x="-1" y="1" z="0"/></vertices>'
# object ATTRIBUTES FIRST SECOND: the two triangles of a square
object() {
    printf '<object id="1" %s><mesh>%s<triangles><triangle v1="0" v2="1" v3="2" %s/><triangle v1="0" v2="2" v3="3" %s/></triangles></mesh></object>' \
        "$1" "$vertices" "$2" "$3"
}
groups='<basematerials id="5"><base name="r" displaycolor="#FF0000"/><base displaycolor="#0000FFFF"/></basematerials><m:colorgroup id="7"><m:color color="#00FF00"/><m:color color="#FFFF00"/><m:color color="#00FFFF"/></m:colorgroup>'
build='<build><item objectid="1"/></build>'
row() { # PLACES RESOURCES [BUILD]
    package "<resources>$groups$2</resources>${3:-$build}"
    # shellcheck disable=SC2086
    shows "$work/a.3mf" $1
}
row 'ff0000:70,72 0000ff:30,27' "$(object '' 'pid="5" p1="0"' 'pid="5" p1="1"')"
row '00ff00:70,72 0000ff:30,27' "$(object 'pid="5" pindex="1"' 'pid="7" p1="0"' '')"
row '00ff00:70,72 ffff00:30,27' "$(object 'pid="7" pindex="0"' '' 'p1="1"')"
row '999999:70,72 ff0000:30,27' "$(object '' '' 'pid="5" p1="0"')"
row '00ff00~:26,73 f2ff00~:26,27' \
    "$(object '' 'pid="7" p1="0" p2="0" p3="0"' 'pid="7" p1="0" p2="1" p3="1"')" \
    '<build><item objectid="1"/></build>'
row '999999:70,72 ff0000:30,27' "$(object '' 'pid="9" p1="0"' 'pid="5" p1="0"')"
told '1 triangles have compositematerials or multiproperties, which pel does not have'
# Textures: upright, of triangles or of the object, beside colours, clamped or
# repeated; what is not in the package is named.
texture() { # STYLES PART
    printf '<m:texture2d id="8" path="%s" contenttype="image/png" %s/><m:texture2dgroup id="9" texid="8">' \
        "$2" "$1"
    printf '<m:tex2coord u="%s" v="%s"/>' 0 0 1 0 1 1 0 1 2 0 2 2 0 2
    printf '</m:texture2dgroup>'
}
t4=$(texture '' /3D/Textures/t4.png)
row 'ff0000:30,30 00ff00:70,30 0000ff:30,70 ffff00:70,70' \
    "$t4$(object '' 'pid="9" p1="0" p2="1" p3="2"' 'pid="9" p1="0" p2="2" p3="3"')"
row 'ffff00:70,70 00ffff:30,30' \
    "$t4$(object 'pid="5" pindex="1"' 'pid="9" p1="0" p2="1" p3="2"' 'pid="7" p1="2"')"
row 'ff0000:70,72 ff0000:30,27' "$t4$(object 'pid="9" pindex="3"' '' '')"
twice='pid="9" p1="0" p2="4" p3="5"'
row '0000ff:51,74 ffff00:73,74 ff0000:51,52' "$t4$(object '' "$twice" "$twice")"
row 'ffff00:51,74 ffff00:73,74 00ff00:52,47' \
    "$(texture 'tilestyleu="clamp" tilestylev="clamp"' /3D/Textures/t4.png)$(object '' \
        "$twice" 'pid="9" p1="0" p2="5" p3="6"')"
row 'ff0000:30,30' "$(texture 'tilestyleu="mirror"' /3D/Textures/t4.png)$(object '' \
    'pid="9" p1="0" p2="1" p3="2"' 'pid="9" p1="0" p2="2" p3="3"')"
told 'is repeated as mirror and wrap: it is shown as wrap both ways'
row '' "$(texture '' /3D/none.png)$(object '' 'pid="9" p1="0" p2="1" p3="2"' '')"
told 'its texture /3D/none.png is left out'
red=$(object 'pid="5" pindex="0"' '' '')
row 'ff0000:73,27 ff0000:51,49 000000:48,52' "$red" \
    '<build><item objectid="1" transform="0.5 0 0 0 0.5 0 0 0 1 0.5 0.5 0"/></build>'
row 'ff0000:30,70 ff0000:70,30 000000:30,30' \
    "$red"'<object id="2"><components><component objectid="1" transform="0.5 0 0 0 0.5 0 0 0 1 0.5 0.5 0"/><component objectid="1" transform="-0.5 0 0 0 0.5 0 0 0 1 -0.5 -0.5 0"/></components></object>' \
    '<build><item objectid="2"/></build>'

refused() { # TEXT MODEL [ATTRIBUTES]
    package "$2" "${3:-}"
    refused_command "a.3mf: $1" info "$work/a.3mf"
}
whole="<resources>$groups$red</resources>$build"
refused 'requires the extension http://x/beams, which pel does not have' "$whole" \
    'xmlns:b="http://x/beams" requiredextensions="b"'
refused 'object 2 is not there' \
    "<resources>$red</resources><build><item objectid='2'/></build>"
refused 'object 2 is a part of itself' "<resources><object id='2'><components><component objectid='2'/></components></object></resources><build><item objectid='2'/></build>"
# chain COUNT COMPONENTS: objects, each in the next one
chain() {
    awk -v n="$1" -v c="$2" 'BEGIN {
        for (i = 2; i <= n; i++) {
            print "<object id=\"" i "\"><components>"
            for (k = 0; k < c; k++)
                print "<component objectid=\"" i - 1 "\"/>"
            print "</components></object>"
        }
    }'
}
refused 'object 1 is one of more than 2^20 that are placed: expected fewer' \
    "<resources>$red$(chain 41 2)</resources><build><item objectid='41'/></build>"
refused 'object 500 is inside of more than 1000 others' \
    "<resources>$red$(chain 1500 1)</resources><build><item objectid='1500'/></build>"
refused 'a triangle of object 1 names a vertex that is out of range' \
    "<resources><object id='1'><mesh>$vertices<triangles><triangle v1='0' v2='1' v3='4'/></triangles></mesh></object></resources>$build"
refused "'red' is no colour" "<resources><basematerials id='1'><base displaycolor='red'/></basematerials></resources>"
refused '3D/a.model, line 1: mismatched tag' '<a></b>'
refused 'a mesh file without triangles' "<resources>$red</resources><build/>"
printf 'PK' >"$work/a.3mf"
refused_command 'a.3mf: is no package of 3MF' info "$work/a.3mf"

[ -e "$work/failed" ] || echo "3MF shows its colours and textures"
