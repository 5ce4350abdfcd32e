#include "sim/font/outline_asset.h"

#include <stdlib.h>
#include <string.h>

#include "sim/cli/message.h"
#include "sim/font/asset.h"
#include "sim/font/points.h"

/* A rectangle; one that lies in another goes round the other way. */
static void put_rectangle(struct font_points *p, int x, int y, int width,
                          int height)
{
    font_points_add(p, PEL_OUTLINE_BEGIN, x, y);
    font_points_add(p, PEL_OUTLINE_ON, x + width, y);
    font_points_add(p, PEL_OUTLINE_ON, x + width, y + height);
    font_points_add(p, PEL_OUTLINE_ON, x, y + height);
}

/* Half an em wide and two thirds high, on the baseline. */
bool outline_add_box(struct font *font)
{
    const int edge = font->em / 16, width = font->em / 2;
    const int height = font->em * 2 / 3;
    const struct font_char box = {.code = FONT_CODE_MAX,
                                  .advance = width + 2 * edge};
    struct font_points points = {.size = 0};
    if (font_missing_of(font) != PEL_FONT_NONE)
        return true;
    put_rectangle(&points, edge, 0, width, height);
    put_rectangle(&points, width, edge, 2 * edge - width, height - 2 * edge);
    font->missing = FONT_CODE_MAX;
    const bool done = font_points_keep(font, &box, &points);
    free(points.bytes);
    return done;
}

/* Equal ones lie at the same place. */
static void fill_glyphs(struct pel_outline_glyph *glyph, uint8_t *bits,
                        struct pel_outline_font_asset *asset,
                        const struct font *font)
{
    for (size_t i = 0; i < font->count; i++) {
        const struct font_char *c = &font->chars[i];
        const uint8_t *points = font->bits + c->offset;
        size_t same = 0;
        while (same < i &&
               (glyph[same].size != c->bytes ||
                memcmp(bits + glyph[same].offset, points, c->bytes) != 0))
            same++;
        glyph[i] = (struct pel_outline_glyph){
            .offset = same < i ? glyph[same].offset : asset->size,
            .size = (uint16_t)c->bytes,
            .advance = (uint16_t)c->advance};
        if (same < i)
            continue;
        memcpy(bits + asset->size, points, c->bytes);
        asset->size += (uint32_t)c->bytes;
    }
}

/* Those whose glyphs are there, among the first 256. */
static uint16_t fill_pairs(struct pel_outline_pair *pair,
                           const struct font *font)
{
    uint16_t n = 0;
    for (size_t i = 0; i < font->pair_count && n < UINT16_MAX; i++) {
        const struct font_pair *p = &font->pairs[i];
        const int left = font_index_of(font, p->left);
        const int right = font_index_of(font, p->right);
        if (left >= 0 && right >= 0 && p->x >= INT16_MIN && p->x <= INT16_MAX)
            pair[n++] = (struct pel_outline_pair){(uint8_t)left, (uint8_t)right,
                                                  (int16_t)p->x};
    }
    return n;
}

bool outline_asset_make(struct pel_outline_font_asset *asset,
                        const struct font *font, const char *path)
{
    const size_t n = font->count;
    *asset = (struct pel_outline_font_asset){.magic = 0};
    if (!font_count_legal(font, path))
        return false;
    struct pel_font_range *range = malloc((n + 1) * sizeof *range);
    struct pel_outline_glyph *glyph = malloc((n + 1) * sizeof *glyph);
    struct pel_outline_pair *pair =
        malloc((font->pair_count + 1) * sizeof *pair);
    uint8_t *bits = malloc(font->size + 1);
    *asset =
        (struct pel_outline_font_asset){.magic = PEL_OUTLINE_FONT_MAGIC,
                                        .version = PEL_OUTLINE_FONT_VERSION,
                                        .em = (uint16_t)font->em,
                                        .ascent = (uint16_t)font->ascent,
                                        .descent = (uint16_t)font->descent,
                                        .left = (int16_t)font->box[0],
                                        .bottom = (int16_t)font->box[1],
                                        .right = (int16_t)font->box[2],
                                        .top = (int16_t)font->box[3],
                                        .glyphs = (uint16_t)n,
                                        .missing = font_missing_of(font),
                                        .range = range,
                                        .glyph = glyph,
                                        .points = bits,
                                        .pair = pair};
    if (!range || !glyph || !pair || !bits) {
        outline_asset_free(asset);
        return message_error("out of memory");
    }
    asset->ranges = font_fill_ranges(range, font);
    asset->pairs = fill_pairs(pair, font);
    fill_glyphs(glyph, bits, asset, font);
    return true;
}

void outline_asset_free(struct pel_outline_font_asset *asset)
{
    free((void *)(uintptr_t)asset->range);
    free((void *)(uintptr_t)asset->glyph);
    free((void *)(uintptr_t)asset->points);
    free((void *)(uintptr_t)asset->pair);
    *asset = (struct pel_outline_font_asset){.magic = 0};
}
