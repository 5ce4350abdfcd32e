/* Ordered dither: the matrix, the levels, and what it leaves alone. */
#include "core/paint/paint_dither.h"
#include "core/paint/paint_linear.h"
#include "core/paint/paint_texture.h"
#include "core/round/circle.h"
#include "tests/support/canvas.h"
#include "tests/support/check.h"
#include "tests/support/shapes.h"

static struct canvas canvas;

/* The Bayer matrix by its bits: those of x ^ y and y, the lowest first. */
static uint32_t bayer(int32_t x, int32_t y)
{
    uint32_t value = 0;
    for (int bit = 0; bit < 3; bit++)
        value = value << 2 | ((uint32_t)(x ^ y) >> bit & 1) << 1 |
                ((uint32_t)y >> bit & 1);
    return value;
}

static bool has_few_levels(const struct layout *l)
{
    return l->bits <= 16 && l->format->id != PEL_FORMAT_GRAY8 && !l->inks;
}

/* What the format shows of a color that it has; grey for grey formats. */
static pel_color shown(const struct layout *l, pel_color c)
{
    return layout_unpack(l, layout_pack(l, c));
}

/* Of one channel of a color whose other channels are the same: the highest
 * value not above c that the format shows, and the lowest above. */
static void levels_around(const struct layout *l, int shift, uint32_t c,
                          uint32_t *low, uint32_t *high)
{
    uint32_t v = c;
    while ((shown(l, v * 0x010101) >> shift & 255) != v)
        v--;
    *low = v;
    for (v = c + 1; v < 255; v++)
        if ((shown(l, v * 0x010101) >> shift & 255) == v)
            break;
    *high = c < 255 ? v : 255;
}

static uint32_t dithered(const struct layout *l, int shift, uint32_t c,
                         int32_t x, int32_t y)
{
    uint32_t low, high;
    levels_around(l, shift, c, &low, &high);
    return (c - low) * 128 > (2 * bayer(x, y) + 1) * (high - low) ? high : low;
}

static pel_color dithered_color(const struct layout *l, pel_color c, int32_t x,
                                int32_t y)
{
    if (!has_few_levels(l))
        return c;
    const uint32_t gray = pel_gray(c);
    pel_color d = c & 0xFF000000;
    for (int shift = 0; shift < 24; shift += 8)
        d |= dithered(l, shift, l->gray ? gray : c >> shift & 255, x, y)
             << shift;
    return d;
}

static pel_color flat_at(const void *color, int32_t x, int32_t y)
{
    return dithered_color(canvas.layout, *(const pel_color *)color, x, y);
}

static void draw(const struct pel_paint *source)
{
    struct pel_dither d;
    assert_int_equal(pel_dither_init(&d, source), PEL_OK);
    pel_box(&canvas.surface, &canvas.surface.bounds, &d.paint);
}

static void check_flat(pel_color color)
{
    const struct pel_flat flat = PEL_FLAT(color);
    draw(&flat.paint);
    canvas_check_drawn(&canvas, NULL, flat_at, &color);
}

/* One color, any alpha, on any surface. */
TEST(flat)
{
    for (struct cases c = cases_of(1500); cases_next(&c);) {
        struct random *r = &c.random;
        const struct pel_rect b = shape_bounds(r, 40, 9);
        const pel_color color = random_word(r);
        canvas_open(&canvas, layouts[c.next % LAYOUT_COUNT].format, &b,
                    random_word(r) % CANVAS_STYLES);
        check_flat(random_word(r) % 2 ? color : color | 0xFF000000);
    }
}

/* Every grey: a level stays, and as each value of the matrix is there once, the
 * mean of 8 x 8 pixels is the color to 1/128 of a step. */
TEST(every_grey)
{
    const struct pel_rect b = {0, 0, 8, 8};
    uint64_t values = 0;
    for (int i = 0; i < 64; i++)
        values |= UINT64_C(1) << bayer(i % 8, i / 8);
    assert_true(values == UINT64_MAX);
    for (int i = 0; i < LAYOUT_COUNT; i++)
        for (uint32_t c = 0; c < 256; c++) {
            canvas_open(&canvas, layouts[i].format, &b, 0);
            check_flat(PEL_RGB(c, c, c));
        }
}

/* A paint that knows nothing but its fill function, and one with its own way
 * into xrgb8888: the same as what they show there, dithered. */
static void left_half(const struct pel_paint *paint,
                      const struct pel_spans *rows)
{
    (void)paint;
    for (int i = 0; i < rows->n; i++)
        for (int32_t x = rows->span[i].x0; x < rows->span[i].x1; x++) {
            const pel_color c = PEL_RGB(x * 5, 99, 255 - x);
            if (x < 20)
                rows->surface->format->put(rows->surface, x,
                                           rows->y + i * rows->step, 1, &c);
        }
}

/* Alpha 0 where the source has drawn nothing. */
static pel_color source_at(const void *exact, int32_t x, int32_t y)
{
    const pel_color shown = canvas_pixel(exact, x, y);
    return shown == canvas_pixel_before(exact, x, y)
               ? 0
               : dithered_color(canvas.layout, shown | 0xFF000000, x, y);
}

static void check_source(const struct layout *l, const struct pel_paint *source)
{
    static const struct pel_point center = PEL_AT(19, 11);
    static struct canvas exact;
    const struct pel_rect b = {0, 0, 40, 24}, box = {1, 15, 39, 23};
    struct pel_dither d;
    canvas_open(&exact, &pel_xrgb8888, &b, 0);
    canvas_open(&canvas, l->format, &b, 0);
    assert_int_equal(pel_dither_init(&d, source), PEL_OK);
    pel_circle(&exact.surface, center, PEL_PX(21), source);
    pel_box(&exact.surface, &box, source);
    pel_circle(&canvas.surface, center, PEL_PX(21), &d.paint);
    pel_box(&canvas.surface, &box, &d.paint);
    canvas_check_drawn(&canvas, NULL, source_at, &exact);
}

TEST(any_source)
{
    static const struct pel_paint half = {left_half, NULL};
    const struct pel_point v[3] = {PEL_AT(-200, -100), PEL_AT(300, -100),
                                   PEL_AT(30, 400)};
    const pel_color c[3] = {0xFFFF0000, 0xFF00FF80, 0xFF0020FF};
    static const struct pel_texture_map map = PEL_TEXTURE_AT(3, -2);
    static const struct pel_rect b = {0, 0, 32, 20};
    static struct canvas picture;
    const struct pel_texels texels = {.surface = &picture.surface};
    struct pel_texture texture;
    struct pel_gouraud gouraud;
    pel_gouraud_init(&gouraud, v, c);
    for (int i = 0; i < LAYOUT_COUNT; i++) {
        canvas_open(&picture, layouts[i].format, &b, 0);
        pel_texture_init_nearest(&texture, &texels, &map);
        check_source(&layouts[i], &texture.base.paint);
        check_source(&layouts[i], &half);
        check_source(&layouts[i], &gouraud.paint);
    }
}

/* Linear gradients of cells about 1/2 to 7 px wide, and one of narrower ones:
 * ends in sight, again and again, either way; and in each corner of the box. */
TEST(narrow_cells)
{
    static const struct pel_point ways[][2] = {
        {PEL_AT(5, 3), PEL_AT(130, 70)},
        {PEL_AT(130, 70), PEL_AT(5, 3)},
        {PEL_AT(12, 60), PEL_AT(140, -90)},
        {PEL_AT(30, 9), PEL_AT(-100, 0)},
        {PEL_AT(-300, 10), PEL_AT(25, 14)},
        {PEL_AT(20, 0), PEL_AT(1700, 200)},
        {PEL_AT(2, 0), PEL_AT(38, 0)},
        {PEL_AT(-1790, 0), PEL_AT(9, 0)},
        {PEL_AT(150, 60), PEL_AT(1.5, 15.5)},
        {PEL_AT(150, -30), PEL_AT(1.5, 22.5)},
        {PEL_AT(-110, 3), PEL_AT(38.5, 22.5)},
        {PEL_AT(-110, 40), PEL_AT(38.5, 15.5)}};
    static const pel_color colors[2] = {0xFF1080F0, 0xFFF0A010};
    for (size_t i = 0; i < sizeof ways / sizeof *ways; i++)
        for (int spread = PEL_PAD; spread <= PEL_REFLECT; spread++) {
            const struct pel_ramp ramp = {colors, 2, (enum pel_spread)spread};
            struct pel_linear linear;
            pel_linear_init(&linear, ways[i][0], ways[i][1], &ramp);
            for (int k = 0; k < LAYOUT_COUNT; k++)
                check_source(&layouts[k], &linear.base.paint);
        }
}

/* A paint that puts opaque colors and others in one call. */
static pel_color mixed_color(int32_t x, int32_t y)
{
    const uint32_t alpha = x % 11 < 7 ? 255 : (uint32_t)x * 53 & 255;
    return alpha << 24 | (PEL_RGB(x * 6, 99 + y * 4, 255 - x) & 0xFFFFFF);
}

static void put_mixed(const struct pel_paint *paint,
                      const struct pel_spans *rows)
{
    (void)paint;
    pel_color c[40];
    for (int32_t i = 0; i < rows->n; i++) {
        const struct pel_span row = rows->span[i];
        for (int32_t x = row.x0; x < row.x1; x++)
            c[x - row.x0] = mixed_color(x, rows->y + i);
        rows->surface->format->put(rows->surface, row.x0, rows->y + i,
                                   row.x1 - row.x0, c);
    }
}

static pel_color mixed_at(const void *paint, int32_t x, int32_t y)
{
    (void)paint;
    return dithered_color(canvas.layout, mixed_color(x, y), x, y);
}

TEST(mixed_alpha)
{
    static const struct pel_paint source = {put_mixed, NULL};
    static const struct pel_rect b = {0, 0, 40, 24};
    for (int i = 0; i < LAYOUT_COUNT; i++) {
        canvas_open(&canvas, layouts[i].format, &b, 0);
        draw(&source);
        canvas_check_drawn(&canvas, NULL, mixed_at, NULL);
    }
}

/* What a source is given: the shape's surface, but for its format, which keeps
 * colors. It colors its rows, then loads what is there. */
static void fill_and_load(const struct pel_paint *paint,
                          const struct pel_spans *rows)
{
    (void)paint;
    const struct pel_surface *s = rows->surface;
    const struct pel_span *row = rows->span;
    pel_color c[40];
    assert_int_equal(s->format->bits, 32);
    assert_int_equal(s->format->word, 4);
    assert_int_equal(s->format->id, 255);
    assert_memory_equal(&s->bounds, &canvas.surface.bounds, sizeof s->bounds);
    assert_memory_equal(&s->clip, &canvas.surface.clip, sizeof s->clip);
    s->format->fill(rows, s->format->pack(0xFF4080C0));
    s->format->load(s, row->x0, rows->y, row->x1 - row->x0, c);
    for (int32_t i = 0; i < row->x1 - row->x0; i++)
        assert_int_equal(canvas_pixel(&canvas, row->x0 + i, rows->y),
                         layout_pack(canvas.layout, c[i]));
}

/* A format of one's own, here of the depths of another, is dithered too. */
TEST(sources_surface)
{
    static const struct pel_paint source = {fill_and_load, NULL};
    static const struct pel_rect b = {0, 0, 40, 3};
    static const pel_color color = 0xFF4080C0;
    struct pel_format own = pel_rgb332;
    own.id = 200;
    canvas_open(&canvas, &pel_rgb332, &b, 0);
    canvas.surface.format = &own;
    draw(&source);
    canvas_check_drawn(&canvas, NULL, flat_at, &color);
}

/* A format of one's own: grey of any depth in 16 bits. */
static struct pel_format own;

static uint32_t own_pack(pel_color c)
{
    return pel_gray(c) >> (8 - own.depth[0]);
}

static void own_put(const struct pel_surface *s, int32_t x, int32_t y,
                    int32_t n, const pel_color *colors)
{
    uint16_t *row = (uint16_t *)(void *)pel_surface_line(s, y);
    for (int32_t i = 0; i < n; i++)
        row[x + i] = (uint16_t)own_pack(colors[i]);
}

/* What a level shows: its bits again and again. */
static uint32_t own_value(uint32_t level, uint32_t bits)
{
    uint64_t all = 0;
    for (uint32_t have = 0; have < 16; have += bits)
        all = all << bits | level;
    return (uint32_t)(all >> ((16 + bits - 1) / bits * bits - 8)) & 255;
}

/* Every channel at every place, where levels are from 255 to 2 apart. */
TEST(every_depth)
{
    static const struct pel_rect b = {0, 0, 20, 8};
    uint16_t pixels[8][20];
    struct pel_surface s;
    own = (struct pel_format){
        .id = 200, .bits = 16, .word = 2, .pack = own_pack, .put = own_put};
    assert_int_equal(pel_surface_init(&s, &own, pixels, sizeof pixels, &b),
                     PEL_OK);
    for (uint32_t bits = 1; bits <= 7; bits++)
        for (uint32_t c = 0, level = 0; c < 256; c++) {
            const struct pel_flat flat = PEL_FLAT(PEL_RGB(c, c, c));
            struct pel_dither d;
            own.depth[0] = (uint8_t)bits;
            pel_dither_init(&d, &flat.paint);
            pel_box(&s, &b, &d.paint);
            level += c == own_value(level + 1, bits);
            const uint32_t low = own_value(level, bits);
            const uint32_t step = own_value(level + 1, bits) - low;
            for (int32_t y = 0; y < 8; y++)
                for (int32_t x = 0; x < 20; x++)
                    assert_int_equal(pixels[y][x],
                                     level + ((c - low) * 128 >
                                              (2 * bayer(x, y) + 1) * step));
        }
}

/* Where a source became a dither later nothing is drawn. */
TEST(dither_of_dither)
{
    static const struct pel_rect b = {0, 0, 8, 8};
    const struct pel_flat flat = PEL_FLAT(0xFF4080C0);
    struct pel_dither d, e = {{NULL, NULL}, NULL};
    assert_int_equal(pel_dither_init(&d, &e.paint), PEL_OK);
    assert_int_equal(pel_dither_init(&e, &flat.paint), PEL_OK);
    for (int i = 0; i < LAYOUT_COUNT; i++) {
        canvas_open(&canvas, layouts[i].format, &b, 0);
        pel_box(&canvas.surface, &canvas.surface.bounds, &d.paint);
        assert_memory_equal(canvas.memory, canvas.before, canvas.size);
    }
}
