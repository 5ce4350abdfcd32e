#include "sim/render/scene.h"

#include <stddef.h>
#include <stdio.h>

#include "core/scene/select_light.h"
#include "core/scene/work.h"

static struct scene_methods *methods_of(const struct pel_frame *frame)
{
    struct scene *scene =
        (void *)((uintptr_t)frame->scene - offsetof(struct scene, core));
    return &scene->methods;
}

static void fill(const struct pel_paint *paint, const struct pel_spans *spans)
{
    struct scene_methods *m = (void *)(uintptr_t)paint;
    for (int32_t i = 0; i < spans->n; i++)
        m->method[m->at].pixels +=
            (uint64_t)pel_max(spans->span[i].x1 - spans->span[i].x0, 0);
    m->inner->fill(m->inner, spans);
}

/* For a depth buffer that asks a translucent paint for colors. */
static void colors(const struct pel_color_paint *paint, int32_t x, int32_t y,
                   int32_t n, pel_color *out)
{
    struct scene_methods *m = (void *)(uintptr_t)paint;
    const struct pel_color_paint *inner = (const void *)m->inner;
    m->method[m->at].pixels += (uint64_t)n;
    inner->colors(inner, x, y, n, out);
}

static const struct pel_paint *counted_paint(
    struct pel_frame *frame, const struct pel_color_paint *surface,
    const pel_color color[3])
{
    const struct pel_frame_triangle *t = &frame->work->triangle;
    struct scene_methods *m = methods_of(frame);
    m->inner = pel_shade_chosen.paint(frame, surface, color);
    m->at = t->method;
    m->method[m->at].triangles++;
    m->bound = t->bound > m->bound ? t->bound : m->bound;
    m->paint = (struct pel_color_paint){{fill, NULL}, colors, frame->opaque};
    return &m->paint.paint;
}

static enum pel_status start(struct pel_frame *frame)
{
    const enum pel_status status = pel_frame_start_chosen(frame);
    const struct pel_mesh_lights *l = &frame->lights;
    if (status == PEL_OK)
        methods_of(frame)->lights_left_out = l->lighting->lights - l->count;
    return status;
}

static const struct pel_paint *shown_paint(
    struct pel_frame *frame, const struct pel_color_paint *surface,
    const pel_color color[3])
{
    static const struct pel_flat paints[PEL_METHODS] = {
        PEL_FLAT(PEL_RGB(96, 96, 96)), PEL_FLAT(PEL_RGB(64, 128, 255)),
        PEL_FLAT(PEL_RGB(224, 32, 32))};
    pel_shade_chosen.paint(frame, surface, color);
    return &paints[frame->work->triangle.method].paint;
}

const struct pel_shading scene_shade_counted = {start, pel_light_note,
                                                counted_paint, 0};
const struct pel_shading scene_shade_methods = {pel_frame_start_chosen,
                                                pel_light_note, shown_paint, 0};

void scene_methods_print(const struct scene_methods *methods)
{
    static const char *const names[PEL_METHODS] = {"flat", "gouraud", "phong"};
    for (int i = 0; i < PEL_METHODS; i++)
        fprintf(stderr, "%-8s %9u triangles %10llu pixels\n", names[i],
                (unsigned)methods->method[i].triangles,
                (unsigned long long)methods->method[i].pixels);
    fprintf(stderr, "the largest bound: %.2f steps\n", methods->bound / 256.);
    fprintf(stderr, "lights left out: %d\n", (int)methods->lights_left_out);
}
