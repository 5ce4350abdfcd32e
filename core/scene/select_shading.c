#include "select.h"
#include "select_light.h"

/* Colors of vertices are rounded, by up to 1/2 step, and planes of them are
 * right to 1/64; a texture's factors are rounded once more. */
enum { GOURAUD_ERROR = 128 + 4, FACTOR_ERROR = 128 };

/* Does light above 255 hide the plane in a channel? It does where some vertices
 * have 255 and some less. */
static bool is_cut(const pel_color color[3])
{
    for (int k = 0; k < 24; k += 8) {
        const uint32_t white = UINT32_C(255) << k;
        const int n = ((color[0] & white) == white) +
                      ((color[1] & white) == white) +
                      ((color[2] & white) == white);
        if (n == 1 || n == 2)
            return true;
    }
    return false;
}

/* The middle of each channel; returns the largest way to a vertex's. */
static uint32_t middle_of(const pel_color c[3], pel_color *middle)
{
    uint32_t range = 0;
    *middle = c[0] & UINT32_C(0xFF000000);
    for (int k = 0; k < 24; k += 8) {
        int32_t low = 255, high = 0;
        for (int i = 0; i < 3; i++) {
            const int32_t v = (int32_t)(c[i] >> k & 255);
            low = pel_min(low, v);
            high = pel_max(high, v);
        }
        *middle |= (uint32_t)(low + high + 1) / 2 << k;
        range = (uint32_t)pel_max((int32_t)range, (high - low + 1) / 2);
    }
    return range;
}

/* Polynomials end in roundings of 1/64 step and less. */
enum { QUICK_ERROR = 8 };

static const struct pel_paint *quick_paint(
    struct pel_frame *frame, const struct pel_color_paint *surface,
    const struct pel_lit_corners *corners, const pel_color color[3])
{
    static const int32_t one[2][3] = {{0, 1 << 28, 0}, {0, 0, 1 << 28}};
    struct pel_phong_quick *quick = &frame->work->paint.quick;
    pel_phong_quick_init(quick, &frame->lights, corners, surface, color);
    quick->alpha = frame->alpha;
    pel_color_paint_init(&quick->base, quick->base.colors, frame->opaque);
    for (int i = 0; i < 2; i++)
        pel_frame_plane(frame, one[i], &quick->weight[i]);
    return &quick->base.paint;
}

static const struct pel_paint *vertex_paint(
    struct pel_frame *frame, const struct pel_color_paint *surface,
    pel_color lit[3], uint32_t room)
{
    pel_color middle;
    if (middle_of(lit, &middle) * 256 <= room)
        lit[0] = lit[1] = lit[2] = middle;
    if (surface)
        return frame->mesh_texture->mapping->modulate(frame, surface, lit);
    if (lit[0] == lit[1] && lit[1] == lit[2]) {
        struct pel_flat *flat = &frame->work->paint.flat;
        *flat = (struct pel_flat)PEL_FLAT(lit[0]);
        return &flat->paint;
    }
    pel_frame_gouraud(frame, lit, &frame->work->paint.gouraud);
    return &frame->work->paint.gouraud.paint;
}

static const struct pel_paint *chosen_paint(
    struct pel_frame *frame, const struct pel_color_paint *surface)
{
    const uint32_t tolerance = (uint32_t)frame->scene->tolerance;
    pel_color lit[3], own[3];
    uint8_t note[3];
    struct pel_lit_corners corners;
    struct pel_light_bounds bounds;
    pel_frame_colors(frame, lit);
    for (int i = 0; i < 3; i++) {
        note[i] = (uint8_t)(lit[i] >> 24);
        lit[i] = (lit[i] & 0xFFFFFFu) | (uint32_t)frame->alpha << 24;
        own[i] = pel_frame_surface(frame, frame->work->triangle.vertex[i]);
    }
    if (tolerance == 0 || !pel_light_bound(frame, note, own, &corners, &bounds))
        return pel_phong_paint(frame, surface, own);
    const uint32_t error = GOURAUD_ERROR + (surface ? FACTOR_ERROR : 0);
    if (error <= tolerance && bounds.plane <= tolerance - error &&
        !is_cut(lit) && !(surface && frame->lights.lighting->plain_highlights))
        return vertex_paint(frame, surface, lit,
                            tolerance - error - bounds.plane);
    if (tolerance >= QUICK_ERROR && bounds.quick <= tolerance - QUICK_ERROR &&
        frame->lights.lighting->lights <= PEL_QUICK_LIGHTS)
        return quick_paint(frame, surface, &corners, own);
    return pel_phong_paint(frame, surface, own);
}

const struct pel_shading pel_shade_chosen = {pel_frame_start_light,
                                             pel_light_note, chosen_paint};
