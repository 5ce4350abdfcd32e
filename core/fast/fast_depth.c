/* Flat and Gouraud triangles on 32-bit pixels through a depth buffer, four
 * pixels at a time: the same bytes as pixel by pixel. Vectors may overlap
 * inside a span, since a pixel that has been stored is not nearer than itself.
 */
#include "../format/span32.h"
#include "../raster/gouraud_spans.h"
#include "../scene/depth.h"
#include "fast_triangle.h"

#if PEL_FAST_FILLS && PEL_VECTORS

/* What stays the same from row to row. Depths are 32.32 numbers, of which the
 * upper half is stored. */
struct steps {
    uint64_t dx;
    pel_u64x2 depth[2]; /* from the first pixel of four to each */
    pel_u32x4 value;    /* of a flat triangle */
    pel_u32x4 dcolor;   /* of a Gouraud one, a pixel on */
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

/* n pixels of a row; depth and color are those of the first. */
struct run {
    pel_word32 *p;
    uint8_t *held;
    int32_t n;
    uint64_t depth;
    pel_u32x4 color;
};

/* With constant `gouraud` and `wide`. Single pixels where there are fewer than
 * four. */
static PEL_ALWAYS_INLINE void draw_run(const struct steps *s,
                                       const struct run *r, bool gouraud,
                                       bool wide)
{
    pel_word32 *const p = r->p;
    uint8_t *const held = r->held;
    const int32_t n = r->n;
    uint64_t depth = r->depth;
    const int32_t size = wide ? 4 : 2;
    pel_u32x4 c = r->color, value = s->value;
    if (gouraud)
        value = pel_gouraud_xrgb4(c, s->dcolor);
    if (n < 4) {
        for (int32_t i = 0; i < n; i++, depth += s->dx)
            draw_one(p + i, held + i * size, depth, value[i & 3], wide);
        return;
    }
    const pel_u64x2 first = {depth, depth};
    pel_u64x2 at[2] = {first + s->depth[0], first + s->depth[1]};
    const uint32_t last = (uint32_t)n - 4;
    const uint64_t length = last * s->dx;
    const pel_u64x2 end[2] = {at[0] + length, at[1] + length};
    pel_u32x4 end_value = value;
    if (gouraud)
        end_value = pel_gouraud_xrgb4(c + last * s->dcolor, s->dcolor);
    for (uint32_t i = 0; i < last; i += 4) {
        draw_four(p + i, held + (int32_t)i * size, at, value, wide);
        at[0] += 4 * s->dx;
        at[1] += 4 * s->dx;
        if (gouraud) {
            c += 4 * s->dcolor;
            value = pel_gouraud_xrgb4(c, s->dcolor);
        }
    }
    draw_four(p + last, held + (int32_t)last * size, end, end_value, wide);
}

static PEL_ALWAYS_INLINE void draw_rows(const struct pel_depth_paint *paint,
                                        const struct pel_surface *surface,
                                        const struct pel_fast_triangle *t,
                                        bool gouraud, bool wide)
{
    const struct pel_flat *flat = (const struct pel_flat *)paint->inner;
    const struct pel_gouraud *g = (const struct pel_gouraud *)paint->inner;
    const struct pel_depth *d = paint->depth;
    struct pel_fast_walk w = pel_fast_walk_begin(surface, t, 4);
    const uintptr_t size = wide ? 4 : 2;
    const uintptr_t pitch =
        size * (uintptr_t)(ptrdiff_t)(d->bounds.x1 - d->bounds.x0);
    uintptr_t held = (uintptr_t)d->values - size * (uintptr_t)d->bounds.x0 +
                     pitch * (uintptr_t)(ptrdiff_t)(t->y0 - d->bounds.y0);
    uint64_t depth = pel_plane_at(&paint->plane, 0, t->y0) << 10;
    const uint64_t dx = paint->plane.dx << 10, dy = paint->plane.dy << 10;
    struct steps s = {.dx = dx, .depth = {{0, dx}, {2 * dx, 3 * dx}}};
    pel_u32x4 start = {0}, down = {0};
    if (gouraud) {
        s.dcolor = pel_get_u32x4(g->dx);
        down = pel_get_u32x4(g->dy);
        start = pel_gouraud_row(g, t->y0);
    } else {
        s.value = pel_make_value32(surface->format->pack(flat->color));
    }
    for (int32_t x, n; pel_fast_walk_next(&w, &x, &n);) {
        const struct run r = {.p = (pel_word32 *)(w.row + 4 * (uintptr_t)x),
                              .held = (uint8_t *)(held + size * (uintptr_t)x),
                              .n = n,
                              .depth = depth + (uint64_t)x * dx,
                              .color = start + (uint32_t)x * s.dcolor};
        draw_run(&s, &r, gouraud, wide);
        start += down;
        depth += dy;
        held += pitch;
    }
}

/* As one vector writes them. */
static bool is_flat32(const struct pel_paint *paint,
                      const struct pel_format *format)
{
    return paint->fast == pel_flat_fast && format->id < 128 &&
           format->bits == 32 &&
           pel_alpha(((const struct pel_flat *)paint)->color) == 255;
}

bool pel_depth_fast(const struct pel_paint *paint,
                    const struct pel_surface *surface,
                    const struct pel_fast_triangle *triangle)
{
    const struct pel_depth_paint *p = (const void *)paint;
    if (!p->keeps || !pel_rect_inside(&surface->clip, &p->depth->bounds))
        return false;
    const bool wide = p->depth->bits == 32;
    if (is_flat32(p->inner, surface->format)) {
        if (wide)
            draw_rows(p, surface, triangle, false, true);
        else
            draw_rows(p, surface, triangle, false, false);
        return true;
    }
    if (p->inner->fill != pel_gouraud_fill ||
        pel_gouraud_bytes((const void *)p->inner, surface->format) != 4)
        return false;
    if (wide)
        draw_rows(p, surface, triangle, true, true);
    else
        draw_rows(p, surface, triangle, true, false);
    return true;
}

#endif
