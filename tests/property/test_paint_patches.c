/* Radial and conic fills of many rows: every pixel is what the paint's colours
 * say of that pixel alone (patches change no byte), and the polynomials of
 * patches keep their bounds. */
#include "core/paint/paint_conic.h"
#include "core/paint/paint_radial.h"
#include "core/paint/patch.h"
#include "core/paint/ramp_lanes.h"
#include "core/raster/rectangle.h"
#include "core/raster/triangle.h"
#include "core/round/circle.h"
#include "core/round/ring.h"
#include "tests/support/canvas.h"
#include "tests/support/check.h"
#include "tests/support/hits.h"
#include "tests/support/paint_cells.h"
#include "tests/support/shapes.h"

static struct pel_radial radial_paint;
static struct pel_conic conic_paint;

/* From inside the bounds to far outside; half of them on the lattice of half
 * pixels, where radial gradients are mirror images. */
static int32_t random_center(struct random *r, int32_t from, int32_t to)
{
    const int32_t reach = 1 << random_between(r, 0, 14);
    int32_t at = random_between(r, PEL_PX(from - reach), PEL_PX(to + reach));
    if (random_word(r) % 2)
        at &= ~127;
    return pel_max(PEL_COORDINATE_MIN, pel_min(PEL_COORDINATE_MAX, at));
}

/* Of cells that tell themselves, or of colours with alpha. */
static struct pel_ramp random_ramp(struct random *r)
{
    static pel_color colors[300];
    struct pel_ramp ramp = cells_random(r);
    if (random_word(r) % 2 || ramp.n > 300)
        return ramp;
    for (int32_t i = 0; i < ramp.n; i++)
        colors[i] = random_word(r);
    ramp.colors = colors;
    return ramp;
}

static struct pel_color_paint *random_paint(struct random *r,
                                            const struct pel_rect *b)
{
    const struct pel_point center = {random_center(r, b->x0, b->x1),
                                     random_center(r, b->y0, b->y1)};
    const struct pel_ramp ramp = random_ramp(r);
    const uint16_t phase = (uint16_t)(random_word(r) % 2 ? random_word(r) : 0);
    struct pel_rings rings = {center, 0, phase};
    rings.radius =
        random_between(r, 256, PEL_PX(1 << random_between(r, 1, 14)));
    if (random_word(r) % 2) {
        assert_int_equal(pel_conic_init(&conic_paint, center, phase, &ramp),
                         PEL_OK);
        return &conic_paint.base;
    }
    assert_int_equal(pel_radial_init(&radial_paint, &rings, &ramp), PEL_OK);
    return &radial_paint.base;
}

static struct pel_rect random_bounds(struct random *r)
{
    const int32_t reach = random_word(r) % 4 ? 300 : 32500;
    struct pel_rect b;
    b.x0 = random_between(r, -reach, reach) & ~7;
    b.y0 = random_between(r, -reach, reach) & ~7;
    b.x1 = b.x0 + random_between(r, 1, 260);
    b.y1 = b.y0 + random_between(r, 1, 90);
    return b;
}

static void draw(const struct pel_surface *s, const struct pel_point v[3],
                 uint32_t shape, const struct pel_paint *p)
{
    const struct pel_rect *b = &s->bounds;
    const struct pel_point from = {PEL_PX(b->x0), PEL_PX(b->y0)};
    const struct pel_point to = {PEL_PX(b->x1), PEL_PX(b->y1)};
    const struct pel_ring_shape ring = {v[0], v[1].y & 4095, v[1].x & 32767};
    if (shape == 0)
        pel_triangle(s, v, p);
    else if (shape == 1)
        pel_circle(s, v[0], v[1].x & 32767, p);
    else if (shape == 2)
        pel_ring(s, &ring, p);
    else
        pel_rectangle(s, from, to, p);
}

static void check_pixels(const struct canvas *c, const struct hits *h,
                         const struct pel_color_paint *p)
{
    const struct pel_rect *b = &c->surface.bounds;
    for (int32_t y = b->y0; y < b->y1; y++)
        for (int32_t x = b->x0; x < b->x1; x++) {
            uint32_t want = canvas_pixel_before(c, x, y);
            pel_color source;
            p->colors(p, x, y, 1, &source);
            if (hits_at(h, x, y))
                want = layout_over(c->layout, want, source);
            if (canvas_pixel(c, x, y) != want)
                fail_msg("%s, pixel %d,%d: colour %08x, expected %x, got %x; "
                         "%s",
                         c->layout->name, x, y, source, want,
                         canvas_pixel(c, x, y), cases_replay());
        }
    canvas_check(c);
}

static void test_pixels(void **state)
{
    (void)state;
    static struct canvas canvas;
    static struct hits hits;
    for (struct cases c = cases_of(4000); cases_next(&c);) {
        struct random *r = &c.random;
        const struct pel_rect b = random_bounds(r);
        const uint32_t shape = random_word(r) % 5;
        const struct layout *layout = &layouts[random_word(r) % LAYOUT_COUNT];
        struct pel_color_paint *p = random_paint(r, &b);
        struct pel_point v[3];
        if (random_word(r) % 2)
            layout = layout_of(&pel_xrgb8888);
        shape_in_box(r, v, 3, &b);
        canvas_open(&canvas, layout->format, &b,
                    random_word(r) % CANVAS_STYLES);
        hits_open(&hits, &b);
        draw(&canvas.surface, v, shape, &p->paint);
        draw(&hits.surface, v, shape, &hits.paint);
        check_pixels(&canvas, &hits, p);
    }
}

#if PEL_PATCHES

enum { WIDTH = 32, ROWS = 16 };

static pel_color row_colors[WIDTH];
static uint64_t row_positions[WIDTH];

/* A curve's run function that keeps positions. */
static void keep(const void *mixer, const struct pel_ramp_walk *walk,
                 pel_color *colors)
{
    (void)mixer;
    struct pel_ramp_walk w = *walk;
    for (int32_t i = 0; i < w.n; i++, pel_ramp_step(&w))
        row_positions[colors - row_colors + i] = w.at;
}

static uint64_t value_at(const struct pel_taylor *t, int32_t right,
                         int32_t below)
{
    const uint64_t u = (uint64_t)(int64_t)right, v = (uint64_t)(int64_t)below;
    return t->at + t->x * u + t->y * v + t->xx * u * u + t->xy * u * v +
           t->yy * v * v + t->xxx * u * u * u + t->xxy * u * u * v +
           t->xyy * u * v * v + t->yyy * v * v * v;
}

static uint64_t magnitude(uint64_t difference)
{
    return difference >> 63 ? 0 - difference : difference;
}

/* A patch, and what its polynomial is near to. */
struct subject {
    const struct pel_patchwork *work;
    struct pel_point middle,
        way; /* the pixel, and its centre from the curve's */
    int size;
    struct pel_taylor t;
};

static struct pel_point corner_of(int size)
{
    return (struct pel_point){-(WIDTH / 2 >> size), -(ROWS / 2 >> size)};
}

/* Nearer to what curve.h gives than it says. */
static void check_error(const struct subject *s)
{
    const struct pel_color_paint *p = s->work->paint;
    const struct pel_point at = corner_of(s->size);
    for (int32_t v = at.y; v < -at.y; v++) {
        p->colors(p, s->middle.x + at.x, s->middle.y + v, -2 * at.x,
                  row_colors);
        for (int32_t u = at.x; u < -at.x; u++) {
            const uint64_t got = value_at(&s->t, u, v);
            const uint64_t off = magnitude(got - row_positions[u - at.x]);
            if (off >= s->t.error ||
                (s->t.reach && magnitude(got - s->t.at) >= s->t.reach))
                fail_msg("size %d, pixel %d,%d, %d,%d from it: off by %llu of "
                         "%llu, reach %llu; %s",
                         s->size, s->middle.x, s->middle.y, u, v,
                         (unsigned long long)off,
                         (unsigned long long)s->t.error,
                         (unsigned long long)s->t.reach, cases_replay());
        }
    }
}

/* Nearer to the exact value than the rest of Taylor's series, |w|^4 / (8 (r -
 * |w|)^3) px of distance or (|w| / r)^4 / 4 (1 - |w| / r) radians, and
 * rounding: 1/16,384 px and a bit, 2^-24 turns. */
static void check_exact(const struct subject *s, real unit, bool conic)
{
    const struct pel_point at = corner_of(s->size);
    const real x0 = s->way.x / 256.0L, y0 = s->way.y / 256.0L;
    const real r = real_root(x0 * x0 + y0 * y0), turn = real_turn(x0, y0);
    for (int32_t v = at.y; v < -at.y; v++)
        for (int32_t u = at.x; u < -at.x; u++) {
            const real x = x0 + u, y = y0 + v;
            const real square = (real)(u * u + v * v), w = real_root(square);
            const uint64_t got = value_at(&s->t, u, v) - s->t.at;
            real off = (int64_t)got / unit, bound;
            if (conic) {
                off -= real_turn(x, y) - turn;
                off -= real_round(off);
                bound =
                    square * square / (r * r * r) / (r - w) / 4 / 6.2831853L +
                    0x1p-24L;
            } else {
                off -= real_root(x * x + y * y) - r;
                bound = square * square / ((r - w) * (r - w) * (r - w)) / 8 +
                        0x1.4p-14L;
            }
            if (real_abs(off) > bound)
                fail_msg("size %d, pixel %d,%d, %d,%d from it: off by %Lg of "
                         "%Lg; %s",
                         s->size, s->middle.x, s->middle.y, u, v, off, bound,
                         cases_replay());
        }
}

/* The grid's lanes are the polynomial less its error, rounded down. */
static void check_lanes(const struct subject *s)
{
    const struct pel_point at = corner_of(s->size);
    const uint64_t error = s->t.error << (64 - s->work->curve->bits) >> 32;
    struct pel_grid g;
    const bool few = pel_patch_grid(s->work, s->way, s->size, &g);
    if (few ? error > UINT32_MAX / 256 / 64 : error < UINT32_MAX / 256 / 512)
        fail_msg("an error of %llu in 2^-32 of the way: %s grid; %s",
                 (unsigned long long)error, few ? "a" : "no", cases_replay());
    if (!few)
        return;
    const int shift = (g.padded ? 62 : 64) - s->work->curve->bits;
    assert_int_equal(g.width, -2 * at.x);
    for (int32_t v = at.y; v < -at.y; v++, pel_grid_next(&g)) {
        struct pel_lanes l = g.row[0];
        for (int32_t u = at.x; u < -at.x; u += 4) {
            const pel_u32x4 four = pel_lanes_next(&l);
            for (int i = 0; i < 4; i++) {
                const uint64_t exact = value_at(&s->t, u + i, v) - s->t.error;
                const uint64_t off =
                    (exact << shift) - ((uint64_t)four[i] << 32);
                if (off >> 32 >= PEL_GRID_ERROR)
                    fail_msg("size %d, %d,%d from the middle: lane %08x, "
                             "position %016llx; %s",
                             s->size, u + i, v, four[i],
                             (unsigned long long)(exact << shift),
                             cases_replay());
            }
        }
    }
}

/* A pixel from which the centre is at least as far away as patches of this size
 * must be, and often just so. */
static struct pel_point random_middle(struct random *r, struct pel_point center,
                                      int size)
{
    const real least = real_root((real)pel_patch_far[size]);
    for (;;) {
        const real x = random_between(r, -1000, 1000);
        const real y = random_between(r, -1000, 1000);
        const real more = random_between(r, 1, 1000) / 1000.0L;
        const real far = least * (1 + more * (1 << random_word(r) % 7));
        const real scale = far / (real_root(x * x + y * y) + 1);
        const struct pel_point p = {
            pel_pixel_of(center.x + (int32_t)(x * scale)),
            pel_pixel_of(center.y + (int32_t)(y * scale))};
        const real dx = (real)pel_pixel_center(p.x) - center.x;
        const real dy = (real)pel_pixel_center(p.y) - center.y;
        if (dx * dx + dy * dy >= pel_patch_far[size])
            return p;
    }
}

static struct pel_taylor any;

static void give_any(const struct pel_curve *curve, int32_t x, int32_t y,
                     int size, struct pel_taylor *t)
{
    (void)curve;
    (void)x;
    (void)y;
    (void)size;
    *t = any;
}

static uint64_t random_long(struct random *r)
{
    return (uint64_t)random_word(r) << 32 | random_word(r);
}

/* Lanes are as much too small as they may be, and no more. */
static void test_lanes(void **state)
{
    (void)state;
    const struct pel_ramp ramp = cells_ramp(2, PEL_REPEAT);
    const struct pel_point center = {0, 0};
    struct pel_conic *const q = &conic_paint;
    const struct pel_patchwork work = {&q->base, &q->curve, &q->ramp,
                                       give_any, NULL,      false};
    pel_conic_init(q, center, 0, &ramp);
    for (struct cases c = cases_of(2000); cases_next(&c);) {
        struct random *r = &c.random;
        struct subject s;
        s.work = &work;
        s.size = (int)(random_word(r) % PEL_PATCH_SIZES);
        s.way = s.middle = center;
        any = (struct pel_taylor){
            random_long(r), random_long(r), random_long(r), random_long(r),
            random_long(r), random_long(r), random_long(r), random_long(r),
            random_long(r), random_long(r), random_word(r), 0};
        s.t = any;
        check_lanes(&s);
    }
}

static void test_polynomials(void **state)
{
    (void)state;
    for (struct cases c = cases_of(6000); cases_next(&c);) {
        struct random *r = &c.random;
        const struct pel_ramp ramp = cells_ramp(2, PEL_REPEAT);
        const struct pel_rings rings = {
            {random_between(r, -70000, 70000), random_between(r, -999, 999)},
            random_between(r, PEL_PX(100),
                           PEL_PX(1 << random_between(r, 8, 14))),
            (uint16_t)random_word(r)};
        struct pel_radial *const p = &radial_paint;
        struct pel_conic *const q = &conic_paint;
        struct pel_patchwork work = {&p->base,          &p->curve, &p->ramp,
                                     pel_radial_taylor, NULL,      true};
        struct subject s;
        s.work = &work;
        s.size = (int)(random_word(r) % PEL_PATCH_SIZES);
        s.middle = random_middle(r, rings.center, s.size);
        s.way.x = pel_pixel_center(s.middle.x) - rings.center.x;
        s.way.y = pel_pixel_center(s.middle.y) - rings.center.y;
        pel_radial_init(p, &rings, &ramp);
        p->curve.run = keep;
        pel_radial_taylor(&p->curve, s.way.x, s.way.y, s.size, &s.t);
        check_error(&s);
        check_exact(&s, (real)p->scale * 16384, false);
        if (random_word(r) % 2)
            p->ramp.spread = PEL_PAD;
        check_lanes(&s);
        pel_conic_init(q, rings.center, rings.phase, &ramp);
        q->curve.run = keep;
        work = (struct pel_patchwork){&q->base,         &q->curve, &q->ramp,
                                      pel_conic_taylor, NULL,      false};
        pel_conic_taylor(&q->curve, s.way.x, s.way.y, s.size, &s.t);
        check_error(&s);
        check_exact(&s, 0x1p64L, true);
        check_lanes(&s);
    }
}

#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pixels),
#if PEL_PATCHES
        cmocka_unit_test(test_polynomials),
        cmocka_unit_test(test_lanes),
#endif
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
