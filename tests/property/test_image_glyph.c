/* Glyphs: every set bit is painted once, at any place, through any clip. */
#include "core/image/glyph_text.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"
#include "tests/support/hits.h"
#include "tests/support/shapes.h"

enum { BYTES = 600 };

static struct hits hits;

struct placed {
    struct pel_stencil glyph;
    int32_t x, y;
};

static bool bit_at(const void *shape, int32_t x, int32_t y)
{
    const struct placed *p = shape;
    x -= p->x;
    y -= p->y;
    if (x < 0 || x >= p->glyph.width || y < 0 || y >= p->glyph.height)
        return false;
    return p->glyph.bits[y * p->glyph.stride + x / 8] >> (7 - x % 8) & 1;
}

/* Noise, or long runs: bytes of zeros and ones. */
static void random_bits(struct random *r, uint8_t *bits)
{
    bool solid = random_word(r) & 1;
    for (int i = 0; i < BYTES; i++) {
        uint32_t word = random_word(r);
        bits[i] = (uint8_t)word;
        if (solid && word >> 28)
            bits[i] = word >> 8 & 1 ? 0xFF : 0;
    }
}

TEST(bits)
{
    static uint8_t bits[BYTES];
    for (struct cases c = cases_of(60000); cases_next(&c);) {
        struct random *r = &c.random;
        const struct pel_point origin = {
            PEL_PX(random_between(r, -32700, 32600)),
            PEL_PX(random_between(r, -32700, 32600))};
        const struct pel_rect window = shape_window(r, &origin, 1, 40);
        const struct pel_rect clip = shape_clip(r, &window);
        struct placed p = {{bits, 0, random_between(r, 0, 60), 0}, 0, 0};
        p.glyph.stride = (p.glyph.width + 7) / 8 + random_between(r, 0, 2);
        p.glyph.height = random_between(r, 0, BYTES / 10);
        p.x = window.x0 + random_between(r, -50, 40);
        p.y = window.y0 + random_between(r, -50, 40);
        random_bits(r, bits);
        hits_open(&hits, &window);
        pel_surface_clip(&hits.surface, &clip);
        pel_glyph(&hits.surface, &p.glyph, p.x, p.y, &hits.paint);
        hits_check(&hits, bit_at, &p, "glyph");
    }
}

TEST(out_of_range)
{
    static const uint8_t bits[] = {0xFF};
    const struct pel_rect window = {0, 0, 8, 8};
    struct pel_stencil g = {bits, 0, 8, 8};
    hits_open(&hits, &window);
    pel_glyph(&hits.surface, &g, 65537, 0, &hits.paint);
    pel_glyph(&hits.surface, &g, 0, INT32_MIN, &hits.paint);
    g.height = 32768;
    pel_glyph(&hits.surface, &g, 0, 0, &hits.paint);
    g.height = -1;
    pel_glyph(&hits.surface, &g, 0, 0, &hits.paint);
    assert_int_equal(hits.pixels, 0);
}
