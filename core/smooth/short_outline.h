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

/* Where a part is looked for. */
struct pel_smooth_search {
    uint8_t side, quarter, quarters; /* that are looked at next */
    bool seek;                       /* an order is looked for */
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
        int16_t y, last_y; /* rows that are left: the first, the last */
    } seen;
#if PEL_SMALL_CODE
    int16_t x, last_x; /* px that are looked at in a row */
#else
    /* Sides that cross the row, and some below, from top to bottom. */
    struct {
        uint16_t order;      /* a list of them */
        uint8_t left;        /* such rows below this one */
        uint8_t passed : 4;  /* of them */
        uint8_t columns : 4; /* of a part, behind full.x1 */
    } rows;
#endif
    /* where its circles are at both ends of the row, or for the least code the
     * curve at hand */
    int32_t at[PEL_SMALL_CODE ? 1 : 2][2];
    struct pel_smooth_part part;
    union {
        struct pel_smooth_window window;   /* finds a part of a row, and then */
        struct pel_smooth_drawing drawing; /* paints it */
    } of;
};

/* A list of sides has 4 bits for each, and 0 behind the last one: 1 + 2 i, the
 * ith curve; one more, its left side alone; OTHER + i, the ith side that is
 * none of a curve's. NO_ORDER and NEVER are no lists. */
enum { PEL_SMOOTH_OTHER = 9, PEL_SMOOTH_NO_ORDER = 14, PEL_SMOOTH_NEVER = 15 };

/* What the sides of a kind of shapes are in row seen.y. */
struct pel_smooth_kind {
    uint32_t sides; /* all curves, then all other ones */
    /* Sets the ith curve; false: it is not in the row, nor is it asked for
     * always. */
    bool (*curve)(const struct pel_smooth_short_outline *outline, int32_t i,
                  bool always, struct pel_smooth_curve *curve);
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

/* The columns that are looked at. With little code it takes long to see that
 * one has nothing. Looks for an order of sides from the next row on, or never.
 */
#if PEL_SMALL_CODE
/* For less code; else for less stack. */
#define PEL_SMOOTH_PLACE static PEL_ALWAYS_INLINE
#define PEL_SMOOTH_SHARED static PEL_NOINLINE
#define PEL_SMOOTH_ONCE static PEL_ALWAYS_INLINE

static inline void pel_smooth_set_columns(struct pel_smooth_short_outline *o,
                                          const struct pel_rect *r)
{
    o->x = (int16_t)r->x0;
    o->last_x = (int16_t)(r->x1 - 1);
}

static inline int32_t pel_smooth_first_x(
    const struct pel_smooth_short_outline *o)
{
    return o->x;
}

static inline int32_t pel_smooth_last_x(
    const struct pel_smooth_short_outline *o)
{
    return o->last_x;
}

static inline void pel_smooth_no_order(struct pel_smooth_short_outline *o,
                                       bool never)
{
    PEL_CAST(void, o);
    PEL_CAST(void, never);
}
#else
#define PEL_SMOOTH_PLACE static PEL_NOINLINE
#define PEL_SMOOTH_SHARED
#define PEL_SMOOTH_ONCE

static inline void pel_smooth_set_columns(struct pel_smooth_short_outline *o,
                                          const struct pel_rect *r)
{
    PEL_CAST(void, o);
    PEL_CAST(void, r);
}

static inline int32_t pel_smooth_first_x(
    const struct pel_smooth_short_outline *o)
{
    return o->smooth.target->clip.x0;
}

static inline int32_t pel_smooth_last_x(
    const struct pel_smooth_short_outline *o)
{
    return o->smooth.target->clip.x1 - 1;
}

static inline void pel_smooth_no_order(struct pel_smooth_short_outline *o,
                                       bool never)
{
    o->rows.order = never ? PEL_SMOOTH_NEVER : PEL_SMOOTH_NO_ORDER;
    o->rows.left = 0;
    o->rows.columns = 0;
}

/* Sets the ith curve, and where it is if that is kept: how
 * many quarters it has, if some may be in the row. */
int32_t pel_smooth_set_curve(struct pel_smooth_short_outline *outline,
                             const struct pel_smooth_kind *kind, int32_t i);

/* Finds what the kth quarter of the curve that is set has in the row; false:
 * nothing. */
bool pel_smooth_set_quarter(struct pel_smooth_short_outline *outline,
                            const struct pel_smooth_kind *kind, int32_t i,
                            int32_t k);

/* Ends a part, and goes on to the next row if it was the last one; false at the
 * end. */
bool pel_smooth_end_part(struct pel_smooth_short_outline *outline);

/* Where a part is looked for, before it has a coverage, in its place. */
static inline struct pel_smooth_search *pel_smooth_search_of(
    struct pel_smooth_short_outline *outline)
{
    return (void *)outline->part.coverage;
}

static inline bool pel_smooth_has_order(
    const struct pel_smooth_short_outline *outline)
{
    return outline->rows.order < PEL_SMOOTH_NO_ORDER ||
           outline->rows.order > PEL_SMOOTH_NEVER;
}

/* Begins a row: if it may be the first one of some with an order, that is
 * looked for (short_order.c): the sides that are found are put in order, each
 * with the column that it begins in; false: no other one is needed. */
void pel_smooth_begin_row(struct pel_smooth_short_outline *outline,
                          const struct pel_smooth_kind *kind);
bool pel_smooth_put_in_order(struct pel_smooth_short_outline *outline,
                             int32_t side, int32_t x);
void pel_smooth_end_order(struct pel_smooth_short_outline *outline);
#endif

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
