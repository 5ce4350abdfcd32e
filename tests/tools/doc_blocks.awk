# doc_blocks.awk -v folder=DIR FILE... : the blocks of C of pages, each by the line
# before it:
#     <!-- picture: NAME WIDTH HEIGHT [FORMAT] -->
#         a `draw`: DIR/NAME.c, a program that draws the picture in bands of 8 lines
#         and writes it as PPM
#     <!-- program: NAME -->    a whole one: DIR/NAME.c
#     <!-- part: NAME -->       of tests/docs/NAME.c, which includes it: DIR/NAME.inc
# Prints the kind and the name of each. C without such a line is an error, and so is
# C that is not fenced as C.
function fail(what)
{
    print FILENAME ":" FNR ": " what > "/dev/stderr"
    failed = 1
}

FNR == 1 { kind = ""; code = fence = 0 }

/^<!-- (picture|program|part): / {
    kind = substr($2, 1, length($2) - 1)
    name = $3
    width = $4
    height = $5
    format = $6 == "-->" ? "xrgb8888" : $6
    next
}

/^```c$/ && !fence {
    if (!kind)
        fail("a block of C that nothing compiles")
    out = folder "/" (kind ? name : "none") (kind == "part" ? ".inc" : ".c")
    print kind, name
    printf "" > out
    if (kind == "picture")
        print "#include <pel/pel.h>" > out
    printf "#line %d \"%s\"\n", FNR + 1, FILENAME > out
    code = 1
    next
}

/^```$/ && code {
    if (kind == "picture") {
        print "#define WIDTH " width > out
        print "#define HEIGHT " height > out
        print "#define FORMAT pel_" format > out
        print "#include \"tests/tools/doc_picture.h\"" > out
    }
    close(out)
    code = 0
    kind = ""
    next
}

code { print > out; next }

/^(```|~~~)/ { fence = !fence; next }

# What ends as C does, or begins so.
(fence || /^(    |\t)/) && (/[;{}]$/ || /^[ \t]*(#include|\/\*)/) {
    fail("C that is not fenced as C, so that nothing compiles it")
}

END { exit failed }
