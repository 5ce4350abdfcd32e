#include "outline_filter.h"

#include "outline_row.h"

/* Sets the next part of the outline in the middle row, perhaps empty: of a span
 * all but its inside, the pixels not at its ends that spans above and below
 * cover. The three rows are walked once: a span above or below that reaches the
 * end of this span stays for the next one. x is where the last inside ends, so
 * that the same one is empty when it is found again. */
static bool next_part(struct pel_outline_filter *r, struct pel_span *part)
{
    const struct pel_outline_spans *above = &r->row[0], *below = &r->row[2];
    const struct pel_span *span = &r->row[1].span[r->at[1]];
    if (r->at[1] == r->row[1].n)
        return false;
    part->x0 = r->x = pel_max(r->x, span->x0);
    while (r->at[0] < above->n && r->at[2] < below->n) {
        const struct pel_span *a = &above->span[r->at[0]];
        const struct pel_span *b = &below->span[r->at[2]];
        const int32_t end = pel_min(a->x1, b->x1);
        const int32_t x0 =
            pel_max(pel_max(span->x0 + 1, r->x), pel_max(a->x0, b->x0));
        const int32_t x1 = pel_min(span->x1 - 1, end);
        if (x0 < x1) {
            r->x = x1;
            part->x1 = x0;
            return true;
        }
        if (end >= span->x1)
            break;
        r->at[a->x1 < b->x1 ? 0 : 2]++;
    }
    part->x1 = span->x1;
    r->at[1]++;
    return true;
}

/* Sets the next parts to paint; false when there are none. */
static PEL_NOINLINE_32 bool next_parts(struct pel_outline_filter *r)
{
    const struct pel_rect *clip = &r->spans.surface->clip;
    struct pel_span part;
    r->spans.n = 0;
    r->spans.y = r->y - 1;
    if (r->spans.y < clip->y0 || r->spans.y >= clip->y1)
        return false;
    while (r->spans.n < PEL_OUTLINE_FILTER_BATCH && next_part(r, &part)) {
        part.x0 = pel_max(part.x0, clip->x0);
        part.x1 = pel_min(part.x1, clip->x1);
        if (part.x0 < part.x1)
            r->part[r->spans.n++] = part;
    }
    return r->spans.n > 0;
}

/* Moves on by a row, whose neighbours are then complete. */
static PEL_NOINLINE_32 void step(struct pel_outline_filter *r)
{
    const struct pel_outline_spans done = r->row[0];
    r->row[0] = r->row[1];
    r->row[1] = r->row[2];
    r->row[2] = done;
    r->row[2].n = 0;
    r->at[0] = r->at[1] = r->at[2] = 0;
    r->x = INT32_MIN;
    r->y++;
}

/* Moves on to row y. Two steps paint all rows that there were; the last of them
 * stays in row[0], above an empty row. */
static PEL_ALWAYS_INLINE void advance(struct pel_outline_filter *r, int32_t y)
{
    for (int k = 0; k < 2 && r->y != y; k++) {
        while (next_parts(r))
            r->out->fill(r->out, &r->spans);
        step(r);
    }
    r->y = y;
}

static void add_span(struct pel_outline_filter *r, const struct pel_span *span)
{
    struct pel_outline_spans *row = &r->row[2];
    if (row->n && row->span[row->n - 1].x1 == span->x0)
        row->span[row->n - 1].x1 = span->x1;
    else if (row->n < r->capacity)
        row->span[row->n++] = *span;
}

static void filter_fill(const struct pel_paint *paint,
                        const struct pel_spans *spans)
{
    struct pel_outline_filter *r =
        (struct pel_outline_filter *)(uintptr_t)paint;
    for (int32_t i = 0; i < spans->n; i++) {
        const int32_t y = spans->y + i * spans->step;
        if (spans->span[i].x0 >= spans->span[i].x1)
            continue;
        if (y != r->y)
            advance(r, y);
        add_span(r, &spans->span[i]);
    }
}

bool pel_outline_filter_begin(struct pel_outline_filter *f,
                              const struct pel_surface *surface,
                              const struct pel_paint *paint,
                              struct pel_span *memory, int32_t spans)
{
    if (pel_rect_empty(&surface->clip))
        return false;
    f->paint = (struct pel_paint){filter_fill, NULL};
    f->surface = *surface;
    f->surface.clip = pel_outline_clip(surface);
    f->capacity = spans / 3;
    for (int k = 0; k < 3; k++)
        f->row[k] = (struct pel_outline_spans){memory + k * f->capacity, 0};
    f->y = f->surface.clip.y0;
    f->at[1] = 0; /* the first step sets the other two and x */
    f->out = paint;
    f->spans = (struct pel_spans){surface, f->part, 0, 0, 0};
    return true;
}

void pel_outline_filter_end(struct pel_outline_filter *f)
{
    if (f->row[1].n || f->row[2].n)
        advance(f, f->y + 2);
}
