/* Paints smooth rounds (round_strips.h). */
#ifndef PEL_SMOOTH_ROUND_ROWS_H
#define PEL_SMOOTH_ROUND_ROWS_H

#include "round_strips.h"
#include "smooth.h"

struct pel_smooth_rows {
    struct pel_smooth smooth;
    struct pel_smooth_strips strips;
    struct pel_span rows; /* that are left */
    int32_t image_y;      /* a row and its image add up to it */
    bool twins;           /* rows are painted with their images */
    bool inside;          /* no column is clipped away */
    bool twin_columns;    /* the left side mirrors the right one, by columns */
    void (*paint)(struct pel_smooth *smooth, const struct pel_smooth_row *row);
    uint8_t coverage[2 * PEL_SMOOTH_WINDOW];
};

/* A round of legal coordinates; false: nothing is visible. */
bool pel_smooth_rows_begin(struct pel_smooth_rows *rows,
                           const struct pel_surface *surface,
                           const struct pel_smooth_round *round,
                           const struct pel_paint *paint);

/* Paints what the strips hold of the first row that is left. */
void pel_smooth_rows_paint(struct pel_smooth_rows *rows,
                           const struct pel_smooth_round *round);

/* Paints a part of a row, and its image, if there is one. */
void pel_smooth_rows_put(struct pel_smooth_rows *rows,
                         struct pel_smooth_row *row);

/* How many columns a window takes. */
static inline int32_t pel_smooth_window(const struct pel_span *columns)
{
    return pel_max(pel_min(columns->x1 - columns->x0, PEL_SMOOTH_WINDOW), 0);
}

/* What lies in x0 up to x1. */
static inline struct pel_span pel_smooth_clipped(struct pel_span span,
                                                 int32_t x0, int32_t x1)
{
    span.x0 = pel_max(span.x0, x0);
    span.x1 = pel_min(span.x1, x1);
    return span;
}

static inline bool pel_smooth_empty(const struct pel_span *span)
{
    return span->x0 >= span->x1;
}

/* Begins and paints all. */
void pel_smooth_round(const struct pel_surface *surface,
                      const struct pel_smooth_round *round,
                      const struct pel_paint *paint);

#endif
