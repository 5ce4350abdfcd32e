/* Very tall and very wide triangles into real memory, whole and in parts, which
 * are clipped and so not drawn by core/fast: the same bytes. Heights are around
 * 4,094 rows, the most that core/fast draws; one row has 20,000 px, and some
 * surfaces have 32,767 px, the most that there can be. */
#include <string.h>

#include "tests/support/cases.h"
#include "tests/support/check.h"
#include "tests/support/shapes.h"
#include "tests/support/layouts.h"

enum { BYTES = 17 << 20 };

static uint32_t memory[2][BYTES / 4];

/* Three points that touch the sides of their box. */
static void points_in(struct random *r, const struct pel_rect *box,
                      struct pel_point v[3])
{
    const struct pel_rect px = {PEL_PX(box->x0), PEL_PX(box->y0),
                                pel_min(PEL_PX(box->x1), PEL_COORDINATE_MAX),
                                pel_min(PEL_PX(box->y1), PEL_COORDINATE_MAX)};
    const int32_t inset = random_between(r, 0, 300);
    for (int i = 0; i < 3; i++) {
        v[i].x = random_between(r, px.x0, px.x1);
        v[i].y = random_between(r, px.y0, px.y1);
    }
    v[0].y = px.y0 + pel_min(inset, (px.y1 - px.y0) / 4);
    v[1].y = px.y1;
    v[random_word(r) % 3].x = px.x0;
    v[random_word(r) % 2].x = px.x1;
}

/* Up to five by five, of which none is the whole. */
static void draw_parts(struct pel_surface *s, const struct pel_point v[3],
                       const struct pel_paint *paint)
{
    const struct pel_rect b = s->bounds;
    const int32_t w = (b.x1 - b.x0 + 8) / 5 + 1, h = (b.y1 - b.y0) / 5 + 1;
    for (int32_t y = b.y0; y < b.y1; y += h)
        for (int32_t x = b.x0; x < b.x1; x += w) {
            const struct pel_rect clip = {x, y, x + w, y + h};
            pel_surface_clip(s, &clip);
            pel_triangle(s, v, paint);
        }
}

/* The formats that have a fast writer, and one that has none. */
static void check_triangle(struct random *r, const struct pel_rect *b)
{
    static const uint32_t formats[] = {0, 1, 2, 6, 7, 11};
    const struct layout *l = &layouts[formats[random_word(r) % 6]];
    const pel_color opaque = random_word(r) & 1 ? 0xFF000000 : 0;
    const pel_color c[3] = {random_word(r) | opaque, random_word(r) | opaque,
                            random_word(r) | opaque};
    const struct pel_flat flat = PEL_FLAT(c[0]);
    const int32_t stride = pel_stride(l->format, b->x1 - b->x0);
    const size_t size = (size_t)stride * (size_t)(b->y1 - b->y0);
    const int before = (int)(random_word(r) & 255);
    struct pel_gouraud gouraud;
    struct pel_point v[3];
    points_in(r, b, v);
    shape_keep(v, 3);
    assert_int_equal(pel_gouraud_init(&gouraud, v, c), PEL_OK);
    const struct pel_paint *paint =
        random_word(r) & 1 ? &flat.paint : &gouraud.paint;
    assert_true(size <= BYTES);
    for (int k = 0; k < 2; k++) {
        struct pel_surface s;
        memset(memory[k], before, size);
        assert_int_equal(
            pel_surface_init_rect(&s, l->format, memory[k], stride, b), PEL_OK);
        if (k)
            draw_parts(&s, v, paint);
        else
            pel_triangle(&s, v, paint);
    }
    if (memcmp(memory[0], memory[1], size) != 0)
        fail_msg("%s, %d x %d: bytes differ; %s", l->name, b->x1 - b->x0,
                 b->y1 - b->y0, cases_replay());
}

TEST(sizes)
{
    static const struct {
        uint64_t count;
        int32_t width[2], height[2];
    } row[] = {{400, {1, 30}, {4090, 4100}},   {40, {900, 1000}, {4093, 4096}},
               {1000, {20000, 20000}, {1, 1}}, {1000, {16382, 16386}, {1, 4}},
               {200, {32767, 32767}, {1, 33}}, {200, {1, 33}, {32767, 32767}}};
    for (size_t i = 0; i < sizeof row / sizeof *row; i++)
        for (struct cases c = cases_of(row[i].count); cases_next(&c);) {
            struct random *r = &c.random;
            const int32_t w =
                random_between(r, row[i].width[0], row[i].width[1]);
            const int32_t h =
                random_between(r, row[i].height[0], row[i].height[1]);
            const int32_t x = random_between(r, -32768, 32767 - w);
            const int32_t y = random_between(r, -32768, 32767 - h);
            const struct pel_rect near = {0, 0, w, h},
                                  far = {x, y, x + w, y + h};
            check_triangle(r, random_word(r) & 1 ? &near : &far);
        }
}
