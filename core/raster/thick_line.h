/* Straight lines of any width. */
#ifndef PEL_RASTER_THICK_LINE_H
#define PEL_RASTER_THICK_LINE_H

#include "paint.h"

PEL_BEGIN_DECLS

struct pel_thick_line_shape {
    struct pel_point from, to;
    int32_t width; /* across, in 1/256 px: 0 to PEL_PX(32767) */
};

/* The four corners: from + n, to + n, to - n, from - n. n goes half of the
 * width across the line: (-(to.y - from.y), to.x - from.x) * width / (2
 * length), rounded to the nearest sub-pixel, away from 0 at a tie, with a
 * length of 31 bits. So a corner is within one sub-pixel of its exact place,
 * and the ends swapped give the same corners. Without length or width all lie
 * on the line. false when the line or a corner is out of range. */
bool pel_thick_line_corners(const struct pel_thick_line_shape *line,
                            struct pel_point v[4]);

/* Are its ends and its width in range? Corners may still be out of it. */
static inline bool pel_thick_line_legal(const struct pel_thick_line_shape *line)
{
    return pel_point_legal(line->from) && pel_point_legal(line->to) &&
           pel_radius_legal(line->width);
}

/* For PEL_HINT: pel_in_subpixels of a line. */
static inline bool pel_thick_line_in_subpixels(
    const struct pel_thick_line_shape *line)
{
    const struct pel_point ends[2] = {line->from, line->to};
    return pel_in_subpixels(ends, 2, line->width);
}

/* A box around the corners, in sub-pixels, of a line that is legal so. */
static inline struct pel_rect pel_thick_line_box(
    const struct pel_thick_line_shape *line)
{
    const struct pel_point a = line->from, b = line->to;
    const int32_t margin = line->width / 2 + 2;
    const struct pel_rect box = {
        pel_min(a.x, b.x) - margin, pel_min(a.y, b.y) - margin,
        pel_max(a.x, b.x) + margin, pel_max(a.y, b.y) + margin};
    return box;
}

/* Fills the polygon of these corners, by the rule of raster/edge.h: the ends
 * are cut straight, across the line. */
void pel_thick_line(const struct pel_surface *surface,
                    const struct pel_thick_line_shape *line,
                    const struct pel_paint *paint);
PEL_END_DECLS
#endif
