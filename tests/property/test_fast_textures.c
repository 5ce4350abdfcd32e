/* The writers of textures (fast_texture_nearest.c, fast_texture_bilinear.c).
 * Each triangle is compared, byte for byte, with the same one drawn in parts,
 * which core draws by colors without the writers; of bilinear ones the test
 * works out these colors itself. Pictures are of every kind and of odd sizes, u
 * and v go up to two pictures beyond them, runs are up to 70 px long. The
 * memory of a picture is as large as the picture, so that a sanitizer sees what
 * is read beside it. */
#include <stdlib.h>
#include <string.h>

#include "core/format/argb8888.h"
#include "drivers/crc.h"
#include "tests/support/check.h"
#include "tests/support/layouts.h"
#include "tests/support/paint_math.h"
#include "tests/support/shapes.h"

enum { WIDTH = 96, HEIGHT = 64, LINE = WIDTH * 4 + 12 };

/* By the index of layouts[]: rgb565_le, rgb565_be, bgr565_le, xrgb8888, gray8;
 * then argb8888, and arrays of colors with and without alpha. */
static const int layouts_of[] = {0, 1, 2, 6, 11};
enum { LAYOUTS = 5, ARGB = LAYOUTS, COLORS, OPAQUE_COLORS, KINDS };

struct picture {
    int kind, width, height;
    bool upside_down;
    int wide;        /* bytes from line to line beyond the texels */
    uint8_t *memory; /* of malloc */
    struct pel_surface surface;
    struct pel_texels texels;
    uint8_t wrap_u, wrap_v;
};

static const struct pel_format *format_of(const struct picture *p)
{
    return p->kind >= ARGB ? &pel_argb8888
                           : layouts[layouts_of[p->kind]].format;
}

static void picture_open(struct picture *p, struct random *r)
{
    const int line = pel_stride(format_of(p), p->width);
    const int stride = p->kind >= COLORS ? line : line + p->wide;
    const size_t size = (size_t)(stride * (p->height - 1) + line);
    p->memory = malloc(size);
    assert_non_null(p->memory);
    for (size_t i = 0; i < size; i++)
        p->memory[i] = (uint8_t)(random_word(r) >> 24);
    if (p->kind == OPAQUE_COLORS)
        for (size_t i = 3; i < size; i += 4)
            p->memory[i] = 255;
    const struct pel_rect bounds = {-3, 5, p->width - 3, p->height + 5};
    p->texels = (struct pel_texels){&p->surface, NULL, 0, 0, false};
    if (p->kind >= COLORS)
        p->texels = (struct pel_texels){NULL, (const void *)p->memory, p->width,
                                        p->height, p->kind == OPAQUE_COLORS};
    else
        assert_int_equal(
            pel_surface_init_rect(
                &p->surface, format_of(p),
                p->memory + (p->upside_down ? stride * (p->height - 1) : 0),
                p->upside_down ? -stride : stride, &bounds),
            PEL_OK);
}

struct target {
    uint8_t memory[HEIGHT * LINE];
    struct pel_surface surface;
};

static struct target whole, parts;

/* Targets are of the layouts alone. */
static void target_open(struct target *t, const struct pel_format *format)
{
    const struct pel_rect bounds = {-16, -8, WIDTH - 16, HEIGHT - 8};
    for (int i = 0; i < HEIGHT * LINE; i++)
        t->memory[i] = (uint8_t)(i * 7);
    assert_int_equal(
        pel_surface_init_rect(&t->surface, format, t->memory, LINE, &bounds),
        PEL_OK);
}

struct drawing {
    struct pel_point v[3];
    struct pel_texture_map map;
    int layout; /* of the target: index of layouts_of[] */
    bool bilinear;
};

static struct pel_texture texture_of(const struct picture *p,
                                     const struct drawing *d)
{
    struct pel_texture t;
    assert_int_equal((d->bilinear
                          ? pel_texture_init_bilinear
                          : pel_texture_init_nearest)(&t, &p->texels, &d->map),
                     PEL_OK);
    t.wrap_u = p->wrap_u;
    t.wrap_v = p->wrap_v;
    return t;
}

static pel_color texel_at(const struct pel_texture *t, int64_t u, int64_t v)
{
    pel_color color;
    u = texel_index(u, t->width, t->wrap_u);
    v = texel_index(v, t->height, t->wrap_v);
    if (!t->surface)
        memcpy(&color, t->memory + v * t->stride + 4 * u, 4);
    else
        t->surface->format->load(t->surface, (int32_t)u + t->surface->bounds.x0,
                                 (int32_t)v + t->surface->bounds.y0, 1, &color);
    return color;
}

/* A place in 1/256 texel from the middle of texel 0, rounded. */
static int64_t place(const struct pel_plane *p, int32_t x, int32_t y)
{
    const uint64_t at = p->at + p->dx * (uint64_t)x + p->dy * (uint64_t)y;
    return ((int64_t)at - (INT64_C(1) << 31) + (1 << 23)) >> 24;
}

/* Bilinear textures channel by channel, as paint_texture.h has them. */
static void bilinear_colors(const struct pel_color_paint *paint, int32_t x,
                            int32_t y, int32_t n, pel_color *colors)
{
    const struct pel_texture *t = (const void *)paint;
    for (int32_t i = 0; i < n; i++) {
        const int64_t u = place(&t->map.u, x + i, y);
        const int64_t v = place(&t->map.v, x + i, y);
        const uint32_t fu = u & 255, fv = v & 255;
        const uint32_t weight[4] = {(256 - fu) * (256 - fv), fu * (256 - fv),
                                    (256 - fu) * fv, fu * fv};
        colors[i] = 0;
        for (int k = 0; k < 32; k += 8) {
            uint32_t sum = 32768;
            for (int j = 0; j < 4; j++)
                sum += weight[j] *
                       (texel_at(t, (u >> 8) + j % 2, (v >> 8) + j / 2) >> k &
                        255);
            colors[i] |= sum >> 16 << k;
        }
    }
}

/* In four parts, nearest ones by core's own colors, bilinear ones by those
 * above. */
static void draw_parts(struct target *t, const struct drawing *d,
                       const struct pel_texture *texture, int32_t x, int32_t y)
{
    const struct pel_rect all = t->surface.bounds;
    struct pel_texture plain = *texture;
    plain.base.paint.fill = pel_color_paint_fill;
    if (d->bilinear)
        plain.base.colors = bilinear_colors;
    for (int i = 0; i < 4; i++) {
        const struct pel_rect clip = {i & 1 ? x : all.x0, i & 2 ? y : all.y0,
                                      i & 1 ? all.x1 : x, i & 2 ? all.y1 : y};
        pel_surface_clip(&t->surface, &clip);
        pel_triangle(&t->surface, d->v, &plain.base.paint);
    }
}

static void check(const struct picture *p, const struct drawing *d,
                  struct random *r)
{
    const struct layout *l = &layouts[layouts_of[d->layout]];
    const struct pel_texture t = texture_of(p, d);
    target_open(&whole, l->format);
    target_open(&parts, l->format);
    pel_triangle(&whole.surface, d->v, &t.base.paint);
    draw_parts(&parts, d, &t, random_between(r, -16, WIDTH - 17),
               random_between(r, -8, HEIGHT - 9));
    if (memcmp(whole.memory, parts.memory, sizeof whole.memory))
        fail_msg("kind %d, %dx%d, wrap %d %d, on %s, bilinear %d, "
                 "%d,%d %d,%d %d,%d: bytes differ; %s",
                 p->kind, p->width, p->height, p->wrap_u, p->wrap_v, l->name,
                 d->bilinear, d->v[0].x, d->v[0].y, d->v[1].x, d->v[1].y,
                 d->v[2].x, d->v[2].y, cases_replay());
}

static void open_random_picture(struct picture *p, struct random *r)
{
    static const int16_t size[][2] = {{451, 300}, {256, 256}, {64, 32}, {1, 1},
                                      {1, 7},     {5, 3},     {2, 2},   {64, 5},
                                      {7, 128},   {20000, 2}};
    const uint32_t i = random_word(r) % 10;
    p->kind = (int)(random_word(r) % KINDS);
    p->width = size[i][0];
    p->height = size[i][1];
    p->upside_down = random_word(r) % 4 == 0;
    p->wide = 0;
    if (random_word(r) % 2)
        p->wide = random_word(r) % 8 && p->height < 100 ? 12 : 160000;
    p->wrap_u = (uint8_t)(random_word(r) % 3);
    p->wrap_v = (uint8_t)(random_word(r) % 3);
    picture_open(p, r);
}

/* Pictures are large, so 16 cases share one; by its number, so that one of them
 * alone sees the same. *opened is the number of the open one, UINT64_MAX before
 * the first. */
static void open_picture_of(struct picture *p, uint64_t *opened,
                            uint64_t number)
{
    if (*opened == number)
        return;
    struct random r = cases_shared(number);
    free(p->memory);
    open_random_picture(p, &r);
    *opened = number;
}

/* u and v inside the picture, or from -2 to 3 pictures. */
static void set_random_map(struct drawing *d, const struct picture *p,
                           struct random *r)
{
    const bool inside = random_word(r) % 2;
    const int32_t w = p->width * 256, h = p->height * 256;
    struct pel_texel_point t[3];
    for (int i = 0; i < 3; i++) {
        t[i].u =
            inside ? random_between(r, 0, w) : random_between(r, -2 * w, 3 * w);
        t[i].v =
            inside ? random_between(r, 0, h) : random_between(r, -2 * h, 3 * h);
    }
    assert_int_equal(pel_texture_map_triangle(&d->map, d->v, t), PEL_OK);
}

TEST(random_triangles)
{
    const struct pel_rect box = {-16, -8, WIDTH - 17, HEIGHT - 9};
    struct picture p = {0};
    uint64_t opened = UINT64_MAX;
    for (struct cases c = cases_of(12000); cases_next(&c);) {
        struct random *r = &c.random;
        struct drawing d;
        open_picture_of(&p, &opened, (c.next - 1) / 16);
        shape_in_box(r, d.v, 3, &box);
        if (random_word(r) % 4 == 0)
            d.v[1].y = d.v[random_word(r) % 2 * 2].y;
        set_random_map(&d, &p, r);
        d.layout = (int)(random_word(r) % LAYOUTS);
        d.bilinear = random_word(r) % 2;
        check(&p, &d, r);
    }
    free(p.memory);
}

/* With and without the vectors of 64-bit CPUs. A change of what the cases are
 * changes the number. */
TEST(every_build_draws_the_same)
{
    const struct pel_rect box = {-16, -8, WIDTH - 17, HEIGHT - 9};
    uint32_t crc = 0;
    for (uint64_t i = 0; i < 200; i++) {
        struct random r = {i * i};
        struct picture p;
        struct drawing d = {.layout = (int)(i % LAYOUTS), .bilinear = i & 8};
        open_random_picture(&p, &r);
        shape_in_box(&r, d.v, 3, &box);
        set_random_map(&d, &p, &r);
        check(&p, &d, &r);
        crc = pel_crc(crc, whole.memory, sizeof whole.memory);
        free(p.memory);
    }
    assert_int_equal(crc, 0xE5520404);
}

/* Texel by pixel, one way round or the other: the first row shows a line of the
 * picture from end to end, or one texel more or less. */
static void set_unit_map(struct drawing *d, const struct picture *p, bool back,
                         int32_t more)
{
    const uint64_t one = UINT64_C(1) << 32;
    const struct pel_texture_map forth = PEL_TEXTURE_AT(0, 0);
    d->map = forth;
    d->map.u.at += (uint64_t)(int64_t)more * one;
    if (back) {
        d->map.u.at = (uint64_t)(int64_t)p->width * one - one / 2 +
                      (uint64_t)(int64_t)more * one;
        d->map.u.dx = 0 - one;
    }
}

static void check_width(struct picture *p, struct drawing *d, int32_t width,
                        struct random *r)
{
    d->v[0] = (struct pel_point){128, 128};
    d->v[1] = (struct pel_point){PEL_PX(width) + 128, 128};
    d->v[2] = (struct pel_point){128 + PEL_PX(width) / 2, PEL_PX(3) + 128};
    for (int i = 0; i < 3 * 2 * 2; i++) {
        set_unit_map(d, p, i & 1, i / 4 - 1);
        d->bilinear = i >> 1 & 1;
        check(p, d, r);
    }
}

TEST(every_length)
{
    struct random r = {5};
    for (int kind = 0; kind < KINDS; kind++)
        for (int width = 1; width <= (PEL_FAST_FILLS ? 70 : 7); width++) {
            struct picture p = {.kind = kind, .width = width, .height = 4};
            struct drawing d;
            picture_open(&p, &r);
            for (d.layout = 0; d.layout < LAYOUTS; d.layout++)
                for (p.wrap_u = 0; p.wrap_u < 3; p.wrap_u++)
                    check_width(&p, &d, width, &r);
            free(p.memory);
        }
}

static void colors_fail(const struct pel_color_paint *paint, int32_t x,
                        int32_t y, int32_t n, pel_color *colors)
{
    (void)paint;
    (void)n;
    (void)colors;
    fail_msg("%d,%d: the writer was not taken", x, y);
}

/* The writers are there for speed: the pictures on xrgb8888 that they are made
 * for must not be drawn without them. */
TEST(writers_are_taken)
{
    static const struct {
        int8_t kind;
        bool bilinear;
    } made[] = {{3, false},
                {OPAQUE_COLORS, false},
                {0, true},
                {3, true},
                {OPAQUE_COLORS, true}};
    struct random r = {6};
    for (size_t i = 0;
         PEL_FAST_FILLS && PEL_VECTORS && i < sizeof made / sizeof *made; i++) {
        struct picture p = {.kind = made[i].kind, .width = 64, .height = 64};
        struct drawing d = {.v = {PEL_AT(1, 1), PEL_AT(60, 2), PEL_AT(3, 50)},
                            .map = PEL_TEXTURE_AT(-1, -1),
                            .bilinear = made[i].bilinear};
        picture_open(&p, &r);
        target_open(&whole, layouts[layouts_of[3]].format);
        struct pel_texture t = texture_of(&p, &d);
        t.base.colors = colors_fail;
        pel_triangle(&whole.surface, d.v, &t.base.paint);
        free(p.memory);
    }
}
