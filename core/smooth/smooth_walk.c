#include "smooth_walk.h"

static bool has_ended(const struct pel_smooth_vertices *edge)
{
    return edge->from == edge->to;
}

static int32_t next_vertex(const struct pel_smooth_walk *k, int i, int32_t at)
{
    at += i ? k->turn : -k->turn;
    return at == k->n ? 0 : at < 0 ? k->n - 1 : at;
}

/* On to the edge below; the chain ends where none goes down. */
static PEL_NOINLINE_32 void find_edge(const struct pel_smooth_walk *k, int i,
                                      struct pel_smooth_vertices *edge)
{
    int32_t down;
    do {
        edge->from = edge->to;
        edge->to = next_vertex(k, i, edge->from);
        down = k->v[edge->to].y - k->v[edge->from].y;
    } while (down == 0);
    if (down < 0)
        edge->to = edge->from;
}

void pel_smooth_next_edge(struct pel_smooth_walk *k, int i)
{
    struct pel_smooth_chain *const s = &k->side[i];
    find_edge(k, i, &s->edge);
    const struct pel_point *const a = &k->v[s->edge.from];
    const struct pel_point *const b = &k->v[s->edge.to];
    s->at = pel_smooth_wide(a->x);
    if (a == b)
        return;
    s->step = pel_smooth_slope(a, b, &s->rise);
}

void pel_smooth_go_down(struct pel_smooth_chain *s, int32_t h)
{
    const int64_t part =
        (int64_t)(pel_times((uint64_t)pel_size_of(s->step), h) >> 8);
    s->at += s->step < 0 ? -part : part;
}

/* The row is to be done from x to the pixel of x, too. */
static PEL_NOINLINE_32 void widen(struct pel_smooth_walk *k, int64_t at)
{
    const int32_t x = (int32_t)(at >> 32);
    k->rest.x0 = pel_min(k->rest.x0, x);
    k->rest.x1 = pel_max(k->rest.x1, x + 1);
}

/* Moves a side on by the row. Where an edge goes down to the end of the row it
 * is as far as a step, or a part of it, takes it, as in rows that are walked.
 */
static void pass(struct pel_smooth_walk *k, int i)
{
    struct pel_smooth_chain *const s = &k->side[i];
    const int32_t bottom = PEL_PX(k->y) + 256;
    k->of.row.above[i] = (struct pel_smooth_above){(int32_t)(s->at >> 16),
                                                   s->rise, s->edge.from};
    widen(k, s->at);
    while (!has_ended(&s->edge) && k->v[s->edge.to].y < bottom) {
        widen(k, pel_smooth_wide(k->v[s->edge.to].x));
        pel_smooth_next_edge(k, i);
        widen(k, s->at);
    }
    if (!has_ended(&s->edge))
        pel_smooth_go_down(s, pel_min(bottom - k->v[s->edge.from].y, 256));
    widen(k, s->at);
}

static void clip_columns(struct pel_span *columns, const struct pel_rect *clip)
{
    columns->x0 = pel_max(columns->x0, clip->x0);
    columns->x1 = pel_min(columns->x1, clip->x1);
}

void pel_smooth_pass_row(struct pel_smooth_walk *k)
{
    k->rest = (struct pel_span){INT32_MAX, INT32_MIN};
    pass(k, 0);
    pass(k, 1);
    clip_columns(&k->rest, &k->smooth.target->clip);
    k->y++;
}

/* How much of the row's height an edge crosses, px 2^-16. */
static uint32_t height_of(const struct pel_smooth_walk *k,
                          const struct pel_smooth_vertices *edge)
{
    const int32_t bottom = PEL_PX(k->y);
    return (uint32_t)(pel_min(k->v[edge->to].y, bottom) -
                      pel_max(k->v[edge->from].y, bottom - 256)) *
           256;
}

/* Of an edge that begins in the row. */
static struct pel_rise rise_of(const struct pel_smooth_walk *k, int i,
                               const struct pel_smooth_vertices *edge)
{
    struct pel_rise rise = k->side[i].rise;
    if (edge->to != k->side[i].edge.to)
        pel_smooth_slope(&k->v[edge->from], &k->v[edge->to], &rise);
    return rise;
}

/* Adds the areas right of side i from the first column that is left on, or
 * takes them away. Columns up to the result are all alike; or the first one is
 * crossed, and that is the result. */
static PEL_NOINLINE_32 int32_t add_side(const struct pel_smooth_walk *k, int i,
                                        int32_t end, uint32_t *area)
{
    const struct pel_smooth_above *const above = &k->of.row.above[i];
    struct pel_smooth_vertices edge = {0, above->from};
    struct pel_smooth_piece p = {0, 0, above->rise, 0};
    int32_t begin = above->x;
    const int32_t x = k->rest.x0;
    find_edge(k, i, &edge);
    while (!has_ended(&edge) && k->v[edge.from].y < PEL_PX(k->y)) {
        const struct pel_point *const b = &k->v[edge.to];
        const bool ends = b->y < PEL_PX(k->y);
        pel_smooth_piece_set(
            &p, begin, ends ? b->x * 256 : (int32_t)(k->side[i].at >> 16));
        p.height = height_of(k, &edge);
        if (x <= p.hi >> 16)
            end = pel_min(end, pel_max(x, p.lo >> 16));
        pel_smooth_add(&p, 0 - (uint32_t)i, x, PEL_SMOOTH_SUMS, area);
        if (!ends)
            break;
        find_edge(k, i, &edge);
        begin = k->v[edge.from].x * 256;
        p.rise = rise_of(k, i, &edge);
    }
    return end;
}

/* Full pixels at the end are left: there may be more of them. */
static int32_t end_of_sums(const uint32_t *area, int32_t x, int32_t end)
{
    end = pel_min(end, x + PEL_SMOOTH_SUMS);
    while (end > x + 1 && area[end - x - 1] >> 24 == 255)
        end--;
    return end;
}

void pel_smooth_rest_of_row(struct pel_smooth_walk *k)
{
    struct pel_smooth_batch *const b = &k->of.batch;
    uint32_t area[PEL_SMOOTH_SUMS];
    const int32_t x = k->rest.x0;
    for (int i = 0; i < PEL_SMOOTH_SUMS; i++)
        area[i] = PEL_SMOOTH_HALF;
    int32_t end = add_side(k, 0, add_side(k, 1, k->rest.x1, area), area);
    const uint32_t first = area[0] >> 24;
    const bool alike = end > x, whole = alike && (uint8_t)(first + 1) < 2;
    if (!whole)
        end = alike ? pel_min(end, x + PEL_SMOOTH_BATCH_BYTES)
                    : end_of_sums(area, x, k->rest.x1);
    b->y = k->y - 1;
    b->n = 1;
    b->count[0] = (uint8_t)(whole ? 0 : end - x);
    b->count[1] = 0;
    for (int32_t i = 0; i < b->count[0]; i++)
        b->coverage[i] = (uint8_t)(area[alike ? 0 : i] >> 24);
    b->at.full[0] = (struct pel_span){whole && first > 0 ? x : end, end};
    k->rest.x0 = end;
}
