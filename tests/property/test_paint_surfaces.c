/* Textures, fans, patterns and nine-slice pictures, on shapes, in every format:
 * each pixel is what the paint says of that pixel alone, stored or blended by
 * the rule. So bands, tiles and clips change no byte. And the same bytes on
 * every CPU. Gradients: test_paint_gradients.c. */
#include "tests/support/any_paint.h"
#include "tests/support/canvas.h"
#include "tests/support/check.h"
#include "tests/support/hits.h"
#include "tests/support/shapes.h"

enum { KINDS = 6, COLORS = 200, TEXELS = 16 * 11 };

static pel_color ramp_colors[COLORS], texels[TEXELS];
static struct pel_fan_triangle triangles[5];
static union any_paint paint;

static void noise(struct random *r, pel_color *colors, int32_t n, bool opaque)
{
    for (int32_t i = 0; i < n; i++)
        colors[i] = random_word(r) | (opaque ? 0xFF000000 : 0);
}

static struct pel_point random_point(struct random *r, const struct pel_rect *b)
{
    struct pel_point p;
    p.x = random_between(r, PEL_PX(b->x0 - 20), PEL_PX(b->x1 + 20));
    p.y = random_between(r, PEL_PX(b->y0 - 20), PEL_PX(b->y1 + 20));
    return p;
}

/* From 0 to 1 at the corner of the bounds, -1 to 1 texels a pixel. */
static void random_plane(struct random *r, const struct pel_rect *b,
                         struct pel_plane *p)
{
    p->at = random_word(r);
    p->dx = (uint64_t)(int64_t)random_word(r) * 2 - UINT32_MAX;
    p->dy = (uint64_t)(int64_t)random_word(r) * 2 - UINT32_MAX;
    p->at -= (uint64_t)(int64_t)b->x0 * p->dx;
    p->at -= (uint64_t)(int64_t)b->y0 * p->dy;
}

static struct pel_color_paint *make_texture(struct random *r, bool bilinear,
                                            const struct pel_rect *b)
{
    const struct pel_texels t = {NULL, texels, 16, 11,
                                 pel_alpha(texels[0] & texels[1] & texels[2]) ==
                                     255};
    struct pel_texture_map map;
    random_plane(r, b, &map.u);
    random_plane(r, b, &map.v);
    if (bilinear)
        pel_texture_init_bilinear(&paint.texture, &t, &map);
    else
        pel_texture_init_nearest(&paint.texture, &t, &map);
    paint.texture.wrap_u = (uint8_t)(random_word(r) % 3);
    paint.texture.wrap_v = (uint8_t)(random_word(r) % 3);
    return &paint.texture.base;
}

static struct pel_color_paint *make_fan(struct random *r,
                                        const struct pel_rect *b)
{
    struct pel_point v[5];
    const struct pel_point at = random_point(r, b);
    const int32_t radius = random_between(r, 256, 9000);
    struct pel_fan_points points = {at, ramp_colors[9], v, ramp_colors, 5};
    pel_fan_perimeter(v, 5, at, radius, (uint16_t)random_word(r));
    assert_int_equal(pel_fan_init(&paint.fan, &points, triangles), PEL_OK);
    return &paint.fan.base;
}

static struct pel_color_paint *make_checker(struct random *r)
{
    const struct pel_checker_fields fields = {
        random_between(r, 1, 9), random_between(r, 1, 9),
        random_between(r, -9, 9), random_between(r, -9, 9)};
    pel_checker_init(&paint.checker, &fields, ramp_colors[0], ramp_colors[1]);
    return &paint.checker.base;
}

static struct pel_color_paint *make_hatch(struct random *r)
{
    const struct pel_hatch_lines lines = {
        random_between(r, -3, 3), random_between(r, -3, 3),
        random_between(r, -9, 9), 9, random_between(r, 0, 9)};
    pel_hatch_init(&paint.hatch, &lines, ramp_colors[0], ramp_colors[1]);
    return &paint.hatch.base;
}

static struct pel_color_paint *make_slices(struct random *r,
                                           const struct pel_rect *b)
{
    static struct pel_surface picture;
    static const struct pel_rect middle = {5, 3, 11, 8};
    const struct pel_rect box = {b->x0 + 3, b->y0 + 2,
                                 b->x0 + random_between(r, 8, 80),
                                 b->y0 + random_between(r, 4, 18)};
    picture = surface_of(&pel_argb8888, texels, sizeof texels, 16, 11);
    pel_nine_slice_init(&paint.slices, &picture, &middle, &box);
    paint.slices.tiled = random_word(r) % 2;
    return &paint.slices.base;
}

static struct pel_color_paint *make(struct random *r, uint32_t kind,
                                    const struct pel_rect *b)
{
    const bool opaque = random_word(r) % 2;
    noise(r, ramp_colors, COLORS, opaque);
    noise(r, texels, TEXELS, opaque);
    switch (kind) {
    case 0:
    case 1:
        return make_texture(r, kind == 0, b);
    case 2:
        return make_fan(r, b);
    case 3:
        return make_checker(r);
    case 4:
        return make_hatch(r);
    default:
        return make_slices(r, b);
    }
}

static void draw(const struct pel_surface *s, const struct pel_point v[3],
                 uint32_t shape, const struct pel_paint *p)
{
    if (shape == 0)
        pel_triangle(s, v, p);
    else if (shape == 1)
        pel_circle(s, v[0], v[1].x & 8191, p);
    else
        pel_rectangle(s, v[0], v[1], p);
}

/* Of pixels that the shape hits: for these alone the test asks whether colors
 * of an opaque paint have alpha 255. */
static pel_color color_at(const void *colors, int32_t x, int32_t y)
{
    const struct pel_color_paint *p = colors;
    pel_color source;
    p->colors(p, x, y, 1, &source);
    if (p->opaque && pel_alpha(source) != 255)
        fail_msg("%08x is not opaque; %s", source, cases_replay());
    return source;
}

TEST(pixels)
{
    static struct canvas canvas;
    static struct hits hits;
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        struct random *r = &c.random;
        const struct pel_rect b = shape_bounds(r, 90, 20);
        const uint32_t kind = random_word(r) % KINDS;
        const uint32_t shape = random_word(r) % 3;
        struct pel_color_paint *p = make(r, kind, &b);
        struct pel_point v[3];
        shape_in_box(r, v, 3, &b);
        canvas_open(&canvas, layouts[random_word(r) % LAYOUT_COUNT].format, &b,
                    random_word(r) % CANVAS_STYLES);
        hits_open(&hits, &b);
        draw(&canvas.surface, v, shape, &p->paint);
        draw(&hits.surface, v, shape, &hits.paint);
        canvas_check_drawn(&canvas, &hits, color_at, p);
    }
}

/* FNV-1a, of the colors of 512 runs. */
static uint32_t checksum_of(uint32_t kind)
{
    struct random r = {kind + 4};
    uint32_t sum = 2166136261u;
    for (int i = 0; i < 512; i++) {
        const struct pel_rect b = shape_bounds(&r, 90, 20);
        struct pel_color_paint *p = make(&r, kind, &b);
        pel_color got[100];
        p->colors(p, b.x0, b.y0, 100, got);
        for (int k = 0; k < 100; k++)
            for (int shift = 0; shift < 32; shift += 8)
                sum = (sum ^ (got[k] >> shift & 255)) * 16777619u;
    }
    return sum;
}

TEST(same_bytes_everywhere)
{
    static const uint32_t sums[KINDS] = {0xf2040aa4, 0x7de153e6, 0x4e4be96e,
                                         0x204b9f74, 0x33036ebb, 0x545f1dc5};
    for (uint32_t kind = 0; kind < KINDS; kind++)
        if (checksum_of(kind) != sums[kind])
            fail_msg("kind %u: expected %08x, got %08x", kind, sums[kind],
                     checksum_of(kind));
}
