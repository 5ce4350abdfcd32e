#!/bin/sh
# damage_mcu.sh TSV : what bench/mcu/run.sh counted, as the atlas's case
# damage-mcu: instructions per triangle by the edge of its box, px.
awk -F '\t' '
    BEGIN { print "case,method,x,y,metric,value,low,high,unit,command" }
    NR > 1 {
        gsub(/_/, " ", $2)
        cpu = $1 == "cortex-m0plus" ? "m0" : "m4"
        print "damage-mcu," $2 "," $3 ",,instructions_" cpu "," $4 \
            ",,,instructions,make damage-mcu"
    }' "$1"
