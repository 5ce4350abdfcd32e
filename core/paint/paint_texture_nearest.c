#include "../format/word.h"
#include "paint_texture_fetch.h"

/* The texel where the coordinate is, or the one that stands for it. */
static inline int32_t in_picture(uint64_t *at, struct pel_texture_side side)
{
    return pel_texture_texel(side, pel_texture_index(at, side.period));
}

/* Where stack or code is scarce a side is not kept from pixel to pixel. */
enum { SIDES_ANEW = PEL_SHORT_STACK || PEL_SMALL_CODE };

static PEL_NOINLINE int32_t in_side(uint64_t *at, int32_t size, int wrap)
{
    return in_picture(at, pel_texture_side_of(size, wrap));
}

/* The column and the line of a texel. */
static PEL_ALWAYS_INLINE struct pel_point texel_at(
    struct pel_texture_axes *a, const struct pel_texture *p,
    struct pel_texture_side across, struct pel_texture_side down)
{
    if (SIDES_ANEW)
        return pel_point_of(in_side(&a->u, p->width, p->wrap_u),
                            in_side(&a->v, p->height, p->wrap_v));
    return pel_point_of(in_picture(&a->u, across), in_picture(&a->v, down));
}

static void outer_run(const struct pel_texture *p, struct pel_texture_axes *a,
                      int32_t n, pel_color *out)
{
    const struct pel_texture_side across =
        pel_texture_side_of(p->width, p->wrap_u);
    const struct pel_texture_side down =
        pel_texture_side_of(p->height, p->wrap_v);
    for (; n > 0; n--, pel_texture_axes_step(a, p)) {
        const struct pel_point at = texel_at(a, p, across, down);
        *out++ = pel_texel(p, p->kind, at.x, at.y);
    }
}

/* A run that does not leave the picture. */
static PEL_ALWAYS_INLINE void inner_run(const struct pel_texture *p, int kind,
                                        struct pel_texture_axes *a, int32_t n,
                                        pel_color *out)
{
    struct pel_texture_axes at = *a;
    do {
        *out++ =
            pel_texel(p, kind, (int32_t)(at.u >> 32), (int32_t)(at.v >> 32));
        pel_texture_axes_step(&at, p);
    } while (--n);
}

static PEL_STEP void inner_runs(const struct pel_texture *p,
                                struct pel_texture_axes *a, int32_t n,
                                pel_color *out)
{
    pel_texture_run(p, a, n, out, inner_run);
}

static void colors(const struct pel_color_paint *paint, int32_t x, int32_t y,
                   int32_t n, pel_color *out)
{
    const struct pel_texture *p = (const void *)paint;
    struct pel_texture_axes a;
    pel_texture_axes_start(&a, p, x, y);
    if (pel_texture_axes_inside(&a, p, n, 0) && !PEL_SMALL_CODE)
        inner_runs(p, &a, n, out);
    else
        outer_run(p, &a, n, out);
}

/* Between surfaces of one format of 16 bits: texels are copied as they are. */
struct copy {
    const struct pel_texture *paint;
    pel_word16 *out, *end;
};

static inline pel_word16 texel16(const uint8_t *memory, int32_t stride,
                                 int32_t u, int32_t v)
{
    const void *line = memory + v * (ptrdiff_t)stride;
    return ((const pel_word16 *)line)[u];
}

#if defined(__GNUC__) && defined(__thumb2__) && defined(__OPTIMIZE__)

/* A run that does not leave the picture, in 32 bits for few registers: u's
 * carry is a column more, v's carry a line, and v's whole lines are in the step
 * of the column. Line and column may go far off in opposite directions: their
 * sum counts, modulo 2^32. */
struct inner {
    uint32_t line, column;
    uint32_t u, v; /* fractions */
    uint32_t stride, columns, du, dv;
};

/* Compilers do not find that the sums leave carries. */
static PEL_ALWAYS_INLINE pel_word16 next_texel(struct inner *w)
{
    const pel_word16 texel = *(const pel_word16 *)(w->line + 2 * w->column);
    __asm__("adds %0, %0, %4\n\t"
            "adc %1, %1, %5\n\t"
            "adds %2, %2, %6\n\t"
            "it cs\n\t"
            "addcs %3, %3, %7"
            : "+&r"(w->u), "+&r"(w->column), "+&r"(w->v), "+&r"(w->line)
            : "r"(w->du), "r"(w->columns), "r"(w->dv), "r"(w->stride)
            : "cc");
    return texel;
}

static inline uint32_t whole(uint64_t at)
{
    return (uint32_t)(at >> 32);
}

static struct inner inner_start(const struct pel_texture *p,
                                const struct pel_texture_axes *a)
{
    const uint64_t du = p->map.u.dx, dv = p->map.v.dx;
    const uint32_t stride = (uint32_t)p->stride;
    const uint32_t texels = (uint32_t)(p->stride / 2);
    return (struct inner){(uint32_t)p->memory + whole(a->v) * stride,
                          whole(a->u),
                          (uint32_t)a->u,
                          (uint32_t)a->v,
                          stride,
                          whole(du) + whole(dv) * texels,
                          (uint32_t)du,
                          (uint32_t)dv};
}

/* Four turns in one, with 7.75 instructions a pixel. */
static PEL_NOINLINE void copy_inner_run(const struct copy *c,
                                        const struct pel_texture_axes *a)
{
    struct inner w = inner_start(c->paint, a);
    pel_word16 *out = c->out;
    for (int32_t fours = (int32_t)(c->end - out) / 4; fours; fours--) {
        out[0] = next_texel(&w);
        out[1] = next_texel(&w);
        out[2] = next_texel(&w);
        out[3] = next_texel(&w);
        out += 4;
    }
    for (pel_word16 *const end = c->end; out != end; out++)
        *out = next_texel(&w);
}

#else

/* A run that does not leave the picture. */
static PEL_NOINLINE void copy_inner_run(const struct copy *c,
                                        const struct pel_texture_axes *a)
{
    const struct pel_texture *p = c->paint;
    const uint8_t *const memory = p->memory;
    const int32_t stride = p->stride;
    const uint64_t du = p->map.u.dx, dv = p->map.v.dx;
    uint64_t u = a->u, v = a->v;
    pel_word16 *const end = c->end;
    for (pel_word16 *out = c->out; out != end; u += du, v += dv)
        *out++ =
            texel16(memory, stride, (int32_t)(u >> 32), (int32_t)(v >> 32));
}

#endif

static PEL_NOINLINE void copy_masked_run(const struct copy *c,
                                         const struct pel_texture_axes *a)
{
    const struct pel_texture *p = c->paint;
    const int32_t u_mask = p->width - 1, v_mask = p->height - 1;
    const uint8_t *const memory = p->memory;
    const int32_t stride = p->stride;
    const uint64_t du = p->map.u.dx, dv = p->map.v.dx;
    uint64_t u = a->u, v = a->v;
    pel_word16 *const end = c->end;
    for (pel_word16 *out = c->out; out != end; u += du, v += dv)
        *out++ = texel16(memory, stride, (int32_t)(u >> 32) & u_mask,
                         (int32_t)(v >> 32) & v_mask);
}

static PEL_NOINLINE void copy_outer_run(const struct copy *c,
                                        struct pel_texture_axes *a)
{
    const struct pel_texture *p = c->paint;
    const struct pel_texture_side across =
        pel_texture_side_of(p->width, p->wrap_u);
    const struct pel_texture_side down =
        pel_texture_side_of(p->height, p->wrap_v);
    for (pel_word16 *out = c->out; out != c->end; out++) {
        const struct pel_point at = texel_at(a, p, across, down);
        *out = texel16(p->memory, p->stride, at.x, at.y);
        pel_texture_axes_step(a, p);
    }
}

static void copy_run(const struct copy *c, int32_t x, int32_t y)
{
    struct pel_texture_axes a;
    pel_texture_axes_start(&a, c->paint, x, y);
    if (pel_texture_axes_inside(&a, c->paint, (int32_t)(c->end - c->out), 0))
        copy_inner_run(c, &a);
    else if (pel_texture_is_masked(c->paint->width, c->paint->wrap_u) &&
             pel_texture_is_masked(c->paint->height, c->paint->wrap_v))
        copy_masked_run(c, &a);
    else
        copy_outer_run(c, &a);
}

static PEL_NOINLINE void copy_rows(const struct pel_texture *p,
                                   const struct pel_surface *surface,
                                   const struct pel_spans *spans)
{
    const struct pel_span *span = spans->span;
    struct copy c = {p, NULL, NULL};
    for (int32_t i = 0, y = spans->y; i < spans->n;
         i++, span++, y += spans->step) {
        if (span->x0 >= span->x1)
            continue;
        c.out = pel_address16(surface, span->x0, y);
        c.end = c.out + (span->x1 - span->x0);
        copy_run(&c, span->x0, y);
    }
}

/* Without vectors. */
static void fill_plain(const struct pel_paint *paint,
                       const struct pel_spans *spans)
{
    const struct pel_texture *p = (const void *)paint;
    const struct pel_surface *s = pel_texture_copied_to(p, spans->surface);
    if (s)
        copy_rows(p, s, spans);
    else
        pel_color_paint_fill(paint, spans);
}

static void fill(const struct pel_paint *paint, const struct pel_spans *spans)
{
    if (!PEL_FAST_FILLS || !PEL_VECTORS ||
        !pel_texture_nearest_fast((const void *)paint, spans, fill_plain))
        fill_plain(paint, spans);
}

enum pel_status pel_texture_init_nearest(struct pel_texture *paint,
                                         const struct pel_texels *texels,
                                         const struct pel_texture_map *map)
{
    enum pel_status status = pel_texture_set(paint, texels, map);
    if (status != PEL_OK)
        return status;
    pel_color_paint_init(&paint->base, colors, paint->base.opaque);
    if (PEL_FAST_FILLS || paint->surface) /* else nothing is copied */
        paint->base.paint.fill = fill;
    return PEL_OK;
}
