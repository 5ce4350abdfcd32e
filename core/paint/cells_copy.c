/* Rows of a gradient that are all alike: one is drawn, and copied. */
#include <string.h>

#include "../format/word.h"
#include "cells.h"

/* Copies the columns of `piece` that rows have, from row y of a surface, which
 * may be one of them. */
static void copy_piece(const struct pel_spans *to,
                       const struct pel_surface *from, int32_t y,
                       struct pel_span piece)
{
    const int32_t bytes = from->format->bits / 8;
    for (int32_t i = 0; i < to->n; i++) {
        const int32_t x = pel_max(to->span[i].x0, piece.x0);
        const int32_t n = pel_min(to->span[i].x1, piece.x1) - x;
        const uintptr_t source = pel_address(from, x, y, bytes);
        const uintptr_t target =
            pel_address(to->surface, x, to->y + i * to->step, bytes);
        if (n > 0 && target != source)
            memcpy((void *)target, (void *)source, (size_t)(n * bytes));
    }
}

static bool is_opaque(const struct pel_ramp *ramp)
{
    pel_color all = ramp->colors[0];
    for (int32_t i = 1; i < ramp->n; i++)
        all &= ramp->colors[i];
    return pel_alpha(all) == 255;
}

/* Do copies pay, and are they right? */
static bool can_copy(const struct pel_gradient *g,
                     const struct pel_spans *spans, struct pel_span *hull)
{
    const struct pel_format *const format = spans->surface->format;
    const int32_t pixels = pel_spans_hull(hull, spans->span, spans->n);
    return format->bits >= 8 && format->id < 128 &&
           pixels >= 2 * (hull->x1 - hull->x0) && pixels >= g->ramp.n &&
           is_opaque(&g->ramp);
}

#if PEL_64BIT

/* A screen may be slow to read: pieces of a row are drawn into a buffer. */
bool pel_cells_copy(const struct pel_gradient *g, const struct pel_spans *spans,
                    void (*fill)(const struct pel_paint *paint,
                                 const struct pel_spans *spans))
{
    uint32_t buffer[2048];
    struct pel_surface row = *spans->surface;
    const int32_t pixels = (int32_t)sizeof buffer * 8 / row.format->bits;
    struct pel_span hull, piece;
    if (!can_copy(g, spans, &hull))
        return false;
    row.pixels = buffer;
    for (piece = hull; piece.x0 < hull.x1; piece.x0 = piece.x1) {
        piece.x1 = pel_min(piece.x0 + pixels, hull.x1);
        row.bounds = (struct pel_rect){piece.x0, 0, piece.x1, 1};
        fill(&g->paint, &(struct pel_spans){&row, &piece, 0, 1, 1});
        copy_piece(spans, &row, 0, piece);
    }
    return true;
}

#else

bool pel_cells_row_to_copy(const struct pel_gradient *g,
                           struct pel_spans *spans)
{
    struct pel_span hull;
    int32_t n = can_copy(g, spans, &hull) ? spans->n : 0;
    for (spans->n = 1; n > 0; n--, spans->span++, spans->y += spans->step)
        if (spans->span->x0 == hull.x0 && spans->span->x1 == hull.x1)
            return true;
    return false;
}

void pel_cells_copy_row(const struct pel_spans *spans,
                        const struct pel_spans *row)
{
    copy_piece(spans, row->surface, row->y, *row->span);
}

#endif
