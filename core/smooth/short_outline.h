/* Outlines where PEL_SMOOTH_TINY is 1: a shape has little to keep while the
 * paint is called. Its curves are set again whenever some pixels of a row are
 * looked at, in functions that have returned by then. */
#ifndef PEL_SMOOTH_SHORT_OUTLINE_H
#define PEL_SMOOTH_SHORT_OUTLINE_H

#include "outline.h"
#include "smooth_layer.h"

/* Columns whose areas are summed at a time. */
enum { PEL_SMOOTH_COLUMNS = PEL_SMOOTH_PIXELS };

/* Full pixels of a row, and some with a coverage each; what comes next begins
 * at full.x1. */
struct pel_smooth_part {
    struct pel_span full, some;
    uint8_t coverage[PEL_SMOOTH_COLUMNS];
};

/* Some columns of a row from full.x1 on, in which the areas right of its sides
 * are added up: for the least code one. */
struct pel_smooth_window {
    struct pel_smooth_crossing crossing;
    struct pel_smooth_curve curve;
    /* 2^-15 px: what each has more than the one before it, and what those have
     * that follow up to the next one that a side crosses */
    int32_t sum[PEL_SMALL_CODE ? 1 : PEL_SMOOTH_COLUMNS + 1];
};

/* What each shape has, first. */
struct pel_smooth_short_outline {
    struct pel_smooth smooth;
    struct {
        int16_t x, y, last_x, last_y;
    } seen; /* px that are left: the first of them and the last */
    /* where its circles are at both ends of the row, or for the least code the
     * curve at hand */
    int32_t at[PEL_SMALL_CODE ? 1 : 2][2];
    struct pel_smooth_part part;
    union {
        struct pel_smooth_window window;   /* finds a part of a row, and then */
        struct pel_smooth_drawing drawing; /* paints it */
    } of;
};

/* What the sides of a kind of shapes are in row seen.y. */
struct pel_smooth_kind {
    uint8_t curves, others;
    /* Sets the ith curve; false: it is not in the row. */
    bool (*curve)(const struct pel_smooth_short_outline *outline, int32_t i,
                  struct pel_smooth_curve *curve);
    /* Cuts a crossing of its kth quarter at its ends; false: nothing is left.
     * NULL: curves are whole circles. */
    bool (*cut)(struct pel_smooth_short_outline *outline, int32_t i, int32_t k);
    /* The ith other side; false: there is none. */
    bool (*other)(const struct pel_smooth_short_outline *outline, int32_t i,
                  struct pel_smooth_crossing *crossing);
};

/* Begins with a box of pixels; `smooth` is set. False: nothing in it can be
 * seen. */
bool pel_smooth_short_outline_begin(struct pel_smooth_short_outline *outline,
                                    const struct pel_rect *box);

/* Ends a part, and finds the next one; false at the end. */
bool pel_smooth_next_part(struct pel_smooth_short_outline *outline,
                          const struct pel_smooth_kind *kind);

/* Begins its full pixels, then the others; false: the paint need not be asked.
 */
bool pel_smooth_begin_part(struct pel_smooth_short_outline *outline,
                           const struct pel_span *span);

/* Paints what is to be seen, from the frame of the shape. */
static PEL_ALWAYS_INLINE void pel_smooth_short_outline_paint(
    struct pel_smooth_short_outline *o, const struct pel_smooth_kind *kind)
{
    while (pel_smooth_next_part(o, kind)) {
        if (pel_smooth_begin_part(o, &o->part.full))
            o->smooth.paint->fill(o->smooth.paint, &o->of.drawing.spans);
        if (pel_smooth_begin_part(o, &o->part.some))
            o->smooth.paint->fill(o->smooth.paint, &o->of.drawing.spans);
    }
}

#endif
