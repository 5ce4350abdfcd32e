#include "../base/divide.h"
#include "perspective.h"
#include "select.h"
#include "select_light.h"
#include "work.h"

/* Colors of vertices are rounded, by up to 1/2 step, and planes of them are
 * right to 1/64; a texture's factors are rounded once more. */
enum { GOURAUD_ERROR = 128 + 4, FACTOR_ERROR = 128 };

/* What a triangle's paint is chosen by. */
struct choice {
    const struct pel_interpolation *between;
    const struct pel_color_paint *surface;
    pel_color lit[3], own[3]; /* the vertices' colors */
    struct pel_light_bounds bounds;
};

static void note(struct pel_frame *frame, enum pel_method method,
                 uint64_t bound)
{
    frame->work->triangle.method = (uint8_t)method;
    frame->work->triangle.bound =
        (uint32_t)(bound +
                   (uint32_t)(frame->scene->tolerance - frame->tolerance));
}

/* One color or Gouraud's; NULL where they are not good enough. Where light
 * above 255 is cut off, Gouraud is no plane, nor is a texture that is
 * multiplied by it. */
static const struct pel_paint *try_vertices(struct pel_frame *frame,
                                            const struct choice *c)
{
    const struct pel_color_ranges lit = pel_color_ranges_of(c->lit);
    const uint64_t bound = c->bounds.plane + GOURAUD_ERROR +
                           (c->surface ? FACTOR_ERROR : 0) +
                           (uint32_t)c->between->error;
    const uint64_t range = (uint32_t)(lit.range + 1) / 2 * 256;
    const uint64_t room = (uint32_t)frame->tolerance;
    if (bound > room || lit.cut ||
        (c->surface &&
         (lit.most == 255 || frame->lights.lighting->plain_highlights)))
        return NULL;
    if (range <= room - bound) {
        note(frame, PEL_METHOD_FLAT, bound + range);
        return pel_frame_flat_paint(frame, c->surface, lit.middle);
    }
    note(frame, PEL_METHOD_GOURAUD, bound);
    return c->between->gouraud(frame, c->surface, c->lit);
}

/* Twice the area, 1/65,536 px, of two pixels: these take less than their bound
 * does. */
enum { FEW_PIXELS = 2 * 2 * 65536 };

static const struct pel_paint *choose(struct pel_frame *frame,
                                      const struct pel_color_paint *surface,
                                      const pel_color color[3],
                                      const struct pel_interpolation *between)
{
    const struct pel_paint *paint = NULL;
    struct choice c;
    uint8_t notes[3];
    c.between = between;
    c.surface = surface;
    for (int i = 0; i < 3; i++) {
        notes[i] = (uint8_t)(color[i] >> 24);
        c.lit[i] = (color[i] & 0xFFFFFFu) | (uint32_t)frame->alpha << 24;
        c.own[i] = pel_frame_surface(frame, frame->work->triangle.vertex[i]);
    }
    if (frame->tolerance > 0 && pel_frame_setup(frame)->area >= FEW_PIXELS &&
        pel_light_bound(frame, notes, c.own, &c.bounds)) {
        paint = try_vertices(frame, &c);
    }
    if (paint)
        return paint;
    note(frame, PEL_METHOD_PHONG, 0);
    return between->phong(frame, surface, c.own);
}

static const struct pel_paint *chosen_paint(
    struct pel_frame *frame, const struct pel_color_paint *surface,
    const pel_color color[3])
{
    static const struct pel_interpolation on_screen = {pel_frame_gouraud_paint,
                                                       pel_phong_paint, 0};
    return choose(frame, surface, color, &on_screen);
}

static const struct pel_paint *divided_paint(
    struct pel_frame *frame, const struct pel_color_paint *surface,
    const pel_color color[3])
{
    return choose(frame, surface, color, &pel_in_world);
}

/* What a light may add to a channel, 1/256 step: 255/256 of the sum of its
 * factors, and roundings of 2^-17 each and of the channel. */
static uint32_t most_of(const struct pel_mesh_light *light)
{
    int32_t most = 0;
    for (int k = 0; k < 3; k++)
        most = pel_max(most, light->diffuse[k] + light->specular[k]);
    return most ? (uint32_t)most + 2 : 0;
}

enum pel_status pel_frame_start_chosen(struct pel_frame *frame)
{
    struct pel_mesh_lights *lights = &frame->lights;
    const enum pel_status status = pel_frame_start_light(frame);
    uint32_t left = (uint32_t)pel_max(frame->tolerance, 0) / 4;
    int32_t kept = 0;
    for (int32_t i = 0; status == PEL_OK && i < lights->count; i++) {
        const uint32_t most = most_of(&lights->light[i]);
        if (most <= left) {
            left -= most;
            frame->tolerance -= (int32_t)most;
        } else
            lights->light[kept++] = lights->light[i];
    }
    lights->count = kept;
    return status;
}

const struct pel_shading pel_shade_chosen = {pel_frame_start_chosen,
                                             pel_light_note, chosen_paint, 0};
const struct pel_shading pel_perspective_chosen = {
    pel_frame_start_chosen, pel_light_note, divided_paint,
    PEL_PERSPECTIVE_SCRATCH_SIZE};
