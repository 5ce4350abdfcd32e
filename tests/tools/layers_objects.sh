#!/bin/sh
# layers_objects.sh SIZE NM OBJECT... : the objects of core, looked at with these
# two programs. They hold no data that can change, and need nothing but memcpy,
# memset and the compiler's helpers for integers, and all that others see of them
# begins with pel_.
set -eu
size=$1
nm=$2
shift 2
status=0

$size "$@" | awk '
    NR > 1 && ($2 > 0 || $3 > 0) {
        print $NF ": data " $2 ", bss " $3 ": core has no state" > "/dev/stderr"
        failed = 1
    }
    END { exit failed }' || status=1

# nm -A: "FILE:ADDRESS TYPE NAME", the address blank for what is undefined.
$nm -A "$@" | awk '
    BEGIN {
        helpers = "^(memcpy|memset" \
            "|__aeabi_(u?idiv|u?idivmod|u?ldivmod|lmul|llsl|llsr|lasr" \
            "|lcmp|ulcmp|memcpy[48]?|memset[48]?|memclr[48]?)" \
            "|__gnu_thumb1_case_[us][qh]i|__gnu_thumb1_case_si" \
            "|__(u?div|u?mod|u?divmod|mul|ashl|ashr|lshr)[dt]i[34]" \
            "|__(clz|ctz|popcount)[sd]i2)$"
    }
    $(NF - 1) == "U" { file = $1; sub(/:.*/, "", file); user[$NF] = file; next }
    { defined[$NF] = 1 }
    $(NF - 1) ~ /^[A-TV-Z]$/ && $NF !~ /^pel_/ {
        print $1 " " $NF ": what is seen outside begins with pel_" > "/dev/stderr"
        failed = 1
    }
    END {
        for (name in user)
            if (!(name in defined) && name !~ helpers) {
                print user[name] ": needs " name > "/dev/stderr"
                failed = 1
            }
        exit failed
    }' || status=1
exit $status
