/* The font of pel's own texts: sim/scenes/fixed_6x13.bdf, a part of the
 * program.
 */
#include <stdlib.h>
#include <string.h>

#include "sim/cli/message.h"
#include "sim/font/asset.h"

__asm__(".section .rodata\n"
        "builtin_font: .incbin \"sim/scenes/fixed_6x13.bdf\"\n"
        "builtin_font_end: .byte 0\n"
        ".text\n");
extern const char builtin_font[], builtin_font_end[];

bool font_asset_builtin(struct pel_font_asset *asset)
{
    struct font font = {.missing = -1};
    struct font_file file = {.path = "builtin:6x13",
                             .size = (size_t)(builtin_font_end - builtin_font)};
    file.data = malloc(file.size + 1); /* the parser cuts it into words */
    if (!file.data)
        return message_error("out of memory");
    memcpy(file.data, builtin_font, file.size + 1);
    const bool done = font_parse_bdf(&font, &file) &&
                      font_asset_make(asset, &font, file.path);
    free(file.data);
    font_free(&font);
    return done;
}
