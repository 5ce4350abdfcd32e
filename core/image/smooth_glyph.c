#include "smooth_glyph.h"

#include "../smooth/smooth_part.h"

/* Pixels of a glyph. */
enum { MOST = 255 * 255 };

/* The run at hand, and where the next one lies. */
struct runs {
    const uint8_t *at;
    uint32_t half;    /* 1: the low half of the byte is next */
    int32_t coverage; /* of 15 */
    uint32_t left;    /* px */
};

static uint32_t nibble(struct runs *r)
{
    r->half ^= 1;
    return r->half ? *r->at >> 4 : *r->at++ & 15u;
}

static void next_run(struct runs *r)
{
    uint32_t n = nibble(r);
    r->coverage = (int32_t)n;
    r->left = 1;
    if (n > 0 && n < 15)
        return;
    r->left = 0;
    do
        r->left += n = nibble(r);
    while (n == 15);
}

/* The same, of nibbles that may go on beyond `end`; false when they do. */
static bool skip_run(struct runs *r, const uint8_t *end)
{
    uint32_t n = r->at < end ? nibble(r) : 16;
    r->left = 1;
    if (n > 0 && n < 15)
        return true;
    r->left = 0;
    do {
        if (r->at >= end)
            return false;
        r->left += n = nibble(r);
    } while (n == 15);
    return true;
}

static bool fits(const struct pel_font_asset *font,
                 const struct pel_font_glyph *glyph)
{
    const uint8_t *const end = font->bits + font->size;
    struct runs r = {font->bits + glyph->offset, 0, 0, 0};
    uint32_t pixels = (uint32_t)glyph->width * glyph->height;
    bool good = glyph->offset <= font->size;
    while (good && pixels > 0) {
        good = skip_run(&r, end) && r.left <= MOST;
        pixels -= r.left < pixels ? r.left : pixels;
    }
    return good;
}

/* One row, of which the pixels inside the clip are painted. */
static void draw_row(struct pel_smooth *smooth, struct runs *r,
                     struct pel_point at, int32_t width)
{
    const struct pel_rect *const clip = &smooth->target->clip;
    const bool is_seen = at.y >= clip->y0;
    struct pel_smooth_part part;
    struct pel_span run = {at.x, at.x};
    pel_smooth_part_begin(&part, pel_max(at.x, clip->x0), at.y);
    for (; run.x1 < at.x + width; run.x0 = run.x1) {
        if (r->left == 0)
            next_run(r);
        const int32_t n = pel_min((int32_t)r->left, at.x + width - run.x0);
        r->left -= (uint32_t)n;
        run.x1 = run.x0 + n;
        const struct pel_span seen = {pel_max(run.x0, clip->x0),
                                      pel_min(run.x1, clip->x1)};
        if (is_seen && seen.x0 < seen.x1)
            pel_smooth_collect(smooth, &part, &seen, r->coverage * 17);
    }
    pel_smooth_flush(smooth, &part, at.x);
}

static void draw(const struct pel_surface *surface,
                 const struct pel_font_asset *font,
                 const struct pel_font_glyph *glyph, struct pel_point at,
                 const struct pel_paint *paint)
{
    const int32_t end = pel_min(at.y + glyph->height, surface->clip.y1);
    struct runs r = {font->bits + glyph->offset, 0, 0, 0};
    struct pel_smooth smooth;
    if (!pel_smooth_begin(&smooth, surface, paint))
        return;
    for (; at.y < end; at.y++)
        draw_row(&smooth, &r, at, glyph->width);
}

static int32_t kerning(const struct pel_font_asset *font,
                       const struct pel_font_glyph *left,
                       const struct pel_font_glyph *right)
{
    const ptrdiff_t a = left - font->glyph, b = right - font->glyph;
    const uint32_t wanted = (uint32_t)a << 8 | (uint32_t)b;
    int32_t low = 0, high = font->pairs;
    while (a < 256 && b < 256 && low < high) {
        const int32_t middle = (low + high) / 2;
        const struct pel_font_pair *const pair = &font->pair[middle];
        const uint32_t at = (uint32_t)pair->left << 8 | pair->right;
        if (at == wanted)
            return pair->x;
        if (at < wanted)
            low = middle + 1;
        else
            high = middle;
    }
    return 0;
}

const struct pel_font_kind pel_font_smooth = {fits, draw, kerning};
