#include "depth.h"

#include <string.h>

#include "certificate.h"
#include "work.h"

size_t pel_depth_size(const struct pel_rect *bounds, int bits)
{
    if (!pel_bounds_legal(bounds) || (bits != 16 && bits != 32))
        return 0;
    const uint64_t pixels = (uint64_t)(uint32_t)(bounds->x1 - bounds->x0) *
                            (uint32_t)(bounds->y1 - bounds->y0);
    const uint64_t bytes = pixels * (uint32_t)(bits / 8);
    return bytes <= SIZE_MAX ? (size_t)bytes : 0;
}

enum pel_status pel_depth_init(struct pel_depth *depth,
                               const struct pel_rect *bounds, int bits,
                               void *memory, size_t size)
{
    if (!depth || !bounds)
        return PEL_ERROR_NULL;
    const struct pel_rect area = *bounds;
    const size_t needed = pel_depth_size(&area, bits);
    *depth = (struct pel_depth){0};
    if (!memory)
        return PEL_ERROR_NULL;
    if (needed == 0)
        return PEL_ERROR_SIZE;
    if (size < needed || (uintptr_t)memory % (size_t)(bits / 8))
        return PEL_ERROR_SCRATCH;
    depth->values = memory;
    depth->bounds = area;
    depth->bits = (uint8_t)bits;
    pel_depth_clear(depth);
    return PEL_OK;
}

void pel_depth_clear(const struct pel_depth *depth)
{
    const size_t size = pel_depth_size(&depth->bounds, depth->bits);
    if (size)
        memset(depth->values, 0, size);
}

/* A value, 2^-24 of 0..2^30, as 32 bits; below 0 only by rounding. */
static inline uint32_t number_of(uint64_t value)
{
    return (int64_t)value < 0 ? 0 : (uint32_t)(value >> 22);
}

/* Tests the value of a pixel whose depth is held; true when it is nearer. */
static inline bool is_nearer(const struct pel_depth_paint *p, void *held,
                             uint64_t value, bool wide)
{
    const uint32_t number = number_of(value) >> (wide ? 0 : 16);
    const bool nearer = number > (wide ? *(uint32_t *)held : *(uint16_t *)held);
    if (nearer && p->keeps && wide)
        *(uint32_t *)held = number;
    else if (nearer && p->keeps)
        *(uint16_t *)held = (uint16_t)number;
    return nearer;
}

/* The first pixel of a part of row y whose test does not give `nearer`, or the
 * part's end. wide: depths of 32 bits. */
static PEL_INLINE_KINDS int32_t skip_wide(const struct pel_depth_paint *p,
                                          const struct pel_span *part,
                                          int32_t y, bool nearer, bool wide)
{
    const struct pel_rect *b = &p->depth->bounds;
    const size_t line = (size_t)(y - b->y0) * (size_t)(b->x1 - b->x0);
    const size_t size = wide ? sizeof(uint32_t) : sizeof(uint16_t);
    int32_t x = part->x0;
    uint8_t *held =
        (uint8_t *)p->depth->values + (line + (size_t)(x - b->x0)) * size;
    uint64_t value = pel_plane_at(&p->plane, x, y);
    for (; x < part->x1 && is_nearer(p, held, value, wide) == nearer; x++) {
        held += size;
        value += p->plane.dx;
    }
    return x;
}

static PEL_INLINE_64 int32_t skip(const struct pel_depth_paint *p,
                                  const struct pel_span *part, int32_t y,
                                  bool nearer)
{
    const bool wide = p->depth->bits == 32;
    if (PEL_64BIT && wide)
        return skip_wide(p, part, y, nearer, true);
    return skip_wide(p, part, y, nearer, PEL_64BIT ? false : wide);
}

/* Spans that go to the inner paint at a time. */
enum { SPANS = PEL_64BIT ? 8 : 4 };

/* Hands the visible parts of a span to the inner paint, as spans of one row. */
static void fill_span(const struct pel_depth_paint *p,
                      const struct pel_surface *surface,
                      const struct pel_span *span, int32_t y)
{
    const struct pel_rect *b = &p->depth->bounds;
    struct pel_span part[SPANS];
    struct pel_spans out = {surface, part, y, 0, 0};
    struct pel_span left = {pel_max(span->x0, b->x0), pel_min(span->x1, b->x1)};
    if (y < b->y0 || y >= b->y1)
        return;
    while (left.x0 < left.x1) {
        const int32_t first = skip(p, &left, y, false);
        if (first == left.x1)
            break;
        left.x0 = first + 1;
        left.x0 = skip(p, &left, y, true);
        part[out.n++] = (struct pel_span){first, left.x0};
        left.x0++; /* that one is tested: hidden */
        if (out.n == SPANS) {
            p->inner->fill(p->inner, &out);
            out.n = 0;
        }
    }
    if (out.n)
        p->inner->fill(p->inner, &out);
}

static void fill(const struct pel_paint *paint, const struct pel_spans *spans)
{
    const struct pel_depth_paint *p = (const void *)paint;
    int32_t y = spans->y;
    for (int32_t i = 0; i < spans->n; i++, y += spans->step)
        fill_span(p, spans->surface, &spans->span[i], y);
}

void pel_depth_paint_init(struct pel_depth_paint *paint,
                          const struct pel_paint *inner,
                          const struct pel_depth *depth,
                          const struct pel_plane *plane, bool keeps)
{
    paint->base.paint = (struct pel_paint){fill, NULL};
    paint->inner = inner;
    paint->depth = depth;
    paint->plane = *plane;
    paint->keeps = keeps;
}

/* Pixels that are hidden or not opaque get alpha 0, which leaves them as they
 * are. */
static void colors(const struct pel_color_paint *paint, int32_t x, int32_t y,
                   int32_t n, pel_color *out)
{
    const struct pel_depth_paint *p = (const void *)paint;
    const struct pel_color_paint *inner = (const void *)p->inner;
    const struct pel_rect *b = &p->depth->bounds;
    const bool inside = y >= b->y0 && y < b->y1;
    inner->colors(inner, x, y, n, out);
    for (const pel_color *end = out + n; out < end; out++, x++) {
        const struct pel_span pixel = {x, x + 1};
        if (!inside || x < b->x0 || x >= b->x1 || pel_alpha(*out) < 255 ||
            skip(p, &pixel, y, false) > x)
            *out = 0;
    }
}

/* From near and z with all their bits: z is coarse, near fine and cut to 31
 * bits, so the quotient has what a coarse z leaves right. */
int32_t pel_nearness(const struct pel_projector *p, int32_t z)
{
    if (p->one)
        return (int32_t)(PEL_DEPTH_NEAR - z);
    const int cut = pel_bits_of((uint64_t)p->near_fine) - 31;
    const int64_t near = pel_scale_down(p->near_fine, cut);
    int64_t q = pel_scale_down(near * PEL_DEPTH_NEAR / z, p->coarse - cut);
    return q < PEL_DEPTH_NEAR ? (int32_t)q : PEL_DEPTH_NEAR;
}

/* Planes are off by less than 2^-17 of 2^30. */
enum { SURELY_ABOVE_0 = 1 << 14 };

static const struct pel_paint *filter(struct pel_frame *frame,
                                      const struct pel_paint *paint)
{
    struct pel_depth_paint *p = &frame->work->depth;
    struct pel_plane plane;
    int32_t near[3];
    for (int i = 0; i < 3; i++)
        near[i] =
            pel_nearness(&frame->projector, frame->work->triangle.corner[i]->z);
    pel_plane_set(&plane, pel_frame_setup(frame), near);
    pel_depth_paint_init(p, paint, p->depth, &plane,
                         frame->pass == PEL_PASS_FIRST);
    /* Where colors may be translucent the first pass draws opaque ones. */
    if (p->keeps && !frame->opaque)
        pel_color_paint_init(&p->base, colors, false);
    else if (pel_min(pel_min(near[0], near[1]), near[2]) >= SURELY_ABOVE_0)
        p->base.paint = (struct pel_paint)PEL_PAINT(
            fill, PEL_VECTORS ? pel_depth_fast : NULL);
    return &p->base.paint;
}

/* A texture with opaque and translucent texels is drawn twice. First the opaque
 * ones, which store their depths. Then all of them are only tested: an opaque
 * one is not nearer than what it has stored, so it stays as it is, and the
 * translucent ones in front are blended. */
void pel_scene_draw_depth(struct pel_frame *frame,
                          const struct pel_surface *surface,
                          const struct pel_depth *depth)
{
    if (frame->triangles == 0)
        return;
    frame->work->depth.depth = depth;
    frame->filter = filter;
    frame->pass = PEL_PASS_FIRST;
    pel_scene_draw(frame, surface);
    frame->pass = PEL_PASS_TRANSLUCENT;
    if (frame->translucent)
        pel_scene_draw(frame, surface);
    frame->pass = PEL_PASS_ALL;
    frame->filter = NULL;
}

void pel_scene_draw_certified(struct pel_frame *frame,
                              const struct pel_surface *surface,
                              const struct pel_rect *doubt,
                              const struct pel_depth *depth)
{
    struct pel_depth_entry *const order = frame->order;
    const uint32_t triangles = frame->triangles;
    struct pel_surface part = *surface;
    pel_scene_draw(frame, surface);
    part.clip = pel_rect_intersect(&part.clip, doubt);
    if (triangles == 0 || pel_rect_empty(&part.clip))
        return;
    frame->order = NULL;
    frame->triangles = frame->scene->mesh->triangles;
    pel_scene_draw_depth(frame, &part, depth);
    frame->order = order;
    frame->triangles = triangles;
}
