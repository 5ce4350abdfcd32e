/* Flat and Gouraud triangles on 32-bit pixels through a depth buffer, four
 * pixels at a time: the same bytes as pixel by pixel. Vectors may overlap
 * inside a span, since a pixel that has been stored is not nearer than itself.
 */
#include "../raster/gouraud_spans.h"
#include "../scene/depth.h"
#include "fast_triangle.h"

#if PEL_FAST_FILLS && PEL_VECTORS

/* What a row starts with. Depths are 32.32 numbers, of which the upper half is
 * stored. */
struct row {
    uint64_t depth;
    uint32_t color[3]; /* blue, green, red, 8.24 */
};

/* A triangle; all that stays the same from row to row. */
struct job {
    struct row at, down; /* at column 0, and the steps of a row */
    uint64_t dx;
    pel_u64x2 depth[2]; /* from the first pixel of four to each */
    pel_u32x4 value;    /* of a flat one */
    struct pel_gouraud_steps steps;
    bool gouraud, wide;
};

static PEL_ALWAYS_INLINE pel_u32x4 get_depths(const void *held, bool wide)
{
    if (wide)
        return pel_get_u32x4(held);
    uint16_t d[4];
    memcpy(d, held, 8);
    return (pel_u32x4){d[0], d[1], d[2], d[3]};
}

static PEL_ALWAYS_INLINE void put_depths(void *held, pel_u32x4 v, bool wide)
{
    const pel_u16x8 narrow = pel_narrow_u16x8(v, v);
    if (wide)
        pel_put_u32x4(held, v);
    else
        memcpy(held, &narrow, 8);
}

/* Tests four pixels. */
static PEL_ALWAYS_INLINE void draw_four(pel_word32 *p, void *held,
                                        const pel_u64x2 depth[2],
                                        pel_u32x4 value, bool wide)
{
    const pel_u32x4 number =
        PEL_LANES((pel_u32x4)depth[0], (pel_u32x4)depth[1], 1, 3, 5, 7) >>
        (wide ? 0 : 16);
    const pel_u32x4 old = get_depths(held, wide);
    const pel_u32x4 nearer = (pel_u32x4)(number > old);
    put_depths(held, (number & nearer) | (old & ~nearer), wide);
    pel_put_u32x4(p, (value & nearer) | (pel_get_u32x4(p) & ~nearer));
}

static PEL_ALWAYS_INLINE void draw_one(pel_word32 *p, void *held,
                                       uint64_t depth, uint32_t value,
                                       bool wide)
{
    const uint32_t number = (uint32_t)(depth >> (wide ? 32 : 48));
    if (number <= (wide ? *(uint32_t *)held : *(uint16_t *)held))
        return;
    if (wide)
        *(uint32_t *)held = number;
    else
        *(uint16_t *)held = (uint16_t)number;
    *p = value;
}

static PEL_ALWAYS_INLINE pel_u32x4 value_of(const struct job *j,
                                            struct pel_gouraud_four color)
{
    return j->gouraud ? pel_gouraud_xrgb4(color) : j->value;
}

/* The first, the middle and the last of fewer than four pixels. */
static PEL_ALWAYS_INLINE void draw_few(const struct job *j, pel_word32 *p,
                                       uint8_t *held, int32_t n, uint64_t depth,
                                       pel_u32x4 value, bool wide)
{
    const int32_t size = wide ? 4 : 2;
    for (int32_t i = 0; i < n; i++, depth += j->dx)
        draw_one(p + i, held + i * size, depth, value[i & 3], wide);
}

static PEL_ALWAYS_INLINE void draw_span(const struct job *j, pel_word32 *p,
                                        uint8_t *held, int32_t n,
                                        const struct row *at, bool wide)
{
    const size_t size = wide ? 4 : 2;
    const pel_u64x2 first = {at->depth, at->depth};
    pel_u64x2 depth[2] = {first + j->depth[0], first + j->depth[1]};
    struct pel_gouraud_four color =
        pel_gouraud_add(j->steps.lanes, pel_gouraud_times(at->color, 1));
    if (n < 4) {
        draw_few(j, p, held, n, at->depth, value_of(j, color), wide);
        return;
    }
    const uint32_t last = (uint32_t)n - 4;
    const uint64_t way = last * j->dx;
    const pel_u64x2 end[2] = {depth[0] + way, depth[1] + way};
    const pel_u32x4 value = value_of(
        j, pel_gouraud_add(color, pel_gouraud_times(j->steps.dx, last)));
    for (uint32_t i = 0; i < last; i += 4) {
        draw_four(p + i, held + i * size, depth, value_of(j, color), wide);
        depth[0] += 4 * j->dx;
        depth[1] += 4 * j->dx;
        color = pel_gouraud_add(color, j->steps.next);
    }
    draw_four(p + last, held + last * size, end, value, wide);
}

static PEL_ALWAYS_INLINE void draw_rows(const struct job *job,
                                        const struct pel_depth *d,
                                        const struct pel_surface *s,
                                        const struct pel_fast_triangle *t,
                                        bool gouraud, bool wide)
{
    struct job j = *job;
    struct pel_fast_walk w = pel_fast_walk_begin(s, t, 4);
    const uintptr_t size = wide ? 4 : 2;
    const uintptr_t pitch =
        size * (uintptr_t)(ptrdiff_t)(d->bounds.x1 - d->bounds.x0);
    uintptr_t held = (uintptr_t)d->values - size * (uintptr_t)d->bounds.x0 +
                     pitch * (uintptr_t)(ptrdiff_t)(t->y0 - d->bounds.y0);
    j.gouraud = gouraud;
    for (int32_t x, n; pel_fast_walk_next(&w, &x, &n); held += pitch) {
        struct row at = j.at;
        at.depth += (uint64_t)x * j.dx;
        for (int k = 0; gouraud && k < 3; k++)
            at.color[k] += (uint32_t)x * j.steps.dx[k];
        draw_span(&j, (pel_word32 *)(w.row + 4 * (uintptr_t)x),
                  (uint8_t *)(held + size * (uintptr_t)x), n, &at, wide);
        j.at.depth += j.down.depth;
        if (gouraud)
            pel_gouraud_step(j.at.color, j.down.color);
    }
}

static void set_depth(struct job *j, const struct pel_plane *plane, int32_t y)
{
    j->dx = plane->dx << 10;
    j->at.depth = pel_plane_at(plane, 0, y) << 10;
    j->down.depth = plane->dy << 10;
    j->depth[0] = (pel_u64x2){0, j->dx};
    j->depth[1] = j->depth[0] + 2 * j->dx;
}

static bool set_color(struct job *j, const struct pel_paint *paint,
                      const struct pel_surface *s, int32_t y)
{
    const struct pel_gouraud *g = (const struct pel_gouraud *)paint;
    const struct pel_flat *flat = (const struct pel_flat *)paint;
    j->gouraud = paint->fast == pel_gouraud_fast;
    if (j->gouraud) {
        j->steps = pel_gouraud_steps_make(g, 1);
        pel_gouraud_at(g, 0, y, j->at.color);
        for (int k = 0; k < 3; k++)
            j->down.color[k] = g->dy[k];
        return pel_gouraud_bytes(g, s->format) == 4;
    }
    if (paint->fast != pel_flat_fast || s->format->id >= 128 ||
        s->format->bits != 32 || pel_alpha(flat->color) != 255)
        return false;
    j->value = (pel_u32x4){0} + s->format->pack(flat->color);
    return true;
}

bool pel_depth_fast(const struct pel_paint *paint,
                    const struct pel_surface *surface,
                    const struct pel_fast_triangle *triangle)
{
    const struct pel_depth_paint *p = (const void *)paint;
    const bool wide = p->depth->bits == 32;
    struct job j;
    if (!p->keeps || !pel_rect_inside(&surface->clip, &p->depth->bounds) ||
        !set_color(&j, p->inner, surface, triangle->y0))
        return false;
    set_depth(&j, &p->plane, triangle->y0);
    if (j.gouraud && wide)
        draw_rows(&j, p->depth, surface, triangle, true, true);
    else if (j.gouraud)
        draw_rows(&j, p->depth, surface, triangle, true, false);
    else if (wide)
        draw_rows(&j, p->depth, surface, triangle, false, true);
    else
        draw_rows(&j, p->depth, surface, triangle, false, false);
    return true;
}

#elif PEL_FAST_FILLS

bool pel_depth_fast(const struct pel_paint *paint,
                    const struct pel_surface *surface,
                    const struct pel_fast_triangle *triangle)
{
    (void)paint;
    (void)surface;
    (void)triangle;
    return false;
}

#endif
