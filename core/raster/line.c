#include "line.h"

#include "edge.h"

/* A line has one span in each row; an exact edge (edge.h) says where it is.
 *
 * Flat lines, no higher than wide: the span of a row goes from where the line
 * crosses the row's upper boundary to where it crosses the lower one. The edge
 * is the line moved down by half a pixel, so that it has its x on boundaries.
 * A line to the left is mirrored, pixel x to pixel -1 - x, because a crossing
 * exactly in the centre of a column belongs to the row below.
 *
 * Steep lines: the pixel floor(x) at the row's centre. An edge rounds its x up,
 * so it is that of -x, and the pixel is minus its result. */
struct walk {
    struct pel_rect p; /* pixels (x0, y0) to (x1, y1), downwards */
    struct pel_edge edge;
    int32_t x; /* flat: begin of the span in this row */
    bool flat, mirrored;
};

/* Starts a flat line at row y, with the edge at the boundary below it. */
static void start_flat(struct walk *w, int32_t y)
{
    const struct pel_rect *p = &w->p;
    const struct pel_point a = {pel_pixel_center(p->x0), PEL_PX(p->y0 + 1)};
    const struct pel_point b = {pel_pixel_center(p->x1), PEL_PX(p->y1 + 1)};
    w->x = p->x0;
    if (p->y0 == p->y1)
        return;
    pel_edge_start(&w->edge, &a, &b, pel_max(y, p->y0 + 1));
    if (y > p->y0) {
        w->x = w->edge.x;
        pel_edge_next(&w->edge);
    }
}

static void start_steep(struct walk *w, int32_t y)
{
    const struct pel_rect *p = &w->p;
    const struct pel_point a = {-PEL_PX(p->x0), pel_pixel_center(p->y0)};
    const struct pel_point b = {-PEL_PX(p->x1), pel_pixel_center(p->y1)};
    pel_edge_start(&w->edge, &a, &b, y);
}

static PEL_NOINLINE void start(struct walk *w, int32_t y)
{
    const int32_t dx = w->p.x1 - w->p.x0, dy = w->p.y1 - w->p.y0;
    w->flat = dy <= dx || dy <= -dx;
    w->mirrored = w->flat && dx < 0;
    if (w->mirrored) {
        w->p.x0 = -1 - w->p.x0;
        w->p.x1 = -1 - w->p.x1;
    }
    if (w->flat)
        start_flat(w, y);
    else
        start_steep(w, y);
}

/* Sets the span of row y and moves on to the next row. */
static PEL_INLINE_LOOP void next_span(struct walk *w, int32_t y,
                                      struct pel_span *span)
{
    int32_t x = -w->edge.x, next = x + 1;
    if (w->flat) {
        x = w->x;
        next = y < w->p.y1 ? w->edge.x : w->p.x1 + 1;
        w->x = next;
    }
    span->x0 = w->mirrored ? -next : x;
    span->x1 = w->mirrored ? -x : next;
    pel_edge_next(&w->edge);
}

/* Paints rows [y, end), clipped. */
static void fill(struct walk *w, const struct pel_surface *surface, int32_t y,
                 int32_t end, const struct pel_paint *paint)
{
    const struct pel_rect *clip = &surface->clip;
    struct pel_span span[PEL_BATCH_ROWS];
    struct pel_spans spans = {surface, span, y, 0, 1};
    for (; spans.y < end; spans.y += spans.n) {
        spans.n = pel_min(end - spans.y, PEL_BATCH_ROWS);
        for (int32_t i = 0; i < spans.n; i++) {
            next_span(w, spans.y + i, &span[i]);
            span[i].x0 = pel_max(span[i].x0, clip->x0);
            span[i].x1 = pel_min(span[i].x1, clip->x1);
        }
        paint->fill(paint, &spans);
    }
}

void pel_line(const struct pel_surface *surface, struct pel_point from,
              struct pel_point to, const struct pel_paint *paint)
{
    bool legal = pel_point_legal(from) && pel_point_legal(to);
    PEL_ASSERT(legal);
    PEL_HINT(pel_in_subpixels((struct pel_point[2]){from, to}, 2, 0));
    if (!legal)
        return;
    struct walk w;
    if (from.y <= to.y)
        w.p = (struct pel_rect){pel_pixel_of(from.x), pel_pixel_of(from.y),
                                pel_pixel_of(to.x), pel_pixel_of(to.y)};
    else
        w.p = (struct pel_rect){pel_pixel_of(to.x), pel_pixel_of(to.y),
                                pel_pixel_of(from.x), pel_pixel_of(from.y)};
    w.edge = (struct pel_edge){0, 0, 0, 0, 0};
    const int32_t y = pel_max(w.p.y0, surface->clip.y0);
    const int32_t end = pel_min(w.p.y1 + 1, surface->clip.y1);
    if (y >= end)
        return;
    start(&w, y);
    fill(&w, surface, y, end, paint);
}
