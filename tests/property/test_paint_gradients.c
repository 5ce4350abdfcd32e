/* Gradients: every pixel of random ones, on shapes, in every format, shows the
 * cell that exact arithmetic says; and a cell is the ring or the sector of the
 * same numbers. What a pixel shows is a function of the pixel alone, so bands,
 * tiles and clips change no byte. */
#include "core/pel.h"
#include "tests/support/any_paint.h"
#include "tests/support/canvas.h"
#include "tests/support/check.h"
#include "tests/support/hits.h"
#include "tests/support/paint_math.h"
#include "tests/support/shapes.h"

__extension__ typedef __int128 wide;

enum kind { LINEAR, RADIAL, CONIC, HUE, KINDS };

struct gradient {
    enum kind kind;
    struct pel_point at, to; /* from, or the centre */
    int32_t radius;
    uint16_t phase; /* or start */
    struct pel_ramp ramp;
    union any_paint u;
};

static pel_color colors[32767];
static struct canvas canvas;
static struct hits hits;

static wide floor_divide(wide n, wide d)
{
    return n / d - (n % d < 0);
}

static int32_t cells_of(const struct gradient *g)
{
    return g->kind == HUE ? 1536 : g->ramp.n == 2 ? 256 : g->ramp.n;
}

static wide linear_cell(const struct gradient *g, int32_t x, int32_t y)
{
    const wide dx = g->to.x - g->at.x, dy = g->to.y - g->at.y;
    const wide way = dx * (pel_pixel_center(x) - g->at.x) +
                     dy * (pel_pixel_center(y) - g->at.y);
    return floor_divide(way * cells_of(g), dx * dx + dy * dy);
}

/* The outer radius of ring k - 1. */
static wide ring_radius(const struct gradient *g, wide k)
{
    return k * g->radius / cells_of(g);
}

/* From a guess to the one ring that holds the pixel. */
static wide ring_at(const struct gradient *g, int32_t x, int32_t y)
{
    const wide u = pel_pixel_center(x) - g->at.x;
    const wide v = pel_pixel_center(y) - g->at.y, square = u * u + v * v;
    wide k = (wide)(real_root((real)square) * cells_of(g) / g->radius);
    while (k > 0 && square <= ring_radius(g, k) * ring_radius(g, k))
        k--;
    while (square > ring_radius(g, k + 1) * ring_radius(g, k + 1))
        k++;
    return k;
}

static int32_t sectors_of(const struct gradient *g)
{
    return g->kind == CONIC && g->ramp.spread == PEL_REFLECT ? 2 * cells_of(g)
                                                             : cells_of(g);
}

static uint16_t angle_of(const struct gradient *g, int64_t k)
{
    return (uint16_t)(g->phase + 65536 * k / sectors_of(g));
}

static wide cross(struct pel_point d, wide u, wide v)
{
    return d.x * v - d.y * u;
}

/* The rule of round/wedge.h, for sectors of up to a half turn. */
static bool in_sector(const struct gradient *g, int64_t k, wide u, wide v)
{
    const struct pel_point from = pel_direction(angle_of(g, k));
    const struct pel_point to = pel_direction(angle_of(g, k + 1));
    if (cross(from, u, v) == 0 && from.x * u + from.y * v > 0)
        return true;
    return cross(from, u, v) > 0 && cross(to, u, v) < 0;
}

static wide sector_at(const struct gradient *g, int32_t x, int32_t y)
{
    const int64_t n = sectors_of(g);
    int64_t u = pel_pixel_center(x) - g->at.x,
            v = pel_pixel_center(y) - g->at.y;
    if (u == 0 && v == 0)
        u = 1;
    if (n == 1)
        return 0;
    real turn = real_turn((real)u, (real)v) * 65536 - g->phase;
    int64_t k = (int64_t)((turn < 0 ? turn + 65536 : turn) * (real)n / 65536);
    for (int64_t i = k + 2 * n - 2; i <= k + 2 * n + 2; i++)
        if (in_sector(g, i % n, u, v))
            return i % n;
    fail_msg("no sector %ld of %ld; %s", (long)k, (long)n, cases_replay());
    return 0;
}

static wide number_at(const struct gradient *g, int32_t x, int32_t y)
{
    if (g->kind == LINEAR)
        return linear_cell(g, x, y);
    return g->kind == RADIAL ? ring_at(g, x, y) : sector_at(g, x, y);
}

static pel_color middle_color(pel_color a, pel_color b, uint32_t i)
{
    pel_color c = 0;
    for (int shift = 0; shift < 32; shift += 8)
        c |= ((a >> shift & 255) * (511 - 2 * i) +
              (b >> shift & 255) * (2 * i + 1) + 256) /
                 512
             << shift;
    return c;
}

static uint32_t hue_channel(const struct gradient *g, uint32_t part)
{
    const uint32_t whole = 255 * 512;
    const uint32_t s = g->u.wheel.s, v = g->u.wheel.v;
    return (v * (whole - s * part) + whole / 2) / whole;
}

static pel_color hue_color(const struct gradient *g, uint32_t cell)
{
    static const char order[6][4] = {"vtp", "tvp", "pvt", "ptv", "tpv", "vpt"};
    const uint32_t part = cell % 256 * 2 + 1, sixth = cell / 256;
    pel_color c = 255;
    for (int i = 0; i < 3; i++)
        c = c << 8 | (order[sixth][i] == 'v'   ? g->u.wheel.v
                      : order[sixth][i] == 'p' ? hue_channel(g, 512)
                      : sixth % 2              ? hue_channel(g, part)
                                               : hue_channel(g, 512 - part));
    return c;
}

static pel_color color_of(const struct gradient *g, wide k)
{
    const wide n = cells_of(g),
               period =
                   g->kind != HUE && g->ramp.spread == PEL_REFLECT ? 2 * n : n;
    if (g->kind == RADIAL)
        k += g->phase * n / 65536;
    if (g->kind < CONIC && g->ramp.spread == PEL_PAD)
        k = k < 0 ? 0 : k < n ? k : n - 1;
    k -= floor_divide(k, period) * period;
    k = k < n ? k : 2 * n - 1 - k;
    if (g->kind == HUE)
        return hue_color(g, (uint32_t)k);
    if (g->ramp.n == 2)
        return middle_color(g->ramp.colors[0], g->ramp.colors[1], (uint32_t)k);
    return g->ramp.colors[k];
}

static int32_t any_size(struct random *r)
{
    const int32_t most = 1 << random_between(r, 8, 23);
    return random_between(r, most / 2, most);
}

/* Near the box, or anywhere; often where centres of pixels are on a boundary.
 */
static struct pel_point any_point(struct random *r, const struct pel_rect *b)
{
    const int32_t grid = 1 << random_between(r, 0, 10);
    struct pel_point p;
    if (random_word(r) % 4 == 0) {
        p.x = random_between(r, PEL_COORDINATE_MIN, PEL_COORDINATE_MAX);
        p.y = random_between(r, PEL_COORDINATE_MIN, PEL_COORDINATE_MAX);
    } else {
        const int32_t far = any_size(r) / (random_word(r) % 2 ? 1 : 100);
        p.x = b->x0 * 256 + random_between(r, -far, far + 9000);
        p.y = b->y0 * 256 + random_between(r, -far, far + 9000);
    }
    p.x = p.x / grid * grid + (random_word(r) % 3 ? 0 : 128);
    p.y = p.y / grid * grid + (random_word(r) % 3 ? 0 : 128);
    p.x = pel_min(pel_max(p.x, PEL_COORDINATE_MIN), PEL_COORDINATE_MAX);
    p.y = pel_min(pel_max(p.y, PEL_COORDINATE_MIN), PEL_COORDINATE_MAX);
    return p;
}

static void any_ramp(struct random *r, struct pel_ramp *ramp)
{
    static const int32_t usual[] = {1, 2, 2, 3, 16, 256, 256, 1000};
    ramp->n = usual[random_word(r) % 8];
    if (random_word(r) % 100 == 0)
        ramp->n = random_between(r, 1, 32767);
    ramp->spread = (enum pel_spread)(random_word(r) % 3);
    pel_color *const color = colors + 32767 - ramp->n; /* none behind */
    ramp->colors = color;
    const pel_color opaque = random_word(r) % 4 ? 0xFF000000 : 0;
    const pel_color few = random_word(r) % 2 ? 0x80FFFFFF : 0xFF808080;
    for (int32_t i = 0; i < ramp->n; i++)
        color[i] = (random_word(r) & few) | opaque;
}

static void any_gradient(struct random *r, struct gradient *g,
                         const struct pel_rect *b)
{
    g->kind = (enum kind)(random_word(r) % KINDS);
    g->at = any_point(r, b);
    g->to = any_point(r, b);
    if (random_word(r) % 8 == 0) { /* more cells than |d|^2 */
        g->to.x = shape_legal(g->at.x + random_between(r, -9, 9));
        g->to.y = shape_legal(g->at.y + random_between(r, -9, 9));
    }
    const uint32_t slope = random_word(r) % 4;
    if (slope == 0)
        g->to.x = g->at.x; /* level */
    else if (slope == 1)
        g->to.y = g->at.y; /* upright */
    g->phase = (uint16_t)(random_word(r) << random_between(r, 0, 15));
    g->radius = pel_min(any_size(r), PEL_PX(32767));
    any_ramp(r, &g->ramp);
    const struct pel_rings rings = {g->at, pel_max(g->radius, 256), g->phase};
    g->radius = rings.radius;
    if (g->at.x == g->to.x && g->at.y == g->to.y)
        g->kind = RADIAL;
    const enum pel_status status =
        g->kind == LINEAR
            ? pel_linear_init(&g->u.linear, g->at, g->to, &g->ramp)
        : g->kind == RADIAL ? pel_radial_init(&g->u.radial, &rings, &g->ramp)
        : g->kind == CONIC
            ? pel_conic_init(&g->u.conic, g->at, g->phase, &g->ramp)
            : pel_hue_wheel_init(&g->u.wheel, g->at, g->phase,
                                 (uint8_t)random_word(r),
                                 (uint8_t)random_word(r));
    assert_int_equal(status, PEL_OK);
}

static void draw(const struct pel_surface *s, const struct pel_point v[3],
                 uint32_t shape, const struct pel_paint *p)
{
    static const struct pel_point all[2] = {
        {PEL_COORDINATE_MIN, PEL_COORDINATE_MIN},
        {PEL_COORDINATE_MAX, PEL_COORDINATE_MAX}};
    const struct pel_ring_shape ring = {v[0], 1000, 5000};
    if (shape == 0)
        pel_triangle(s, v, p);
    else if (shape == 1)
        pel_ring(s, &ring, p);
    else
        pel_rectangle(s, all[0], all[1], p);
}

static pel_color color_at(const void *gradient, int32_t x, int32_t y)
{
    return color_of(gradient, number_at(gradient, x, y));
}

/* The pixels of the same cell as (x, y), by the shape that it is. */
static void check_shape(const struct gradient *g, int32_t x, int32_t y)
{
    const struct pel_rect *b = &canvas.surface.bounds;
    const int32_t k = (int32_t)number_at(g, x, y), most = PEL_PX(32767);
    const wide outer = g->kind == RADIAL ? ring_radius(g, k + 1) : most;
    if (outer > most || (k == 0 && g->kind == RADIAL) || sectors_of(g) == 1)
        return;
    hits_open(&hits, b);
    if (g->kind == RADIAL)
        pel_ring(&hits.surface,
                 &(struct pel_ring_shape){g->at, (int32_t)ring_radius(g, k),
                                          (int32_t)outer},
                 &hits.paint);
    else
        pel_sector(&hits.surface,
                   &(struct pel_sector_shape){g->at, most, angle_of(g, k),
                                              angle_of(g, k + 1)},
                   &hits.paint);
    for (y = b->y0; y < b->y1; y++)
        for (x = b->x0; x < b->x1; x++) {
            const wide u = pel_pixel_center(x) - g->at.x;
            const wide v = pel_pixel_center(y) - g->at.y;
            const bool reached = u * u + v * v <= (wide)most * most;
            if (hits_at(&hits, x, y) != (reached && number_at(g, x, y) == k))
                fail_msg("cell %d at %d,%d is another shape; %s", k, x, y,
                         cases_replay());
        }
}

/* Every pixel of a shape, all of the surface or what `draw` makes of v. */
static void check_drawn(const struct gradient *g, const struct pel_rect *b,
                        const struct pel_point v[3], uint32_t shape)
{
    hits_open(&hits, b);
    draw(&canvas.surface, v, shape, &g->u.paint);
    draw(&hits.surface, v, shape, &hits.paint);
    canvas_check_drawn(&canvas, &hits, color_at, g);
}

TEST(every_cell)
{
    static struct gradient g;
    for (struct cases c = cases_of(100000); cases_next(&c);) {
        struct random *r = &c.random;
        const struct pel_rect b =
            shape_bounds(r, 64, random_word(r) % 4 ? 9 : 70);
        const uint32_t shape = random_word(r) % 4;
        struct pel_point v[3];
        any_gradient(r, &g, &b);
        shape_in_box(r, v, 3, &b);
        canvas_open(&canvas, layouts[random_word(r) % LAYOUT_COUNT].format, &b,
                    random_word(r) % CANVAS_STYLES);
        check_drawn(&g, &b, v, shape);
        if (g.kind != LINEAR)
            check_shape(&g, random_between(r, b.x0, b.x1 - 1),
                        random_between(r, b.y0, b.y1 - 1));
    }
}

/* Narrow rings around a wide disc, so far out that the squares of their radii
 * do not fit the 32 bits of core/fast. */
TEST(far_rings)
{
    static struct gradient g = {.kind = RADIAL,
                                .radius = 2400 * 673,
                                .ramp = {colors, 2400, PEL_REPEAT}};
    static const struct pel_point v[3] = {{0, 0}};
    const struct pel_rings rings = {.radius = g.radius};
    const struct pel_rect row = {0, 0, 6300, 1};
    for (uint32_t i = 0; i < 2400; i++)
        colors[i] = 0xFF000000 | (i < 380 ? 0 : i);
    assert_int_equal(pel_radial_init(&g.u.radial, &rings, &g.ramp), PEL_OK);
    canvas_open(&canvas, &pel_xrgb8888, &row, 0);
    check_drawn(&g, &row, v, 3);
}
