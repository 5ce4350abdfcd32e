#include "rim.h"

#include "../format/word.h"

/* The next piece of the row above the present one, perhaps empty: of a run what
 * is left without its interior, which is one pixel smaller at both ends, where
 * runs of the rows above and below are on both sides of it. All three rows are
 * gone through once: runs above and below that reach to the end of this run
 * stay for the next one. Interior that is cut out ends at x, so that it is
 * empty when it is seen again. */
static bool next_piece(struct pel_rim *r, struct pel_span *piece)
{
    const struct pel_rim_line *above = &r->line[0], *below = &r->line[2];
    const struct pel_span *run = &r->line[1].run[r->at[1]];
    if (r->at[1] == r->line[1].n)
        return false;
    piece->x0 = r->x = pel_max(r->x, run->x0);
    while (r->at[0] < above->n && r->at[2] < below->n) {
        const struct pel_span *a = &above->run[r->at[0]];
        const struct pel_span *b = &below->run[r->at[2]];
        const int32_t end = pel_min(a->x1, b->x1);
        const int32_t x0 =
            pel_max(pel_max(run->x0 + 1, r->x), pel_max(a->x0, b->x0));
        const int32_t x1 = pel_min(run->x1 - 1, end);
        if (x0 < x1) {
            r->x = x1;
            piece->x1 = x0;
            return true;
        }
        if (end >= run->x1)
            break;
        r->at[a->x1 < b->x1 ? 0 : 2]++;
    }
    piece->x1 = run->x1;
    r->at[1]++;
    return true;
}

/* The next pieces, to paint them; false when there are no more. */
static PEL_WIDE bool next_pieces(struct pel_rim *r)
{
    const struct pel_rect *clip = &r->spans.surface->clip;
    struct pel_span piece;
    r->spans.n = 0;
    r->spans.y = r->y - 1;
    if (r->spans.y < clip->y0 || r->spans.y >= clip->y1)
        return false;
    while (r->spans.n < PEL_RIM_PIECES && next_piece(r, &piece)) {
        piece.x0 = pel_max(piece.x0, clip->x0);
        piece.x1 = pel_min(piece.x1, clip->x1);
        if (piece.x0 < piece.x1)
            r->piece[r->spans.n++] = piece;
    }
    return r->spans.n > 0;
}

/* On by a row: the neighbours of the present one are complete then. */
static PEL_WIDE void step(struct pel_rim *r)
{
    const struct pel_rim_line done = r->line[0];
    r->line[0] = r->line[1];
    r->line[1] = r->line[2];
    r->line[2] = done;
    r->line[2].n = 0;
    r->at[0] = r->at[1] = r->at[2] = 0;
    r->x = INT32_MIN;
    r->y++;
}

/* To row y. Two steps put all rows that there were; the first of them is then
 * only above an empty one. */
static PEL_ALWAYS_INLINE void advance(struct pel_rim *r, int32_t y)
{
    for (int k = 0; k < 2 && r->y != y; k++) {
        while (next_pieces(r))
            r->out->fill(r->out, &r->spans);
        step(r);
    }
    r->y = y;
}

static void add_run(struct pel_rim *r, const struct pel_span *run)
{
    struct pel_rim_line *line = &r->line[2];
    if (line->n && line->run[line->n - 1].x1 == run->x0)
        line->run[line->n - 1].x1 = run->x1;
    else if (line->n < r->capacity)
        line->run[line->n++] = *run;
}

static void rim_fill(const struct pel_paint *paint,
                     const struct pel_spans *spans)
{
    struct pel_rim *r = (struct pel_rim *)(uintptr_t)paint;
    int32_t y = spans->y;
    for (int32_t i = 0; i < spans->n; i++, y += spans->step) {
        if (spans->span[i].x0 >= spans->span[i].x1)
            continue;
        if (y != r->y)
            advance(r, y);
        add_run(r, &spans->span[i]);
    }
}

bool pel_rim_begin(struct pel_rim *rim, const struct pel_surface *surface,
                   const struct pel_paint *paint, struct pel_span *memory,
                   int32_t runs)
{
    if (pel_rect_empty(&surface->clip))
        return false;
    rim->paint = (struct pel_paint){.fill = rim_fill};
    rim->surface = *surface;
    rim->surface.clip.x0--;
    rim->surface.clip.y0--;
    rim->surface.clip.x1++;
    rim->surface.clip.y1++;
    rim->capacity = runs / 3;
    for (int k = 0; k < 3; k++)
        rim->line[k] = (struct pel_rim_line){memory + k * rim->capacity, 0};
    rim->y = rim->surface.clip.y0;
    rim->at[1] = 0; /* the other two, and x, are set by the first step */
    rim->out = paint;
    rim->spans = (struct pel_spans){surface, rim->piece, 0, 0, 0};
    return true;
}

void pel_rim_end(struct pel_rim *rim)
{
    advance(rim, rim->y + 2);
}
