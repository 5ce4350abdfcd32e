#include "stats.h"

#include "select_light.h"
#include "work.h"

static void fill(const struct pel_paint *paint, const struct pel_spans *spans)
{
    struct pel_stats *s = (void *)(uintptr_t)paint;
    for (int32_t i = 0; i < spans->n; i++)
        s->method[s->at].pixels +=
            (uint64_t)pel_max(spans->span[i].x1 - spans->span[i].x0, 0);
    s->inner->fill(s->inner, spans);
}

/* For a depth buffer that asks a translucent paint for colors. */
static void colors(const struct pel_color_paint *paint, int32_t x, int32_t y,
                   int32_t n, pel_color *out)
{
    struct pel_stats *s = (void *)(uintptr_t)paint;
    const struct pel_color_paint *inner = (const void *)s->inner;
    s->method[s->at].pixels += (uint64_t)n;
    inner->colors(inner, x, y, n, out);
}

static const struct pel_paint *counted_paint(
    struct pel_frame *frame, const struct pel_color_paint *surface,
    const pel_color color[3])
{
    struct pel_stats *s = frame->scene->stats;
    s->inner = pel_shade_chosen.paint(frame, surface, color);
    s->at = frame->work->triangle.method;
    s->method[s->at].triangles++;
    if (frame->work->triangle.bound > s->bound)
        s->bound = frame->work->triangle.bound;
    s->paint = (struct pel_color_paint){{fill, NULL}, colors, frame->opaque};
    return &s->paint.paint;
}

static enum pel_status start(struct pel_frame *frame)
{
    const enum pel_status status = pel_frame_start_chosen(frame);
    const struct pel_mesh_lights *l = &frame->lights;
    if (status == PEL_OK)
        frame->scene->stats->lights_left_out = l->lighting->lights - l->count;
    return status;
}

const struct pel_shading pel_shade_counted = {start, pel_light_note,
                                              counted_paint, 0};
