/* Gradients: every pixel of random ones, on shapes, in every format, shows the
 * cell that exact arithmetic says; and a cell is the ring or the sector of the
 * same numbers. What a pixel shows is a function of the pixel alone, so bands,
 * tiles and clips change no byte. */
#include "core/pel.h"
#include "tests/support/canvas.h"
#include "tests/support/check.h"
#include "tests/support/hits.h"
#include "tests/support/reference_gradient.h"
#include "tests/support/shapes.h"

static pel_color colors[32767];
static struct canvas canvas;
static struct hits hits;

static int32_t any_size(struct random *r)
{
    const int32_t most = 1 << random_between(r, 8, 23);
    return random_between(r, most / 2, most);
}

/* Near the box, or anywhere; often with centres of pixels on a boundary. */
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
    p.x = shape_legal(p.x / grid * grid + (random_word(r) % 3 ? 0 : 128));
    p.y = shape_legal(p.y / grid * grid + (random_word(r) % 3 ? 0 : 128));
    return p;
}

/* Colors end where the array does, so that sanitizers see a read beyond. Now
 * and then one of the first lets light through, or each is black or nothing,
 * which pack alike. */
static void any_ramp(struct random *r, struct pel_ramp *ramp)
{
    static const int32_t usual[] = {1, 2, 2, 3, 16, 256, 256, 1000};
    ramp->n = usual[random_word(r) % 8];
    if (random_word(r) % 100 == 0)
        ramp->n = random_between(r, 1, 32767);
    ramp->spread = (enum pel_spread)(random_word(r) % 3);
    const pel_color opaque = random_word(r) % 4 ? 0xFF000000 : 0;
    const pel_color few = random_word(r) % 2 ? 0x80FFFFFF : 0xFF808080;
    const bool bare = random_word(r) % 16 == 0;
    pel_color *const color = colors + 32767 - ramp->n;
    for (int32_t i = 0; i < ramp->n; i++)
        color[i] = bare ? 0xFF000000 * (random_word(r) % 2)
                        : (random_word(r) & few) | opaque;
    if (random_word(r) % 3 == 0)
        color[pel_min(random_between(r, 0, 2), ramp->n - 1)] &=
            random_word(r) % 2 ? 0xFEFFFFFF : 0x7FFFFFFF;
    ramp->colors = color;
}

static void any_gradient(struct random *r, struct gradient *g,
                         const struct pel_rect *b)
{
    const bool narrow = random_word(r) % 4 == 0; /* rings in sight */
    g->kind = narrow ? RADIAL : (enum kind)(random_word(r) % 5 % KINDS);
    g->at = any_point(r, b);
    if (narrow)
        shape_in_box(r, &g->at, 1, b);
    g->to = any_point(r, b);
    if (random_word(r) % 8 == 0) { /* more cells than |d|^2 */
        g->to.x = shape_legal(g->at.x + random_between(r, -4, 4));
        g->to.y = shape_legal(g->at.y + random_between(r, -4, 4));
    }
    if (random_word(r) % 4 == 0)
        g->to.x = g->at.x;            /* level */
    else if (random_word(r) % 3 == 0) /* upright, or nearly */
        g->to.y = shape_legal(g->at.y + (random_word(r) % 4 == 0));
    g->phase = (uint16_t)(random_word(r) << random_between(r, 0, 15));
    any_ramp(r, &g->ramp);
    g->s = (uint8_t)random_word(r);
    g->v = (uint8_t)random_word(r);
    g->radius = any_size(r);
    if (narrow)
        g->radius = cells_of(g) * (g->radius / 256 % 800 + 1);
    g->radius = pel_min(g->radius, PEL_PX(32767));
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
            : pel_hue_wheel_init(&g->u.wheel, g->at, g->phase, g->s, g->v);
    assert_int_equal(status, PEL_OK);
}

static void draw(const struct pel_surface *s, const struct pel_point v[3],
                 uint32_t shape, const struct pel_paint *p)
{
    const struct pel_rect *b = &s->bounds;
    const struct pel_span full = {b->x0, b->x1}, back = {b->x1, b->x0};
    const struct pel_span spans[3] = {full, back, full};
    static uint32_t scratch[PEL_POLYGON_SCRATCH_SIZE(40) / 4];
    struct pel_point comb[40];
    for (int i = 0; i < 40; i++) {
        comb[i].x = shape_legal(v[0].x + 300 * i);
        comb[i].y = v[1 + i % 2].y;
    }
    if (shape == 0)
        pel_triangle(s, v, p);
    else if (shape == 1)
        pel_ring(s, &(struct pel_ring_shape){v[0], 1000, 5000}, p);
    else if (shape == 2)
        pel_polygon(s, &(struct pel_polygon_shape){comb, 40, PEL_EVEN_ODD}, p,
                    scratch, sizeof scratch);
    else if (shape == 4)
        p->fill(p, &(struct pel_spans){s, spans, b->y0,
                                       pel_min(b->y1 - b->y0, 2), 1});
    else if (shape == 5)
        p->fill(p, &(struct pel_spans){s, spans + 1, b->y0, 2, 0});
    else
        pel_box(s, b, p);
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
        struct pel_point v[3];
        any_gradient(r, &g, &b);
        shape_in_box(r, v, 3, &b);
        canvas_open(&canvas, layouts[random_word(r) % LAYOUT_COUNT].format, &b,
                    random_word(r) % CANVAS_STYLES);
        check_drawn(&g, &b, v, random_word(r) % 6);
        if (g.kind != LINEAR)
            check_shape(&g, random_between(r, b.x0, b.x1 - 1),
                        random_between(r, b.y0, b.y1 - 1));
    }
}

/* The colors of `source`, pixel by pixel. */
static struct gradient source;

static void put_exact(const struct pel_paint *paint,
                      const struct pel_spans *rows)
{
    (void)paint;
    for (int32_t i = 0; i < rows->n; i++) {
        const int32_t y = rows->y + i * rows->step;
        for (int32_t x = rows->span[i].x0; x < rows->span[i].x1; x++) {
            const pel_color c = color_at(&source, x, y);
            rows->surface->format->put(rows->surface, x, y, 1, &c);
        }
    }
}

/* A linear gradient that a dither walks in a loop of its own, as a rule: of two
 * opaque colors, with all of the box on its way, in cells of about a pixel. Now
 * and then pixels lie on boundaries, or a cell ends just behind one. */
static void any_walk(struct random *r, const struct pel_rect *b)
{
    const int32_t n = cells_of(&source), way = n * random_between(r, 99, 999);
    const uint32_t kind = random_word(r) % 8, turn = random_word(r) % 2;
    struct pel_point v[2];
    v[0].x = shape_legal(b->x0 * 256 - random_between(r, -99, way / 2));
    v[0].y = shape_legal(b->y0 * 256 + random_between(r, -999, 999));
    v[1].x = shape_legal(v[0].x + way);
    v[1].y = shape_legal(v[0].y + random_between(r, -way, way) / 4);
    if (kind == 0) {
        v[0] = (struct pel_point){b->x1 * 256 - 128 - 65279, 0};
        v[1] = (struct pel_point){v[0].x + 65535, 0};
    } else if (kind == 1) {
        const int32_t down = random_between(r, -1, 1);
        v[0].x = pel_pixel_center(b->x0 - random_between(r, 0, 2 * n / 3));
        v[0].y = pel_pixel_center(b->y0 - down * random_between(r, 0, 9));
        v[1].x = v[0].x + n * 256;
        v[1].y = v[0].y + n * 256 * down;
    }
    source.at = random_word(r) % 8 ? v[turn] : any_point(r, b);
    source.to = random_word(r) % 8 ? v[1 - turn] : any_point(r, b);
}

/* A dither of a gradient shows what a dither of its colors, one by one, does.
 */
TEST(dithered)
{
    static const struct pel_paint exact = {put_exact, NULL};
    static struct canvas canvases[2];
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        struct random *r = &c.random;
        const bool usual = random_word(r) % 2;
        const pel_color two[2] = {random_word(r) | 0xFF000000,
                                  random_word(r) | 0xFF000000};
        any_ramp(r, &source.ramp);
        if (usual) {
            source.ramp.colors = two;
            source.ramp.n = 2;
        }
        const int32_t width = cells_of(&source) < 16 ? 5 : 160;
        const struct pel_rect b = shape_bounds(r, width, 9);
        const struct pel_format *format =
            random_word(r) % 2 ? &pel_rgb565_le : &pel_rgb565_be;
        const uint32_t shape = random_word(r) % 6;
        struct pel_point v[3];
        any_walk(r, &b);
        if (pel_linear_init(&source.u.linear, source.at, source.to,
                            &source.ramp) != PEL_OK)
            continue; /* both ends are one point */
        shape_in_box(r, v, 3, &b);
        for (int i = 0; i < 2; i++) {
            struct pel_dither d;
            pel_dither_init(&d, i ? &exact : &source.u.paint);
            canvas_open(&canvases[i], format, &b, 0);
            draw(&canvases[i].surface, v, shape, &d.paint);
        }
        canvas_check_same(&canvases[0], &canvases[1]);
    }
}

/* Narrow rings: pixels on circles, and squares that the 32 bits of core/fast
 * hold, or only just do not. */
TEST(narrow_rings)
{
    static const struct {
        struct pel_point at;
        int32_t radius, n, width, height;
        uint32_t shape;
    } rows[] = {
        {{128, 128}, 2400 * 673, 2400, 4096, 1, 3},
        {{128, 128}, 2400 * 673, 2400, 4097, 1, 3},
        {{128, 128}, 200 * 512, 200, 257, 1, 3},
        {{128, 129}, 1000 * 256, 1000, 21, 1, 3},
        {{128, 128}, 14019, 50, 24, 1, 3},
        {{5248, 5248}, 16 * 256, 16, 41, 41, 3},
        {{127, 128}, 256, 1000, 20, 1, 3},
        {{128, 128}, 100 * 256, 100, 40, 2, 4},
    };
    static struct gradient g = {.kind = RADIAL};
    static const struct pel_point v[3] = {{0, 0}};
    for (uint32_t i = 0; i < 2400; i++)
        colors[i] = 0xFF000000 | i;
    for (size_t i = 0; i < 3 * sizeof rows / sizeof *rows; i++) {
        const size_t k = i / 3;
        const struct pel_rings rings = {rows[k].at, rows[k].radius, 0};
        const struct pel_rect box = {0, 0, rows[k].width, rows[k].height};
        g.at = rings.center;
        g.radius = rings.radius;
        g.ramp = (struct pel_ramp){colors, rows[k].n, (enum pel_spread)(i % 3)};
        assert_int_equal(pel_radial_init(&g.u.radial, &rings, &g.ramp), PEL_OK);
        canvas_open(&canvas, &pel_xrgb8888, &box, 0);
        check_drawn(&g, &box, v, rows[k].shape);
    }
}

/* Rows through the centre, and next to it: narrow sectors, of which one ends
 * just behind a half turn or next to the whole one, and a single sector. */
TEST(half_turns)
{
    static struct gradient g = {.kind = CONIC, .ramp = {colors, 16384, 0}};
    static const struct pel_point v[3] = {{0, 0}};
    const struct pel_rect box = {0, 0, 128, 1};
    for (uint32_t i = 0; i < 16384; i++)
        colors[i] = 0xFF000000 | i;
    for (int i = 0; i < 18; i++) {
        g.at = (struct pel_point){i % 2 * PEL_PX(128), 127 + i / 2 % 3};
        g.phase = i < 6 ? 1 : i < 12 ? 3 : 0;
        g.ramp.n = i < 12 ? 16384 : 1;
        assert_int_equal(pel_conic_init(&g.u.conic, g.at, g.phase, &g.ramp),
                         PEL_OK);
        canvas_open(&canvas, &pel_xrgb8888, &box, 0);
        check_drawn(&g, &box, v, 3);
    }
}

/* A horizontal gradient wider than the buffer that rows are copied from. */
TEST(wide_rows)
{
    static struct gradient g = {.to = PEL_AT(9000, 0),
                                .ramp = {colors, 1000, PEL_PAD}};
    static const struct pel_point v[3] = {{0, 0}};
    const struct pel_rect box = {0, 0, 9000, 2};
    for (uint32_t i = 0; i < 1000; i++)
        colors[i] = 0xFF000000 | i << 14;
    assert_int_equal(pel_linear_init(&g.u.linear, g.at, g.to, &g.ramp), PEL_OK);
    for (int i = 0; i < 2; i++) {
        canvas_open(&canvas, i ? &pel_xrgb8888 : &pel_rgb332, &box, 0);
        check_drawn(&g, &box, v, 3);
    }
}
