#include "fast_texture.h"

#if PEL_FAST_FILLS && PEL_VECTORS

/* Runs are inside whose texels and those `more` further right and down are;
 * with a mask any texel is. */
struct pel_texture_steps pel_texture_steps_make(
    const struct pel_texture *p, const struct pel_texture_writer *w)
{
    const uint64_t du = p->map.u.dx, dv = p->map.v.dx;
    const uint32_t width = (uint32_t)p->width, height = (uint32_t)p->height;
    const bool all_u = !w->more && pel_texture_is_masked(p->width, p->wrap_u);
    const bool all_v = !w->more && pel_texture_is_masked(p->height, p->wrap_v);
    const uint32_t more = (uint32_t)w->more,
                   line = (uint32_t)(p->stride / w->texel_bytes);
    const pel_u32x4 zero = {0, 0, 0, 0};
    return (struct pel_texture_steps){
        .du = du,
        .dv = dv,
        .u = {0, du},
        .v = {0, dv},
        .u_on = {2 * du, 2 * du},
        .v_on = {2 * dv, 2 * dv},
        .u_end = all_u ? UINT64_MAX : (uint64_t)(width - more) << 32,
        .v_end = all_v ? UINT64_MAX : (uint64_t)(height - more) << 32,
        .u_mask = zero + (all_u ? width - 1 : 0xFFFF),
        .v_mask = zero + (all_v ? height - 1 : 0xFFFF),
        .line = zero + (line & 0xFFFF),
        .stride = p->stride,
        .memory = p->memory,
        .set = p->kind == PEL_TEXTURE_XRGB8888 ? PEL_LE32(0xFF000000u) : 0};
}

/* A coordinate is affine, so a run is inside when both ends are. */
static inline bool is_inside(const struct pel_texture_steps *s,
                             const struct pel_texture_run *r)
{
    const uint64_t last = (uint64_t)r->n - 1;
    const uint64_t u = r->u + last * s->du, v = r->v + last * s->dv;
    return r->u < s->u_end && u < s->u_end && r->v < s->v_end && v < s->v_end;
}

void pel_texture_fill_runs(const struct pel_texture *p,
                           const struct pel_surface *surface,
                           const struct pel_spans *spans,
                           const struct pel_texture_writer *writer,
                           pel_texture_fill *other)
{
    const struct pel_texture_steps s = pel_texture_steps_make(p, writer);
    const uint32_t back = writer->more ? PEL_TEXTURE_HALF_BACK : 0;
    int32_t y = spans->y;
    for (int32_t i = 0; i < spans->n; i++, y += spans->step) {
        const struct pel_span *span = &spans->span[i];
        const struct pel_spans one = {surface, span, y, 1, 1};
        const struct pel_texture_run run = {
            pel_address(surface, span->x0, y, writer->pixel_bytes),
            pel_texture_at(&p->map.u, span->x0, y) - back,
            pel_texture_at(&p->map.v, span->x0, y) - back, span->x1 - span->x0};
        if (run.n <= 0)
            continue;
        if (is_inside(&s, &run))
            writer->put(&s, &run);
        else
            other(&p->base.paint, &one);
    }
}

#endif
