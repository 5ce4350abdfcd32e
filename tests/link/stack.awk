# Stack in bytes, from machine code.
#
# Input: `objdump -d --no-show-raw-insn` of an object; the answer is the largest
# frame. Or, of a linked program, `objdump -s` (its words), the linker's map and
# then the disassembly; the answer is the deepest path from main and main's own
# frame. With -v frames=PREFIX the frame of each function whose name begins so.
# -v formats="NAME ..." names the objects of core/format, -v
# pointers=FILE is pointers.txt.
#
# A call through a pointer may reach the functions that pointers.txt gives the
# caller, or its object, of those whose address stands in the program. An object that
# has no line there may reach any of them; a paint, or what it calls, any format.

function fail(what)
{
    print "stack: " what > "/dev/stderr"
    failed = 1
    exit 1
}

# The address of a function as a pointer has it: bit 0 set.
function pointer(address,    digits, last)
{
    digits = "0123456789abcdef"
    last = index(digits, substr(address, 8))
    return substr(address, 1, 7) substr(digits, last + 1, 1)
}

# The functions that pointers may reach, as a regular expression, by object.
function read_pointers(    line, names, n, i, targets)
{
    while ((getline line < pointers) > 0) {
        if (line !~ /^[^#]*:/)
            continue
        targets = substr(line, index(line, ":") + 1)
        gsub(/^ +| +$/, "", targets)
        gsub(/\*/, ".*", targets)
        gsub(/ +/, "|", targets)
        n = split(substr(line, 1, index(line, ":") - 1), names, " ")
        for (i = 1; i <= n; i++)
            reach[names[i]] = "^(" targets ")@"
    }
}

BEGIN {
    if (pointers != "")
        read_pointers()
}

# ---- words of the program: " 0123 aabbccdd ...", bytes in memory order
/^Contents of section/ { words = $4 == ".text:" || $4 == ".data:"; next }
words && /^ [0-9a-f]+ [0-9a-f]/ {
    for (i = 2; i <= 5 && length($i) == 8; i++)
        is_word[substr($i, 7, 2) substr($i, 5, 2) substr($i, 3, 2) \
                substr($i, 1, 2)] = 1
    next
}

# ---- map: ".text.name  0x00000123  0x45 path/libpel.a(name.o)", in one line or
# in two
/^ \.[^ ]+/ { section = $1 }
section ~ /^\.text/ && /^ .* 0x[0-9a-f]+ +0x[0-9a-f]+ .*\.o\)?$/ {
    object = $NF
    sub(/\.o\)?$/, "", object)
    sub(/.*[\/(]/, "", object)
    address = $(NF - 2)
    object_at[substr(address, length(address) - 7)] = object
    next
}

# ---- code
/^[0-9a-f]+ <.*>:$/ {
    code = $2
    gsub(/[<>:]/, "", code)
    code = code "@" $1 # two objects may have a static of one name
    address_of[code] = $1
    at[$1] = code
    frame[code] += 0
    popped = ""
    next
}
/^ *[0-9a-f]+:\t\.word/ && code != "" {
    word[substr($1, 1, length($1) - 1)] = $3
    next
}
/^ *[0-9a-f]+:\t/ && code != "" {
    if ($2 ~ /^(push|stmdb)/) {
        list = $0
        sub(/.*\{/, "", list)
        sub(/\}.*/, "", list)
        frame[code] += 4 * split(list, registers, ",")
    } else if ($2 ~ /^str/ && /\[sp, #-[0-9]+\]!/) {
        list = $0
        sub(/.*\[sp, #-/, "", list)
        frame[code] += list + 0
    } else if ($2 ~ /^sub/ && $3 == "sp," && ($4 == "sp," ? $5 : $4) ~ /^#/) {
        frame[code] += substr($4 == "sp," ? $5 : $4, 2)
    } else if ($2 ~ /^add/ && $3 == "sp," && literal[$NF "@" code] != "") {
        large[code] = literal[$NF "@" code] # negative, in a pool below
    } else if ($2 ~ /^(sub|add)/ && $3 == "sp," && $NF ~ /^r[0-9]/ &&
               !(code in large)) {
        fail(code ": a frame whose size stands in a register")
    } else if ($2 ~ /^bl?(\.[nw])?$/ && $NF ~ /^<[^+]*>$/) {
        sub(/^0+/, "", $3)
        calls[code] = calls[code] " " $3
    } else if ($2 == "blx" || ($2 == "bx" && $3 != "lr" && $3 != popped)) {
        calls[code] = calls[code] " pointer"
    }
    # What a register has from the pool of literals, until it is written again.
    if ($3 ~ /^r[0-9]+,$/) {
        register = substr($3, 1, length($3) - 1) "@" code
        literal[register] = ""
        if ($2 ~ /^ldr/ && $4 ~ /^\[pc/ && match($0, /\([0-9a-f]+ </))
            literal[register] = substr($0, RSTART + 1, RLENGTH - 3)
    }
    # The return address of a function that gives back more than its frame.
    if ($2 == "pop" && $3 ~ /^\{r[0-7]\}$/)
        popped = substr($3, 2, 2)
    if (frame[code] > largest)
        largest = frame[code]
    next
}

function callee_of(address)
{
    return at[substr("00000000", 1, 8 - length(address)) address]
}

function is_format(code) { return index(" " formats " ", \
                                        " " object_at[address_of[code]] " ") }

# Marks what a paint's fill function calls directly as part of the paint.
function mark_paint(code,    list, n, i)
{
    if (code in in_paint)
        return
    in_paint[code] = 1
    n = split(calls[code], list, " ")
    for (i = 1; i <= n; i++)
        if (list[i] != "pointer")
            mark_paint(callee_of(list[i]))
}

function may_reach(caller, code,    who, name)
{
    who = object_at[address_of[caller]]
    name = caller
    sub(/[.@].*/, "", name)
    if ((who "/" name) in reach)
        who = who "/" name
    if (who in reach)
        return code ~ reach[who] ||
            object_at[address_of[code]] "/" code ~ reach[who]
    return is_format(code) || !(caller in in_paint)
}

function pointer_depth(caller,    code, d, deepest)
{
    for (code in taken)
        if (may_reach(caller, code))
            if ((d = depth(code)) > deepest)
                deepest = d
    return deepest + 0
}

function depth(code,    list, n, i, d, deepest)
{
    if (code in done)
        return done[code]
    if (code in open)
        fail("recursion at " code)
    open[code] = 1
    n = split(calls[code], list, " ")
    for (i = 1; i <= n; i++) {
        if (list[i] == "pointer")
            d = pointer_depth(code)
        else if (callee_of(list[i]) == code)
            continue # a loop
        else
            d = depth(callee_of(list[i]))
        if (d > deepest)
            deepest = d
    }
    delete open[code]
    return done[code] = frame[code] + deepest
}

# What 0xfffffd14 takes of the stack: 748.
function minus(hexadecimal,    value, i)
{
    for (i = 3; i <= length(hexadecimal); i++)
        value = 16 * value + index("0123456789abcdef", \
                                   substr(hexadecimal, i, 1)) - 1
    return 4294967296 - value
}

END {
    if (failed)
        exit 1
    for (code in large) {
        if (word[large[code]] !~ /^0xffff/)
            fail(code ": a frame whose size is not in its pool")
        frame[code] += minus(word[large[code]])
        if (frame[code] > largest)
            largest = frame[code]
    }
    if (frames != "") {
        for (code in frame)
            if (index(code, frames) == 1)
                print substr(code, 1, index(code, "@") - 1), frame[code]
        exit
    }
    if (formats == "") {
        print largest + 0
        exit
    }
    for (code in frame)
        if (pointer(address_of[code]) in is_word)
            taken[code] = 1
    for (code in taken)
        if (!is_format(code))
            mark_paint(code)
    for (code in frame)
        if (code ~ /^main@/)
            print depth(code), frame[code]
}
