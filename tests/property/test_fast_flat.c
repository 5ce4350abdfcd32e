/* The writers of spans by vectors, and the one that owns the row loop of a
 * triangle (fast_flat.c), against the formats' rule: first rows from 0 to 41 px
 * wide, at every place of a row against 16 bytes, heights on both sides of
 * whole batches of 4, 5 or 8 rows and of the 128 rows of one division. */
#include "tests/support/canvas.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"
#include "tests/support/shapes.h"

enum { WIDTH = 60 };

static struct canvas canvas;
static struct hits hits;

/* A first row of `width` pixels from `x` on, then narrower ones to the left,
 * the middle or the right; or the same upside down. */
static void set_triangle(struct pel_point v[3], int32_t x, int32_t width,
                         int32_t height, int form)
{
    const int32_t top = 128 + PEL_PX(2), left = PEL_PX(x) + 128;
    const int32_t third = left + PEL_PX(width) * (form % 3) / 2;
    const bool up = form >= 3;
    v[0].x = left;
    v[1].x = left + PEL_PX(width);
    v[0].y = v[1].y = up ? top + PEL_PX(height) - 1 : top;
    v[2] = (struct pel_point){third, up ? top - 1 : top + PEL_PX(height)};
}

/* Each 10th case may be about 128 rows high. The formats are xrgb8888,
 * xbgr8888, the three of 5-6-5 bits, xrgb1555, and one that has no writer of
 * its own. */
TEST(colors)
{
    static const int32_t heights[] = {1, 2, 15, 16, 17, 24, 127, 128, 129};
    static const uint32_t formats[] = {6, 7, 0, 1, 2, 3, 11};
    static const pel_color colors[] = {0xFF123456, 0x80FF40C0, 0x01FFFFFF,
                                       0xFE000102, 0x00FFFFFF};
    static const pel_color corners[3] = {0xFFFF0040, 0xFF0080FF, 0xFF20FF00};
    for (struct cases c = cases_of(80000); cases_next(&c);) {
        struct random *r = &c.random;
        const struct layout *l = &layouts[formats[random_word(r) % 7]];
        const int32_t height = heights[random_word(r) % (c.next % 10 ? 6 : 9)];
        const uint32_t color = random_word(r) % 6;
        const struct pel_flat flat = PEL_FLAT(colors[color % 5]);
        const struct pel_rect b = {0, 0, WIDTH, height + 4};
        struct pel_gouraud gouraud;
        struct pel_point v[3];
        set_triangle(v, random_between(r, 0, 15), random_between(r, 0, 41),
                     height, random_between(r, 0, 5));
        shape_keep(v, 3);
        assert_int_equal(pel_gouraud_init(&gouraud, v, corners), PEL_OK);
        canvas_open(&canvas, l->format, &b, random_word(r) % CANVAS_STYLES);
        hits_open(&hits, &b);
        pel_triangle(&hits.surface, v, &hits.paint);
        pel_triangle(&canvas.surface, v,
                     color < 5 ? &flat.paint : &gouraud.paint);
        if (color < 5)
            canvas_check_drawn(&canvas, &hits, canvas_flat, &flat);
        else
            canvas_check_drawn(&canvas, &hits, canvas_gouraud, &gouraud);
    }
}

static void fill_fails(const struct pel_paint *paint,
                       const struct pel_spans *rows)
{
    (void)paint;
    fail_msg("format %d: the writer was not taken", rows->surface->format->id);
}

/* The writers are there for speed: what they are made for must not go the other
 * way. */
TEST(writers_are_taken)
{
    static const struct pel_format *const all[] = {
        &pel_xrgb8888,  &pel_xbgr8888,  &pel_rgbx8888,  &pel_bgrx8888,
        &pel_rgb565_le, &pel_rgb565_be, &pel_bgr565_le, &pel_xrgb1555_le};
    static const struct pel_point v[3] = {PEL_AT(1, 1), PEL_AT(20, 2),
                                          PEL_AT(3, 20)};
    static const struct pel_flat flat = {{fill_fails, pel_flat_fast},
                                         PEL_RGB(17, 34, 51)};
    const struct pel_rect b = {0, 0, 32, 32};
    for (int f = 0; f < 8; f++) {
        canvas_open(&canvas, all[f], &b, 0);
        pel_triangle(&canvas.surface, v, &flat.paint);
    }
}
