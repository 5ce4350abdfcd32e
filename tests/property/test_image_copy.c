/* Copies between any two formats: every pixel by the rule, none outside the
 * clip or the area, whatever the strides. */

#include "core/format/argb8888.h"
#include "core/image/copy.h"
#include "tests/support/canvas.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"
#include "tests/support/shapes.h"

enum { SIZE = 40 };

static struct canvas to, from;

/* Mostly overlaps the source and lands near the destination. */
static struct pel_copy_part random_copy(struct random *r)
{
    const struct pel_rect *s = &from.surface.bounds, *d = &to.surface.bounds;
    struct pel_copy_part c = {&from.surface, {0, 0, 0, 0}, 0, 0};
    c.area.x0 = s->x0 + random_between(r, -20, SIZE);
    c.area.y0 = s->y0 + random_between(r, -20, SIZE);
    c.area.x1 = c.area.x0 + random_between(r, -2, 2 * SIZE);
    c.area.y1 = c.area.y0 + random_between(r, -2, 2 * SIZE);
    c.x = d->x0 + random_between(r, -20, SIZE);
    c.y = d->y0 + random_between(r, -20, SIZE);
    return c;
}

static struct pel_copy_part open_case(struct cases *c, uint64_t pair)
{
    struct random *r = &c->random;
    const struct pel_rect a = shape_bounds(r, SIZE, SIZE);
    const struct pel_rect b = shape_bounds(r, SIZE, SIZE);
    canvas_open(&to, layouts[pair % LAYOUT_COUNT].format, &a,
                random_word(r) % CANVAS_STYLES);
    canvas_open(&from, layouts[pair / LAYOUT_COUNT % LAYOUT_COUNT].format, &b,
                random_word(r) % CANVAS_STYLES);
    const struct pel_rect clip = shape_clip(r, &a), none = {0, 0, 0, 0};
    pel_surface_clip(&to.surface, &clip);
    pel_surface_clip(&from.surface, &none);
    return random_copy(r);
}

/* Where the destination's pixel comes from; false when it is not copied to. */
static bool source_of(const struct pel_copy_part *c, int32_t *x, int32_t *y)
{
    const struct pel_rect *b = &c->source->bounds;
    *x += c->area.x0 - c->x;
    *y += c->area.y0 - c->y;
    return *x >= c->area.x0 && *x < c->area.x1 && *y >= c->area.y0 &&
           *y < c->area.y1 && *x >= b->x0 && *x < b->x1 && *y >= b->y0 &&
           *y < b->y1;
}

/* The color that arrives from a pixel; alpha 0 where none does. */
typedef pel_color rule(int32_t x, int32_t y, uint32_t option);

struct copied {
    const struct pel_copy_part *copy;
    rule *rule;
    uint32_t option;
};

static pel_color color_at(const void *copied, int32_t x, int32_t y)
{
    const struct copied *c = copied;
    const struct pel_rect *clip = &to.surface.clip;
    if (x < clip->x0 || x >= clip->x1 || y < clip->y0 || y >= clip->y1 ||
        !source_of(c->copy, &x, &y))
        return 0;
    return c->rule(x, y, c->option);
}

static void check(const struct pel_copy_part *copy, rule *expected,
                  uint32_t option)
{
    const struct copied copied = {copy, expected, option};
    canvas_check_drawn(&to, NULL, color_at, &copied);
}

static pel_color opaque_rule(int32_t x, int32_t y, uint32_t option)
{
    (void)option;
    return layout_unpack(from.layout, canvas_pixel(&from, x, y)) |
           PEL_RGB(0, 0, 0);
}

static pel_color keyed_rule(int32_t x, int32_t y, uint32_t key)
{
    uint32_t unused = from.layout->unused;
    bool is_key =
        (canvas_pixel(&from, x, y) | unused) == layout_pack(from.layout, key);
    return is_key ? 0 : opaque_rule(x, y, 0);
}

static pel_color alpha_rule(int32_t x, int32_t y, uint32_t alpha)
{
    return (opaque_rule(x, y, 0) & UINT32_C(0xFFFFFF)) | alpha << 24;
}

TEST(every_way)
{
    for (struct cases c = cases_of(67500); cases_next(&c);) {
        const struct pel_copy_part copy = open_case(&c, c.next / 3);
        const struct pel_rect *b = &from.surface.bounds;
        /* A pixel of the picture, in bits that its format may drop. */
        const pel_color key =
            layout_unpack(from.layout, canvas_pixel(&from, b->x0, b->y0));
        uint32_t alpha = random_word(&c.random) & 255;
        if (alpha % 4 == 0)
            alpha = alpha / 4 % 2 ? 0 : 255;
        if (c.next % 3 == 0) {
            pel_copy(&to.surface, &copy);
            check(&copy, opaque_rule, 0);
        } else if (c.next % 3 == 1) {
            pel_copy_keyed(&to.surface, &copy, key);
            check(&copy, keyed_rule, key);
        } else {
            pel_copy_alpha(&to.surface, &copy, (uint8_t)alpha);
            check(&copy, alpha_rule, alpha);
        }
    }
}

/* The canvas's words of 32 bits, read as colors with alpha. */
static pel_color argb_rule(int32_t x, int32_t y, uint32_t alpha)
{
    uint32_t p = canvas_pixel(&from, x, y);
    uint32_t weight = ((p >> 24) * alpha * 2 + 255) / 510;
    return (p & UINT32_C(0xFFFFFF)) | weight << 24;
}

TEST(alpha_of_pixels)
{
    uint64_t xrgb = 0;
    while (layouts[xrgb].format != &pel_xrgb8888)
        xrgb++;
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        struct pel_copy_part copy =
            open_case(&c, xrgb * LAYOUT_COUNT + c.next % LAYOUT_COUNT);
        struct pel_surface argb = from.surface;
        uint32_t alpha = c.next % 2 ? random_word(&c.random) & 255 : 255;
        argb.format = &pel_argb8888;
        copy.source = &argb;
        pel_copy_alpha(&to.surface, &copy, (uint8_t)alpha);
        check(&copy, argb_rule, alpha);
    }
}

/* The alpha of a pixel is no part of the key, and nothing else's. */
TEST(key_ignores_alpha)
{
    static uint32_t words[3];
    const pel_color color[] = {0x12FF00FF, 0xFFFF00FF, 0x00FF00FE};
    const struct pel_rect b = {0, 0, 8, 1};
    struct pel_surface argb;
    canvas_open(&to, &pel_rgb888, &b, 0);
    argb = surface_of(&pel_argb8888, words, sizeof words, 3, 1);
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 4; k++)
            ((uint8_t *)&words[i])[k] = (uint8_t)(color[i] >> 8 * k);
    const struct pel_copy_part copy = {&argb, {0, 0, 3, 1}, 2, 0};
    pel_copy_keyed(&to.surface, &copy, PEL_RGB(255, 0, 255));
    for (int32_t x = 0; x < 8; x++)
        assert_int_equal(canvas_pixel(&to, x, 0),
                         x == 4 ? 0xFF00FE : canvas_pixel_before(&to, x, 0));
}

/* As a destination it is xrgb8888. */
TEST(argb_is_drawn_into_as_xrgb)
{
    const struct pel_rect b = {0, 0, 16, 4};
    const struct pel_flat mixed = PEL_FLAT(PEL_RGBA(200, 100, 50, 77));
    const struct pel_flat solid = PEL_FLAT(PEL_RGB(20, 10, 5));
    canvas_open(&to, &pel_xrgb8888, &b, 0);
    canvas_open(&from, &pel_xrgb8888, &b, 0);
    struct pel_surface argb = from.surface;
    argb.format = &pel_argb8888;
    for (int i = 0; i < 2; i++) {
        const struct pel_surface *s = i ? &argb : &to.surface;
        pel_rectangle(s, (struct pel_point)PEL_AT(1, 0),
                      (struct pel_point)PEL_AT(15, 3), &mixed.paint);
        pel_rectangle(s, (struct pel_point)PEL_AT(3, 1),
                      (struct pel_point)PEL_AT(7, 2), &solid.paint);
    }
    canvas_check_same(&to, &from);
}

TEST(out_of_range)
{
    const struct pel_rect b = {0, 0, 16, 16};
    canvas_open(&to, &pel_gray8, &b, 0);
    canvas_open(&from, &pel_rgb332, &b, 0);
    struct pel_copy_part c = {&from.surface, {0, 0, 16, 16}, 65537, 0};
    pel_copy(&to.surface, &c);
    c.x = 0;
    c.y = INT32_MIN;
    pel_copy(&to.surface, &c);
    c.y = 0;
    c.area.x0 = INT32_MIN;
    pel_copy_alpha(&to.surface, &c, 255);
    assert_memory_equal(to.memory, to.before, to.size);
}

/* A surface whose init failed has no format. */
TEST(failed_surfaces)
{
    const struct pel_rect b = {0, 0, 8, 8};
    struct pel_surface failed;
    canvas_open(&to, &pel_gray8, &b, 0);
    assert_true(pel_surface_init(&failed, &pel_gray8, &failed, 1, &b) < 0);
    const struct pel_copy_part c = {&failed, b, 0, 0};
    const struct pel_copy_part d = {&to.surface, b, 0, 0};
    pel_copy(&to.surface, &c);
    pel_copy_keyed(&to.surface, &c, 0);
    pel_copy_alpha(&to.surface, &c, 255);
    pel_copy(&failed, &d);
    pel_copy_keyed(&failed, &d, 0);
    assert_memory_equal(to.memory, to.before, to.size);
}

static uint32_t pack_321(pel_color c)
{
    return pel_red(c) >> 5 << 5 | pel_green(c) >> 6 << 3 |
           pel_blue(c) >> 7 << 1;
}

static pel_color unpack_321(uint32_t p)
{
    return PEL_RGB((p >> 5) * 36, (p >> 3 & 3) * 85, (p >> 1 & 1) * 255);
}

static void load_321(const struct pel_surface *s, int32_t x, int32_t y,
                     int32_t n, pel_color *colors)
{
    for (const uint8_t *p = pel_surface_line(s, y) + x; n > 0; n--)
        *colors++ = unpack_321(*p++);
}

static void put_321(const struct pel_surface *s, int32_t x, int32_t y,
                    int32_t n, const pel_color *colors)
{
    for (uint8_t *p = pel_surface_line(s, y) + x; n > 0; n--)
        *p++ = (uint8_t)pack_321(*colors++);
}

/* Bits that a program's own format leaves unused are not copied. */
TEST(unused_bits)
{
    static const struct pel_format own = {.id = 200,
                                          .bits = 8,
                                          .word = 1,
                                          .pack = pack_321,
                                          .unpack = unpack_321,
                                          .load = load_321,
                                          .put = put_321};
    static const struct pel_rect b = {0, 0, 1, 1};
    uint8_t source = 0xFF, pixel = 0;
    struct pel_surface f, t;
    assert_int_equal(pel_surface_init(&f, &own, &source, 1, &b), PEL_OK);
    assert_int_equal(pel_surface_init(&t, &own, &pixel, 1, &b), PEL_OK);
    pel_copy(&t, &(struct pel_copy_part){&f, b, 0, 0});
    assert_int_equal(pixel, pack_321(unpack_321(0xFF)));
}
