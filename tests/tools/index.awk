# index.awk HEADER... : docs/index.md, every function, type, macro and object of
# headers in the house style, a line each, with the first sentence of its comment.
# A comment belongs to the declarations below it, up to a blank line; a sentence
# "name: ..." in it is that name's own. A struct without a comment is told by its
# members, an enum by its values.

# The first sentence: up to a full stop before a capital, a blank line, or an
# example, which is indented.
function sentence(text,    i)
{
    sub(/^[ :]+/, "", text)
    sub(/[ .:]*\001.*/, "", text)
    for (i = 1; i < length(text); i++)
        if (substr(text, i) ~ /^[.:] +([A-Z]|pel_|PEL_)/)
            break
    text = substr(text, 1, i)
    sub(/[.:; ]*$/, "", text)
    return text
}

# What `comment` says of a name; nothing where it is of other names.
function said(name,    i, n, part)
{
    n = split(comment, part, /[.;] /)
    for (i = 1; i <= n; i++)
        if (index(part[i], name ": ") == 1)
            return sentence(substr(part[i], length(name) + 2))
    return comment ~ /^(pel|PEL)_[A-Za-z_0-9]*: / ? "" : sentence(comment)
}

# The same, or else the value of a constant, if that is short.
function said_or(name, value,    text)
{
    text = said(name)
    return text == "" && value != "" && length(value) < 30 ? value : text
}

# The value of an enumerator in the text of an enum.
function value_of(name, text)
{
    if (!match(text, name " = [^,}]*"))
        return ""
    text = substr(text, RSTART + length(name " = "), RLENGTH - length(name " = "))
    sub(/ +$/, "", text)
    return text
}

function escaped(text)
{
    gsub(/[|*<]/, "\\\\&", text)
    return text
}

# A row: a kind before the name, parameters behind it.
function add(kind, name, more, about_it)
{
    if (name in seen || name ~ /_H$/)
        return
    seen[name]
    if (headed != FILENAME)
        printf "\n## [%s](../%s)\n\n%s.\n\n| | |\n|---|---|\n", FILENAME,
            FILENAME, escaped(sentence(head))
    headed = FILENAME
    printf "| `%s%s%s` | %s |\n", kind, name, more, escaped(about_it)
}

# The last words of a list's parts.
function names(list, separator,    i, n, at, part, all)
{
    while (match(list, /\( ?\*[a-z_ *]+\)[^(;,]*\([^)]*\)/)) { # of functions
        at = substr(list, RSTART + 1, RLENGTH)
        sub(/\).*/, "", at)
        list = substr(list, 1, RSTART - 1) at substr(list, RSTART + RLENGTH)
    }
    gsub(/ = [^,]*|\[[^\]]*\]|[()*]/, " ", list)
    n = split(list, part, separator)
    for (i = 1; i <= n; i++) {
        sub(/ +$/, "", part[i])
        sub(/.* /, "", part[i])
        if (part[i] != "")
            all = all (all == "" ? "" : ", ") part[i]
    }
    return all
}

# A declaration that is complete, without comments.
function declare(text,    name, list, word, i, n)
{
    gsub(/__attribute__ *\(\([^)]*\)\)/, "", text)
    gsub(/  +/, " ", text)
    if (text ~ /^(struct|enum|union) [a-z_0-9]+;/ || text ~ /_FILE$/)
        return
    if (text ~ /^(struct|enum|union) ([a-z_0-9]+ )?\{/) {
        n = split(text, word, " ")
        list = text
        sub(/^[^{]*\{/, "", list)
        sub(/\}[^}]*$/, "", list)
        list = names(list, word[1] == "enum" ? "," : "[,;]")
        if (word[2] != "{") {
            name = said(word[2])
            add(word[1] " ", word[2], "", name == "" ? list : name)
            return
        }
        n = split(list, word, ", ")
        for (i = 1; i <= n; i++)
            add("", word[i], "", said_or(word[i], value_of(word[i], text)))
        return
    }
    if (text ~ /^typedef char .*\[/)
        return # what holds at compile time
    if (text ~ /^typedef/ && text !~ /\(/) {
        name = names(text, ";")
        add("", name, "", said(name))
        return
    }
    if (text !~ /\(/ || text ~ /^extern/) {
        name = names(text, "[;=]")
        sub(/,.*/, "", name)
        add("", name, "", said(name))
        return
    }
    match(text, /[a-zA-Z_0-9]+\(/)
    name = substr(text, RSTART, RLENGTH - 1)
    list = substr(text, RSTART + RLENGTH)
    sub(/\)[^)]*$/, "", list)
    list = names(list, ",")
    add("", name, "(" (list == "void" ? "" : list) ")", said(name))
}

FNR == 1 { comment = head = text = ""; inside = body = long = 0 }

body { body = !/^}/; next }
/^{$/ { body = 1; declare(text); text = ""; next }

!inside && text == "" && /^\/\*/ { inside = 1; comment = "" }
inside {
    inside = !/\*\//
    line = $0
    sub(/^(\/\*| \*) ?/, "", line)
    sub(/ *\*\/.*/, "", line)
    if (line ~ /^ *$|^   /)
        line = "\001"
    comment = comment (comment == "" ? "" : " ") line
    if (!inside && head == "")
        head = comment
    next
}

/^$/ && text == "" { comment = ""; next }
/^#define [A-Za-z_0-9]+/ && !long {
    name = $2
    sub(/\(.*/, "", name)
    list = $0
    list = sub(/^#define [A-Za-z_0-9]+\(/, "", list) ? \
        "(" substr(list, 1, index(list, ")")) : ""
    value = $0
    sub(/^#define [A-Za-z_0-9]+ ?/, "", value)
    add("", name, list, said_or(name, list == "" && value ~ /^[^\\\/]+$/ ? \
        value : ""))
}
/^ *#/ || long { long = /\\$/; next }
/^PEL_(BEGIN|END)_DECLS/ { next }

text != "" || /^[A-Za-z_]/ {
    line = $0
    sub(/^ +/, " ", line)
    text = text line
    while (match(text, /\/\*/) && index(substr(text, RSTART), "*/"))
        text = substr(text, 1, RSTART - 1) substr(text, RSTART + \
            index(substr(text, RSTART), "*/") + 1)
    if (text ~ /; *$/ && text !~ /\/\*/ &&
        gsub(/{/, "{", text) == gsub(/}/, "}", text)) {
        declare(text)
        text = ""
    }
}
