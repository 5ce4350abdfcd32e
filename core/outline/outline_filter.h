/* Outlines of any shape: a filter between a shape and a paint that lets through
 * the pixels of the shape that have a neighbour (left, right, above or below)
 * outside of it. An outline lies inside the fill, is as symmetric, one pixel
 * wide and closed (its pixels touch at corners at least). The fill without the
 * outline, then the outline, paint every pixel of the fill once.
 *
 * The shape is drawn with the surface and the paint of the filter:
 *
 *     enum { SPANS = PEL_OUTLINE_FILTER_SPANS(2) };
 *     struct pel_span memory[SPANS];
 *     struct pel_outline_filter f;
 *     if (pel_outline_filter_begin(&f, surface, paint, memory, SPANS)) {
 *         pel_ring(&f.surface, &ring, &f.paint);
 *         pel_outline_filter_end(&f);
 *     }
 *
 * That surface has a clip one pixel larger on every side, so that the clip
 * makes no edge. Unlike other paints the filter has a state: it needs the rows
 * from the top down, and each row from left to right, as all shapes of core
 * draw them. */
#ifndef PEL_OUTLINE_OUTLINE_FILTER_H
#define PEL_OUTLINE_OUTLINE_FILTER_H

#include "../raster/paint.h"

PEL_BEGIN_DECLS

/* Spans of memory for shapes with at most n spans in a row: 1 without a dent or
 * hole, 2 for a ring, 3 for an arc, half of the vertices for a polygon. Spans
 * beyond n in a row are left out. */
#define PEL_OUTLINE_FILTER_SPANS(n) (3 * (n))

struct pel_outline_spans {
    struct pel_span *span;
    int32_t n;
};

enum { PEL_OUTLINE_FILTER_BATCH = 4 };

struct pel_outline_filter {
    struct pel_paint paint;
    struct pel_surface surface;
    const struct pel_paint *out;
    struct pel_spans spans; /* parts of row y - 1 */
    struct pel_span part[PEL_OUTLINE_FILTER_BATCH];
    struct pel_outline_spans row[3]; /* rows y - 2, y - 1 and y */
    int32_t y, capacity;
    int32_t x, at[3]; /* row y - 1 is done up to x; at: next span of each */
};

/* `spans` is the size of memory, a multiple of 3; the caller may use it again
 * after the end. false: nothing can be covered, and no end is needed. */
bool pel_outline_filter_begin(struct pel_outline_filter *f,
                              const struct pel_surface *surface,
                              const struct pel_paint *paint,
                              struct pel_span *memory, int32_t spans);

void pel_outline_filter_end(struct pel_outline_filter *f);

PEL_END_DECLS

#endif
