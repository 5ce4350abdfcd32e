/* What changes no byte: bands and tiles, clipping, vertex order, translation,
 * stride and direction of lines, and the build of core. And what every byte
 * must be, in every format: the source packed, or blended by the rule, of
 * smooth shapes what a mask of their coverage shows. Every shape and outline,
 * path and stroke, smooth shapes and Gouraud triangles, on fenced canvases. */
#include <string.h>

#include "drivers/crc.h"
#include "tests/support/any_shape.h"
#include "tests/support/canvas.h"
#include "tests/support/check.h"
#include "tests/support/hits.h"
#include "tests/support/shapes.h"

static struct canvas whole, other;
static struct hits hits;

struct drawing {
    struct any_shape shape;
    enum { FILL, OUTLINE, SMOOTH, GOURAUD } what;
    pel_color color[3]; /* color[0] alone but for Gouraud */
};

static pel_color random_color(struct random *r, bool opaque)
{
    const pel_color c = random_word(r);
    const uint32_t kind = random_word(r) % 4;
    if (opaque || kind < 2)
        return c | 0xFF000000u;
    return kind == 2 ? c : c & 0x00FFFFFFu;
}

static struct drawing random_drawing(struct random *r, bool opaque)
{
    struct drawing d;
    const struct pel_rect bounds = shape_bounds(r, 40, 40);
    const unsigned style = random_word(r) % CANVAS_STYLES;
    canvas_open(&whole, layouts[random_word(r) % LAYOUT_COUNT].format, &bounds,
                style);
    const uint32_t kind = random_word(r) % (ANY_KINDS + 2);
    const uint32_t what = random_word(r) % 8;
    d.what = kind >= ANY_KINDS ? GOURAUD
             : what < 2        ? OUTLINE
             : what < 5        ? SMOOTH
                               : FILL;
    any_in_box(r, &d.shape,
               kind < ANY_KINDS ? (enum any_kind)kind : ANY_TRIANGLE, &bounds);
    for (int i = 0; i < 3; i++)
        d.color[i] = random_color(r, opaque);
    return d;
}

/* What it covers, through another paint. */
static void cover(const struct pel_surface *surface, const struct drawing *d,
                  const struct pel_paint *paint)
{
    if (d->what == SMOOTH && any_draw_smooth(surface, &d->shape, paint))
        return;
    (d->what == OUTLINE ? any_draw_outline : any_draw)(surface, &d->shape,
                                                       paint);
}

static void draw(const struct pel_surface *surface, const struct drawing *d)
{
    const struct pel_flat flat = PEL_FLAT(d->color[0]);
    if (d->what == GOURAUD)
        pel_triangle_gouraud(surface, d->shape.v, d->color);
    else
        cover(surface, d, &flat.paint);
}

static void check_tile(const struct drawing *d, const struct pel_rect *tile,
                       unsigned style)
{
    canvas_open(&other, whole.layout->format, tile, style);
    draw(&other.surface, d);
    canvas_check_part(&whole, &other);
}

/* Columns and rows where a tile of any format may begin: all, or every 8th. */
static int32_t next_cut(struct random *r, int32_t from, int32_t end,
                        bool aligned)
{
    int32_t cut = from + random_between(r, 1, 24);
    if (aligned)
        cut = (cut + 7) & ~7;
    return pel_min(cut, end);
}

TEST(tiles_equal_the_whole)
{
    for (struct cases c = cases_of(60000); cases_next(&c);) {
        struct random *r = &c.random;
        struct drawing d = random_drawing(&c.random, false);
        const struct pel_rect b = whole.surface.bounds;
        bool aligned = whole.layout->bits < 8, bands = random_word(r) % 2;
        struct pel_rect t;
        draw(&whole.surface, &d);
        canvas_check(&whole);
        for (t.y0 = b.y0; t.y0 < b.y1; t.y0 = t.y1) {
            t.y1 = next_cut(r, t.y0, b.y1, aligned);
            for (t.x0 = b.x0; t.x0 < b.x1; t.x0 = t.x1) {
                t.x1 = bands ? b.x1 : next_cut(r, t.x0, b.x1, aligned);
                check_tile(&d, &t, random_word(r) % 8);
            }
        }
    }
}

TEST(clip_is_crop)
{
    for (struct cases c = cases_of(75000); cases_next(&c);) {
        struct drawing d = random_drawing(&c.random, false);
        const struct pel_rect b = whole.surface.bounds;
        const struct pel_rect clip = shape_clip(&c.random, &b);
        canvas_open(&other, whole.layout->format, &b,
                    random_word(&c.random) % 8);
        draw(&whole.surface, &d);
        pel_surface_clip(&other.surface, &clip);
        draw(&other.surface, &d);
        canvas_check_part(&whole, &other);
    }
}

/* The shape in white on black is its coverage. */
static void check_smooth(const struct drawing *d, const struct pel_flat *flat)
{
    static const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));
    static uint8_t gray[40 * 40];
    const struct pel_rect b = whole.surface.bounds;
    struct pel_surface mask;
    struct pel_masked masked;
    memset(gray, 0, sizeof gray);
    assert_int_equal(pel_surface_init(&mask, &pel_gray8, gray, sizeof gray, &b),
                     PEL_OK);
    cover(&mask, d, &white.paint);
    canvas_open(&other, whole.layout->format, &b, 0);
    assert_int_equal(pel_masked_init(&masked, &mask, b.x0, b.y0, &flat->paint),
                     PEL_OK);
    pel_box(&other.surface, &b, &masked.base.paint);
    canvas_check_same(&other, &whole);
}

/* Alpha 255: the source packed; 0: what was there; else the blend. */
static void check_bytes(const struct drawing *d)
{
    const struct pel_flat flat = PEL_FLAT(d->color[0]);
    if (d->what == SMOOTH) {
        check_smooth(d, &flat);
        return;
    }
    struct pel_gouraud gouraud;
    pel_gouraud_init(&gouraud, d->shape.v, d->color);
    hits_open(&hits, &whole.surface.bounds);
    cover(&hits.surface, d, &hits.paint);
    if (d->what == GOURAUD)
        canvas_check_drawn(&whole, &hits, canvas_gouraud, &gouraud);
    else
        canvas_check_drawn(&whole, &hits, canvas_flat, &flat);
}

TEST(bytes_follow_the_rule)
{
    for (struct cases c = cases_of(75000); cases_next(&c);) {
        struct drawing d = random_drawing(&c.random, c.next % 2);
        draw(&whole.surface, &d);
        check_bytes(&d);
    }
}

/* Every order of three; of polygons every start, in both directions. */
static struct drawing reordered(const struct drawing *d, int32_t i)
{
    struct drawing p = *d;
    const int32_t n = any_points(&d->shape);
    for (int32_t k = 0; k < n; k++) {
        const int32_t from = (i % 2 ? n - 1 - k : k) + i / 2;
        p.shape.v[k] = d->shape.v[from % n];
        if (d->what == GOURAUD)
            p.color[k] = d->color[from % n];
    }
    return p;
}

TEST(vertex_order_changes_nothing)
{
    for (struct cases c = cases_of(50000); cases_next(&c);) {
        const struct drawing d = random_drawing(&c.random, false);
        const struct pel_rect b = whole.surface.bounds;
        const enum any_kind kind = d.shape.kind;
        if (kind == ANY_RECTANGLE || kind == ANY_ROUNDED_RECTANGLE ||
            kind >= ANY_PATH)
            continue;
        draw(&whole.surface, &d);
        for (int32_t i = 1; i < 2 * any_points(&d.shape); i++) {
            const struct drawing p = reordered(&d, i);
            canvas_open(&other, whole.layout->format, &b,
                        (unsigned)i % CANVAS_STYLES);
            draw(&other.surface, &p);
            canvas_check_same(&whole, &other);
        }
    }
}

/* A shift by whole pixels that keeps it in range: of bits 3 and up,
 * so that tiles of every format may begin there. */
static int32_t random_shift(struct random *r, int32_t lo, int32_t hi)
{
    int32_t room_down = (lo - PEL_COORDINATE_MIN) / 2048;
    int32_t room_up = (PEL_COORDINATE_MAX - hi) / 2048;
    return 8 * random_between(r, -room_down, room_up);
}

/* Grows by the points. */
static void extend(struct pel_rect *e, const struct pel_point *v, int32_t n)
{
    for (; n > 0; n--, v++) {
        e->x0 = pel_min(e->x0, v->x);
        e->y0 = pel_min(e->y0, v->y);
        e->x1 = pel_max(e->x1, v->x);
        e->y1 = pel_max(e->y1, v->y);
    }
}

/* On all sides; false: beyond the range, where nothing may be drawn. */
static bool grow(struct pel_rect *e, int32_t by)
{
    e->x0 -= by;
    e->y0 -= by;
    e->x1 += by;
    e->y1 += by;
    return pel_points_legal(
        (struct pel_point[2]){{e->x0, e->y0}, {e->x1, e->y1}}, 2);
}

static void shift(struct pel_point *v, int32_t n, int32_t dx, int32_t dy)
{
    for (; n > 0; n--, v++) {
        v->x += PEL_PX(dx);
        v->y += PEL_PX(dy);
    }
}

/* A thick line is not drawn where one of its corners is out of range; smooth
 * ones may have square ends. */
static bool is_drawn(const struct drawing *d)
{
    const struct any_shape *const s = &d->shape;
    struct pel_point v[4];
    if (s->kind != ANY_THICK_LINE)
        return true;
    if (!pel_thick_line_corners(THICK(s), v))
        return false;
    const struct pel_point n = {v[0].x - s->v[0].x, v[0].y - s->v[0].y};
    for (int i = 0; i < 4 && d->what == SMOOTH; i++) {
        const int32_t sign = i == 1 || i == 2 ? 1 : -1;
        v[i].x += sign * n.y;
        v[i].y -= sign * n.x;
    }
    return pel_points_legal(v, 4);
}

TEST(translation_changes_nothing)
{
    for (struct cases c = cases_of(75000); cases_next(&c);) {
        struct drawing d = random_drawing(&c.random, false);
        struct pel_rect b = whole.surface.bounds;
        struct pel_rect e = {PEL_PX(b.x0), PEL_PX(b.y0), PEL_PX(b.x1) - 1,
                             PEL_PX(b.y1) - 1};
        extend(&e, d.shape.v, ANY_POINTS);
        if (!grow(&e, any_reach(&d.shape)))
            continue;
        int32_t dx = random_shift(&c.random, e.x0, e.x1);
        int32_t dy = random_shift(&c.random, e.y0, e.y1);
        b = (struct pel_rect){b.x0 + dx, b.y0 + dy, b.x1 + dx, b.y1 + dy};
        canvas_open(&other, whole.layout->format, &b,
                    random_word(&c.random) % 8);
        canvas_copy(&other, &whole);
        const bool drawn = is_drawn(&d);
        draw(&whole.surface, &d);
        shift(d.shape.v, ANY_POINTS, dx, dy);
        draw(&other.surface, &d);
        if (drawn == is_drawn(&d))
            canvas_check_same(&whole, &other);
    }
}

/* Clips with no pixel, far away or turned round: nothing is drawn. */
TEST(empty_clips)
{
    static const struct pel_rect clip[] = {
        {8388608, 0, 8388672, 64},
        {0, 0, -536870912, 64},
        {INT32_MAX, 0, INT32_MIN, 24},
        {0, INT32_MAX, 64, INT32_MIN},
        {INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN},
        {INT32_MIN, INT32_MIN, INT32_MIN, INT32_MIN},
        {40, 0, 20, 64},
        {0, 40, 64, 20},
    };
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        const struct drawing d = random_drawing(&c.random, false);
        pel_surface_clip(
            &whole.surface,
            &clip[random_word(&c.random) % (sizeof clip / sizeof *clip)]);
        draw(&whole.surface, &d);
        canvas_check(&whole);
    }
}

/* Core shows the same with and without the walk and the vectors of 64-bit CPUs,
 * whatever its knobs. A change of what the cases are changes the number. */
TEST(every_build_draws_the_same)
{
    uint32_t crc = 0;
    for (uint64_t i = 0; i < 5000; i++) {
        struct random r = {i * i};
        const struct drawing d = random_drawing(&r, i % 2);
        draw(&whole.surface, &d);
        crc = pel_crc(crc, whole.memory, whole.size);
    }
    assert_int_equal(crc, 0x6470C66D);
}
