#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sim/image/format_names.h"
#include "sim/cli/message.h"
#include "sim/cli/number.h"
#include "sim/script/assets.h"
#include "sim/script/meshes.h"

static bool refuse(const struct script_place *place, const char *word,
                   const char *right)
{
    return message_error_at(place->path, place->line, "%s: %s must be %s",
                            place->command->name, word, right);
}

static bool parse_subpixels(const struct script_place *place, const char *word,
                            int32_t *value)
{
    switch (number_subpixels(word, value)) {
    case NUMBER_OK:
        return true;
    case NUMBER_RANGE:
        return refuse(place, word, "in -32768..32767.998 pixels");
    default:
        return refuse(place, word, "a decimal number such as 12 or -3.25");
    }
}

static bool parse_length(const struct script_place *place, const char *word,
                         int32_t *value)
{
    if (!parse_subpixels(place, word, value))
        return false;
    if (*value < 0 || *value > PEL_PX(32767))
        return refuse(place, word, "in 0..32767 pixels");
    return true;
}

static bool parse_whole(const struct script_place *place, const char *word,
                        const int32_t range[2], int32_t *value)
{
    int64_t v;
    char right[48];
    snprintf(right, sizeof right, "a whole number in %d..%d", (int)range[0],
             (int)range[1]);
    if (number_integer(word, range[0], range[1], &v) != NUMBER_OK)
        return refuse(place, word, right);
    *value = (int32_t)v;
    return true;
}

static bool parse_turn(const struct script_place *place, const char *word,
                       int32_t *value)
{
    int64_t v;
    if (number_decimal(word, 65536, 0, 65536, &v) != NUMBER_OK)
        return refuse(place, word, "a part of a turn, 0 to 1");
    *value = (int32_t)(v & 65535);
    return true;
}

static bool parse_way(const struct script_place *place, const char *word,
                      int32_t *value)
{
    int64_t v;
    if (number_decimal(word, 65536, 0, 65536, &v) != NUMBER_OK)
        return refuse(place, word, "a part of the way, 0 to 1");
    *value = (int32_t)v;
    return true;
}

static bool parse_color(const struct script_place *place, const char *word,
                        int32_t *value)
{
    const size_t digits = strspn(word + 1, "0123456789abcdefABCDEF");
    if (word[0] != '#' || word[digits + 1] || (digits != 6 && digits != 8))
        return refuse(place, word, "a colour: #rrggbb or #rrggbbaa");
    const uint32_t v = (uint32_t)strtoul(word + 1, NULL, 16);
    const pel_color color = digits == 6 ? 0xFF000000u | v : v << 24 | v >> 8;
    memcpy(value, &color, sizeof color);
    return true;
}

static bool parse_format(const struct script_place *place, const char *word,
                         int32_t *value)
{
    for (int32_t i = 0; format_names[i].name; i++) {
        if (strcmp(format_names[i].name, word) == 0) {
            *value = i;
            return true;
        }
    }
    return message_error_at(place->path, place->line,
                            "canvas: unknown format %s: valid are %s", word,
                            format_list());
}

static bool parse_scaled(const struct script_place *place,
                         enum script_kind kind, const char *word,
                         int32_t *value)
{
    static const int64_t world = 16384 * 65536;
    int64_t v, low = 1, high = world;
    const char *right = "a decimal number above 0, up to 16384";
    if (kind == KIND_PLACE) {
        low = -world;
        right = "a decimal number in -16384..16384";
    } else if (kind == KIND_FACTOR) {
        low = 0;
        high = 16 * 65536 - 1;
        right = "a decimal number from 0 to less than 16";
    }
    if (number_decimal(word, 65536, low, high, &v) != NUMBER_OK)
        return refuse(place, word, right);
    *value = (int32_t)v;
    return true;
}

/* The names are those of the command's usage. */
static bool parse_choice(const struct script_place *place, const char *word,
                         int32_t *value)
{
    const char *name = place->command->usage;
    const size_t length = strlen(word);
    for (int32_t i = 0; *name; i++) {
        const size_t n = strcspn(name, "|");
        if (n == length && strncmp(name, word, n) == 0) {
            *value = i;
            return true;
        }
        name += n + (name[n] == '|');
    }
    return refuse(place, word, place->command->usage);
}

static bool parse_number(const struct script_place *place,
                         enum script_kind kind, const char *word,
                         int32_t *value)
{
    static const int32_t pixel[] = {-32768, 32767}, count[] = {0, 32767},
                         size[] = {1, 32767}, byte[] = {0, 255},
                         exponent[] = {1, 256};
    switch (kind) {
    case KIND_PIXEL:
        return parse_whole(place, word, pixel, value);
    case KIND_COUNT:
        return parse_whole(place, word, count, value);
    case KIND_SIZE:
        return parse_whole(place, word, size, value);
    case KIND_BYTE:
        return parse_whole(place, word, byte, value);
    case KIND_SHININESS:
        return parse_whole(place, word, exponent, value);
    case KIND_PLACE:
    case KIND_FACTOR:
    case KIND_MEASURE:
        return parse_scaled(place, kind, word, value);
    case KIND_LENGTH:
        return parse_length(place, word, value);
    case KIND_TURN:
        return parse_turn(place, word, value);
    case KIND_WAY:
        return parse_way(place, word, value);
    default:
        return parse_subpixels(place, word, value);
    }
}

bool script_argument(const struct script_place *place, enum script_kind kind,
                     const char *word, int32_t *value)
{
    switch (kind) {
    case KIND_COLOR:
        return parse_color(place, word, value);
    case KIND_FORMAT:
        return parse_format(place, word, value);
    case KIND_FONT:
        return script_add_font(place, word, value);
    case KIND_PICTURE:
        return script_add_picture(place, word, value);
    case KIND_CHOICE:
        return parse_choice(place, word, value);
    case KIND_FILE:
        return script_add_file(place, word, value);
    case KIND_MESH:
        return script_add_mesh(place, word, value);
    case KIND_TEXT:
        return script_add_text(place, word, value);
    default:
        return parse_number(place, kind, word, value);
    }
}
