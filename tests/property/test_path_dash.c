/* Dashes of strokes. */
#include <math.h>
#include <string.h>

#include "tests/support/canvas.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"
#include "tests/support/shapes.h"
#include "tests/support/stroke_area.h"

enum { SIZE = 24 };

static uint64_t scratch[1 << 16];
static struct canvas whole, other;
static const struct pel_flat ink = PEL_FLAT(PEL_RGBA(200, 40, 90, 120));

static enum pel_status draw(const struct pel_surface *surface, bool smooth,
                            const struct pel_polyline_shape *line, size_t size)
{
    return (smooth ? pel_smooth_polyline
                   : pel_polyline)(surface, line, &ink.paint, scratch, size);
}

/* Dashes of a straight line are lines of their own, also without length. */
TEST(dashes_are_lines)
{
    const struct pel_rect bounds = {0, 0, SIZE, SIZE};
    for (struct cases c = cases_of(4000); cases_next(&c);) {
        struct random *r = &c.random;
        const bool dots = random_word(r) % 4 == 0;
        const int32_t dash[2] = {dots ? 0 : random_between(r, 1, 1500),
                                 random_between(r, 256, 1500)};
        const struct pel_point v[2] = {{random_between(r, -9, 200), 3000},
                                       {random_between(r, 5000, 7000), 3000}};
        const struct pel_dashes dashes = {&pel_dashed, dash, 2,
                                          random_between(r, 0, 3) * 3333};
        struct pel_polyline_shape line = {
            v,
            2,
            false,
            {.width = random_between(r, 2, 999),
             .cap = (enum pel_cap)(random_word(r) % 3),
             .dashes = &dashes}};
        const uint32_t smooth = random_word(r) % 2;
        canvas_open(&whole, &pel_rgb888, &bounds, 0);
        canvas_open(&other, &pel_rgb888, &bounds, 0);
        assert_int_equal(draw(&whole.surface, smooth, &line, sizeof scratch),
                         PEL_OK);
        struct pel_path path;
        uint8_t verbs[128];
        struct pel_point ends[128];
        int32_t n = 0, x = v[0].x - dashes.phase % (dash[0] + dash[1]);
        for (; x < v[1].x + dots; x += dash[0] + dash[1]) {
            const int32_t from = pel_max(x, v[0].x);
            const int32_t to = pel_min(x + dash[0], v[1].x);
            if (from > to || (from == to && from == v[0].x && !dots))
                continue;
            verbs[n] = PEL_MOVE;
            ends[n++] = (struct pel_point){from, 3000};
            verbs[n] = PEL_LINE;
            ends[n++] = (struct pel_point){to, 3000};
        }
        path = (struct pel_path){.verbs = verbs,
                                 .points32 = &ends[0].x,
                                 .verb_count = n,
                                 .point_count = n};
        struct pel_path_shape shape = {.path = &path, .stroke = line.stroke};
        shape.stroke.dashes = NULL;
        assert_int_equal(
            (smooth ? pel_smooth_path_stroke : pel_path_stroke)(
                &other.surface, &shape, &ink.paint, scratch, sizeof scratch),
            PEL_OK);
        canvas_check_same(&whole, &other);
    }
}

static void check_dots(const int32_t *dash, int32_t count, const int32_t *x,
                       int32_t n)
{
    const struct pel_rect bounds = {0, 0, SIZE, SIZE};
    for (uint32_t i = 0; i < 4; i++) {
        const struct pel_point v[2] = {{1000, 3000}, {5000, 3000}};
        const struct pel_dashes dashes = {&pel_dashed, dash, count, 0};
        struct pel_polyline_shape line = {
            v,
            2,
            false,
            {.width = 300,
             .cap = i / 2 ? PEL_CAP_ROUND : PEL_CAP_SQUARE,
             .dashes = &dashes}};
        canvas_open(&whole, &pel_rgb888, &bounds, 0);
        canvas_open(&other, &pel_rgb888, &bounds, 0);
        assert_int_equal(draw(&whole.surface, i % 2, &line, sizeof scratch),
                         PEL_OK);
        line.stroke.dashes = NULL;
        line.n = 1;
        for (int32_t k = 0; k < n; k++) {
            const struct pel_point dot = {x[k], 3000};
            line.v = &dot;
            assert_int_equal(draw(&other.surface, i % 2, &line, sizeof scratch),
                             PEL_OK);
        }
        canvas_check_same(&whole, &other);
    }
}

TEST(dotted_lines_begin_with_a_dot)
{
    static const int32_t one[2] = {0, 2000}, at[3] = {1000, 3000, 5000};
    static const int32_t odd[5] = {0, 1653, 0, 2500, 9363},
                         two[2] = {1000, 2653};
    check_dots(one, 2, at, 3);
    check_dots(odd, 5, two, 2);
}

/* Nothing where the part begins in a gap. */
TEST(dashed_parts_without_length_are_dots)
{
    static const int32_t dash[2] = {500, 700};
    const struct pel_rect bounds = {0, 0, SIZE, SIZE};
    for (uint32_t i = 0; i < 72; i++) {
        const struct pel_point v[3] = {
            {3000, 3000}, {3000, 3000}, {3000, 3000}};
        const struct pel_dashes dashes = {&pel_dashed, dash, 2,
                                          i / 18 % 2 ? 600 : 100};
        struct pel_polyline_shape line = {
            v,
            (int32_t)(i / 2 % 3) + 1,
            i / 36,
            {.width = 700, .cap = (enum pel_cap)(i / 6 % 3)}};
        canvas_open(&whole, &pel_rgb888, &bounds, 0);
        canvas_open(&other, &pel_rgb888, &bounds, 0);
        if (dashes.phase == 100)
            assert_int_equal(draw(&other.surface, i % 2, &line, sizeof scratch),
                             PEL_OK);
        line.stroke.dashes = &dashes;
        assert_int_equal(draw(&whole.surface, i % 2, &line, sizeof scratch),
                         PEL_OK);
        canvas_check_same(&whole, &other);
    }
}

/* Each part of a path begins with the same dash, and may be a dot. */
TEST(parts_begin_anew)
{
    static const uint8_t verbs[6] = {PEL_MOVE, PEL_LINE, PEL_LINE,
                                     PEL_MOVE, PEL_LINE, PEL_LINE};
    static const struct pel_flat full = PEL_FLAT(PEL_RGB(200, 40, 90));
    const struct pel_rect bounds = {0, 0, SIZE, SIZE};
    for (struct cases c = cases_of(2000); cases_next(&c);) {
        struct random *r = &c.random;
        struct pel_point v[6];
        for (int i = 0; i < 6; i++)
            v[i] = (struct pel_point){random_between(r, 0, PEL_PX(SIZE)),
                                      random_between(r, 0, PEL_PX(SIZE))};
        if (random_word(r) % 4 == 0)
            v[4] = v[5] = v[3];
        const int32_t dash[2] = {random_between(r, 1, 1500),
                                 random_between(r, 256, 1500)};
        const struct pel_dashes dashes = {&pel_dashed, dash, 2,
                                          random_between(r, 0, 3000)};
        struct pel_path path = {verbs, NULL, &v[0].x, 6, 6};
        const struct pel_path_shape shape = {
            .path = &path,
            .stroke = {.width = 500, .cap = PEL_CAP_ROUND, .dashes = &dashes}};
        canvas_open(&whole, &pel_rgb888, &bounds, 0);
        canvas_open(&other, &pel_rgb888, &bounds, 0);
        assert_int_equal(pel_path_stroke(&whole.surface, &shape, &full.paint,
                                         scratch, sizeof scratch),
                         PEL_OK);
        path.verb_count = path.point_count = 3;
        for (int i = 0; i < 6; i += 3) {
            path.points32 = &v[i].x;
            assert_int_equal(pel_path_stroke(&other.surface, &shape,
                                             &full.paint, scratch,
                                             sizeof scratch),
                             PEL_OK);
        }
        canvas_check_same(&whole, &other);
    }
}

/* How deep the middles of pixels are in the dashes, 1/256 px: surely, and if
 * what rounding may leave out is there. */
static double sure[SIZE][SIZE], most[SIZE][SIZE];

static void take(int x, int y, double depth, bool certain)
{
    most[y][x] = fmax(most[y][x], depth);
    if (certain)
        sure[y][x] = fmax(sure[y][x], depth);
}

/* The rectangle along a line of direction u, from one way to another. */
static void take_piece(const struct pel_point *a, const double u[2],
                       double from, double to, double half)
{
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++) {
            const double dx = x * 256 + 128 - a->x, dy = y * 256 + 128 - a->y;
            const double along = dx * u[0] + dy * u[1];
            const double across = fabs(dx * u[1] - dy * u[0]);
            take(x, y, fmin(fmin(along - from, to - along), half - across),
                 true);
        }
}

static double beside(const double *p, const double *q, double x, double y)
{
    const double dx = q[0] - p[0], dy = q[1] - p[1];
    return (dx * (y - p[1]) - dy * (x - p[0])) / hypot(dx, dy);
}

/* The corner that is cut off outside of a turn from u to w. */
static void take_bevel(const struct pel_point *p, const double u[2],
                       const double w[2], double half, bool certain)
{
    const double turn = u[0] * w[1] - u[1] * w[0], side = turn < 0 ? -1 : 1;
    const double v[3][2] = {
        {p->x, p->y},
        {p->x + side * half * u[1], p->y - side * half * u[0]},
        {p->x + side * half * w[1], p->y - side * half * w[0]}};
    if (fabs(turn) < 1e-6)
        return;
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++) {
            double depth = 1e9;
            for (int i = 0; i < 3; i++)
                depth =
                    fmin(depth, side * beside(v[i], v[(i + 1) % 3],
                                              x * 256 + 128, y * 256 + 128));
            take(x, y, depth, certain);
        }
}

static void take_dash(const struct pel_polyline_shape *line, double u[2][2],
                      const double *length, double from, double to)
{
    const double half = line->stroke.width / 2;
    const double cap = line->stroke.cap == PEL_CAP_SQUARE ? half : 0;
    const double end = fmin(length[0], to), all = length[0] + length[1];
    if (from < length[0])
        take_piece(&line->v[0], u[0], fmax(from, 0) - cap, end + cap, half);
    if (line->n == 3 && to > length[0] && from < all)
        take_piece(&line->v[1], u[1], fmax(from - length[0], 0),
                   fmin(to, all) - length[0], half);
    if (line->n == 3 && from < length[0] + 2 && to > length[0] - 2)
        take_bevel(&line->v[1], u[0], u[1], half,
                   from < length[0] - 2 && to > length[0] + 2);
}

static void measure_dashes(const struct pel_polyline_shape *line)
{
    const struct pel_stroke *const s = &line->stroke;
    double u[2][2], length[2] = {0, 0}, from = -s->dashes->phase;
    for (int i = 0; i + 1 < line->n; i++) {
        const double dx = line->v[i + 1].x - line->v[i].x;
        const double dy = line->v[i + 1].y - line->v[i].y;
        length[i] = hypot(dx, dy);
        u[i][0] = dx / length[i];
        u[i][1] = dy / length[i];
    }
    for (int y = 0; y < SIZE; y++)
        for (int x = 0; x < SIZE; x++)
            sure[y][x] = most[y][x] = -1e9;
    for (; from < length[0] + length[1];
         from += s->dashes->length[0] + s->dashes->length[1])
        if (from + s->dashes->length[0] > 0)
            take_dash(line, u, length, from, from + s->dashes->length[0]);
}

/* Short ones, too, and those that begin or end beside a turn. Square caps on
 * one line only: beside a turn the other line may be the one that has it. */
TEST(dashes_have_the_direction_of_their_line)
{
    enum { ROUNDING = 4 };
    static struct hits hits;
    const struct pel_rect bounds = {0, 0, SIZE, SIZE};
    for (struct cases c = cases_of(4000); cases_next(&c);) {
        struct random *r = &c.random;
        struct pel_point v[3];
        for (int i = 0; i < 3; i++)
            v[i] = (struct pel_point){random_between(r, 0, 2000) + 2000 * i,
                                      random_between(r, 0, 6144)};
        const int32_t n = random_between(r, 2, 3);
        const int32_t dash[2] = {
            random_between(r, 3, 1 << random_between(r, 3, 11)),
            random_between(r, 256, 3000)};
        struct pel_dashes dashes = {&pel_dashed, dash, 2, 0};
        const struct pel_polyline_shape line = {
            v,
            n,
            false,
            {.width = random_between(r, 2, 5000),
             .cap =
                 n == 2 && random_word(r) % 2 ? PEL_CAP_SQUARE : PEL_CAP_BUTT,
             .dashes = &dashes}};
        const double way = hypot(v[1].x - v[0].x, v[1].y - v[0].y);
        const int32_t period = dash[0] + dash[1];
        dashes.phase = /* an end is near that of the first line */
            5 * period - (int32_t)way % period + random_between(r, -9, 9) +
            (int32_t)(random_word(r) % 2) * dash[0];
        /* One that begins at the end by less than lengths are rounded by may
         * be left out, and its cap with it. */
        const double last = fmod(way + dashes.phase, period);
        if (n == 2 && last > 0 && last < 1. / 32)
            continue;
        shape_keep(v, n);
        cases_keep(stroke_print, &line, sizeof line);
        measure_dashes(&line);
        hits_open(&hits, &bounds);
        assert_int_equal(pel_polyline(&hits.surface, &line, &hits.paint,
                                      scratch, sizeof scratch),
                         PEL_OK);
        for (int y = 0; y < SIZE; y++)
            for (int x = 0; x < SIZE; x++) {
                const int hit = hits_at(&hits, x, y);
                if (hit ? most[y][x] < -ROUNDING : sure[y][x] > ROUNDING)
                    fail_msg("(%d, %d): %d, %.1f to %.1f deep, dashes %d, %d "
                             "from %d: %s",
                             x, y, hit, sure[y][x], most[y][x], dash[0],
                             dash[1], dashes.phase, cases_replay());
            }
    }
}
