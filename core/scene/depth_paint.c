#include "depth.h"

/* A value, 2^-24 of 0..2^30, as 32 bits; below 0 only by rounding. */
static inline uint32_t number_of(uint64_t value)
{
    return (int64_t)value < 0 ? 0 : (uint32_t)(value >> 22);
}

static inline bool nearer16(uint16_t *held, uint64_t value, bool keeps)
{
    const uint16_t number = (uint16_t)(number_of(value) >> 16);
    const bool nearer = number > *held;
    if (nearer && keeps)
        *held = number;
    return nearer;
}

static inline bool nearer32(uint32_t *held, uint64_t value, bool keeps)
{
    const uint32_t number = number_of(value);
    const bool nearer = number > *held;
    if (nearer && keeps)
        *held = number;
    return nearer;
}

/* Where from x on, up to x1, the first pixel is that is nearer, or is not. */
static int32_t skip(const struct pel_depth_paint *p, int32_t x, int32_t x1,
                    int32_t y, bool nearer)
{
    const struct pel_rect *b = &p->depth->bounds;
    const size_t at =
        (size_t)(y - b->y0) * (size_t)(b->x1 - b->x0) + (size_t)(x - b->x0);
    uint64_t value = pel_plane_at(&p->plane, x, y);
    if (p->depth->bits == 16) {
        uint16_t *held = (uint16_t *)p->depth->values + at;
        while (x < x1 && nearer16(held, value, p->keeps) == nearer) {
            x++;
            held++;
            value += p->plane.dx;
        }
    } else {
        uint32_t *held = (uint32_t *)p->depth->values + at;
        while (x < x1 && nearer32(held, value, p->keeps) == nearer) {
            x++;
            held++;
            value += p->plane.dx;
        }
    }
    return x;
}

/* Runs that go to the inner paint at a time. */
enum { RUNS = PEL_64BIT ? 8 : 4 };

/* Runs of one line, so the step is 0. The pixel at which a run begins was
 * found, and with `keeps` noted, by the search for it. */
static void fill_line(const struct pel_depth_paint *p,
                      const struct pel_spans *spans,
                      const struct pel_span *line, int32_t y)
{
    const struct pel_rect *b = &p->depth->bounds;
    struct pel_span run[RUNS];
    struct pel_spans out = {spans->surface, run, y, 0, 0};
    const int32_t end = pel_min(line->x1, b->x1);
    int32_t x = pel_max(line->x0, b->x0);
    if (y < b->y0 || y >= b->y1)
        return;
    while ((x = skip(p, x, end, y, false)) < end) {
        run[out.n].x0 = x;
        run[out.n++].x1 = x = skip(p, x + 1, end, y, true);
        if (out.n == RUNS) {
            p->inner->fill(p->inner, &out);
            out.n = 0;
        }
        x++;
    }
    if (out.n)
        p->inner->fill(p->inner, &out);
}

static void fill(const struct pel_paint *paint, const struct pel_spans *spans)
{
    const struct pel_depth_paint *p = (const void *)paint;
    int32_t y = spans->y;
    for (int32_t i = 0; i < spans->n; i++, y += spans->step)
        fill_line(p, spans, &spans->span[i], y);
}

static void set(struct pel_depth_paint *paint, const struct pel_paint *inner,
                const struct pel_depth *depth, const struct pel_plane *plane)
{
    paint->inner = inner;
    paint->depth = depth;
    paint->plane = *plane;
}

void pel_depth_paint_init(struct pel_depth_paint *paint,
                          const struct pel_paint *inner,
                          const struct pel_depth *depth,
                          const struct pel_plane *plane, bool keeps)
{
    set(paint, inner, depth, plane);
    paint->base.paint = (struct pel_paint){fill, NULL};
    paint->keeps = keeps;
}

/* The others become clear, which leaves a pixel as it is. */
static void colors(const struct pel_color_paint *paint, int32_t x, int32_t y,
                   int32_t n, pel_color *out)
{
    const struct pel_depth_paint *p = (const void *)paint;
    const struct pel_color_paint *inner = (const void *)p->inner;
    const struct pel_rect *b = &p->depth->bounds;
    const bool inside = y >= b->y0 && y < b->y1;
    inner->colors(inner, x, y, n, out);
    for (const pel_color *end = out + n; out < end; out++, x++)
        if (!inside || x < b->x0 || x >= b->x1 || pel_alpha(*out) < 255 ||
            skip(p, x, x + 1, y, false) > x)
            *out = 0;
}

void pel_depth_texels_init(struct pel_depth_paint *paint,
                           const struct pel_color_paint *inner,
                           const struct pel_depth *depth,
                           const struct pel_plane *plane)
{
    set(paint, &inner->paint, depth, plane);
    pel_color_paint_init(&paint->base, colors, false);
    paint->keeps = true;
}
