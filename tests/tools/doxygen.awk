# doxygen.awk HEADER : the header with its comments as doxygen's. The first one is
# the file's; one at the left margin or above a member is of what stands below it,
# up to a blank line; one behind a member is of that member. Comments in bodies
# stay as they are.

# Text as it stands, where doxygen would read commands, tags and links.
function escaped(text)
{
    gsub(/[\\@<>&#%"$]/, "\\\\&", text)
    gsub(/::/, "\\::", text)
    return text
}

# A line of a comment; examples, which are indented, stand as they are.
function put(line, end)
{
    if ((line ~ /^    /) != 0 + example) {
        example = !example
        print example ? "@verbatim" : "@endverbatim"
    }
    print example ? line : escaped(line)
    if (end && example)
        print "@endverbatim"
    if (end) {
        example = 0
        print "*/"
    }
}

# What compilers are told not to take is nothing to read about.
held != "" && /^ *#error/ { held = ""; dropped = 1; next }
held != "" && !going { print held; held = "" }
/^#if / || going {
    held = held (held == "" ? "" : "\n") $0
    going = /\\$/
    next
}
dropped && /^#endif/ { dropped = 0; next }

body { body = !/^}/; print; next }
/^{$/ { body = 1; print; next }

# The file's comment, and comments on lines of their own.
!inside && /^ *\/\*/ {
    inside = 1
    margin = match($0, /\/\*/)
    print (FNR != 1 ? "/**" : \
        FILENAME ~ /core\/pel.h$/ ? "/** @mainpage Pel" : "/** @file")
    line = substr($0, margin + 3)
    if (sub(/ *\*\/$/, "", line)) {
        put(line, 1)
        inside = 0
    } else {
        put(line, 0)
    }
    next
}
inside == 1 {
    line = substr($0, margin + 3)
    if (sub(/ *\*\/ *$/, "", line) || /\*\/ *$/) {
        put(/^ *\*\/$/ ? "" : line, 1)
        inside = 0
    } else {
        put(line, 0)
    }
    next
}

# Behind a member or a value: up to the end of the comment.
!inside && /[;,({a-zA-Z_0-9}] *\/\*/ && !/^#/ {
    at = index($0, "/*")
    printf "%s/**<", substr($0, 1, at - 1)
    $0 = substr($0, at + 2)
    inside = 2
}
inside == 2 {
    at = index($0, "*/")
    if (at) {
        print escaped(substr($0, 1, at - 1)) substr($0, at)
        inside = 0
    } else {
        print escaped($0)
    }
    next
}

{ print }
