/* What pel import can do to a picture. */
#include "sim/asset/import.h"

#include <stdlib.h>
#include <string.h>

#include "sim/cli/arguments.h"
#include "sim/cli/message.h"

#define AT(member) .offset = offsetof(struct import_changes, member)

static bool parse_palette(const char *option, const char *text, void *input)
{
    struct import_changes *c = input;
    char *end;
    c->own_palette = strcmp(text, "own") == 0;
    c->colors = c->own_palette ? 0 : (int)strtol(text, &end, 10);
    return c->own_palette ||
           (end != text && !*end && c->colors >= 2 && c->colors <= 256) ||
           message_error("--%s is '%s': expected a number of colours, 2 to "
                         "256, or own",
                         option, text);
}

const struct option_row import_change_options[] = {
    {"key", "COLOUR", "of a picture, pixels of this #rrggbb become clear",
     OPTION_COLOR, AT(key), .flag = offsetof(struct import_changes, has_key)},
    {"resize", "WxH", "of a picture, its new size, by a Lanczos filter",
     OPTION_INTEGER, AT(size), .n = 2, .separator = 'x', .low = 1,
     .high = PICTURE_SIZE_MAX,
     .flag = offsetof(struct import_changes, has_size),
     .expected = "WxH from 1x1 to 32767x32767, such as 48x48"},
    {"palette", "N|own",
     "of palette4 and palette8, N colours that stand for all of the picture; "
     "or those that its file has, in their order (PNG, BMP)",
     OPTION_CALL, .parse = parse_palette},
    {"dither", "WAY",
     "of a picture of few bits a channel, or of a chosen palette: none "
     "(default), ordered, as core does it, or diffusion",
     OPTION_CHOICE, AT(dither), .n = sizeof(enum picture_dither),
     .expected = "none|ordered|diffusion"},
    {"alpha", "FORMAT",
     "of a picture in a format without alpha: its alpha is not blended, but "
     "another image, NAME_alpha, in gray8, gray4 or mono1: for "
     "pel_masked_init, around a texture of the picture",
     OPTION_CHOICE, AT(alpha), .n = sizeof(enum import_alpha),
     .expected = "none|gray8|gray4|mono1"},
    {"compress", NULL,
     "a picture to be drawn by pel_copy_runs (pel/asset/runs_asset.h): equal "
     "pixels beside each other and equal rows take flash once",
     OPTION_FLAG, AT(compress)},
    {.help = NULL},
};
