#!/bin/sh
# Every model of assimp-testmodels is as models.tsv says: right, with its counts,
# when its picture was looked at; or refused, with the reason. ACCEPT=1 writes
# the list anew: look at what changed, and at its picture.
set -u
. "$(dirname "$0")/lib.sh"
models=${PEL_MODELS:-/usr/share/assimp/models}
list=tests/sim/models.tsv
tab=$(printf '\t')
[ -r "$models/Collada/duck.dae" ] ||
    fail "$models is missing: the package assimp-testmodels brings it"
"$PEL" info tests/sim/field/ind.obj 2>&1 | grep -q 'without assimp' && exit 0
"$PEL" info tests/sim/field/pct.gltf 2>&1 | grep -q 'without jansson' && exit 0

# What stands beside the meshes.
beside='png|jpg|bmp|tga|txt|mtl|bin|md|glsl|uc|dds|max|html?|xml|skeleton'
beside="$beside|material|vert|frag|pcx|tif|gif|lxo|sbsar|svg|psd"
top=$PWD
case $PEL in
/*) pel=$PEL ;;
*) pel=$top/$PEL ;;
esac
cd "$models" || exit 1
find . -type f | sed 's,^\./,,' | grep -viE "\.($beside)\$" |
    grep -viE 'ReferenceImages|SourceFiles|/LICENSE|README|ATTRIB' |
    LC_ALL=C sort | while read -r file; do
    if "$pel" info "$file" >"$work/out" 2>"$work/err" </dev/null; then
        printf '%s\tright\t%s\n' "$file" \
            "$(sed -n '1s/, normals.*//p' "$work/out")"
    else
        # Of many lines the last, without the file's name.
        line=$(tail -n 1 "$work/err")
        line=${line#pel: }
        line=${line#"$file"}
        printf '%s\trefused\t%s\n' "$file" \
            "$(printf %s "$line" | sed 's/^\(:[0-9]*\)*: //' | cut -c1-90)"
    fi
done >"$work/models.tsv"
cd "$top" || exit 1
if [ -n "${ACCEPT:-}" ]; then
    diff $list "$work/models.tsv"
    cp "$work/models.tsv" $list
fi
cut -f 1-3 $list | diff - "$work/models.tsv" >"$work/diff" ||
    fail "models are not as $list has them:
$(cat "$work/diff")"
[ -e "$work/failed" ] ||
    echo "models: $(grep -c "${tab}right$tab" $list) right, $(grep -c "${tab}refused$tab" $list) refused"
