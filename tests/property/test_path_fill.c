/* Paths: curves against the lines that they become, and fills against polygons
 * of these lines. */
#include <math.h>
#include <string.h>

#include "core/path/pen.h"
#include "tests/support/canvas.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"
#include "tests/support/shapes.h"

enum { VERBS = 12, POINTS = 3 * VERBS, LINES = 4096 * VERBS };

/* A pen that keeps the points. */
struct keeper {
    struct pel_pen pen;
    struct pel_point v[LINES + 1];
    int32_t n, moves;
};

static struct keeper keeper;

static enum pel_status keep(struct pel_pen *pen, enum pel_verb verb,
                            const struct pel_point *p)
{
    struct keeper *const k = (struct keeper *)(void *)pen;
    if (p && verb != PEL_CLOSE && k->n <= LINES)
        k->v[k->n++] = *p;
    k->moves += verb == PEL_MOVE && p;
    return PEL_OK;
}

static struct pel_pen pen_of(enum pel_status (*draw)(struct pel_pen *pen,
                                                     enum pel_verb verb,
                                                     const struct pel_point *p))
{
    static struct pel_path_state state;
    return (struct pel_pen){.draw = draw,
                            .top = PEL_COORDINATE_MIN,
                            .bottom = PEL_COORDINATE_MAX,
                            .memory = &state};
}

static enum pel_status flatten(const struct pel_path_shape *shape)
{
    keeper.pen = pen_of(keep);
    keeper.n = keeper.moves = 0;
    return pel_path_walk(shape, &keeper.pen);
}

static double bezier(const struct pel_point *v, int n, double t, bool y)
{
    double at[4];
    for (int i = 0; i <= n; i++)
        at[i] = y ? v[i].y : v[i].x;
    for (int k = n; k > 0; k--)
        for (int i = 0; i < k; i++)
            at[i] += (at[i + 1] - at[i]) * t;
    return at[0];
}

static double distance(double x, double y, const struct pel_point *a,
                       const struct pel_point *b)
{
    const double dx = b->x - a->x, dy = b->y - a->y, l = dx * dx + dy * dy;
    double t = l > 0 ? ((x - a->x) * dx + (y - a->y) * dy) / l : 0;
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    return hypot(x - a->x - t * dx, y - a->y - t * dy);
}

TEST(lines_are_near_their_curve)
{
    static const uint8_t quad[] = {PEL_MOVE, PEL_QUAD};
    static const uint8_t cubic[] = {PEL_MOVE, PEL_CUBIC};
    enum { SAMPLES = 5, MOST = 256 };
    double worst = 0;
    for (struct cases c = cases_of(100000); cases_next(&c);) {
        struct random *r = &c.random;
        struct pel_point v[4];
        const int n = random_word(r) % 2 ? 2 : 3;
        const struct pel_path path = {.verbs = n == 2 ? quad : cubic,
                                      .verb_count = 2,
                                      .points32 = &v[0].x,
                                      .point_count = n + 1};
        const struct pel_path_shape shape = {
            .path = &path,
            .tolerance = random_word(r) % 2 ? 0 : random_between(r, 4, 999)};
        if (random_word(r) % 4)
            shape_in_box(r, v, 4, &(struct pel_rect){0, 0, 99, 99});
        else
            shape_adversarial(r, v, 4);
        assert_int_equal(flatten(&shape), PEL_OK);
        const double tolerance = shape.tolerance ? shape.tolerance : 16;
        const int32_t parts = keeper.n - 1, step = 1 + parts / MOST;
        for (int32_t i = 0; i < parts; i += step)
            for (int k = 0; k <= SAMPLES; k++) {
                const double t = (i + (double)k / SAMPLES) / parts;
                const double off =
                    distance(bezier(v, n, t, false), bezier(v, n, t, true),
                             &keeper.v[i], &keeper.v[i + 1]);
                worst = fmax(worst, off / tolerance);
                if (off > tolerance)
                    fail_msg("%.2f of %.2f at t = %.5f, %d parts: %s", off,
                             tolerance, t, parts, cases_replay());
            }
    }
    assert_true(cases_alone() || worst > .5);
}

/* A path of several parts, in a box of 40 px or beside it. */
struct random_path {
    uint8_t verbs[VERBS];
    int16_t points[2 * POINTS];
    struct pel_path path;
    struct pel_transform transform;
    struct pel_path_shape shape;
};

static void make_path(struct random *r, struct random_path *p, bool one_part)
{
    static const int32_t count[] = {1, 1, 2, 3, 0};
    const struct pel_rect box = {-40, -40, 60, 60};
    struct pel_point v[3];
    p->path = (struct pel_path){.verbs = p->verbs,
                                .verb_count = random_between(r, 1, VERBS),
                                .points16 = p->points};
    for (int32_t i = 0; i < p->path.verb_count; i++) {
        const uint32_t verb = one_part ? 1 + random_word(r) % 3
                                       : random_word(r) % (PEL_CLOSE + 1);
        p->verbs[i] = i ? (uint8_t)verb : PEL_MOVE;
        shape_in_box(r, v, 3, &box);
        cases_forget();
        for (int32_t k = 0; k < count[p->verbs[i]]; k++) {
            p->points[2 * p->path.point_count] = (int16_t)v[k].x;
            p->points[2 * p->path.point_count++ + 1] = (int16_t)v[k].y;
        }
    }
    p->transform = (struct pel_transform){
        random_between(r, -99999, 99999),
        random_between(r, -99999, 99999),
        random_between(r, -99999, 99999),
        random_between(r, -99999, 99999),
        {random_between(r, 0, 9999), random_between(r, 0, 9999)}};
    p->shape = (struct pel_path_shape){
        .path = &p->path,
        .transform = random_word(r) % 2 ? &p->transform : NULL,
        .rule = random_word(r) % 2 ? PEL_EVEN_ODD : PEL_NON_ZERO};
}

static struct canvas whole, other;
static uint64_t scratch[1 << 16], polygon_scratch[1 << 16];

/* From the ends of all parts back to their beginnings: polygons have one
 * outline. */
static enum pel_status keep_closed(struct pel_pen *pen, enum pel_verb verb,
                                   const struct pel_point *p)
{
    static struct pel_point start;
    struct keeper *const k = (struct keeper *)(void *)pen;
    if (k->n > 0 && verb != PEL_LINE) {
        k->v[k->n++] = start;
        k->v[k->n++] = k->v[0];
    }
    if (verb == PEL_MOVE && p)
        start = *p;
    return keep(pen, verb, verb == PEL_CLOSE ? &start : p);
}

static struct pel_polygon_shape polygon_of(const struct pel_path_shape *shape)
{
    keeper.pen = pen_of(keep_closed);
    keeper.n = 0;
    assert_int_equal(pel_path_walk(shape, &keeper.pen), PEL_OK);
    return (struct pel_polygon_shape){keeper.v, keeper.n, shape->rule};
}

static int32_t transformed(int32_t at, int64_t sum)
{
    sum += 32768;
    return at + (int32_t)(sum >= 0 ? sum / 65536 : -((65535 - sum) / 65536));
}

/* Ends of lines are where the header's formula takes them. */
TEST(points_are_transformed)
{
    static const uint8_t verbs[] = {PEL_MOVE, PEL_LINE, PEL_LINE};
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        struct random *const r = &c.random;
        int16_t v[6];
        for (int i = 0; i < 6; i++)
            v[i] = (int16_t)random_between(r, -32768, 32767);
        const struct pel_transform t = {
            random_between(r, -99999, 99999),
            random_between(r, -99999, 99999),
            random_between(r, -99999, 99999),
            random_between(r, -99999, 99999),
            {random_between(r, -9999, 9999), random_between(r, -9999, 9999)}};
        const struct pel_path path = {
            .verbs = verbs, .verb_count = 3, .points16 = v, .point_count = 3};
        const struct pel_path_shape shape = {.path = &path, .transform = &t};
        keeper.pen = pen_of(keep);
        keeper.n = 0;
        assert_int_equal(pel_path_walk(&shape, &keeper.pen), PEL_OK);
        for (int i = 0; i < 3; i++) {
            const int64_t x = v[2 * i], y = v[2 * i + 1];
            if (keeper.v[i].x != transformed(t.at.x, t.xx * x + t.xy * y) ||
                keeper.v[i].y != transformed(t.at.y, t.yx * x + t.yy * y))
                fail_msg("(%d, %d): %d %d; %s", (int)x, (int)y, keeper.v[i].x,
                         keeper.v[i].y, cases_replay());
        }
    }
}

static const struct pel_flat ink = PEL_FLAT(PEL_RGBA(200, 40, 90, 120));

TEST(fills_are_polygons_of_the_lines)
{
    static const struct pel_rect bounds = {-3, -5, 37, 35};
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        static struct random_path p;
        const bool smooth = random_word(&c.random) % 2;
        make_path(&c.random, &p, smooth);
        const struct pel_polygon_shape polygon = polygon_of(&p.shape);
        canvas_open(&whole, &pel_xrgb8888, &bounds, 0);
        canvas_open(&other, &pel_xrgb8888, &bounds, 0);
        assert_int_equal((smooth ? pel_smooth_polygon : pel_polygon)(
                             &whole.surface, &polygon, &ink.paint,
                             polygon_scratch, sizeof polygon_scratch),
                         PEL_OK);
        assert_int_equal(
            (smooth ? pel_smooth_path_fill : pel_path_fill)(
                &other.surface, &p.shape, &ink.paint, scratch, sizeof scratch),
            PEL_OK);
        canvas_check_same(&whole, &other);
    }
}

TEST(hits_are_what_is_filled)
{
    static const struct pel_rect bounds = {-3, -5, 37, 35};
    static struct hits hits;
    for (struct cases c = cases_of(500); cases_next(&c);) {
        static struct random_path p;
        make_path(&c.random, &p, false);
        hits_open(&hits, &bounds);
        assert_int_equal(pel_path_fill(&hits.surface, &p.shape, &hits.paint,
                                       scratch, sizeof scratch),
                         PEL_OK);
        for (int32_t y = bounds.y0; y < bounds.y1; y++)
            for (int32_t x = bounds.x0; x < bounds.x1; x++)
                if (pel_hit_path_fill(&p.shape, x, y) != hits_at(&hits, x, y))
                    fail_msg("(%d, %d): %s", x, y, cases_replay());
    }
}

/* Whatever the bytes are: refused as pel_path_check refuses them, out of range,
 * or drawn. */
TEST(random_bytes_are_refused_or_drawn)
{
    static const struct pel_rect bounds = {-3, -5, 37, 35};
    long drawn = 0;
    for (struct cases c = cases_of(100000); cases_next(&c);) {
        struct random *r = &c.random;
        static struct random_path p;
        make_path(r, &p, false);
        for (uint32_t n = random_word(r) % 3; n > 0; n--)
            p.verbs[random_word(r) % VERBS] =
                (uint8_t)random_between(r, 0, PEL_CLOSE + 1);
        p.path.point_count += random_word(r) % 4 ? 0 : random_between(r, -2, 1);
        if (p.path.point_count > POINTS)
            p.path.point_count = POINTS;
        const enum pel_status status = pel_path_check(&p.path);
        canvas_open(&whole, &pel_rgb565_le, &bounds, 0);
        const enum pel_status done = pel_path_fill(
            &whole.surface, &p.shape, &ink.paint, scratch, sizeof scratch);
        if (done != status && done != PEL_ERROR_RANGE)
            fail_msg("%d, checked %d: %s", done, status, cases_replay());
        drawn += done == PEL_OK;
    }
    assert_true(cases_alone() || drawn > 100);
}
