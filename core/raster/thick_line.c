#include "thick_line.h"

#include "../base/divide.h"
#include "sides.h"

/* floor(sqrt(n)) for n < 2^62, a bit a turn. pel_square_root() is faster, but
 * with its table 300 bytes larger on a microcontroller; a line takes one
 * root. */
static uint32_t root(uint64_t n)
{
    uint64_t r = 0;
    for (uint64_t bit = UINT64_C(1) << 60; bit; bit >>= 2) {
        const uint64_t more = r + bit;
        r >>= 1;
        if (n >= more) {
            n -= more;
            r += bit;
        }
    }
    return (uint32_t)r;
}

/* A length of 2^30 <= size < 2^31 in units of 2^-shift sub-pixels. */
struct length {
    uint32_t size;
    int shift;
};

static PEL_NOINLINE_32 struct length length_of(int32_t dx, int32_t dy)
{
    struct length l = {0, 0};
    uint64_t square = (uint64_t)(pel_square(dx) + pel_square(dy));
    for (; square < UINT64_C(1) << 60; square <<= 2)
        l.shift++;
    l.size = root(square);
    return l;
}

/* round(v width / (2 l)), away from 0 at a tie. |v| is at most the length, so
 * the product is below 2^31 2^23. */
static PEL_NOINLINE_32 int32_t across(int32_t v, int32_t width,
                                      const struct length *l)
{
    const uint32_t size = (uint32_t)pel_magnitude(v) << l->shift;
    const uint64_t n = pel_multiply(size, (uint32_t)width) + l->size;
    const int32_t half = (int32_t)pel_divide(n, 2 * l->size);
    return v < 0 ? -half : half;
}

bool pel_thick_line_corners(const struct pel_thick_line_shape *line,
                            struct pel_point v[4])
{
    const struct pel_point a = line->from, b = line->to;
    if (!pel_thick_line_legal(line))
        return false;
    const int32_t dx = b.x - a.x, dy = b.y - a.y;
    struct pel_point n = {0, 0};
    if (dx || dy) {
        const struct length length = length_of(dx, dy);
        n.x = across(-dy, line->width, &length);
        n.y = across(dx, line->width, &length);
    }
    v[0] = (struct pel_point){a.x + n.x, a.y + n.y};
    v[1] = (struct pel_point){b.x + n.x, b.y + n.y};
    v[2] = (struct pel_point){b.x - n.x, b.y - n.y};
    v[3] = (struct pel_point){a.x - n.x, a.y - n.y};
    return pel_points_legal(v, 4);
}

struct walk {
    struct pel_point v[4]; /* corners */
    struct pel_side side[2];
    int32_t end; /* row */
    struct pel_spans spans;
    union pel_batch batch;
};

/* Starts at the first visible row; false where there is none. Steps are
 * functions of their own, to spare the stack of the paint. */
static PEL_NOINLINE_32 bool start(struct walk *w)
{
    const struct pel_point *const v = w->v;
    const struct pel_rect *const clip = &w->spans.surface->clip;
    int top = 0;
    for (int i = 1; i < 4; i++)
        if (v[i].y < v[top].y)
            top = i;
    const struct pel_point *const bottom = &v[(top + 2) & 3];
    w->end = pel_min(pel_first_pixel(bottom->y), clip->y1);
    w->spans.y = pel_max(pel_first_pixel(v[top].y), clip->y0);
    if (w->spans.y >= w->end)
        return false;
    w->side[0].end = &v[(top + 1) & 3];
    w->side[1].end = &v[(top + 3) & 3];
    w->side[0].last = w->side[1].last = bottom;
    pel_side_start(&w->side[0], &v[top], w->spans.y);
    pel_side_start(&w->side[1], &v[top], w->spans.y);
    return true;
}

static PEL_STEP void walk_rows(struct walk *w)
{
    struct pel_spans *const spans = &w->spans;
    spans->n = pel_min(w->end - spans->y, PEL_ROWS);
    pel_side_walk(&w->side[0], spans->y, w->batch.x, spans->n);
    pel_side_walk(&w->side[1], spans->y, w->batch.x + 1, spans->n);
    pel_spans_order(w->batch.span, spans->n, &spans->surface->clip);
}

/* False when its box has no pixel in the clip. */
static PEL_NOINLINE_32 bool is_visible(const struct pel_surface *surface,
                                       const struct pel_thick_line_shape *line)
{
    const struct pel_rect box = pel_thick_line_box(line);
    const struct pel_rect seen = pel_rect_pixels(&box, &surface->clip);
    return !pel_rect_empty(&seen);
}

void pel_thick_line(const struct pel_surface *surface,
                    const struct pel_thick_line_shape *line,
                    const struct pel_paint *paint)
{
    struct walk w;
    PEL_HINT(pel_thick_line_in_subpixels(line));
    if (pel_thick_line_legal(line) && !is_visible(surface, line))
        return;
    bool legal = pel_thick_line_corners(line, w.v);
    PEL_ASSERT(legal);
    w.spans = (struct pel_spans){surface, w.batch.span, 0, 0, 1};
    if (!legal || !start(&w))
        return;
    for (; w.spans.y < w.end; w.spans.y += w.spans.n) {
        walk_rows(&w);
        paint->fill(paint, &w.spans);
    }
}
