/* Fills of paths: their sides into the sweep of centres, or past the centre of
 * one pixel. */
#include "../raster/crossing.h"
#include "../raster/sweep.h"
#include "pen.h"

/* Parts that are left open are closed. */
static enum pel_status draw(struct pel_pen *pen, enum pel_verb verb,
                            const struct pel_point *p)
{
    struct pel_fill_pen *const f = (struct pel_fill_pen *)(void *)pen;
    struct pel_sides *const sides = pen->sides;
    const struct pel_point *const to = verb == PEL_LINE ? p : &f->start;
    sides->kind->add(sides, to->x, to->y);
    if (verb == PEL_MOVE && p)
        f->start = sides->at = *p;
    return sides->full ? PEL_ERROR_SCRATCH : PEL_OK;
}

void pel_fill_pen_begin(struct pel_fill_pen *f, struct pel_sides *sides)
{
    *f = (struct pel_fill_pen){.pen = {draw, sides->top, sides->bottom,
                                       PEL_COORDINATE_MAX, sides,
                                       sides->memory}};
    sides->at = f->start;
}

enum pel_status pel_path_walk_sides(const void *shape, struct pel_sides *sides)
{
    struct pel_fill_pen f;
    pel_fill_pen_begin(&f, sides);
    return pel_path_walk(shape, &f.pen);
}

struct fill {
    struct pel_sides_painter painter;
    struct pel_sweep *sweep;
    const struct pel_surface *surface;
    const struct pel_paint *paint;
    struct pel_path_state state;
};

PEL_STATIC_ASSERT(pel_fill_fits,
                  PEL_PATH_SCRATCH_SIZE(0) >=
                      sizeof(struct fill) + PEL_POLYGON_SCRATCH_SIZE(0));

static void begin_sweep(struct pel_sides *sides)
{
    ((struct fill *)(void *)sides)->sweep->count = 0;
}

static void add_to_sweep(struct pel_sides *sides, int32_t x, int32_t y)
{
    struct fill *const f = (struct fill *)(void *)sides;
    const struct pel_point from = sides->at;
    sides->at = (struct pel_point){x, y};
    sides->full |=
        !pel_sweep_add(f->sweep, &from, &sides->at, sides->y0, sides->y1);
}

static bool paint_sweep(struct pel_sides *sides)
{
    struct fill *const f = (struct fill *)(void *)sides;
    const int32_t spare = f->sweep->room - 2 * f->sweep->count;
    pel_sweep_paint(f->sweep, f->surface, f->paint);
    return spare >= 0;
}

static const struct pel_sides_kind fill_kind = {
    .begin = begin_sweep, .add = add_to_sweep, .paint = paint_sweep};

enum pel_status pel_sides_begin_fill(const struct pel_surface *surface,
                                     enum pel_fill_rule rule,
                                     const struct pel_paint *paint,
                                     const struct pel_scratch *scratch)
{
    const size_t head = PEL_PATH_SCRATCH_SIZE(0);
    struct fill *const f = scratch->memory;
    if (!surface || !paint || !f)
        return PEL_ERROR_NULL;
    if ((uintptr_t)f % 8 || scratch->size < head)
        return PEL_ERROR_SCRATCH;
    const size_t room =
        (scratch->size - head) / (PEL_PATH_SCRATCH_SIZE(1) - head);
    f->painter.sides.kind = &fill_kind;
    f->painter.sides.memory = &f->state;
    pel_sides_set_clip(&f->painter, &surface->clip);
    f->surface = surface;
    f->paint = paint;
    f->sweep =
        pel_sweep_begin(f + 1, room > 65536 ? 65536 : (int32_t)room, rule);
    return PEL_OK;
}

enum pel_status pel_path_fill(const struct pel_surface *surface,
                              const struct pel_path_shape *shape,
                              const struct pel_paint *paint, void *scratch,
                              size_t size)
{
    return pel_sides_fill_path(pel_sides_begin_fill, surface, shape, paint,
                               &(const struct pel_scratch){scratch, size});
}

struct hit {
    struct pel_sides sides;
    struct pel_point center;
    int32_t winding;
};

static void add_crossing(struct pel_sides *sides, int32_t x, int32_t y)
{
    struct hit *const h = (struct hit *)(void *)sides;
    const struct pel_point from = sides->at;
    sides->at = (struct pel_point){x, y};
    h->winding += pel_crossing(&from, &sides->at, h->center);
}

static const struct pel_sides_kind hit_kind = {.add = add_crossing};

bool pel_sides_hit(pel_outline_walk *walk, const void *shape,
                   enum pel_fill_rule rule, int32_t x, int32_t y)
{
    struct pel_path_state state;
    struct hit h = {.sides = {.kind = &hit_kind, .memory = &state}};
    if (!pel_pixel_legal(x, y))
        return false;
    h.center = (struct pel_point){pel_pixel_center(x), pel_pixel_center(y)};
    pel_sides_set_rows(&h.sides, y, y + 1);
    return walk(shape, &h.sides) == PEL_OK &&
           (rule == PEL_EVEN_ODD ? h.winding & 1 : h.winding != 0);
}

bool pel_hit_path_fill(const struct pel_path_shape *shape, int32_t x, int32_t y)
{
    return pel_sides_hit(pel_path_walk_sides, shape, shape->rule, x, y);
}
