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

void pel_icon_place(struct pel_icon_shape *shape, int32_t size, int32_t turn,
                    struct pel_point at)
{
    const struct pel_icon_asset *const icon = shape->icon;
    const uint32_t side = (uint32_t)pel_max(icon->width, icon->height);
    shape->scale = pel_transform_scale(size, side);
    shape->transform = pel_transform_turned(shape->scale, turn, false, at);
    (void)pel_transform_point(&shape->transform, -(icon->width / 2),
                              -(icon->height / 2), &shape->transform.at);
}

struct pel_rect pel_icon_box(const struct pel_icon_shape *shape)
{
    const struct pel_icon_asset *const icon = shape->icon;
    const struct pel_rect units = {icon->left, icon->top, icon->right,
                                   icon->bottom};
    return pel_transform_box(&shape->transform, units);
}

/* A part on its way to the surface, at the head of the scratch memory. */
struct drawing {
    struct pel_surface surface;
    const struct pel_icon_shape *shape;
    struct pel_path path;
    struct pel_path_shape outline;
    union {
        struct pel_flat flat;
        struct pel_icon_paint gradient;
    } paint;
};

/* The program's with the alpha of the part. */
static pel_color program_color(pel_color color, pel_color part)
{
    const uint32_t alpha = pel_round_div255(pel_alpha(color) * pel_alpha(part));
    return (color & UINT32_C(0xFFFFFF)) | alpha << 24;
}

/* False: out of range. */
static bool set_paint(struct drawing *d, const struct pel_icon_part *part)
{
    const struct pel_icon_asset *const icon = d->shape->icon;
    if (part->gradient < PEL_ICON_PROGRAM)
        return icon->painter->make(&d->paint.gradient,
                                   &icon->gradient[part->gradient], d->shape);
    d->paint.flat = (struct pel_flat)PEL_FLAT(
        part->gradient == PEL_ICON_FLAT
            ? part->color
            : program_color(d->shape->color, part->color));
    return true;
}

static void set_outline(struct drawing *d, const struct pel_icon_part *part)
{
    const int64_t width = pel_long_product(d->shape->scale, part->width);
    d->path.verb_count = part->verbs;
    d->path.point_count = part->points;
    d->outline.rule = (enum pel_fill_rule)(part->kind & 1);
    d->outline.stroke.width = (int32_t)((width + 32768) >> 16);
    d->outline.stroke.cap = (enum pel_cap)part->cap;
    d->outline.stroke.join = (enum pel_join)part->join;
    d->outline.stroke.miter_limit = part->miter_limit;
}

typedef char pel_icon_fits[sizeof(struct drawing) <= PEL_ICON_SIZE ? 1 : -1];

/* With `size` bytes behind the drawing. */
static enum pel_status draw_parts(struct drawing *d, size_t size)
{
    const struct pel_icon_asset *const icon = d->shape->icon;
    const struct pel_icon_kind *const kind = d->shape->kind;
    const struct pel_icon_part *part = icon->part;
    enum pel_status status = PEL_OK;
    for (uint32_t left = icon->parts; left > 0 && status == PEL_OK; left--) {
        if (!set_paint(d, part))
            return PEL_ERROR_RANGE;
        set_outline(d, part);
        status = (part->kind == PEL_ICON_STROKE ? kind->stroke : kind->fill)(
            &d->surface, &d->outline, &d->paint.flat.paint,
            (char *)d + PEL_ICON_SIZE, size);
        d->path.verbs += part->verbs;
        d->path.points16 += 2 * part->points;
        part++;
    }
    return status;
}

enum pel_status pel_icon(const struct pel_surface *surface,
                         const struct pel_icon_shape *shape, void *scratch,
                         size_t size)
{
    struct drawing *const d = scratch;
    if (!surface || !shape || !shape->icon || !shape->kind || !d)
        return PEL_ERROR_NULL;
    if (shape->icon->strokes && !shape->kind->stroke)
        return PEL_ERROR_FORMAT;
    if ((uintptr_t)d % 8 || size < PEL_ICON_SIZE)
        return PEL_ERROR_SCRATCH;
    d->surface = *surface;
    d->shape = shape;
    d->path.verbs = shape->icon->verb;
    d->path.points16 = shape->icon->point;
    d->path.points32 = NULL;
    d->outline.path = &d->path;
    d->outline.transform = &shape->transform;
    d->outline.tolerance = shape->tolerance;
    d->outline.stroke.dashes = NULL;
    const struct pel_rect box = pel_icon_box(shape);
    d->surface.clip = pel_rect_intersect(&box, &surface->clip);
    return pel_rect_empty(&d->surface.clip)
               ? PEL_OK
               : draw_parts(d, size - PEL_ICON_SIZE);
}
