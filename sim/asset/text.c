#include "sim/asset/text.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "sim/asset/import.h"
#include "sim/cli/message.h"
#include "sim/cli/text_line.h"
#include "sim/icon/icon.h"

static const char made[] = "/* Made by pel import from ";

/* The base name, without what could end a comment. */
static void print_base_name(FILE *out, const char *path)
{
    const char *slash = strrchr(path, '/');
    for (const char *c = slash ? slash + 1 : path; *c; c++)
        fputc(isalnum((unsigned char)*c) || strchr("._-+ ", *c) ? *c : '_',
              out);
}

static void print_origin(FILE *out, const struct import_options *options)
{
    fputs(made, out);
    print_base_name(out, options->source);
    fprintf(out, ". */\n");
}

static void print_declaration(FILE *out, const struct import_text *text)
{
    const char *name = text->options->name;
    fprintf(out, "extern const struct pel_%s_asset %s;\n", text->kind, name);
    if (text->palette)
        fprintf(out, "extern const struct pel_palette %s_palette;\n", name);
    if (text->alpha)
        fprintf(out, "extern const struct pel_image_asset %s_alpha;\n", name);
    if (text->shading)
        fprintf(out, "extern const struct pel_shading *const %s_shading;\n",
                name);
    if (text->mappings)
        fprintf(out,
                "extern const struct pel_mapping *const %s_mapping[%u];\n"
                "extern const uint8_t %s_span[%u];\n",
                name, text->mappings, name, text->mappings);
}

const char *import_name(const char *output, char name[IMPORT_NAME])
{
    const char *slash = strrchr(output, '/');
    const char *base = slash ? slash + 1 : output;
    size_t n = strcspn(base, ".");
    if (strcmp(base, "-") == 0 || n == 0) {
        base = "asset";
        n = 5;
    }
    snprintf(name, IMPORT_NAME, "%s%.*s",
             isdigit((unsigned char)*base) ? "_" : "", (int)n, base);
    for (char *p = name; *p; p++)
        if (!isalnum((unsigned char)*p))
            *p = '_';
    return name;
}

/* Names that the asset's files cannot have: words of C and of C++, macros, and
 * those functions of the C library that an asset may well be named after: it
 * would take their place in all of the program, without a word from the linker.
 */
static bool is_taken(const char *name)
{
    static const char words[] =
        " alignas alignof and and_eq asm auto bitand bitor bool break case "
        "catch char class compl concept const const_cast consteval constexpr "
        "constinit continue co_await co_return co_yield decltype default "
        "delete do double dynamic_cast else enum explicit export extern false "
        "float for friend goto if inline int linux long main mutable namespace "
        "new noexcept not not_eq nullptr NULL operator or or_eq private "
        "protected public register reinterpret_cast requires restrict return "
        "short signed sizeof static static_assert static_cast struct switch "
        "template this thread_local throw true try typedef typeid typename "
        "typeof union unix unsigned using virtual void volatile wchar_t while "
        "xor xor_eq "
        "abort abs accept access acct alarm bind brk ceil chroot clock close "
        "connect cos daemon div dup environ errno exit exp fork floor free "
        "index kill link listen log nice open pause pipe poll pow printf "
        "raise rand random read remove rename rewind rindex round select send "
        "shutdown signal sin sleep socket splice sqrt stat stderr stdin stdout "
        "swab sync system tan tee time times trunc truncate unlink wait write ";
    char padded[IMPORT_NAME + 2];
    snprintf(padded, sizeof padded, " %s ", name);
    return strstr(words, padded) != NULL;
}

bool import_name_check(const char *name)
{
    const size_t n = strspn(name, "abcdefghijklmnopqrstuvwxyz"
                                  "ABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789");
    if (n == 0 || n >= IMPORT_NAME || name[n] || isdigit((unsigned char)*name))
        return message_error("the name '%s' is no identifier of C: expected "
                             "--name such as duck",
                             name);
    return !is_taken(name) ||
           message_error("the name '%s' is one that C or C++ has already: "
                         "expected --name such as duck",
                         name);
}

bool import_text_open(struct import_text *text,
                      const struct import_options *options, const char *kind)
{
    text->options = options;
    text->kind = kind;
    text->format = NULL;
    text->palette = text->alpha = text->shading = false;
    text->mappings = 0;
    text->scratch[0] = 0;
    if (!output_open(&text->output, options->output))
        return false;
    print_origin(text->output.stream, options);
    fprintf(text->output.stream, "#include <pel/pel.h>\n");
    return true;
}

void import_array_begin(struct import_text *text, const char *type,
                        const char *what, uint32_t count, int axes)
{
    FILE *out = text->output.stream;
    fprintf(out, "\nstatic const %s %s_%s[%u]", type, text->options->name, what,
            count);
    if (axes > 1)
        fprintf(out, "[%d]", axes);
    fprintf(out, " = {");
    text->column = 80;
}

void import_item(struct import_text *text, const char *format, ...)
{
    char item[80];
    va_list arguments;
    va_start(arguments, format);
    const int size = vsnprintf(item, sizeof(item), format, arguments);
    va_end(arguments);
    const bool wrap = text->column + 1 + size > 80;
    fprintf(text->output.stream, "%s%s", wrap ? "\n    " : " ", item);
    text->column = wrap ? 4 + size : text->column + 1 + size;
}

void import_array_end(struct import_text *text)
{
    fprintf(text->output.stream, "\n};\n");
}

static long number_at(const struct import_array *array, size_t i)
{
    const char *type = array->type;
    if (strcmp(type, "int8_t") == 0)
        return ((const int8_t *)array->data)[i];
    if (strcmp(type, "uint8_t") == 0)
        return ((const uint8_t *)array->data)[i];
    if (strcmp(type, "int16_t") == 0)
        return ((const int16_t *)array->data)[i];
    if (strcmp(type, "uint16_t") == 0)
        return ((const uint16_t *)array->data)[i];
    return (long)((const uint32_t *)array->data)[i];
}

void import_array(struct import_text *text, const struct import_array *array)
{
    static const char *const formats[] = {"%ld,", "{%ld, %ld},",
                                          "{%ld, %ld, %ld},"};
    const size_t axes = (size_t)array->axes;
    if (!array->data)
        return;
    import_array_begin(text, array->type, array->what, array->count,
                       array->axes);
    for (size_t i = 0; i < array->count * axes; i += axes) {
        long value[3] = {0};
        for (size_t k = 0; k < axes; k++)
            value[k] = number_at(array, i + k);
        import_item(text, formats[axes - 1], value[0], value[1], value[2]);
    }
    import_array_end(text);
}

void import_struct_begin(struct import_text *text)
{
    FILE *out = text->output.stream;
    fputc('\n', out);
    print_declaration(out, text);
    fprintf(out, "const struct pel_%s_asset %s = {\n", text->kind,
            text->options->name);
}

/* True, with a message, for a header that pel import has not made. */
static bool is_foreign(const char *path, const struct import_text *text)
{
    char start[sizeof(made)];
    const bool readable = access(path, R_OK) == 0;
    if (readable ? text_start(path, start, sizeof(start)) == 0 ||
                       strcmp(start, made) == 0
                 : access(path, F_OK) != 0)
        return false;
    message_error_at(path, 0,
                     "was not made by pel import and stays as it is; it "
                     "should say: extern const struct pel_%s_asset %s;",
                     text->kind, text->options->name);
    return true;
}

static void print_scratch(FILE *out, const struct import_text *text)
{
    fprintf(
        out,
        "\n/* Bytes of scratch memory, aligned to 8, for pel_icon at sizes "
        "from %d px to\n * so many, %d at most, and any angle. */\n#define ",
        ICON_SCRATCH_SIZE_MIN, ICON_SCRATCH_SIZE_MAX);
    for (const char *c = text->options->name; *c; c++)
        fputc(toupper((unsigned char)*c), out);
    fprintf(out,
            "_SCRATCH(px) \\\n    PEL_ICON_SCRATCH_SIZE(%d, (px) * %d / 1024 + "
            "4)\n",
            text->scratch[0], text->scratch[1]);
}

/* pel.h, which C++ may include too. */
static void print_header(FILE *out, const struct import_text *text)
{
    const char *name = text->options->name;
    print_origin(out, text->options);
    fprintf(out, "#ifndef PEL_ASSET_%s_H\n#define PEL_ASSET_%s_H\n\n", name,
            name);
    fprintf(out, "#include <pel/pel.h>\n\n");
    if (text->format)
        fprintf(out, "/* Its format: &%s%s. */\n",
                text->palette ? name : "pel_",
                text->palette ? "_palette.format" : text->format);
    print_declaration(out, text);
    if (text->scratch[0])
        print_scratch(out, text);
    fprintf(out, "\n#endif\n");
}

bool import_text_commit(struct import_text *text)
{
    struct output header;
    char *path;
    const char *output = text->options->output;
    const int base = (int)strlen(output) - 1; /* without the c of .c */
    if (strcmp(output, "-") == 0)
        return output_commit(&text->output);
    if (asprintf(&path, "%.*sh", base, output) < 0) {
        output_abandon(&text->output);
        return message_error("out of memory");
    }
    const bool alone = is_foreign(path, text);
    bool done = alone || output_open(&header, path);
    if (done && !alone)
        print_header(header.stream, text);
    if (done)
        done = output_commit_both(&text->output, alone ? NULL : &header);
    else
        output_abandon(&text->output);
    free(path);
    return done;
}
