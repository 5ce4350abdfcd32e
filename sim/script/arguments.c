#include <string.h>

#include "sim/image/format_names.h"
#include "sim/cli/arguments.h"
#include "sim/cli/message.h"
#include "sim/cli/number.h"
#include "sim/script/parser.h"

static bool refuse(const struct script_parser *p, const char *word,
                   const char *expected)
{
    return ERROR_AT(p, "%s: %s: expected %s", p->command->name, word, expected);
}

static bool parse_color(const struct script_parser *p, const char *word,
                        int32_t *value)
{
    pel_color color;
    const size_t length = number_color(word, &color);
    if (!length || word[length])
        return refuse(p, word, "a colour, #rrggbb or #rrggbbaa");
    memcpy(value, &color, sizeof color);
    return true;
}

static bool parse_format(const struct script_parser *p, const char *word,
                         int32_t *value)
{
    for (*value = 0; format_names[*value].name; ++*value)
        if (strcmp(format_names[*value].name, word) == 0)
            return true;
    return refuse(p, word, format_list());
}

/* The names are those of the command's usage. */
static bool parse_choice(const struct script_parser *p, const char *word,
                         int32_t *value)
{
    *value = choice_find(p->command->usage, word);
    return *value >= 0 || refuse(p, word, p->command->usage);
}

/* Decimals in 1/unit; unit 0: whole numbers. */
static bool parse_number(const struct script_parser *p, enum script_kind kind,
                         const char *word, int32_t *value)
{
    enum { WORLD = 16384 * 65536 };
    static const struct range {
        char kind;
        int32_t unit, low, high;
        const char *expected;
    } ranges[] = {
        {KIND_PIXEL, 0, -32768, 32767, "a whole number in -32768..32767"},
        {KIND_COUNT, 0, 0, 32767, "a whole number in 0..32767"},
        {KIND_SIZE, 0, 1, 32767, "a whole number in 1..32767"},
        {KIND_BYTE, 0, 0, 255, "a whole number in 0..255"},
        {KIND_SHININESS, 0, 1, 256, "a whole number in 1..256"},
        {KIND_COORDINATE, 256, PEL_COORDINATE_MIN, PEL_COORDINATE_MAX,
         "pixels in -32768..32767.998, such as 12 or -3.25"},
        {KIND_LENGTH, 256, 0, PEL_PX(32767),
         "pixels in 0..32767, such as 12 or 3.25"},
        {KIND_POSITION, 65536, 0, 65536, "a position from 0 to 1"},
        {KIND_TURN, 65536, 0, 65536, "a part of a turn from 0 to 1"},
        {KIND_PLACE, 65536, -WORLD, WORLD, "a decimal in -16384..16384"},
        {KIND_MEASURE, 65536, 1, WORLD, "a decimal above 0, up to 16384"},
        {KIND_FACTOR, 65536, 0, 16 * 65536 - 1,
         "a decimal from 0 to less than 16"},
        {KIND_TEXELS, 65536, 0, 256 * 65536, "a decimal from 0 to 256"},
    };
    const struct range *r = ranges;
    int64_t v;
    while (r->kind != (char)kind)
        r++;
    if ((r->unit ? number_decimal(word, r->unit, r->low, r->high, &v)
                 : number_integer(word, r->low, r->high, &v)) != NUMBER_OK)
        return refuse(p, word, r->expected);
    *value = (int32_t)v;
    return true;
}

bool script_argument(struct script_parser *p, enum script_kind kind,
                     const char *word, int32_t *value)
{
    switch (kind) {
    case KIND_COLOR:
        return parse_color(p, word, value);
    case KIND_FORMAT:
        return parse_format(p, word, value);
    case KIND_CHOICE:
        return parse_choice(p, word, value);
    case KIND_FONT:
    case KIND_PICTURE:
    case KIND_ICON:
    case KIND_FILE:
    case KIND_MESH:
    case KIND_TEXT:
        return script_add_asset(p, kind, word, value);
    default:
        return parse_number(p, kind, word, value);
    }
}
