#include "select.h"
#include "select_light.h"

/* Colors of vertices are rounded, by up to 1/2 step, and planes of them are
 * right to 1/64; a texture's factors are rounded once more. */
enum { GOURAUD_ERROR = 128 + 4, FACTOR_ERROR = 128 };

/* Does light above 255 hide the plane in a channel? It does where some vertices
 * have 255 and some less, and where it is to be multiplied. */
static bool is_cut(const pel_color color[3], bool multiplied)
{
    for (int k = 0; k < 24; k += 8) {
        const uint32_t white = UINT32_C(255) << k;
        const int n = ((color[0] & white) == white) +
                      ((color[1] & white) == white) +
                      ((color[2] & white) == white);
        if (n == 1 || n == 2 || (n && multiplied))
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
enum { QUICK_ERROR = 8, SPAN_MOST = 3 };

static uint64_t size_of(uint64_t gradient)
{
    return (uint64_t)pel_size_of((int64_t)gradient);
}

/* How much of an edge a pixel to the right is, 2^-28, rounded up. */
static uint64_t edge_part(const struct pel_plane weight[2])
{
    const uint64_t a = size_of(weight[0].dx), b = size_of(weight[1].dx);
    const uint64_t c = size_of(weight[0].dx + weight[1].dx);
    const uint64_t most = a > b ? a : b;
    return ((most > c ? most : c) >> 24) + 1;
}

/* The bits of the longest span, up to 1/4 edge, that is good enough; none where
 * normals turn by 3/4 or more. */
static int span_of(const struct pel_light_bounds *b, uint64_t part,
                   uint64_t room)
{
    int bits = b->tears || b->turns.normal >= 49152 ? 0 : SPAN_MOST;
    for (; bits > 0; bits--) {
        const uint64_t s = part << bits >> 12;
        if (s < 16384 && pel_light_span_bound(b, (uint32_t)s + 1) <= room)
            break;
    }
    return bits;
}

static void note(struct pel_frame *frame, enum pel_method method,
                 uint64_t bound)
{
    frame->work->method = (uint8_t)method;
    frame->work->bound =
        (uint32_t)(bound + (uint32_t)(frame->scene->tolerance - frame->room));
}

static const struct pel_paint *exact_paint(
    struct pel_frame *frame, const struct pel_color_paint *surface,
    const pel_color color[3])
{
    note(frame, PEL_METHOD_PHONG, 0);
    return pel_phong_paint(frame, surface, color);
}

static const struct pel_paint *quick_paint(
    struct pel_frame *frame, const struct pel_color_paint *surface,
    const struct pel_lit_corners *corners,
    const struct pel_light_bounds *bounds, const pel_color color[3])
{
    static const int32_t one[2][3] = {{0, 1 << 28, 0}, {0, 0, 1 << 28}};
    struct pel_phong_quick *quick = &frame->work->paint.quick;
    const uint64_t room = (uint32_t)frame->room - QUICK_ERROR;
    pel_phong_quick_init(quick, &frame->lights, corners, surface, color);
    quick->alpha = frame->alpha;
    pel_color_paint_init(&quick->base, quick->base.colors, frame->opaque);
    for (int i = 0; i < 2; i++)
        pel_frame_plane(frame, one[i], &quick->weight[i]);
    quick->dull = bounds->quick + bounds->dull <= room / 2;
    const uint64_t dull = quick->dull ? bounds->dull : 0;
    const uint64_t part = edge_part(quick->weight);
    quick->span = (uint8_t)span_of(bounds, part, room - dull);
    note(frame, quick->span ? PEL_METHOD_SPANS : PEL_METHOD_QUICK,
         dull + QUICK_ERROR +
             (quick->span ? pel_light_span_bound(
                                bounds, (uint32_t)(part << quick->span >> 12))
                          : bounds->quick));
    return &quick->base.paint;
}

/* `bound` is that of Gouraud; a flat color may add up to `room`. */
static const struct pel_paint *vertex_paint(
    struct pel_frame *frame, const struct pel_color_paint *surface,
    pel_color lit[3], uint64_t bound, uint64_t room)
{
    pel_color middle;
    const uint64_t range = (uint64_t)middle_of(lit, &middle) * 256;
    const bool flat = range <= room;
    note(frame, flat ? PEL_METHOD_FLAT : PEL_METHOD_GOURAUD,
         bound + (flat ? range : 0));
    if (flat)
        lit[0] = lit[1] = lit[2] = middle;
    if (surface)
        return frame->mesh_texture->mapping->modulate(frame, surface, lit);
    if (flat) {
        struct pel_flat *paint = &frame->work->paint.flat;
        *paint = (struct pel_flat)PEL_FLAT(middle);
        return &paint->paint;
    }
    pel_frame_gouraud(frame, lit, &frame->work->paint.gouraud);
    return &frame->work->paint.gouraud.paint;
}

/* The paint of Gouraud or one color; NULL where they are not good enough. */
static const struct pel_paint *try_vertices(
    struct pel_frame *frame, const struct pel_color_paint *surface,
    pel_color lit[3], const struct pel_light_bounds *bounds)
{
    const uint64_t tolerance = (uint32_t)frame->room;
    const uint64_t bound =
        bounds->plane + GOURAUD_ERROR + (surface ? FACTOR_ERROR : 0);
    if (bound > tolerance || is_cut(lit, surface) ||
        (surface && frame->lights.lighting->plain_highlights))
        return NULL;
    return vertex_paint(frame, surface, lit, bound, tolerance - bound);
}

/* Twice the area, 1/65,536 px, of two pixels: these take less than their bound
 * does. */
enum { FEW_PIXELS = 2 * 2 * 65536 };

static const struct pel_paint *chosen_paint(
    struct pel_frame *frame, const struct pel_color_paint *surface)
{
    const int64_t tolerance = frame->room;
    pel_color lit[3], own[3];
    uint8_t notes[3];
    struct pel_lit_corners corners;
    struct pel_light_bounds bounds;
    pel_frame_colors(frame, lit);
    for (int i = 0; i < 3; i++) {
        notes[i] = (uint8_t)(lit[i] >> 24);
        lit[i] = (lit[i] & 0xFFFFFFu) | (uint32_t)frame->alpha << 24;
        own[i] = pel_frame_surface(frame, frame->work->triangle.vertex[i]);
    }
    if (tolerance < QUICK_ERROR || pel_frame_setup(frame)->area < FEW_PIXELS ||
        !pel_light_bound(frame, notes, own, &corners, &bounds))
        return exact_paint(frame, surface, own);
    const struct pel_paint *paint = try_vertices(frame, surface, lit, &bounds);
    if (paint)
        return paint;
    if (bounds.quick <= (uint64_t)(tolerance - QUICK_ERROR) &&
        frame->lights.count <= PEL_QUICK_LIGHTS)
        return quick_paint(frame, surface, &corners, &bounds, own);
    return exact_paint(frame, surface, own);
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
                                             pel_light_note, chosen_paint};
