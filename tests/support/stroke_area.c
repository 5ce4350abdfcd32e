#include "stroke_area.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tests/support/check.h"

/* A stroke is the union of convex pieces: polygons, and parts of discs. */
struct piece {
    int n; /* corners; 0: the disc around v[0], in front of lines through that
              point in the directions v[1] and v[2] */
    double v[4][2], radius;
};

struct run {
    double from, to;
};

enum { PIECES = 256 };

static struct piece pieces[PIECES];
static int count;
static bool sure;

static void add_polygon(int n, const double v[][2])
{
    struct piece *const p = &pieces[count++];
    p->n = n;
    memcpy(p->v, v, (size_t)n * sizeof *v);
}

static void add_disc(const double *center, double radius, const double *front,
                     const double *other)
{
    struct piece *const p = &pieces[count++];
    p->n = 0;
    p->radius = radius;
    memcpy(p->v[0], center, sizeof p->v[0]);
    memcpy(p->v[1], front, sizeof p->v[1]);
    memcpy(p->v[2], other, sizeof p->v[2]);
}

/* The end at b of a line from a. */
static void add_cap(const double *a, const double *b, double half)
{
    const double front[2] = {b[0] - a[0], b[1] - a[1]};
    add_disc(b, half, front, front);
}

/* From a to b, longer at its ends by so much. */
static void add_line(const double *a, const double *b, double half, double from,
                     double to)
{
    const double l = hypot(b[0] - a[0], b[1] - a[1]);
    const double x = (b[0] - a[0]) / l, y = (b[1] - a[1]) / l;
    const double p[2] = {a[0] - from * x, a[1] - from * y};
    const double q[2] = {b[0] + to * x, b[1] + to * y};
    const double v[4][2] = {{p[0] + half * y, p[1] - half * x},
                            {q[0] + half * y, q[1] - half * x},
                            {q[0] - half * y, q[1] + half * x},
                            {p[0] - half * y, p[1] + half * x}};
    add_polygon(4, v);
}

/* The corner at b, of lines from a and to c. */
static void add_join(const double *a, const double *b, const double *c,
                     double half, const struct pel_stroke *stroke)
{
    const double l = hypot(b[0] - a[0], b[1] - a[1]);
    const double m = hypot(c[0] - b[0], c[1] - b[1]);
    const double ux = (b[0] - a[0]) / l, uy = (b[1] - a[1]) / l;
    const double wx = (c[0] - b[0]) / m, wy = (c[1] - b[1]) / m;
    const double side = ux * wy - uy * wx >= 0 ? half : -half;
    const double k = 1 + ux * wx + uy * wy;
    const double limit =
        (stroke->miter_limit ? stroke->miter_limit : 1024) / 256.;
    double v[4][2] = {{b[0], b[1]},
                      {b[0] + side * uy, b[1] - side * ux},
                      {b[0] + side * wy, b[1] - side * wx}};
    if (stroke->join == PEL_JOIN_ROUND) {
        const double front[2] = {ux, uy}, behind[2] = {-wx, -wy};
        add_disc(b, half, front, behind);
        return;
    }
    if (stroke->join == PEL_JOIN_MITER) {
        sure = sure && fabs(k * limit * limit - 2) > 1e-3;
        if (k * limit * limit >= 2) {
            memcpy(v[3], v[2], sizeof v[3]);
            v[2][0] = b[0] + side * (uy + wy) / k;
            v[2][1] = b[1] - side * (ux + wx) / k;
            add_polygon(4, (const double(*)[2])v);
            return;
        }
    }
    add_polygon(3, (const double(*)[2])v);
}

static void add_pieces(const struct pel_polyline_shape *line)
{
    const double half = line->stroke.width / 2 / 256.;
    const double square = line->stroke.cap == PEL_CAP_SQUARE ? half : 0;
    double v[66][2];
    int n = 0;
    for (int32_t i = 0; i < line->n + line->closed; i++) {
        const struct pel_point p = line->v[i % line->n];
        if (n > 0 && p.x / 256. == v[n - 1][0] && p.y / 256. == v[n - 1][1])
            continue;
        v[n][0] = p.x / 256.;
        v[n++][1] = p.y / 256.;
    }
    if (n == 1) {
        const double b[2] = {v[0][0], v[0][1] - half}, *a = v[0];
        const double none[2] = {0, 0};
        if (line->stroke.cap == PEL_CAP_ROUND)
            add_disc(a, half, none, none);
        else if (line->stroke.cap == PEL_CAP_SQUARE && half > 0)
            add_line(a, b, half, half, 0);
        return;
    }
    for (int i = 0; i + 1 < n; i++)
        add_line(v[i], v[i + 1], half, i || line->closed ? 0 : square,
                 i + 2 < n || line->closed ? 0 : square);
    for (int i = 1; i + 1 < n; i++)
        add_join(v[i - 1], v[i], v[i + 1], half, &line->stroke);
    if (line->closed)
        add_join(v[n - 2], v[0], v[1], half, &line->stroke);
    if (!line->closed && line->stroke.cap == PEL_CAP_ROUND) {
        add_cap(v[1], v[0], half);
        add_cap(v[n - 2], v[n - 1], half);
    }
}

/* Cuts off what lies behind: where f x + g < 0. */
static void cut(struct run *run, double f, double g)
{
    if (f > 0)
        run->from = fmax(run->from, -g / f);
    else if (f < 0)
        run->to = fmin(run->to, -g / f);
    else if (g < 0)
        run->to = run->from;
}

static bool run_of_disc(const struct piece *p, double y, struct run *run)
{
    const double d = y - p->v[0][1], w = p->radius * p->radius - d * d;
    if (w <= 0)
        return false;
    *run = (struct run){p->v[0][0] - sqrt(w), p->v[0][0] + sqrt(w)};
    for (int i = 1; i <= 2; i++)
        cut(run, p->v[i][0], p->v[i][1] * d - p->v[i][0] * p->v[0][0]);
    return run->from < run->to;
}

/* What a piece covers of a scanline; false: nothing. */
static bool run_of(const struct piece *p, double y, struct run *run)
{
    *run = (struct run){1e9, -1e9};
    if (p->n == 0)
        return run_of_disc(p, y, run);
    for (int i = 0; i < p->n; i++) {
        const double *const a = p->v[i], *const b = p->v[(i + 1) % p->n];
        if ((a[1] <= y) == (b[1] <= y))
            continue;
        const double x = a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]);
        run->from = fmin(run->from, x);
        run->to = fmax(run->to, x);
    }
    return run->from < run->to;
}

static int by_from(const void *a, const void *b)
{
    const double x = ((const struct run *)a)->from;
    const double y = ((const struct run *)b)->from;
    return (x > y) - (x < y);
}

static void add_run(double from, double to, double weight, double *area)
{
    from = fmax(from, 0);
    to = fmin(to, STROKE_AREA_SIZE);
    for (int x = (int)from; x < STROKE_AREA_SIZE && x < to; x++)
        area[x] += weight * (fmin(to, x + 1) - fmax(from, x));
}

/* Runs that overlap count once. */
static void add_scanline(double y, double x0, double weight, double *area)
{
    struct run run[PIECES];
    int n = 0;
    for (int i = 0; i < count; i++)
        if (run_of(&pieces[i], y, &run[n]))
            n++;
    qsort(run, (size_t)n, sizeof *run, by_from);
    double end = -1e9;
    for (int i = 0; i < n; i++) {
        if (run[i].to <= end)
            continue;
        add_run(fmax(run[i].from, end) - x0, run[i].to - x0, weight, area);
        end = run[i].to;
    }
}

bool stroke_area(const struct pel_polyline_shape *line, int32_t x0, int32_t y0,
                 int scanlines, double area[STROKE_AREA_SIZE][STROKE_AREA_SIZE])
{
    memset(area, 0, STROKE_AREA_SIZE * sizeof *area);
    count = 0;
    sure = true;
    if (line->n > 0 && line->stroke.width > 1)
        add_pieces(line);
    for (int y = 0; y < STROKE_AREA_SIZE; y++)
        for (int i = 0; i < scanlines; i++)
            add_scanline(y0 + y + (i + .5) / scanlines, x0, 1. / scanlines,
                         area[y]);
    return sure;
}

void stroke_print(const void *line)
{
    const struct pel_polyline_shape *const l = line;
    print_error("polyline of %d points, closed %d, width %d, cap %d, join %d, "
                "limit %d\n",
                l->n, l->closed, l->stroke.width, (int)l->stroke.cap,
                (int)l->stroke.join, l->stroke.miter_limit);
}
