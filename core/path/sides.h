/* The seam between what makes the sides of an outline, a path or the stroke
 * along one, and what takes them: a sweep, a smooth one, a hit test. */
#ifndef PEL_PATH_SIDES_H
#define PEL_PATH_SIDES_H

#include "path.h"

struct pel_sides;

struct pel_sides_kind {
    /* Forgets all sides; the rows have changed. */
    void (*begin)(struct pel_sides *sides);
    /* Takes one, of legal points; false: there is no room for it. */
    bool (*add)(struct pel_sides *sides, const struct pel_point *a,
                const struct pel_point *b);
    /* Paints what is inside. */
    void (*paint)(struct pel_sides *sides);
};

/* The first member of each kind's struct. */
struct pel_sides {
    const struct pel_sides_kind *kind;
    int32_t y0, y1;      /* rows that are drawn */
    int32_t top, bottom; /* the same in sub-pixels */
};

/* What makes them: walks all of an outline. PEL_ERROR_SCRATCH: there was no
 * room. */
struct pel_outline_source {
    enum pel_status (*walk)(const void *shape, struct pel_sides *sides);
    const void *shape;
};

struct pel_scratch {
    void *memory;
    size_t size;
};

/* Draws the source inside the clip: as many rows at a time as have room. */
enum pel_status pel_sides_draw(struct pel_sides *sides,
                               const struct pel_rect *clip,
                               const struct pel_outline_source *source);

/* The same with the aliased sweep. */
enum pel_status pel_sides_fill(const struct pel_surface *surface,
                               const struct pel_outline_source *source,
                               enum pel_fill_rule rule,
                               const struct pel_paint *paint,
                               const struct pel_scratch *scratch);

/* Is the centre of pixel (x, y) inside? */
bool pel_sides_hit(const struct pel_outline_source *source,
                   enum pel_fill_rule rule, int32_t x, int32_t y);

/* The sources: shapes of struct pel_path_shape and pel_polyline_shape. */
enum pel_status pel_path_walk_fill(const void *shape, struct pel_sides *sides);
enum pel_status pel_path_walk_stroke(const void *shape,
                                     struct pel_sides *sides);
enum pel_status pel_polyline_walk(const void *shape, struct pel_sides *sides);

#endif
