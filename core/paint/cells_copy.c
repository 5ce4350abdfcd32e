/* Rows of a gradient that are all alike: one is drawn, and copied. */
#include <string.h>

#include "../format/word.h"
#include "cells.h"

typedef void fill_row(const struct pel_paint *paint,
                      const struct pel_spans *spans);

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

#if PEL_64BIT

/* A screen may be slow to read: pieces of a row are drawn into a buffer. */
static bool copy_rows(const struct pel_gradient *g,
                      const struct pel_spans *spans,
                      const struct pel_span *hull, fill_row *fill)
{
    uint32_t buffer[2048];
    struct pel_surface row = *spans->surface;
    const int32_t pixels = (int32_t)sizeof buffer * 8 / row.format->bits;
    row.pixels = buffer;
    struct pel_span piece = *hull;
    for (; piece.x0 < hull->x1; piece.x0 = piece.x1) {
        piece.x1 = pel_min(piece.x0 + pixels, hull->x1);
        row.bounds = (struct pel_rect){piece.x0, 0, piece.x1, 1};
        fill(&g->paint, &(struct pel_spans){&row, &piece, 0, 1, 1});
        copy_piece(spans, &row, 0, piece);
    }
    return true;
}

#else

/* Stack is short: a row that has the columns of all others is drawn. */
static bool copy_rows(const struct pel_gradient *g,
                      const struct pel_spans *spans,
                      const struct pel_span *hull, fill_row *fill)
{
    struct pel_spans one = *spans;
    for (int32_t left = spans->n; left; left--, one.span++, one.y += one.step) {
        one.n = 1;
        if (one.span->x0 == hull->x0 && one.span->x1 == hull->x1) {
            fill(&g->paint, &one);
            copy_piece(spans, spans->surface, one.y, *hull);
            return true;
        }
    }
    return false;
}

#endif

static bool is_opaque(const struct pel_ramp *ramp)
{
    pel_color all = ramp->colors[0];
    for (int32_t i = 1; i < ramp->n; i++)
        all &= ramp->colors[i];
    return pel_alpha(all) == 255;
}

bool pel_cells_copy(const struct pel_gradient *g, const struct pel_spans *spans,
                    fill_row *fill)
{
    const struct pel_format *const format = spans->surface->format;
    struct pel_span hull;
    const int32_t pixels = pel_spans_hull(&hull, spans->span, spans->n);
    return format->bits >= 8 && format->id < 128 &&
           pixels >= 2 * (hull.x1 - hull.x0) && pixels >= g->ramp.n &&
           is_opaque(&g->ramp) && copy_rows(g, spans, &hull, fill);
}
