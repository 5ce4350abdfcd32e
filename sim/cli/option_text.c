#include "sim/cli/option_text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sim/image/format_names.h"
#include "sim/cli/message.h"
#include "sim/cli/number.h"

/* strtod also takes blanks before a number, hexadecimal ones, and words. */
bool option_numbers_read(const char *text, const struct option_numbers *o,
                         double *value)
{
    for (int i = 0; i < o->n; i++) {
        char *end;
        const size_t length = strspn(text, "+-.0123456789eE");
        value[i] = strtod(text, &end);
        if (end == text || end > text + length ||
            !(value[i] >= o->low && value[i] <= o->high) ||
            *end != (i < o->n - 1 ? o->separator : '\0'))
            return false;
        text = end + 1;
    }
    return true;
}

bool option_numbers(const char *option, const char *text,
                    const struct option_numbers *numbers, double *value)
{
    return option_numbers_read(text, numbers, value) ||
           message_error("%s is '%s'; %s would be right", option, text,
                         numbers->right);
}

bool option_integer(const char *option, const char *text, int min, int max,
                    int *value)
{
    int64_t v = 0;
    const bool right = number_integer(text, min, max, &v) == NUMBER_OK;
    *value = (int)v;
    return right || message_error("%s is '%s'; a whole number from %d to %d "
                                  "would be right",
                                  option, text, min, max);
}

bool option_format(const char *text, const struct pel_format **format)
{
    *format = format_find(text);
    return *format ||
           message_error("--format is '%s'; one of %s would be right", text,
                         format_list());
}

/* "a, b or c" */
static void list_names(const char *const *names, char *text, size_t size)
{
    size_t length = 0;
    for (int i = 0; names[i] && length < size; i++)
        length += (size_t)snprintf(text + length, size - length, "%s%s",
                                   i == 0         ? ""
                                   : names[i + 1] ? ", "
                                                  : " or ",
                                   names[i]);
}

bool option_choice(const char *option, const char *text,
                   const char *const *names, int *choice)
{
    char list[256];
    for (int i = 0; names[i]; i++) {
        if (strcmp(names[i], text) == 0) {
            *choice = i;
            return true;
        }
    }
    list_names(names, list, sizeof(list));
    return message_error("%s is '%s'; %s would be right", option, text, list);
}

bool option_color(const char *option, const char *text, unsigned *color)
{
    const char *digits = text + (*text == '#');
    if (strlen(digits) != 6 ||
        digits[strspn(digits, "0123456789abcdefABCDEF")] != '\0')
        return message_error("%s is '%s'; #rrggbb, such as #ffffff, would be "
                             "right",
                             option, text);
    *color = 0xFF000000u | (unsigned)strtoul(digits, NULL, 16);
    return true;
}

bool options_has(const struct options_given *given, const char *name)
{
    for (int i = 0; i < given->count; i++)
        if (strcmp(given->names[i], name) == 0)
            return true;
    return false;
}

void options_note(struct options_given *given,
                  const struct argp_option *options, int key)
{
    while (options->key != key)
        options++;
    if (!options_has(given, options->name))
        given->names[given->count++] = options->name;
}
