/* The sweep that fills outlines: it takes their sides one by one, in any order,
 * and paints the pixels whose centre is inside, row by row. For those who write
 * a shape; polygon.h and path/path.h have what firmware calls. */
#ifndef PEL_RASTER_SWEEP_H
#define PEL_RASTER_SWEEP_H

#include "edge.h"
#include "polygon.h"

/* One side of the outline, from its first visible row on. */
struct pel_sweep_side {
    struct pel_edge edge;
    int32_t first, end; /* rows, half-open */
    int32_t winding;    /* +1 downwards, -1 upwards */
};

/* The head of scratch memory, behind which lie `room` sides and `room` indices
 * of them, the order: its first `active` are the sides that cross the present
 * row, by x; from `next` to `count` those to come, by first row. active <= next
 * always. It lies there and not on the stack, of which sweeps with a larger
 * paint have little left. */
struct pel_sweep {
    int32_t count, next, active;
    int32_t mask; /* of the winding number: 1 even-odd, -1 non-zero */
    int32_t room; /* sides that there is memory for */
};

static inline struct pel_sweep_side *pel_sweep_sides(struct pel_sweep *w)
{
    return (struct pel_sweep_side *)(void *)(w + 1);
}

static inline int32_t *pel_sweep_order(struct pel_sweep *w)
{
    return (int32_t *)(void *)(pel_sweep_sides(w) + w->room);
}

/* In memory of PEL_POLYGON_SCRATCH_SIZE(room). */
static inline struct pel_sweep *pel_sweep_begin(void *scratch, int32_t room,
                                                enum pel_fill_rule rule)
{
    struct pel_sweep *const w = PEL_CAST(struct pel_sweep *, scratch);
    w->count = w->next = w->active = 0;
    w->mask = rule == PEL_EVEN_ODD ? 1 : -1;
    w->room = room;
    return w;
}

/* Adds the side from a to b, of legal points, if it crosses the centres of rows
 * from y0 to y1 - 1. False: there is no room for it. */
bool pel_sweep_add(struct pel_sweep *w, const struct pel_point *a,
                   const struct pel_point *b, int32_t y0, int32_t y1);

/* Begins the sweep of a polygon and adds its sides. As pel_polygon_visible:
 * only where that is 1 there is something to paint. */
int pel_polygon_begin(const struct pel_polygon_shape *polygon, void *scratch,
                      size_t size, const struct pel_rect *clip);

/* Paints what is inside the sides of a closed outline, no pixel twice. Their
 * rows must lie inside the clip. There are no sides any more then. PEL_OK. */
enum pel_status pel_sweep_paint(struct pel_sweep *w,
                                const struct pel_surface *surface,
                                const struct pel_paint *paint);

#endif
