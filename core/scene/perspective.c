#include "perspective.h"

#include "work.h"

/* A triangle's values in perspective: a surface's colors come first, and then
 * work->paint.shaded is drawn on them. It follows frame->work[0]. */
struct pel_divided_triangle {
    struct pel_divided by;
    struct pel_divided_value value[PEL_VALUES];
    const struct pel_color_paint *surface; /* or NULL */
};

PEL_STATIC_ASSERT(pel_perspective_size, sizeof(struct pel_divided_triangle) <=
                                            PEL_PERSPECTIVE_SCRATCH_SIZE);

enum { SPAN = 8 };

/* What a color may be off by between divided pixels, bits of 2^-24: 1/4 step.
 */
enum { ROOM = 22 };

/* Of colors of vertices and of light at pixels, 1/256 step: 1/4 step each. */
enum { ERROR = 128 };

/* Steps that light at pixels is taken to change by over a triangle, at most. */
enum { CHANGE_OF_LIGHT = 2048 };

/* The widest range of a channel. */
static int32_t range_of(const pel_color color[3])
{
    int32_t range = 0;
    for (int i = 0; i < 9; i++)
        range = pel_max(
            range, (int32_t)(color[i / 3] >> i % 3 * 8 & 255) -
                       (int32_t)(color[(i / 3 + 1) % 3] >> i % 3 * 8 & 255));
    return range;
}

/* True where the lines of all colors keep their room: du (r - 1) / 4, du in
 * 1/64 of it. */
static bool is_near(const struct pel_divided *d, int32_t x, int32_t y)
{
    const struct pel_plane *line = pel_divided_planes(d);
    const int bits = d->span;
    const int64_t w = (int64_t)pel_plane_at(&d->w, x, y) >> 24;
    const int64_t change = (int64_t)(d->w.dx << bits) >> 24;
    const int64_t least = change < 0 ? w + change : w;
    for (int k = 0; k < d->values; k++) {
        const uint64_t du =
            (uint64_t)pel_size_of((int64_t)line[k].dx) >> (ROOM - 6 - bits);
        if (du >> 32 ||
            pel_multiply((uint32_t)du, (uint32_t)pel_size_of(change)) >
                (uint64_t)least << 8)
            return false;
    }
    return true;
}

static void colors(const struct pel_color_paint *paint, int32_t x, int32_t y,
                   int32_t n, pel_color *out)
{
    const struct pel_divided_triangle *d = (const void *)paint;
    if (d->surface)
        d->surface->colors(d->surface, x, y, n, out);
    pel_divided_colors(&d->by.base, x, y, n, out);
}

/* A surface whose colors are there. */
static void there(const struct pel_color_paint *paint, int32_t x, int32_t y,
                  int32_t n, pel_color *out)
{
    (void)paint;
    (void)(x + y + n);
    (void)out;
}

static const struct pel_color_paint surface_there =
    PEL_COLOR_PAINT(there, true);

static struct pel_divided_triangle *triangle_of(struct pel_frame *frame)
{
    return (void *)(frame->work + 1);
}

/* True where values that are linear on screen would show: they are off by at
 * most change (r - 1) / 4, for a channel that changes by so many steps and r
 * the ratio of the distances. */
static bool is_deep(const struct pel_frame *frame, int32_t change)
{
    const struct pel_clip_corner *const *c = frame->work->triangle.corner;
    const int32_t near = pel_min(pel_min(c[0]->z, c[1]->z), c[2]->z);
    const int32_t far = pel_max(pel_max(c[0]->z, c[1]->z), c[2]->z);
    return !frame->projector.one && pel_long_product(change, far - near) > near;
}

/* Divides the values of work->paint.shaded, which has begun. */
static const struct pel_paint *divide(struct pel_frame *frame,
                                      const struct pel_color_paint *surface,
                                      int32_t span)
{
    const struct pel_frame_triangle *t = &frame->work->triangle;
    const struct pel_shaded *p = &frame->work->paint.shaded;
    struct pel_divided_triangle *d = triangle_of(frame);
    const int32_t z[3] = {t->corner[0]->z, t->corner[1]->z, t->corner[2]->z};
    d->surface = surface;
    pel_divided_init(&d->by, &p->base, pel_frame_setup(frame), z, span);
    d->by.base.colors = colors;
    d->by.is_near = is_near;
    d->by.values = (uint8_t)(p->end - p->first);
    d->by.planes = (uint16_t)(offsetof(struct pel_shaded, plane) +
                              p->first * sizeof(struct pel_plane));
    return &d->by.base.paint;
}

static void set_value(struct pel_frame *frame, int k, const int32_t vertex[3])
{
    struct pel_divided_triangle *d = triangle_of(frame);
    int32_t corner[3];
    int64_t fine[3];
    pel_corners_mix(&frame->work->triangle, vertex, corner);
    for (int i = 0; i < 3; i++)
        fine[i] = corner[i] * INT64_C(256);
    pel_divided_set(&d->value[k - frame->work->paint.shaded.first], &d->by,
                    pel_frame_setup(frame), fine);
}

static const struct pel_paint *gouraud(struct pel_frame *frame,
                                       const struct pel_color_paint *surface,
                                       const pel_color color[3])
{
    if (!is_deep(frame, range_of(color)))
        return pel_frame_gouraud_paint(frame, surface, color);
    struct pel_shaded *p =
        pel_shaded_start(frame, surface ? &surface_there : NULL, color,
                         pel_modulated_pixel, PEL_AT_COLOR);
    p->under = UINT32_C(0xFFFFFFFF);
    const struct pel_paint *paint = divide(frame, surface, SPAN);
    pel_color_planes(frame, color, set_value);
    return paint;
}

static const struct pel_paint *phong(struct pel_frame *frame,
                                     const struct pel_color_paint *surface,
                                     const pel_color color[3])
{
    if (!is_deep(frame, CHANGE_OF_LIGHT))
        return pel_phong_paint(frame, surface, color);
    pel_shaded_start(frame, surface ? &surface_there : NULL, color,
                     pel_lit_pixel, 0);
    const struct pel_paint *paint = divide(frame, surface, PEL_SPAN_EXACT);
    pel_phong_values(frame, color, set_value);
    return paint;
}

const struct pel_interpolation pel_in_world = {gouraud, phong, ERROR};

const struct pel_shading pel_perspective_gouraud = {
    NULL, NULL, gouraud, PEL_PERSPECTIVE_SCRATCH_SIZE};
const struct pel_shading pel_perspective_lit_gouraud = {
    pel_frame_start_light, pel_frame_light_vertex, gouraud,
    PEL_PERSPECTIVE_SCRATCH_SIZE};
const struct pel_shading pel_perspective_phong = {
    pel_frame_start_light, NULL, phong, PEL_PERSPECTIVE_SCRATCH_SIZE};
