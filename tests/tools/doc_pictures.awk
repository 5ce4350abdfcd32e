# doc_pictures.awk -v folder=DIR FILE... : the C blocks of pages that have a line
# `<!-- picture: NAME WIDTH HEIGHT [FORMAT] -->` before them, each as DIR/NAME.c, a
# program that draws the picture in bands of 8 lines and writes it as PPM. Prints
# the names. A C block without that line, or without a `draw`, is an error.
function fail(what)
{
    print FILENAME ":" FNR ": " what > "/dev/stderr"
    failed = 1
}

/^<!-- picture: / {
    name = $3
    width = $4
    height = $5
    format = $6 == "-->" ? "xrgb8888" : $6
    next
}

/^```c$/ {
    if (!name)
        fail("a block of C without a picture")
    out = folder "/" name ".c"
    print name
    print "#include <pel/pel.h>" > out
    printf "#line %d \"%s\"\n", FNR + 1, FILENAME > out
    code = 1
    next
}

/^```$/ && code {
    print "#define WIDTH " width > out
    print "#define HEIGHT " height > out
    print "#define FORMAT pel_" format > out
    print "#include \"tests/tools/doc_picture.h\"" > out
    close(out)
    code = 0
    name = ""
    next
}

code { print > out }

END { exit failed }
