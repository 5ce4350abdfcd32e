#include "smooth_path.h"

#include "../smooth/smooth_sweep.h"
#include "stroker.h"

/* The head of the scratch memory; behind it are pens. */
struct smooth {
    struct pel_sides_painter painter;
    struct pel_smooth_sweep sweep;
    struct pel_lines lines; /* of a stroke */
    struct pel_point to;    /* where the latest side ends */
};

#if PEL_SMOOTH_TINY
PEL_STATIC_ASSERT(pel_smooth_paint_fits,
                  sizeof(struct pel_smooth_drawing) <=
                      PEL_SMOOTH_EDGES_AT - PEL_SMOOTH_PAINT_AT);
#endif
PEL_STATIC_ASSERT(pel_smooth_path_fits,
                  sizeof(struct smooth) <= PEL_SMOOTH_PENS_AT);
PEL_STATIC_ASSERT(pel_smooth_path_is_aligned,
                  PEL_SMOOTH_EDGES_AT % 8 == 0 &&
                      PEL_SMOOTH_PENS_AT % sizeof(void *) == 0 &&
                      PEL_SMOOTH_PAINT_AT % sizeof(void *) == 0);

static void begin(struct pel_sides *sides)
{
    struct smooth *const s = (struct smooth *)(void *)sides;
    pel_smooth_sweep_set_rows(&s->sweep, sides->y0, sides->y1);
}

/* Makes room: the lower half of the rows is drawn later. False: there is one
 * alone. */
static PEL_NOINLINE_32 bool halve(struct smooth *s)
{
    struct pel_sides *const sides = &s->painter.sides;
    const int32_t half = (sides->y1 - sides->y0) / 2;
    pel_sides_set_rows(sides, sides->y0, sides->y1 - half);
    pel_smooth_sweep_cut(&s->sweep, sides->y1);
    return half > 0;
}

static void add(struct pel_sides *sides, int32_t x, int32_t y)
{
    struct smooth *const s = (struct smooth *)(void *)sides;
    s->to = (struct pel_point){x, y};
    while (!sides->full && !pel_smooth_sweep_add(&s->sweep, &sides->at, &s->to))
        sides->full = !halve(s);
    sides->at = s->to;
}

static bool paint_sides(struct pel_sides *sides)
{
    struct smooth *const s = (struct smooth *)(void *)sides;
    const int32_t count = s->sweep.count;
    pel_smooth_sweep_paint(&s->sweep);
    return 2 * count <= s->sweep.room;
}

static const struct pel_sides_kind smooth_kind = {
    .begin = begin, .add = add, .paint = paint_sides};

/* How many edges there is memory for beside a row; -1: not even for that. */
static int32_t room_in(const struct pel_scratch *scratch, int32_t width)
{
    const size_t row = PEL_SMOOTH_PATH_SCRATCH_SIZE(0, width);
    const size_t edge = PEL_SMOOTH_PATH_SCRATCH_SIZE(1, width) - row;
    if (scratch->size < row || (uintptr_t)scratch->memory % 8)
        return -1;
    const size_t room = (scratch->size - row) / edge;
    return room > 65536 ? 65536 : (int32_t)room;
}

/* On a format that cannot be blended there are no rows to draw. */
enum pel_status pel_sides_begin_smooth(const struct pel_surface *surface,
                                       enum pel_fill_rule rule,
                                       const struct pel_paint *p,
                                       const struct pel_scratch *scratch)
{
    if (!surface || !p || !scratch->memory)
        return PEL_ERROR_NULL;
    const struct pel_rect *const clip = &surface->clip;
    const int32_t room = room_in(scratch, pel_max(clip->x1 - clip->x0, 0));
    struct smooth *const s = scratch->memory;
    if (room < 0)
        return PEL_ERROR_SCRATCH;
    s->painter.sides.kind = &smooth_kind;
    s->painter.sides.memory = (char *)s + PEL_SMOOTH_PENS_AT;
    s->painter.sides.in_piece = false;
    pel_sides_set_clip(&s->painter, clip);
#if PEL_SMOOTH_TINY
    s->sweep.drawing = (void *)((char *)s + PEL_SMOOTH_PAINT_AT);
#endif
    if (pel_smooth_begin(&s->sweep.smooth, surface, p))
        pel_smooth_sweep_begin(&s->sweep, (char *)s + PEL_SMOOTH_EDGES_AT, room,
                               rule);
    else
        s->painter.sides.y1 = INT32_MIN;
    return PEL_OK;
}

enum pel_status pel_smooth_path_fill(const struct pel_surface *surface,
                                     const struct pel_path_shape *shape,
                                     const struct pel_paint *paint,
                                     void *scratch, size_t size)
{
    return pel_sides_fill_path(pel_sides_begin_smooth, surface, shape, paint,
                               &(const struct pel_scratch){scratch, size});
}

static PEL_ALWAYS_INLINE enum pel_status draw_stroke(
    const struct pel_surface *surface, const struct pel_lines *lines,
    const struct pel_paint *paint, const struct pel_scratch *scratch)
{
    struct smooth *const s = scratch->memory;
    const enum pel_status status =
        pel_sides_begin_smooth(surface, PEL_NON_ZERO, paint, scratch);
    if (status != PEL_OK)
        return status;
    s->lines = *lines;
    return pel_sides_draw(&s->painter, pel_stroke_walk, &s->lines);
}

enum pel_status pel_smooth_path_stroke(const struct pel_surface *surface,
                                       const struct pel_path_shape *shape,
                                       const struct pel_paint *paint,
                                       void *scratch, size_t size)
{
    const struct pel_scratch memory = {scratch, size};
    if (!shape)
        return PEL_ERROR_NULL;
    const struct pel_lines lines = {pel_path_walk, shape, &shape->stroke};
    return draw_stroke(surface, &lines, paint, &memory);
}

enum pel_status pel_smooth_polyline(const struct pel_surface *surface,
                                    const struct pel_polyline_shape *line,
                                    const struct pel_paint *paint,
                                    void *scratch, size_t size)
{
    const struct pel_scratch memory = {scratch, size};
    if (!line)
        return PEL_ERROR_NULL;
    const struct pel_lines lines = {pel_polyline_walk, line, &line->stroke};
    return draw_stroke(surface, &lines, paint, &memory);
}
