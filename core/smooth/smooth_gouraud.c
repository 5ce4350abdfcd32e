#include "smooth_gouraud.h"

/* The whole part of a plane's value, cut to 0..255; or the value that a
 * pel_gouraud has there, if that differs by its rounding alone. */
static uint32_t channel_of(uint64_t value, uint32_t gouraud)
{
    const int32_t v = (int32_t)(value >> 32);
    const int32_t cut = pel_max(0, pel_min(v, 255));
    return pel_magnitude(cut - (int32_t)gouraud) <= 2 ? gouraud : (uint32_t)cut;
}

/* Adds channel k of n pixels from (x, y) on. */
static PEL_NOINLINE_32 void add_channel(const struct pel_smooth_gouraud *p,
                                        int k, const struct pel_rect *run,
                                        pel_color *colors)
{
    const struct pel_gouraud *const g = &p->inner;
    const uint64_t dx = p->channel[k].dx;
    uint64_t value = pel_plane_at(&p->channel[k], run->x0, run->y0);
    uint32_t inner =
        g->at[k] + (uint32_t)run->x0 * g->dx[k] + (uint32_t)run->y0 * g->dy[k];
    for (int32_t n = run->x1 - run->x0; n > 0; n--) {
        *colors++ |= channel_of(value, inner >> 24) << 8 * k;
        value += dx;
        inner += g->dx[k];
    }
}

static void fill_run(const struct pel_smooth_gouraud *p,
                     const struct pel_surface *surface,
                     const struct pel_rect *run)
{
    pel_color colors[PEL_BUFFER_PIXELS];
    for (int32_t i = 0; i < run->x1 - run->x0; i++)
        colors[i] = 0;
    for (int k = 0; k < 4; k++)
        add_channel(p, k, run, colors);
    pel_put_colors(surface, run->x0, run->y0, run->x1 - run->x0, colors);
}

/* Full pixels come on real surfaces, and have their centres inside. */
static void fill(const struct pel_paint *paint, const struct pel_spans *spans)
{
    const struct pel_smooth_gouraud *const p = (const void *)paint;
    const struct pel_surface *const surface = spans->surface;
    const struct pel_span *span = spans->span;
    struct pel_rect run = {0, spans->y, 0, 0};
    if (surface->format->id < PEL_SMOOTH_FORMAT) {
        pel_gouraud_fill(&p->inner.paint, spans);
        return;
    }
    for (int32_t i = spans->n; i > 0; i--, span++, run.y0 += spans->step)
        for (run.x0 = span->x0; run.x0 < span->x1; run.x0 = run.x1) {
            run.x1 = pel_min(span->x1, run.x0 + PEL_BUFFER_PIXELS);
            fill_run(p, surface, &run);
        }
}

static void set_channel(struct pel_plane *channel,
                        const struct pel_plane_setup *setup, int k,
                        const pel_color c[3])
{
    int32_t value[3];
    for (int i = 0; i < 3; i++)
        value[i] = (int32_t)(c[i] >> 8 * k & 255) * 256;
    pel_plane_set(channel, setup, value);
    channel->at += 0x80000000u;
}

enum pel_status pel_smooth_gouraud_init(struct pel_smooth_gouraud *paint,
                                        const struct pel_point v[3],
                                        const pel_color c[3])
{
    struct pel_plane_setup setup;
    if (!paint)
        return PEL_ERROR_NULL;
    const enum pel_status status = pel_gouraud_init(&paint->inner, v, c);
    paint->paint = (struct pel_paint){fill, NULL};
    if (status != PEL_OK) {
        pel_paint_clear(&paint->paint);
        return status;
    }
    pel_plane_start(&setup, v);
    for (int k = 0; k < 4; k++)
        set_channel(&paint->channel[k], &setup, k, c);
    return PEL_OK;
}

void pel_smooth_triangle_gouraud(const struct pel_surface *surface,
                                 const struct pel_point v[3],
                                 const pel_color c[3])
{
    struct pel_smooth_gouraud paint;
    const enum pel_status status = pel_smooth_gouraud_init(&paint, v, c);
    PEL_ASSERT(status == PEL_OK);
    if (status == PEL_OK)
        pel_smooth_triangle(surface, v, &paint.paint);
}
