#include "icon.h"

#include "../path/smooth_path.h"
#include "../path/transform.h"
#include "icon_paint.h"

typedef enum pel_status draw_function(const struct pel_surface *surface,
                                      const struct pel_path_shape *shape,
                                      const struct pel_paint *paint,
                                      void *scratch, size_t size);

struct pel_icon_kind {
    draw_function *fill, *stroke; /* stroke: NULL where there are none */
};

const struct pel_icon_kind pel_icon_aliased = {pel_path_fill, NULL};
const struct pel_icon_kind pel_icon_aliased_strokes = {pel_path_fill,
                                                       pel_path_stroke};
const struct pel_icon_kind pel_icon_smooth = {pel_smooth_path_fill, NULL};
const struct pel_icon_kind pel_icon_smooth_strokes = {pel_smooth_path_fill,
                                                      pel_smooth_path_stroke};

enum pel_status pel_icon_place(struct pel_icon_shape *shape, int32_t size,
                               int32_t turn, struct pel_point at)
{
    const struct pel_icon_asset *const icon = shape->icon;
    const uint32_t side = (uint32_t)pel_max(icon->width, icon->height);
    shape->scale = pel_transform_scale(size, side);
    shape->transform = pel_transform_turned(shape->scale, turn, false, at);
    return pel_transform_point(&shape->transform, -(icon->width / 2),
                               -(icon->height / 2), &shape->transform.at)
               ? PEL_OK
               : PEL_ERROR_RANGE;
}

struct pel_rect pel_icon_box(const struct pel_icon_shape *shape)
{
    const struct pel_icon_asset *const icon = shape->icon;
    const struct pel_rect units = {icon->left, icon->top, icon->right,
                                   icon->bottom};
    return pel_transform_box(&shape->transform, units);
}

/* A part on its way to the surface, at the head of the scratch memory, as
 * stacks are small. */
struct drawing {
    struct pel_surface surface;
    const struct pel_icon_shape *shape;
    const struct pel_icon_part *part;
    int32_t left; /* of the parts, with this one */
    size_t size;  /* bytes behind this */
    struct pel_path path;
    struct pel_path_shape outline;
    union {
        struct pel_flat flat;
        struct pel_icon_paint gradient;
    } paint;
    struct pel_icon_run run;
};

PEL_STATIC_ASSERT(pel_icon_fits, sizeof(struct drawing) <= PEL_ICON_SIZE);

/* False: out of range. */
static bool set_paint(struct drawing *d)
{
    const struct pel_icon_asset *const icon = d->shape->icon;
    const struct pel_icon_part *const part = d->part;
    d->paint.gradient.run = &d->run;
    if (part->gradient < PEL_ICON_PROGRAM)
        return icon->painter->make(&d->paint.gradient,
                                   &icon->gradient[part->gradient], d->shape);
    d->paint.flat = (struct pel_flat)PEL_FLAT(
        part->gradient == PEL_ICON_FLAT
            ? part->color
            : pel_weighed(d->shape->color, pel_alpha(part->color)));
    return true;
}

/* False: out of range. */
static PEL_NOINLINE bool set_part(struct drawing *d)
{
    const struct pel_icon_part *const part = d->part;
    const int64_t width = pel_long_product(d->shape->scale, part->width);
    d->path.verb_count = part->verbs;
    d->path.point_count = part->points;
    d->outline.rule = (enum pel_fill_rule)(part->kind & 1);
    d->outline.stroke.width = (int32_t)((width + 32768) >> 16);
    d->outline.stroke.cap = (enum pel_cap)part->cap;
    d->outline.stroke.join = (enum pel_join)part->join;
    d->outline.stroke.miter_limit = part->miter_limit;
    return set_paint(d);
}

static enum pel_status draw_part(struct drawing *d)
{
    const struct pel_icon_kind *const kind = d->shape->kind;
    return (d->part->kind == PEL_ICON_STROKE ? kind->stroke : kind->fill)(
        &d->surface, &d->outline, &d->paint.flat.paint,
        (char *)d + PEL_ICON_SIZE, d->size);
}

static void next_part(struct drawing *d)
{
    d->path.verbs += d->part->verbs;
    d->path.points16 += 2 * d->part->points;
    d->part++;
    d->left--;
}

static PEL_NOINLINE enum pel_status begin(struct drawing *d,
                                          const struct pel_surface *surface,
                                          const struct pel_icon_shape *shape,
                                          size_t size)
{
    if (!surface || !shape || !shape->icon || !shape->kind || !d)
        return PEL_ERROR_NULL;
    if (shape->icon->strokes && !shape->kind->stroke)
        return PEL_ERROR_FORMAT;
    if ((uintptr_t)d % 8 || size < PEL_ICON_SIZE)
        return PEL_ERROR_SCRATCH;
    d->surface = *surface;
    d->shape = shape;
    d->part = shape->icon->part;
    d->size = size - PEL_ICON_SIZE;
    d->path.verbs = shape->icon->verb;
    d->path.points16 = shape->icon->point;
    d->path.points32 = NULL;
    d->outline.path = &d->path;
    d->outline.transform = &shape->transform;
    d->outline.tolerance = shape->tolerance;
    d->outline.stroke.dashes = NULL;
    const struct pel_rect box = pel_icon_box(shape);
    d->surface.clip = pel_rect_intersect(&box, &surface->clip);
    d->left = pel_rect_empty(&d->surface.clip) ? 0 : shape->icon->parts;
    return PEL_OK;
}

enum pel_status pel_icon(const struct pel_surface *surface,
                         const struct pel_icon_shape *shape, void *scratch,
                         size_t size)
{
    struct drawing *const d = scratch;
    enum pel_status status = begin(d, surface, shape, size);
    for (; status == PEL_OK && d->left > 0; next_part(d))
        status = set_part(d) ? draw_part(d) : PEL_ERROR_RANGE;
    return status;
}
