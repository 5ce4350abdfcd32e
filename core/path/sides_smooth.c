#include "sides_smooth.h"

#include "../smooth/smooth_sweep.h"
#include "smooth_path.h"

struct smooth {
    struct pel_sides sides;
    struct pel_smooth_sweep sweep;
};

static void begin(struct pel_sides *sides)
{
    struct smooth *const s = (struct smooth *)(void *)sides;
    s->sweep.count = s->sweep.active = 0;
    s->sweep.y0 = sides->y0;
    s->sweep.y1 = sides->y1;
}

static bool add(struct pel_sides *sides, const struct pel_point *a,
                const struct pel_point *b)
{
    struct smooth *const s = (struct smooth *)(void *)sides;
    return pel_smooth_sweep_add(&s->sweep, a, b);
}

static void paint_sides(struct pel_sides *sides)
{
    struct smooth *const s = (struct smooth *)(void *)sides;
    pel_smooth_sweep_paint(&s->sweep);
}

static const struct pel_sides_kind smooth_kind = {begin, add, paint_sides};

/* How many edges there is memory for beside a row; -1: not even for that. */
static int32_t room_in(const struct pel_scratch *scratch, int32_t width)
{
    const size_t row = PEL_SMOOTH_PATH_SCRATCH_SIZE(0, width);
    const size_t edge = PEL_SMOOTH_PATH_SCRATCH_SIZE(1, 0) - 4;
    if (scratch->size < row || (uintptr_t)scratch->memory % 8)
        return -1;
    const size_t room = (scratch->size - row) / edge;
    return room > 65536 ? 65536 : (int32_t)room;
}

enum pel_status pel_sides_smooth(const struct pel_surface *surface,
                                 const struct pel_outline_source *source,
                                 enum pel_fill_rule rule,
                                 const struct pel_paint *p,
                                 const struct pel_scratch *scratch)
{
    struct smooth s;
    if (!surface || !p || !scratch->memory)
        return PEL_ERROR_NULL;
    const struct pel_rect *const clip = &surface->clip;
    const int32_t room = room_in(scratch, pel_max(clip->x1 - clip->x0, 0));
    if (room < 0)
        return PEL_ERROR_SCRATCH;
    s.sides.kind = &smooth_kind;
    if (!pel_smooth_begin(&s.sweep.smooth, surface, p))
        return PEL_OK;
    pel_smooth_sweep_begin(&s.sweep, scratch->memory, room, rule);
    return pel_sides_draw(&s.sides, clip, source);
}
