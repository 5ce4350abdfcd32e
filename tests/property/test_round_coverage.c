/* Every shape that has a reference, random and adversarial, through clip
 * windows anywhere: fill, outline and hit test against 128-bit arithmetic, each
 * pixel painted once. */
#include <string.h>

#include "tests/support/any_shape.h"
#include "tests/support/check.h"
#include "tests/support/hits.h"
#include "tests/support/shapes.h"

enum { WINDOW = 20 };

static struct hits hits;

static void open_window(struct random *r, const struct any_shape *s)
{
    const struct pel_rect window = any_window(r, s, WINDOW);
    const struct pel_rect clip = shape_clip(r, &window);
    hits_open(&hits, &window);
    pel_surface_clip(&hits.surface, &clip);
}

/* More of the fills that most programs draw. */
static void check_shapes(enum any_kind kind, bool outline, bool adversarial)
{
    const bool plain = kind == ANY_CIRCLE || kind == ANY_LINE ||
                       kind == ANY_RECTANGLE || kind == ANY_POLYGON;
    const uint64_t count = outline ? 20000 : plain ? 200000 : 40000;
    uint64_t covered = 0;
    for (struct cases c = cases_of(count); cases_next(&c);) {
        struct any_shape s;
        any_random(&c.random, &s, kind, adversarial);
        open_window(&c.random, &s);
        (outline ? any_draw_outline : any_draw)(&hits.surface, &s, &hits.paint);
        hits_check(&hits, outline ? any_outline_expected : any_fill_expected,
                   &s, any_name(&s));
        covered += hits.pixels;
    }
    assert_true(cases_alone() || covered > 0);
}

static void add(struct pel_rect *box, int32_t x, int32_t y)
{
    if (pel_rect_empty(box))
        *box = (struct pel_rect){x, y, x + 1, y + 1};
    box->x0 = pel_min(box->x0, x);
    box->y0 = pel_min(box->y0, y);
    box->x1 = pel_max(box->x1, x + 1);
    box->y1 = pel_max(box->y1, y + 1);
}

/* The dirty box is that of the pixels that belong to the shape or its outline
 * inside the clip, painting or not, and changes nothing of what is painted.
 * What is not painted needs no pixels. */
TEST(dirty_boxes)
{
    for (struct cases c = cases_of(100000); cases_next(&c);) {
        struct random *r = &c.random;
        const enum any_kind kind =
            (enum any_kind)(random_word(r) % ANY_REFERENCED);
        const bool outline = random_word(r) & 1, paints = random_word(r) & 1;
        struct any_shape s;
        struct pel_dirty dirty;
        struct pel_rect box = {0, 0, 0, 0};
        any_random(r, &s, kind, random_word(r) & 1);
        open_window(r, &s);
        pel_dirty_begin(&dirty, paints ? &hits.paint : NULL);
        assert_true(pel_rect_empty(&dirty.box));
        const struct pel_rect *clip = &hits.surface.clip;
        const struct pel_surface none = {NULL, 0, hits.surface.bounds, *clip,
                                         NULL};
        (outline ? any_draw_outline : any_draw)(paints ? &hits.surface : &none,
                                                &s, &dirty.paint);
        for (int32_t y = clip->y0; y < clip->y1; y++)
            for (int32_t x = clip->x0; x < clip->x1; x++)
                if (outline ? any_reference_outline_at(&s, x, y)
                            : any_reference_at(&s, x, y))
                    add(&box, x, y);
        if (memcmp(&box, &dirty.box, sizeof box))
            fail_msg("%s: box %d %d %d %d, expected %d %d %d %d; %s",
                     any_name(&s), dirty.box.x0, dirty.box.y0, dirty.box.x1,
                     dirty.box.y1, box.x0, box.y0, box.x1, box.y1,
                     cases_replay());
        if (paints)
            hits_check(&hits,
                       outline ? any_outline_expected : any_fill_expected, &s,
                       any_name(&s));
        else
            assert_int_equal(hits.pixels, 0);
    }
}

TEST(fills)
{
    for (int kind = 0; kind < 2 * ANY_REFERENCED; kind++)
        check_shapes((enum any_kind)(kind / 2), false, kind % 2);
}

/* Around the ends of arcs and sectors of a few angles, where their box may cut
 * off too much. */
TEST(ends_of_narrow_arcs)
{
    uint64_t covered = 0;
    for (struct cases c = cases_of(60000); cases_next(&c);) {
        struct random *r = &c.random;
        const bool outline = random_word(r) & 1;
        struct any_shape s;
        any_random(r, &s, random_word(r) & 1 ? ANY_ARC : ANY_SECTOR, false);
        s.radius = random_between(r, 1, PEL_PX(32767)) >> random_word(r) % 16;
        s.inner = s.radius - (s.radius >> random_word(r) % 12);
        s.from = random_between(r, -70000, 70000);
        if (random_word(r) & 1)
            s.from &= -16384;
        s.from += random_between(r, -2, 2);
        s.to = s.from + (random_between(r, 1, 40000) >> random_word(r) % 15);
        const struct pel_point d =
            pel_direction((uint16_t)(random_word(r) & 1 ? s.from : s.to));
        const int32_t radius =
            s.kind == ANY_ARC && random_word(r) & 1 ? s.inner : s.radius;
        const int32_t x = pel_pixel_of(
            s.v[0].x + (int32_t)(pel_product(d.x, radius) / 32768));
        const int32_t y = pel_pixel_of(
            s.v[0].y + (int32_t)(pel_product(d.y, radius) / 32768));
        if (x < -32750 || y < -32750 || x > 32740 || y > 32740)
            continue;
        const struct pel_rect window = {x - 6, y - 6, x + 7, y + 7};
        hits_open(&hits, &window);
        (outline ? any_draw_outline : any_draw)(&hits.surface, &s, &hits.paint);
        hits_check(&hits, outline ? any_outline_expected : any_fill_expected,
                   &s, any_name(&s));
        covered += hits.pixels;
    }
    assert_true(covered > 0 || cases_alone());
}

TEST(outlines)
{
    for (int kind = 0; kind < 2 * ANY_REFERENCED; kind++)
        check_shapes((enum any_kind)(kind / 2), true, kind % 2);
}
