#include <string.h>

#include "api.h"

static const uint8_t bits[512] = {0x81, 0xFF, 0x00, 0x5A, 0x3C, 0xF0, 0x0F,
                                  0xAA, 0x01, 0x80, 0xFE, 0x7F, 0x18, 0xE7};

/* Illegal sizes, or those of the bits that are there. */
static void glyph(struct api *a, const struct pel_surface *surface,
                  const struct pel_paint *paint)
{
    struct pel_stencil g = {bits, 8, input_number(&a->in),
                            input_number(&a->in)};
    if (g.width > 64 && g.width <= 32767)
        g.width %= 65;
    if (g.height > 64 && g.height <= 32767)
        g.height %= 65;
    const struct pel_point at = api_point(a);
    pel_glyph(surface, &g, at.x, at.y, paint);
}

static void text(struct api *a, const struct pel_surface *surface,
                 const struct pel_paint *paint)
{
    static const struct pel_font_range range[2] = {{'A', 2, 0}, {0x80, 1, 2}};
    struct pel_font_glyph glyphs[3];
    char string[25] = {0};
    for (int i = 0; i < 3; i++)
        glyphs[i] = (struct pel_font_glyph){input_byte(&a->in),
                                            (uint8_t)input_below(&a->in, 17),
                                            (uint8_t)input_below(&a->in, 17),
                                            (int8_t)input_byte(&a->in),
                                            (int8_t)input_byte(&a->in),
                                            input_byte(&a->in)};
    const struct pel_font_asset font = {PEL_FONT_MAGIC,
                                        PEL_FONT_VERSION,
                                        input_byte(&a->in),
                                        input_byte(&a->in),
                                        2,
                                        3,
                                        input_byte(&a->in) & 1 ? 1
                                                               : PEL_FONT_NONE,
                                        sizeof bits,
                                        range,
                                        glyphs,
                                        bits,
                                        NULL,
                                        NULL,
                                        0,
                                        NULL};
    const struct pel_point at = api_point(a);
    const struct pel_text_block block = {&font, string, at.x, at.y};
    for (size_t i = 0; i < sizeof string - 1; i++)
        string[i] = (char)input_byte(&a->in);
    if (pel_font_asset_check(&font) != PEL_OK)
        return;
    pel_text(surface, &block, paint);
    pel_text_scaled(surface, &block, 1 + (at.x & 15), paint);
    pel_text_measure(&font, string);
}

/* From another surface: the two must not overlap. */
static void copy(struct api *a, const struct pel_surface *surface)
{
    const struct pel_surface *from = &a->surface[input_below(&a->in, 4)];
    struct pel_copy_part part = {from, api_rect(a), 0, 0};
    const uint32_t kind = input_byte(&a->in);
    if (from == surface)
        return;
    if (kind & 4)
        part.area = from->bounds;
    part.x = surface->bounds.x0 + (int8_t)input_byte(&a->in);
    part.y = surface->bounds.y0 + (int8_t)input_byte(&a->in);
    if (kind & 8)
        part.x = input_number(&a->in);
    if (kind & 16)
        part.y = input_number(&a->in);
    if (kind % 4 == 0)
        pel_copy_alpha(surface, &part, input_byte(&a->in));
    else if (kind % 4 == 1)
        pel_copy_keyed(surface, &part, input_word(&a->in));
    else
        pel_copy(surface, &part);
}

static void scroll(struct api *a, const struct pel_surface *surface)
{
    struct pel_rect area = api_rect(a);
    if (input_byte(&a->in) & 1)
        area = surface->bounds;
    const struct pel_point by = api_point(a);
    const int32_t few = (int8_t)input_byte(&a->in);
    pel_scroll(surface, &area, few & 1 ? by.x : few, few & 2 ? by.y : few);
}

void api_image(struct api *a, const struct pel_surface *surface,
               const struct pel_paint *paint)
{
    switch (input_below(&a->in, 5)) {
    case 0:
        glyph(a, surface, paint);
        break;
    case 1:
        text(a, surface, paint);
        break;
    case 2:
        scroll(a, surface);
        break;
    default:
        copy(a, surface);
        break;
    }
}
