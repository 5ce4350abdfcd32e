/* Paths: verbs and points, and curves as lines.
 *
 * With a = p0, a curve is a + C t + B t^2 + A t^3, where a quadratic one has
 * A = 0, B = p0 - 2 p1 + p2, C = 2 (p1 - p0), and a cubic one
 * A = p3 - 3 p2 + 3 p1 - p0, B = 3 (p0 - 2 p1 + p2), C = 3 (p1 - p0). Between
 * two values of t that are 1 / n apart it lies at most max |second derivative|
 * / 8 n^2 from the line between, and that derivative is linear: it is the
 * largest at an end, 2 B or 2 B + 6 A. So n^2 >= max(|B|, |B + 3 A|) / (4
 * tolerance) are enough. n is a power of two, 4,096 at most: |B| and |B + 3 A|
 * are below 2^26.6 in each direction, and the tolerance less the rounding of
 * points is 3 at least. */
#include "pen.h"
#include "transform.h"

static const uint8_t points_of[PEL_CLOSE + 1] = {1, 1, 2, 3, 0};

/* Adds to *to a coordinate of a point by the row (a, b) of the transform;
 * false: out of range. Sums are modulo 2^64: one that wraps is far out of
 * range. */
static bool transform(int32_t a, int32_t b, int32_t x, int32_t y, int32_t *to)
{
    const uint64_t sum = (uint64_t)pel_long_product(a, x) +
                         (uint64_t)pel_long_product(b, y) + 32768;
    const int64_t at = ((int64_t)sum >> 16) + *to;
    *to = (int32_t)at;
    return at >= PEL_COORDINATE_MIN && at <= PEL_COORDINATE_MAX;
}

bool pel_transform_point(const struct pel_transform *t, int32_t x, int32_t y,
                         struct pel_point *to)
{
    *to = t->at;
    return transform(t->xx, t->xy, x, y, &to->x) &&
           transform(t->yx, t->yy, x, y, &to->y);
}

/* Sets *to to the next point; false: it is out of range. */
static bool take_point(struct pel_path_state *w, struct pel_point *to)
{
    const struct pel_transform *const t = w->shape->transform;
    const struct pel_path *const path = w->shape->path;
    const int32_t i = 2 * w->next++;
    const int32_t x = path->points16 ? path->points16[i] : path->points32[i];
    const int32_t y =
        path->points16 ? path->points16[i + 1] : path->points32[i + 1];
    *to = (struct pel_point){x, y};
    return t ? pel_transform_point(t, x, y, to) : pel_point_legal(*to);
}

/* Not less than the length of a vector, nor above 1.12 of it. */
static int32_t size_of(int32_t x, int32_t y)
{
    x = pel_magnitude(x);
    y = pel_magnitude(y);
    return pel_max(x, y) + pel_min(x, y) / 2 + 1;
}

/* Of a curve of n points. */
static struct pel_factors factors_of(const int32_t *p, int n)
{
    struct pel_factors f = {2 * (p[2] - p[0]), p[0] - 2 * p[2] + p[4], 0};
    if (n == 3)
        f = (struct pel_factors){3 * (p[2] - p[0]), 3 * f.b,
                                 p[6] - 3 * p[4] + 3 * p[2] - p[0]};
    return f;
}

/* log2 of how many lines it becomes. */
static int parts_of(const struct pel_factors *x, const struct pel_factors *y,
                    int32_t tolerance)
{
    const int32_t size =
        pel_max(size_of(x->b, y->b), size_of(x->b + 3 * x->a, y->b + 3 * y->a));
    int k = 0;
    while (size >> 2 * (k + 1) >= tolerance - 1)
        k++;
    return k;
}

/* Where t = i / 2^k is, from t = 0, rounded. The product is what this times
 * 2^3k is, below 2^60; sums before it wrap around. */
static int32_t move_of(const struct pel_factors *f, int32_t i, int k)
{
    const uint64_t b = (uint64_t)(int64_t)f->b << k;
    const uint64_t c = (uint64_t)(int64_t)f->c << 2 * k;
    const uint64_t ab = (uint64_t)pel_product(f->a, i) + b;
    const uint64_t all = pel_times(pel_times(ab, i) + c, i);
    return (int32_t)((int64_t)(all + ((UINT64_C(1) << 3 * k) >> 1)) >> 3 * k);
}

static PEL_NOINLINE void set_point(struct pel_curves *w)
{
    w->to.x = w->v[0].x + move_of(&w->x, w->i, w->k);
    w->to.y = w->v[0].y + move_of(&w->y, w->i, w->k);
}

static PEL_NOINLINE void set_curve(struct pel_curves *w, int n)
{
    w->x = factors_of(&w->v[0].x, n);
    w->y = factors_of(&w->v[0].y, n);
    w->k = parts_of(&w->x, &w->y, w->tolerance ? w->tolerance : 16);
    const struct pel_rect box = pel_points_box(w->v, n + 1);
    w->seen = box.y1 >= w->pen->top && box.y0 <= w->pen->bottom;
}

static enum pel_status draw_curve(struct pel_curves *w, int n)
{
    set_curve(w, n);
    enum pel_status status = PEL_OK;
    for (w->i = 1; w->i < 1 << w->k && status == PEL_OK; w->i++) {
        set_point(w);
        status = w->pen->draw(w->pen, PEL_LINE, &w->to);
        if (!w->seen)
            w->i = pel_max(w->i, (1 << w->k) - 2);
    }
    return status == PEL_OK ? w->pen->draw(w->pen, PEL_LINE, &w->v[n]) : status;
}

/* A part that begins where the one before it was closed. */
static enum pel_status begin_again(struct pel_curves *w)
{
    if (!w->closed)
        return PEL_OK;
    w->closed = false;
    return w->pen->draw(w->pen, PEL_MOVE, &w->start);
}

enum pel_status pel_curves_add(struct pel_curves *w, enum pel_verb verb)
{
    const int n = points_of[verb];
    enum pel_status status = PEL_OK;
    if (verb == PEL_MOVE)
        w->closed = false;
    else
        status = begin_again(w);
    if (verb == PEL_MOVE)
        w->start = w->v[1];
    if (status == PEL_OK)
        status =
            n > 1 ? draw_curve(w, n) : w->pen->draw(w->pen, verb, &w->v[1]);
    w->closed = verb == PEL_CLOSE;
    w->v[0] = w->closed ? w->start : w->v[n];
    return status;
}

/* Is it a verb, at its place, whose points are there? */
static bool is_legal(const struct pel_path_state *w, uint32_t verb)
{
    return verb <= PEL_CLOSE && w->points - w->next >= points_of[verb] &&
           (w->begun || verb == PEL_MOVE);
}

static PEL_NOINLINE enum pel_status take_points(struct pel_path_state *w,
                                                uint32_t verb)
{
    if (!is_legal(w, verb))
        return PEL_ERROR_FORMAT;
    for (int i = 1; i <= points_of[verb]; i++)
        if (!take_point(w, &w->curves.v[i]))
            return PEL_ERROR_RANGE;
    w->begun = true;
    return PEL_OK;
}

static bool has_verb(const struct pel_path_state *w)
{
    const struct pel_path *const path = w->shape->path;
    return w->verb < path->verbs + path->verb_count;
}

static enum pel_status take_verb(struct pel_path_state *w)
{
    const enum pel_status status = take_points(w, *w->verb++);
    return status == PEL_OK
               ? pel_curves_add(&w->curves, (enum pel_verb)w->verb[-1])
               : status;
}

static enum pel_status check(const struct pel_path *path)
{
    if (!path || !path->verbs || !path->points16 == !path->points32)
        return PEL_ERROR_NULL;
    return path->verb_count < 0 || path->point_count < 0 ||
                   path->point_count > INT32_MAX / 2
               ? PEL_ERROR_FORMAT
               : PEL_OK;
}

enum pel_status pel_path_check(const struct pel_path *path)
{
    enum pel_status status = check(path);
    int32_t points = 0;
    if (status != PEL_OK)
        return status;
    for (int32_t i = 0; i < path->verb_count; i++) {
        const uint8_t verb = path->verbs[i];
        if (verb > PEL_CLOSE || (i == 0 && verb != PEL_MOVE) ||
            path->point_count - points < points_of[verb])
            return PEL_ERROR_FORMAT;
        points += points_of[verb];
    }
    return points == path->point_count ? PEL_OK : PEL_ERROR_FORMAT;
}

static PEL_NOINLINE enum pel_status begin(const struct pel_path_shape *shape,
                                          struct pel_pen *pen)
{
    const int32_t tolerance = shape->tolerance;
    struct pel_path_state *const w = pen->memory;
    const enum pel_status status = check(shape->path);
    if (status != PEL_OK)
        return status;
    if (!pel_tolerance_legal(tolerance))
        return PEL_ERROR_RANGE;
    w->shape = shape;
    w->verb = shape->path->verbs;
    w->next = 0;
    w->points = shape->path->point_count;
    w->begun = w->curves.closed = false;
    w->curves.pen = pen;
    w->curves.tolerance = tolerance;
    return PEL_OK;
}

enum pel_status pel_path_walk(const void *shape, struct pel_pen *pen)
{
    struct pel_path_state *const w = pen->memory;
    enum pel_status status = begin(shape, pen);
    if (status != PEL_OK)
        return status;
    while (status == PEL_OK && has_verb(w))
        status = take_verb(w);
    if (status == PEL_OK && w->next < w->points)
        status = PEL_ERROR_FORMAT;
    return status == PEL_OK ? w->curves.pen->draw(w->curves.pen, PEL_MOVE, NULL)
                            : status;
}
