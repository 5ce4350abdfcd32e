/* Paths: outlines of lines and curves as const data, which fill at any size and
 * angle, and strokes: lines of any width along them.
 *
 *     static const uint8_t verbs[] = {
 *         PEL_MOVE, PEL_CUBIC, PEL_LINE, PEL_CLOSE};
 *     static const int16_t points[] = {
 *         0, 0, 0, 64, 96, 64, 96, 0, 48, -32};
 *     static const struct pel_path leaf = {
 *         .verbs = verbs, .points16 = points,
 *         .verb_count = 4, .point_count = 5};
 *     static const struct pel_transform twice = {
 *         PEL_SCALE(2), 0, 0, PEL_SCALE(2), PEL_AT(40, 80)};
 *     static uint64_t scratch[PEL_PATH_SCRATCH_SIZE(32) / 8 + 1];
 *
 *     const struct pel_path_shape shape = {
 *         .path = &leaf, .transform = &twice};
 *     pel_path_fill(&screen, &shape, &green.paint, scratch, sizeof scratch);
 *
 * A curve becomes lines: a number that depends on the curve alone, so bands,
 * tiles and clips change no pixel, and what is covered is what pel_polygon
 * covers of these lines. The smooth ones are in smooth_path.h. */
#ifndef PEL_PATH_PATH_H
#define PEL_PATH_PATH_H

#include "../raster/polygon.h"
#include "stroke.h"

PEL_BEGIN_DECLS

/* How a path goes on, and the points that it takes. */
enum pel_verb {
    PEL_MOVE,  /* 1: a part of the path begins here */
    PEL_LINE,  /* 1: a straight line to it */
    PEL_QUAD,  /* 2: a quadratic Bezier curve: its control point, its end */
    PEL_CUBIC, /* 3: a cubic one: two control points, its end */
    PEL_CLOSE  /* 0: a line back to where the part began, and the next one, if
                  no PEL_MOVE follows, begins there */
};

/* The first verb is PEL_MOVE. The points, x and y in turn, are in one of the
 * two lists; the other one is NULL. */
struct pel_path {
    const uint8_t *verbs;    /* enum pel_verb */
    const int16_t *points16; /* units of the path */
    const int32_t *points32;
    int32_t verb_count, point_count;
};

/* Where a point of a path lies on the surface, in 1/256 px:
 * x = at.x + round((xx x + xy y) / 65536), y = at.y + round((yx x + yy y) /
 * 65536). So PEL_SCALE(1) makes a unit a pixel, 65536 a sub-pixel. */
struct pel_transform {
    int32_t xx, xy, yx, yy;
    struct pel_point at;
};

/* Pixels for a unit of a path, above -128 and below 128; a constant may have a
 * fraction. */
#define PEL_SCALE(n) PEL_CAST(int32_t, (n)*INT64_C(16777216))

struct pel_path_shape {
    const struct pel_path *path;
    const struct pel_transform *transform; /* NULL: points are sub-pixels */
    enum pel_fill_rule rule;               /* of a fill */
    struct pel_stroke stroke;              /* of a stroke */
    int32_t tolerance; /* how far lines may lie from a curve, 1/256 px: 4 up to
                          65,535; 0 is 16, a sixteenth of a pixel */
};

/* Points that straight lines join; `closed`, the last and the first one too. */
struct pel_polyline_shape {
    const struct pel_point *v;
    int32_t n;
    bool closed;
    struct pel_stroke stroke;
};

/* Bytes of scratch memory, which is aligned to 8; for constant expressions. A
 * shape is drawn as many rows at a time as have room there, and its path is
 * walked once for each such lot, so more memory takes less time. At least one
 * row has to fit: of a fill `sides` are those that go through a row of pixels,
 * two or more for each part of the outline; of a stroke `width` is that of the
 * clip, px. */
#define PEL_PATH_SCRATCH_SIZE(sides) \
    (PEL_POLYGON_SCRATCH_SIZE(sides) + 54 * sizeof(void *))
#define PEL_STROKE_SCRATCH_SIZE(width, rows)                                  \
    (PEL_CAST(size_t, rows) * (PEL_CAST(size_t, (width) + 31) / 32 + 2) * 4 + \
     118 * sizeof(void *))

/* Is it a path? PEL_ERROR_NULL, PEL_ERROR_FORMAT (a verb that is none, or
 * before the first PEL_MOVE; points that are too many or too few). For data
 * from elsewhere: what draws a path checks it anyway. */
enum pel_status pel_path_check(const struct pel_path *path);

/* Fill the path, the stroke along it, and the stroke along points: the pixels
 * whose centre is inside, by the rule of raster/edge.h, each once, however
 * often a stroke crosses itself. Scratch memory is the caller's, may hold
 * anything, and may be used again after the call.
 *
 * PEL_ERROR_NULL, PEL_ERROR_FORMAT (as pel_path_check), PEL_ERROR_RANGE (a
 * point out of range; of a stroke, one nearer to its end than the width, or
 * than half of the width times the miter limit; a number of the shape out of
 * its own range): nothing is drawn then. PEL_ERROR_SCRATCH: the memory is not
 * aligned to 8, or too small for one row of a stroke, and nothing is drawn; or
 * a row of a fill has more sides than there is room for, and the rows above it
 * are drawn. */
enum pel_status pel_path_fill(const struct pel_surface *surface,
                              const struct pel_path_shape *shape,
                              const struct pel_paint *paint, void *scratch,
                              size_t size);
enum pel_status pel_path_stroke(const struct pel_surface *surface,
                                const struct pel_path_shape *shape,
                                const struct pel_paint *paint, void *scratch,
                                size_t size);
enum pel_status pel_polyline(const struct pel_surface *surface,
                             const struct pel_polyline_shape *line,
                             const struct pel_paint *paint, void *scratch,
                             size_t size);

/* Hit tests as in hit/hit.h: true for the pixels that these cover. They walk
 * the path, and what a drawing keeps in scratch memory is on the stack: on a
 * Cortex-M0+ a fill's takes 0.4 KB of it, a stroke's 0.8, with dashes or
 * without. */
bool pel_hit_path_fill(const struct pel_path_shape *shape, int32_t x,
                       int32_t y);
bool pel_hit_path_stroke(const struct pel_path_shape *shape, int32_t x,
                         int32_t y);
bool pel_hit_polyline(const struct pel_polyline_shape *line, int32_t x,
                      int32_t y);
PEL_END_DECLS
#endif
