# amalgamate.awk : core in one source and one header.
#
#     awk -f amalgamate.awk -v header=1 >pel.h
#     awk -f amalgamate.awk core/*/*.c >pel.c
#
# pel.h is core/pel.h with all that it includes. pel.c is the files one after
# the other, each with the private headers that it is the first to need and with
# its .inc files in place. What a file defines for itself gets its name: `fill`
# of disc.c becomes fill_in_disc. The folders of OPTIONAL come last, and each is
# left out where PEL_WITH_FOLDER is 0.
#
# A small program is to link no more of it than of separate files. So on CPUs of
# 32 bits no function becomes a part of one of another file. And where a compiler
# optimises for size, functions of headers are inlined: of those that a file calls
# once it would do so itself, but here it sees the calls of all files. Those that
# a file calls more than once are PEL_SHARED in their headers, and shared here.

BEGIN {
    OPTIONAL = "^(hit|image|outline|paint|path|scene|smooth)$"
    expand("core/pel.h", 0)
    if (header) {
        print "#ifndef PEL_INLINE\n#define PEL_INLINE inline\n#endif"
        printf "%s", text
        exit
    }
    for (optional = 0; optional < 2; optional++)
        for (i = 1; i < ARGC; i++)
            if ((folder_of(ARGV[i]) ~ OPTIONAL) == optional)
                read(++files, ARGV[i])
    print "/* Pel in one file: see pel.h. Written by make amalgamation. */"
    print "#ifdef __OPTIMIZE_SIZE__\n#define PEL_INLINE PEL_ALWAYS_INLINE\n#endif"
    print "#include \"pel.h\"\n"
    print "#define PEL_ONE_APART"
    print "#if !PEL_64BIT && defined(__has_attribute)"
    print "#if __has_attribute(__noipa__)\n#undef PEL_ONE_APART"
    print "#define PEL_ONE_APART __attribute__((__noipa__))\n#endif\n#endif"
    print "\n/* Functions that no caller is left of are no mistake here. */"
    print "#ifdef __clang__"
    print "#pragma clang diagnostic ignored \"-Wunused-function\"\n#endif\n"
    print "/* 0 leaves a part of Pel out; linkers leave out what is not named. */"
    n = split(OPTIONAL, folders, /[^a-z]+/)
    for (i = 2; i < n; i++)
        printf "#ifndef %s\n#define %s 1\n#endif\n", with(folders[i]),
            with(folders[i])
    print "#if !PEL_WITH_PAINT && (PEL_WITH_SCENE || PEL_FAST_FILLS)"
    print "#error \"PEL_WITH_PAINT 0 wants PEL_WITH_SCENE and PEL_FAST_FILLS 0\""
    print "#endif"
    for (i = 1; i <= files; i++)
        write(i, path_of[i])
    exit
}

function folder_of(path,    part) { split(path, part, "/"); return part[2] }
function with(folder) { return "PEL_WITH_" toupper(folder) }

function dirname(path) { sub(/\/[^\/]*$/, "", path); return path }

# Adds a file to `text`, with what it includes from core in place; headers once.
# What is included inside an #if may be needed again outside: it is written each
# time, and guards itself. `again`: this is such a header. Lines of headers that
# go to pel.c are marked: they keep their names.
function expand(path, again,    line, depth, name)
{
    while (sub(/[^\/.]+\/\.\.\//, "", path))
        ;
    if (path in seen)
        return
    if (path ~ /\.h$/ && !again)
        seen[path]
    depth = path ~ /\.h$/ ? -1 : 0 # the guard of a header does not count
    while ((getline line < path) > 0) {
        if (line ~ /^#if/)
            depth++
        if (line ~ /^#endif/)
            depth--
        if (line ~ /^#define/ && path !~ /\.h$/) {
            split(line, word, /[ (]/)
            macros = macros "#undef " word[2] "\n"
        }
        if (path ~ /\.h$/)
            sub(/^static inline /, "static PEL_INLINE ", line)
        if (line ~ /^#include "/) {
            split(line, word, "\"")
            name = word[2]
            expand(dirname(path) "/" name, again || depth > 0)
        } else
            text = text (path ~ /\.h$/ && !header ? "\001" : "") line "\n"
    }
    close(path)
}

function read(i, path)
{
    text = ""
    macros = ""
    expand(path, folder_of(path) ~ OPTIONAL)
    path_of[i] = path
    body[i] = text
    undefine[i] = macros
    collect(i)
}

# The names that file i defines for itself. A tag has "struct " before it.
function collect(i,    line, n, k, inside, name)
{
    n = split(body[i], line, "\n")
    for (k = 1; k <= n; k++) {
        name = line[k]
        if (name ~ /^static / && name !~ /[(=;[]/)
            name = "static " line[k + 1]
        if (name ~ /^static /) {
            sub(/[(=;[].*/, "", name)
            sub(/ *$/, "", name)
            sub(/.*[ *]/, "", name)
            own[i, name]
        } else if (name ~ /^(struct|enum|union) [a-z_0-9]+ \{/) {
            split(name, word, " ")
            own[i, "struct " word[2]]
        } else if (name ~ /^(typedef .*|\})[ *]+[a-z_0-9]+;$/) {
            sub(/;$/, "", name)
            sub(/.*[ *]/, "", name)
            own[i, name]
        }
        if (line[k] ~ /^enum .*\{/)
            inside = 1
        if (inside) {
            name = line[k]
            sub(/.*\{/, "", name)
            while (match(name, /[A-Z][A-Z_0-9]*/)) {
                own[i, substr(name, RSTART, RLENGTH)]
                name = substr(name, RSTART + RLENGTH)
                sub(/^[^,]*/, "", name)
            }
        }
        if (line[k] ~ /\}/)
            inside = 0
    }
}

# Code with the names of file i renamed, but for members.
function renamed(i, stem, code,    out, name, before, kind, tag)
{
    while (match(code, /[A-Za-z_][A-Za-z_0-9]*/)) {
        name = substr(code, RSTART, RLENGTH)
        before = substr(code, 1, RSTART - 1)
        out = out before name
        code = substr(code, RSTART + RLENGTH)
        tag = before == " " ? kind : ""
        if (((i, tag name) in own) && before !~ /(\.|->)$/ && name !~ /^(pel|PEL)_/)
            out = out "_in_" stem
        kind = name ~ /^(struct|enum|union)$/ ? "struct " : ""
    }
    return out code
}

# Does a function begin in line k that other files call?
function is_public(line, k)
{
    if (line[k] !~ /^[A-Za-z].*[ *]pel_[a-z_0-9]*\(/ || line[k] ~ /^(static|typedef) /)
        return 0
    while (line[k] !~ /[;{]$/)
        k++
    return line[k] ~ /\{$/
}

function write(i, path,    folder, stem, n, k, line, comment, rest, at, part)
{
    folder = folder_of(path)
    stem = path
    sub(/.*\//, "", stem)
    sub(/\.c$/, "", stem)
    print "\n/* " path " */"
    if (folder ~ OPTIONAL)
        print "#if " with(folder)
    n = split(body[i], line, "\n")
    for (k = 1; k < n; k++) {
        rest = line[k]
        if (sub(/^\001/, "", rest)) {
            print rest
            continue
        }
        if (is_public(line, k))
            rest = "PEL_ONE_APART " rest
        while ((at = index(rest, comment ? "*/" : "/*")) > 0) {
            part = substr(rest, 1, at + 1)
            printf "%s", comment ? part : renamed(i, stem, part)
            rest = substr(rest, at + 2)
            comment = !comment
        }
        print comment ? rest : renamed(i, stem, rest)
    }
    printf "%s", undefine[i]
    if (folder ~ OPTIONAL)
        print "#endif"
}
