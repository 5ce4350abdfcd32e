# The mutants of one C source in the house style: one line for each,
#
#     FILE <tab> LINE <tab> CHANGE <tab> OLD LINE <tab> NEW LINE
#
# where CHANGE is `OLD -> NEW`, with #K behind it for the K-th such change in the
# line. Awk's variable `active` names a file of the line numbers that some build
# compiles; others are left alone, as are preprocessor lines, assertions and
# declarations without a value.
#
# What is changed: comparisons by one step, operators into their opposites, each
# number up and down by one, pel_min into pel_max, true into false and back; a
# term of a sum, a negation or a whole statement is dropped.

function pair(a, b)
{
    opposite[a] = b
    opposite[b] = a
}

function set_of(words, set,    list, count, i)
{
    count = split(words, list, " ")
    for (i = 1; i <= count; i++)
        set[list[i]] = 1
}

BEGIN {
    FS = "\n"
    while ((getline line < active) > 0)
        is_active[line] = 1
    pair("<", "<="); pair(">", ">="); pair("==", "!=")
    pair("+", "-"); pair("<<", ">>"); pair("++", "--")
    pair("&", "|"); pair("&&", "||")
    pair("+=", "-="); pair("|=", "&="); pair("<<=", ">>=")
    pair("pel_min", "pel_max"); pair("true", "false")
    opposite["*"] = "+"; opposite["/"] = "*"; opposite["%"] = "/"
    opposite["*="] = "+="; opposite["/="] = "*="; opposite["%="] = "/="
    set_of("<<= >>= ...", triple)
    set_of("-> ++ -- << >> <= >= == != && || += -= *= /= %= &= |= ^=", double)
    set_of("; , ) ] + - < > <= >= == != && || : ?", weaker_than_a_sum)
    set_of("return goto break for", jump)
    word = "^[A-Za-z_][A-Za-z_0-9]*"
    number = "^[0-9][0-9A-Fa-fxuUlL]*"
    type = "(const )?(struct|enum|bool|int|char|void|size_t|u?int[0-9]+_t|" \
           "ptrdiff_t|pel_color|pel_word[0-9]*|gradient) "
}

# Blanks comments out, keeping columns.
function code_of(text,    i, out, two)
{
    out = ""
    for (i = 1; i <= length(text); i++) {
        two = substr(text, i, 2)
        if (in_comment && two == "*/") {
            in_comment = 0
            i++
            out = out "  "
        } else if (in_comment || two == "/*") {
            in_comment = 1
            out = out " "
        } else {
            out = out substr(text, i, 1)
        }
    }
    sub(/ +$/, "", out)
    return out
}

function token_length(rest)
{
    if (match(rest, /^ +/) || match(rest, word) || match(rest, number))
        return RLENGTH
    if (substr(rest, 1, 3) in triple)
        return 3
    return substr(rest, 1, 2) in double ? 2 : 1
}

# token[1..n] and their columns at[1..n].
function tokens_of(code,    i, size)
{
    n = 0
    for (i = 1; i <= length(code); i += size) {
        size = token_length(substr(code, i))
        if (substr(code, i, 1) != " ") {
            token[++n] = substr(code, i, size)
            at[n] = i
        }
    }
}

function text_of(i, k)
{
    return substr(code, at[i], at[k] + length(token[k]) - at[i])
}

# Puts `new` in the place of tokens i to k.
function emit(i, k, new, change)
{
    if (++seen[FNR, change] > 1)
        change = change " #" seen[FNR, change]
    print FILENAME "\t" FNR "\t" change "\t" $0 "\t" \
        substr($0, 1, at[i] - 1) new substr($0, at[k] + length(token[k]))
}

function replace(i, new)
{
    emit(i, i, new, token[i] " -> " new)
}

function drop(i, k)
{
    emit(i, k, "", "drop " text_of(i, k))
}

# With blanks on both sides: not a sign, an address or a pointer.
function is_binary(i)
{
    return i > 1 && substr(code, at[i] - 1, 1) == " " &&
           (i == n || substr(code, at[i] + length(token[i]), 1) == " ")
}

# The lowest bit flipped.
function hex_neighbour(text,    last)
{
    match(text, /[0-9A-Fa-f]u?$/)
    last = index("0123456789ABCDEF", toupper(substr(text, RSTART, 1)))
    return substr(text, 1, RSTART - 1) substr("1032547698BADCFE", last, 1) \
        substr(text, RSTART + 1)
}

function mutate_number(i,    suffix)
{
    if (token[i] ~ /^0x/) {
        replace(i, hex_neighbour(token[i]))
        return
    }
    suffix = token[i]
    sub(/^[0-9]+/, "", suffix)
    replace(i, sprintf("%.0f", token[i] + 1) suffix)
    if (token[i] + 0 > 0)
        replace(i, sprintf("%.0f", token[i] - 1) suffix)
}

# A term `+ a->b` or `- 2`, when nothing behind it binds tighter. (One less 1 is
# what mutate_number makes of 1.)
function mutate_term(i,    k)
{
    k = i + 1
    if (k > n || token[k] == "1" || token[k] !~ /^[A-Za-z_0-9]/)
        return
    while (k + 2 <= n && (token[k + 1] == "->" || token[k + 1] == "."))
        k += 2
    if (k < n && token[k + 1] in weaker_than_a_sum)
        drop(i, k)
}

# The size of an array, where it is declared: v[3] behind a type.
function is_size(i)
{
    return i > 3 && token[i - 1] == "[" && token[i + 1] == "]" &&
           token[i - 3] ~ /^(\*|[a-z_0-9]*[a-z0-9])$/ && token[i - 3] != "return"
}

function mutate_token(i)
{
    if (is_size(i))
        return
    if (token[i] ~ number) {
        mutate_number(i)
    } else if (token[i] == "!" || token[i] == "~") {
        drop(i, i)
    } else if (token[i] in opposite) {
        if (token[i] ~ word || token[i] ~ /^(\+\+|--)$/ || is_binary(i))
            replace(i, opposite[token[i]])
        else if (token[i] == "-")
            drop(i, i)
        if (token[i] ~ /^[+-]$/ && is_binary(i))
            mutate_term(i)
    }
}

# A statement of one line that is no declaration and no jump; `last` is the line
# before it.
function is_statement()
{
    return code ~ /^ [^}]*;$/ && !(token[1] in jump) && code !~ ("^ +" type) &&
           last ~ /([;{})]|else|do)$/
}

{
    code = code_of($0)
    if (in_macro || code ~ /^#/) {
        in_macro = code ~ /\\$/
        next
    }
    if (code == "" || !(FNR in is_active))
        next
    if (code !~ /PEL_ASSERT|^typedef/ &&
        code !~ ("^ *(static )?" type "[^=(]*;$") &&
        (code ~ /^ / || code ~ /=/)) {
        tokens_of(code)
        for (i = 1; i <= n; i++)
            mutate_token(i)
        if (is_statement())
            emit(1, n, ";", "drop statement")
    }
    last = code
}
