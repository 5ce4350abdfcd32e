/* Sides into the sweep of centres. */
#include "../raster/sweep.h"
#include "sides.h"

struct fill {
    struct pel_sides sides;
    struct pel_sweep *sweep;
    const struct pel_surface *surface;
    const struct pel_paint *paint;
};

static void begin(struct pel_sides *sides)
{
    ((struct fill *)(void *)sides)->sweep->count = 0;
}

static bool add(struct pel_sides *sides, const struct pel_point *a,
                const struct pel_point *b)
{
    struct fill *const f = (struct fill *)(void *)sides;
    return pel_sweep_add(f->sweep, a, b, sides->y0, sides->y1);
}

static void paint_sides(struct pel_sides *sides)
{
    struct fill *const f = (struct fill *)(void *)sides;
    pel_sweep_paint(f->sweep, f->surface, f->paint);
}

static const struct pel_sides_kind fill_kind = {begin, add, paint_sides};

enum pel_status pel_sides_fill(const struct pel_surface *surface,
                               const struct pel_outline_source *source,
                               enum pel_fill_rule rule,
                               const struct pel_paint *p,
                               const struct pel_scratch *scratch)
{
    const size_t head = PEL_PATH_SCRATCH_SIZE(0);
    struct fill f;
    if (!surface || !p || !scratch->memory)
        return PEL_ERROR_NULL;
    if ((uintptr_t)scratch->memory % 4 || scratch->size < head)
        return PEL_ERROR_SCRATCH;
    f.sides.kind = &fill_kind;
    f.surface = surface;
    f.paint = p;
    const size_t room =
        (scratch->size - head) / (PEL_PATH_SCRATCH_SIZE(1) - head);
    f.sweep = pel_sweep_begin(scratch->memory,
                              room > 65536 ? 65536 : (int32_t)room, rule);
    return pel_sides_draw(&f.sides, &surface->clip, source);
}
