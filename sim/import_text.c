#include "import_text.h"

#include <ctype.h>
#include <string.h>

/* The base name, without what could end a comment. */
static void print_base_name(FILE *out, const char *path)
{
    const char *slash = strrchr(path, '/');
    for (const char *c = slash ? slash + 1 : path; *c; c++)
        fputc(isalnum((unsigned char)*c) || strchr("._-+ ", *c) ? *c : '_',
              out);
}

bool import_text_open(struct import_text *text, const char *path,
                      const char *source, const char *header)
{
    if (!output_open(&text->output, path))
        return false;
    FILE *out = text->output.stream;
    fprintf(out, "/* Made by pel import from ");
    print_base_name(out, source);
    fprintf(out, ". */\n#include \"%s\"\n", header);
    return true;
}

void import_array_begin(struct import_text *text, const char *name,
                        const struct import_array *array)
{
    FILE *out = text->output.stream;
    fprintf(out, "\nstatic const %s %s_%s[%u]", array->type, name, array->what,
            array->count);
    if (array->axes > 1)
        fprintf(out, "[%d]", array->axes);
    fprintf(out, " = {");
    text->column = 80;
}

void import_array_item(struct import_text *text, const long *value, int n)
{
    char item[80];
    int size = snprintf(item, sizeof(item), n > 1 ? "{%ld" : "%ld", value[0]);
    for (int i = 1; i < n; i++)
        size += snprintf(item + size, sizeof(item) - (size_t)size, ", %ld",
                         value[i]);
    size +=
        snprintf(item + size, sizeof(item) - (size_t)size, n > 1 ? "}," : ",");
    bool wrap = text->column + 1 + size > 80;
    fprintf(text->output.stream, "%s%s", wrap ? "\n    " : " ", item);
    text->column = wrap ? 4 + size : text->column + 1 + size;
}

void import_array_end(struct import_text *text)
{
    fprintf(text->output.stream, "\n};\n");
}
