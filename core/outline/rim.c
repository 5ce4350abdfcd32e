#include "rim.h"

/* One run without its interior: what is left of it, one pixel smaller at both
 * ends, when runs of the rows above and below are on both sides of it. */
static void put_run(struct pel_rim *r, int32_t y, const struct pel_row *run)
{
    const struct pel_rim_line *above = &r->line[0], *below = &r->line[2];
    int32_t x = run->x0;
    for (int32_t i = 0, j = 0; i < above->n && j < below->n;) {
        const struct pel_row *a = &above->run[i], *b = &below->run[j];
        int32_t x0 = pel_max(run->x0 + 1, pel_max(a->x0, b->x0));
        int32_t x1 = pel_min(run->x1 - 1, pel_min(a->x1, b->x1));
        if (x0 < x1) {
            pel_collect_clipped(&r->out, y, x, x0);
            x = x1;
        }
        if (a->x1 < b->x1)
            i++;
        else
            j++;
    }
    pel_collect_clipped(&r->out, y, x, run->x1);
}

/* Puts the row above the present one, whose neighbours are complete now, and
 * moves on by a row. */
static void step(struct pel_rim *r)
{
    const struct pel_rect *clip = &r->out.rows.surface->clip;
    const int32_t y = r->y - 1;
    struct pel_rim_line done = r->line[0];
    if (y >= clip->y0 && y < clip->y1)
        for (int32_t i = 0; i < r->line[1].n; i++)
            put_run(r, y, &r->line[1].run[i]);
    r->line[0] = r->line[1];
    r->line[1] = r->line[2];
    r->line[2] = done;
    r->line[2].n = 0;
    r->y++;
}

/* To row y. Two steps put all rows that there were; the first of them is then
 * only above an empty one. */
static void advance(struct pel_rim *r, int32_t y)
{
    for (int k = 0; k < 2 && r->y != y; k++)
        step(r);
    r->y = y;
}

static void add_run(struct pel_rim *r, const struct pel_row *run)
{
    struct pel_rim_line *line = &r->line[2];
    if (line->n && line->run[line->n - 1].x1 == run->x0)
        line->run[line->n - 1].x1 = run->x1;
    else if (line->n < r->capacity)
        line->run[line->n++] = *run;
}

static void rim_fill(const struct pel_paint *paint, const struct pel_rows *rows)
{
    struct pel_rim *r = (struct pel_rim *)(uintptr_t)paint;
    int32_t y = rows->y;
    for (int32_t i = 0; i < rows->n; i++, y += rows->step) {
        if (rows->row[i].x0 >= rows->row[i].x1)
            continue;
        if (y != r->y)
            advance(r, y);
        add_run(r, &rows->row[i]);
    }
}

bool pel_rim_begin(struct pel_rim *rim, const struct pel_surface *surface,
                   const struct pel_paint *paint, struct pel_row *memory,
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
    pel_collect_begin(&rim->out, surface, paint);
    return true;
}

void pel_rim_end(struct pel_rim *rim)
{
    advance(rim, rim->y + 2);
    pel_collect_end(&rim->out);
}
