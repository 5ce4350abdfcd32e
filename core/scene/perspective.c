#include "perspective.h"

#include "work.h"

/* A triangle whose values from `first` on are divided: a paint that sets the
 * values of `shaded` to those at hand, and `out` to the surface's colors, and
 * calls its function. It follows frame->work[0]. */
struct pel_divided_triangle {
    struct pel_color_paint base;
    struct pel_shaded *shaded;
    const struct pel_color_paint *surface; /* or NULL */
    struct pel_divided by;
    uint8_t first;
    struct pel_divided_value value[PEL_VALUES];
};

typedef char pel_perspective_size[sizeof(struct pel_divided_triangle) <=
                                          PEL_PERSPECTIVE_SCRATCH_SIZE
                                      ? 1
                                      : -1];

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

/* True where a line over the span of a pixel keeps the room of all colors: du
 * (r - 1) / 4, du in 1/64 of it. */
static bool is_near(const struct pel_divided_triangle *d,
                    const struct pel_plane *line, int32_t x, int32_t y)
{
    const int bits = d->by.span;
    const int32_t begin = x & (int32_t)(UINT32_MAX << bits);
    const int64_t w = (int64_t)pel_plane_at(&d->by.w, begin, y) >> 24;
    const int64_t change = (int64_t)(d->by.w.dx << bits) >> 24;
    const int64_t least = change < 0 ? w + change : w;
    for (int k = 0; k < d->by.values; k++) {
        const uint64_t du =
            (uint64_t)pel_size_of((int64_t)line[k].dx) >> (ROOM - 6 - bits);
        if (du >> 32 ||
            pel_multiply((uint32_t)du, (uint32_t)pel_size_of(change)) >
                (uint64_t)least << 8)
            return false;
    }
    return true;
}

/* Sets the values of pixels from x on and returns the pixels' number. */
static int32_t set_values(struct pel_divided_triangle *d, int32_t x, int32_t y)
{
    const uint8_t span = d->by.span;
    struct pel_plane *line = &d->shaded->plane[d->first];
    int32_t n = pel_divided_lines(&d->by, x, y, line);
    if (span > 0 && !is_near(d, line, x, y)) {
        d->by.span = 0;
        n = pel_divided_lines(&d->by, x, y, line);
        d->by.span = span;
    }
    return n;
}

static void colors(const struct pel_color_paint *paint, int32_t x, int32_t y,
                   int32_t n, pel_color *out)
{
    struct pel_divided_triangle *d = (void *)(uintptr_t)paint;
    const struct pel_color_paint *shaded = &d->shaded->base;
    if (d->surface)
        d->surface->colors(d->surface, x, y, n, out);
    for (int32_t part; n > 0; n -= part, x += part, out += part) {
        part = pel_min(set_values(d, x, y), n);
        shaded->colors(shaded, 0, 0, part, out);
    }
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

static void white(const struct pel_color_paint *paint, int32_t x, int32_t y,
                  int32_t n, pel_color *out)
{
    (void)paint;
    (void)(x + y);
    for (int32_t i = 0; i < n; i++)
        out[i] = UINT32_C(0xFFFFFFFF);
}

static struct pel_divided_triangle *triangle_of(struct pel_frame *frame)
{
    return (void *)(frame->work + 1);
}

/* Begins a triangle over which a channel changes by so many steps. A value that
 * is linear on screen is off by at most change (r - 1) / 4, r the ratio of the
 * distances. */
static bool start(struct pel_frame *frame, int32_t change, int first)
{
    const struct pel_frame_triangle *t = &frame->work->triangle;
    struct pel_divided_triangle *d = triangle_of(frame);
    int32_t z[3], near = INT32_MAX, far = 0;
    for (int i = 0; i < 3; i++) {
        z[i] = t->corner[i]->z;
        near = pel_min(near, z[i]);
        far = pel_max(far, z[i]);
    }
    if (frame->projector.one || pel_long_product(change, far - near) <= near)
        return false;
    pel_divided_init(&d->by, pel_frame_setup(frame), z,
                     first == PEL_AT_COLOR ? SPAN : PEL_SPAN_EXACT);
    d->by.values = (uint8_t)(PEL_VALUES - first);
    d->by.value = &d->value[first];
    d->first = (uint8_t)first;
    d->shaded = &frame->work->paint.shaded;
    pel_color_paint_init(&d->base, colors, frame->opaque);
    return true;
}

static void set_value(struct pel_frame *frame, int k, const int32_t vertex[3])
{
    struct pel_divided_triangle *d = triangle_of(frame);
    int32_t corner[3];
    int64_t fine[3];
    pel_corners_mix(&frame->work->triangle, vertex, corner);
    for (int i = 0; i < 3; i++)
        fine[i] = corner[i] * INT64_C(256);
    pel_divided_set(&d->value[k], &d->by, pel_frame_setup(frame), fine);
}

static const struct pel_paint *gouraud(struct pel_frame *frame,
                                       const struct pel_color_paint *surface,
                                       const pel_color color[3])
{
    static const struct pel_color_paint none = PEL_COLOR_PAINT(white, true);
    struct pel_divided_triangle *d = triangle_of(frame);
    if (!start(frame, range_of(color), PEL_AT_COLOR))
        return pel_frame_gouraud_paint(frame, surface, color);
    d->surface = surface ? surface : &none;
    pel_shaded_start(frame, &surface_there, pel_modulated_pixel, PEL_AT_COLOR);
    pel_color_planes(frame, color, set_value);
    return &d->base.paint;
}

static const struct pel_paint *phong(struct pel_frame *frame,
                                     const struct pel_color_paint *surface,
                                     const pel_color color[3])
{
    struct pel_divided_triangle *d = triangle_of(frame);
    if (!start(frame, CHANGE_OF_LIGHT, 0))
        return pel_phong_paint(frame, surface, color);
    pel_shaded_start(frame, surface ? &surface_there : NULL, pel_lit_pixel, 0);
    d->surface = surface;
    if (surface)
        d->by.values = PEL_AT_COLOR;
    pel_phong_values(frame, color, set_value);
    return &d->base.paint;
}

const struct pel_interpolation pel_in_world = {gouraud, phong, ERROR};

const struct pel_shading pel_perspective_gouraud = {
    NULL, NULL, gouraud, PEL_PERSPECTIVE_SCRATCH_SIZE};
const struct pel_shading pel_perspective_lit_gouraud = {
    pel_frame_start_light, pel_frame_light_vertex, gouraud,
    PEL_PERSPECTIVE_SCRATCH_SIZE};
const struct pel_shading pel_perspective_phong = {
    pel_frame_start_light, NULL, phong, PEL_PERSPECTIVE_SCRATCH_SIZE};
