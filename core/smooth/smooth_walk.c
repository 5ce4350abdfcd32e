#include "smooth_walk.h"

#include "smooth_row.h"

/* Pixels whose areas are summed at a time. */
#if defined(__OPTIMIZE_SIZE__) && !PEL_SMALL_CODE
enum { AT_ONCE = 1 };
#else
enum { AT_ONCE = PEL_SMOOTH_PIXELS };
#endif

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
    struct pel_smooth_side *const s = &k->side[i];
    find_edge(k, i, &s->edge);
    const struct pel_point *const a = &k->v[s->edge.from];
    const struct pel_point *const b = &k->v[s->edge.to];
    s->at = pel_smooth_wide(a->x);
    if (a == b)
        return;
    s->step = pel_smooth_step(a, b);
    s->rise = pel_smooth_rise(a, b);
}

void pel_smooth_go_down(struct pel_smooth_side *s, int32_t h)
{
    const int64_t part =
        (int64_t)(pel_times((uint64_t)pel_size_of(s->step), h) >> 8);
    s->at += s->step < 0 ? -part : part;
}

/* Moves a side on by the row. Where an edge goes down to the end of the row it
 * is as far as a step, or a part of it, takes it, as in rows that are walked.
 */
static void pass(struct pel_smooth_walk *k, int i)
{
    struct pel_smooth_side *const s = &k->side[i];
    const int32_t bottom = PEL_PX(k->y) + 256;
    k->of.row.above[i] =
        (struct pel_smooth_above){(int32_t)(s->at >> 16), s->rise, s->edge};
    while (!has_ended(&s->edge) && k->v[s->edge.to].y < bottom)
        pel_smooth_next_edge(k, i);
    if (!has_ended(&s->edge))
        pel_smooth_go_down(s, pel_min(bottom - k->v[s->edge.from].y, 256));
}

void pel_smooth_pass_row(struct pel_smooth_walk *k)
{
    pass(k, 0);
    pass(k, 1);
    k->rest = (struct pel_span){INT32_MIN, INT32_MAX};
    k->y++;
}

/* How much of the row's height an edge crosses. */
static int32_t height_of(const struct pel_smooth_walk *k,
                         const struct pel_smooth_vertices *edge)
{
    const int32_t bottom = PEL_PX(k->y);
    return pel_min(k->v[edge->to].y, bottom) -
           pel_max(k->v[edge->from].y, bottom - 256);
}

/* Of an edge that begins in the row. */
static struct pel_rise rise_of(const struct pel_smooth_walk *k, int i,
                               const struct pel_smooth_vertices *edge)
{
    if (edge->to == k->side[i].edge.to)
        return k->side[i].rise;
    return pel_smooth_rise(&k->v[edge->from], &k->v[edge->to]);
}

static void widen(struct pel_span *span, int32_t x)
{
    span->x0 = pel_min(span->x0, x);
    span->x1 = pel_max(span->x1, x + 1);
}

/* The pixels that side i crosses. */
static PEL_NOINLINE_32 struct pel_span crossed_by(
    const struct pel_smooth_walk *k, int i)
{
    const struct pel_smooth_above *const above = &k->of.row.above[i];
    struct pel_smooth_vertices edge = above->edge;
    struct pel_span crossed = {INT32_MAX, INT32_MIN};
    int32_t begin = above->x >> 16;
    while (!has_ended(&edge) && k->v[edge.from].y < PEL_PX(k->y)) {
        const struct pel_point *const b = &k->v[edge.to];
        widen(&crossed, begin);
        if (b->y >= PEL_PX(k->y)) {
            widen(&crossed, (int32_t)(k->side[i].at >> 32));
            break;
        }
        widen(&crossed, pel_pixel_of(b->x));
        find_edge(k, i, &edge);
        begin = pel_pixel_of(k->v[edge.from].x);
    }
    return crossed;
}

/* Adds the areas right of side i in n pixels from x on, or takes them away. */
static PEL_NOINLINE_32 void cross_side(const struct pel_smooth_walk *k, int i,
                                       int32_t x, int32_t n, uint32_t *area)
{
    const struct pel_smooth_above *const above = &k->of.row.above[i];
    struct pel_smooth_vertices edge = above->edge;
    struct pel_smooth_piece p = {0, 0, above->rise, 0};
    int32_t begin = above->x;
    while (!has_ended(&edge) && k->v[edge.from].y < PEL_PX(k->y)) {
        const struct pel_point *const b = &k->v[edge.to];
        const bool ends = b->y < PEL_PX(k->y);
        const int32_t end = ends ? b->x * 256 : (int32_t)(k->side[i].at >> 16);
        pel_smooth_piece_set(&p, begin, end);
        p.height = (uint32_t)height_of(k, &edge) * 256;
        pel_smooth_add(&p, 0 - (uint32_t)i, x, n, area);
        if (!ends)
            return;
        begin = end;
        find_edge(k, i, &edge);
        p.rise = rise_of(k, i, &edge);
    }
}

static void cover(const void *shape, int32_t x, int32_t n, uint8_t *to)
{
    uint32_t area[AT_ONCE];
    for (int32_t k; n > 0; n -= k, x += k) {
        k = pel_min(n, AT_ONCE);
        for (int32_t i = 0; i < k; i++)
            area[i] = PEL_SMOOTH_HALF;
        cross_side(shape, 0, x, k, area);
        cross_side(shape, 1, x, k, area);
        for (int32_t i = 0; i < k; i++)
            *to++ = (uint8_t)(area[i] >> 24);
    }
}

/* The coverage of what is between the sides. */
static uint8_t even_of(const struct pel_smooth_walk *k)
{
    uint32_t area = PEL_SMOOTH_HALF;
    cross_side(k, 0, INT32_MAX - 1, 1, &area);
    return (uint8_t)(area >> 24);
}

void pel_smooth_rest_of_row(struct pel_smooth_walk *k)
{
    const struct pel_rect *const clip = &k->smooth.target->clip;
    struct pel_span crossed[2] = {crossed_by(k, 0), crossed_by(k, 1)};
    struct pel_smooth_columns c = {k->rest, crossed, 2, cover, k, 0};
    c.even = even_of(k);
    c.left.x0 = pel_max(c.left.x0, pel_max(crossed[0].x0, clip->x0));
    c.left.x1 = pel_min(pel_max(crossed[0].x1, crossed[1].x1), clip->x1);
    k->of.row.y = k->y - 1;
    k->of.row.n = 0;
    if (c.left.x0 < c.left.x1) {
        if (c.left.x1 - c.left.x0 <= PEL_SMOOTH_PIXELS)
            crossed[0] = c.left;
        pel_smooth_cover(&c, &k->of.batch);
    }
    k->rest = c.left;
}
