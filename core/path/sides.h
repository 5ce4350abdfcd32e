/* The seam between what makes the sides of an outline, a path or the stroke
 * along one, and what takes them: a sweep, a smooth one, a hit test. */
#ifndef PEL_PATH_SIDES_H
#define PEL_PATH_SIDES_H

#include "smooth_path.h"

struct pel_sides;

struct pel_sides_kind {
    /* Forgets all sides; the rows have changed. */
    void (*begin)(struct pel_sides *sides);
    /* Takes one from `at` to (x, y), a legal point, and goes there. */
    void (*add)(struct pel_sides *sides, int32_t x, int32_t y);
    /* Ends a convex piece of a stroke: its sides were added clockwise on
     * screen, from `start` on. NULL: sides that pieces share are left out. */
    void (*end)(struct pel_sides *sides);
    /* Paints what is inside. True: there was room for twice as many. */
    bool (*paint)(struct pel_sides *sides);
};

/* The first member of each kind's struct. */
struct pel_sides {
    const struct pel_sides_kind *kind;
    int32_t y0, y1;      /* rows that are drawn */
    int32_t top, bottom; /* the same in sub-pixels */
    void *memory;        /* for the pens of a walk, PEL_PENS_SIZE bytes */
    struct pel_point at, start;
    bool in_piece;
    bool full; /* there was no room for a side */
};

/* Memory of a shape that is drawn, at the head of the scratch memory, as stacks
 * are small: what takes the sides, and behind it the pens. */
enum {
    PEL_PENS_SIZE = 90 * sizeof(void *),
    PEL_TAKER_SIZE = PEL_STROKE_SCRATCH_SIZE(0, 0) - PEL_PENS_SIZE
};

/* Of a smooth painter, in bytes: before the edges, which are aligned to 8,
 * there are the pens, whose memory is the caller's where the walk has none; the
 * end of it is used while pixels are painted, when all walks have ended. */
enum {
    PEL_SMOOTH_EDGES_AT = PEL_SMOOTH_PATH_SCRATCH_SIZE(0, 0) - sizeof(int32_t),
    PEL_SMOOTH_PENS_AT = PEL_SMOOTH_EDGES_AT - PEL_PENS_SIZE,
    PEL_SMOOTH_PAINT_AT = PEL_SMOOTH_EDGES_AT - 26 * sizeof(void *)
};

/* What makes them: walks all of an outline. PEL_ERROR_SCRATCH: there was no
 * room. */
typedef enum pel_status pel_outline_walk(const void *shape,
                                         struct pel_sides *sides);

/* Sides that are painted some rows at a time. */
struct pel_sides_painter {
    struct pel_sides sides; /* the rows at hand */
    const struct pel_rect *clip;
    pel_outline_walk *walk;
    const void *shape;
};

struct pel_scratch {
    void *memory;
    size_t size;
};

static inline void pel_sides_set_rows(struct pel_sides *s, int32_t y0,
                                      int32_t y1)
{
    s->y0 = y0;
    s->y1 = y1;
    s->top = PEL_PX(y0);
    s->bottom = PEL_PX(y1);
    s->full = false;
}

/* With the rows of the clip. */
static inline void pel_sides_set_clip(struct pel_sides_painter *p,
                                      const struct pel_rect *clip)
{
    p->clip = clip;
    pel_sides_set_rows(&p->sides, clip->y0, clip->y1);
}

/* Makes a painter at the head of the scratch memory, which takes sides by the
 * aliased sweep, and by that of areas. The surface and the paint must live
 * until it has drawn. */
typedef enum pel_status pel_sides_begin(const struct pel_surface *surface,
                                        enum pel_fill_rule rule,
                                        const struct pel_paint *paint,
                                        const struct pel_scratch *scratch);
pel_sides_begin pel_sides_begin_fill, pel_sides_begin_smooth;

/* Draws what the walk makes inside the clip: as many rows at a time as have
 * room. */
enum pel_status pel_sides_draw(struct pel_sides_painter *painter,
                               pel_outline_walk *walk, const void *shape);

/* Is the centre of pixel (x, y) inside? */
bool pel_sides_hit(pel_outline_walk *walk, const void *shape,
                   enum pel_fill_rule rule, int32_t x, int32_t y);

/* The source of the fill of a struct pel_path_shape, and that fill. */
enum pel_status pel_path_walk_sides(const void *shape, struct pel_sides *sides);
static PEL_ALWAYS_INLINE enum pel_status pel_sides_fill_path(
    pel_sides_begin *begin, const struct pel_surface *surface,
    const struct pel_path_shape *shape, const struct pel_paint *paint,
    const struct pel_scratch *scratch)
{
    if (!shape)
        return PEL_ERROR_NULL;
    const enum pel_status status = begin(surface, shape->rule, paint, scratch);
    return status == PEL_OK
               ? pel_sides_draw(scratch->memory, pel_path_walk_sides, shape)
               : status;
}

/* The lines of the shapes of strokes. */
struct pel_pen;
enum pel_status pel_path_walk(const void *shape, struct pel_pen *pen);
enum pel_status pel_polyline_walk(const void *shape, struct pel_pen *pen);

#endif
