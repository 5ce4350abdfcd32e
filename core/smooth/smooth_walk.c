#include "smooth_walk.h"

#include "../raster/edge.h"

/* Bytes of a part of a row. */
enum { BYTES = 2 * PEL_SMOOTH_WIDE };

bool pel_smooth_next_edge(const struct pel_smooth_walk *k,
                          struct pel_smooth_side *s)
{
    const struct pel_point *a, *b;
    do {
        s->from = s->to;
        a = &k->v[s->from];
        if (a->y == k->bottom)
            return false;
        s->to = pel_smooth_next_vertex(k, s->to, s->turn);
        b = &k->v[s->to];
    } while (b->y <= a->y);
    s->at = pel_smooth_wide(a->x);
    s->step = pel_smooth_step(a, b);
    s->rise = pel_smooth_rise(a, b);
    return true;
}

/* Part of an edge in a row. */
struct piece {
    int32_t lo, hi; /* px 2^-16 */
    struct pel_rise rise;
    int32_t h; /* 1/256 */
};

/* What a side has in a row: the end of an edge that begins above, or none (h =
 * 0), edges from vertex `from` to vertex `to`, and the beginning of one that
 * goes on below. */
struct part {
    struct piece first, last;
    int32_t from, to;
};

struct row {
    struct part part[2];
    int32_t lo[2], hi[2]; /* px that the sides cross */
};

static struct piece piece_of(int64_t a, int64_t b, struct pel_rise rise,
                             int32_t h)
{
    const int32_t x0 = (int32_t)(a >> 16), x1 = (int32_t)(b >> 16);
    const struct piece p = {pel_min(x0, x1), pel_max(x0, x1), rise, h};
    return p;
}

static uint32_t area_right_of(const struct piece *p, int32_t x)
{
    const int32_t a = p->lo >> 16, b = p->hi >> 16;
    const uint32_t full = (uint32_t)p->h * (255 << 16);
    const uint32_t low = p->lo & 0xFFFF, high = p->hi & 0xFFFF;
    if (x < a)
        return 0;
    if (x > b)
        return full;
    if (a == b)
        return ((131072 - low - high) * (uint32_t)p->h >> 2) * 510;
    if (x == a)
        return pel_smooth_corner(&p->rise, 65536 - low);
    if (x == b)
        return full - pel_smooth_corner(&p->rise, high);
    return pel_smooth_between(&p->rise, 65536 - low) +
           (uint32_t)(x - a - 1) * p->rise.value;
}

static uint32_t area_of_part(const struct pel_smooth_walk *k, int i,
                             const struct part *r, int32_t x)
{
    uint32_t area = 0;
    if (r->first.h)
        area += area_right_of(&r->first, x);
    if (r->last.h)
        area += area_right_of(&r->last, x);
    for (int32_t from = r->from, to; from != r->to; from = to) {
        to = pel_smooth_next_vertex(k, from, k->side[i].turn);
        const struct pel_point *const a = &k->v[from], *const b = &k->v[to];
        if (b->y <= a->y)
            continue;
        const struct piece p =
            piece_of(pel_smooth_wide(a->x), pel_smooth_wide(b->x),
                     pel_smooth_rise(a, b), b->y - a->y);
        area += area_right_of(&p, x);
    }
    return area;
}

static PEL_NOINLINE uint8_t coverage_at(const struct pel_smooth_walk *k,
                                        const struct row *row, int32_t x)
{
    const int64_t sum = (int64_t)area_of_part(k, 0, &row->part[0], x) -
                        area_of_part(k, 1, &row->part[1], x) + PEL_SMOOTH_HALF;
    return (uint8_t)pel_max(0, pel_min((int32_t)(sum >> 24), 255));
}

static void widen(struct row *row, int i, const struct piece *p)
{
    row->lo[i] = pel_min(row->lo[i], p->lo >> 16);
    row->hi[i] = pel_max(row->hi[i], p->hi >> 16);
}

/* x of a side h / 256 px further down. */
static int64_t x_below(const struct pel_smooth_side *s, int32_t h)
{
    return s->at + (h == 256 ? s->step : pel_smooth_part(s->step, h));
}

/* Moves side i on to the next row. */
static void part_of_row(struct pel_smooth_walk *k, int i, int32_t y,
                        struct row *row)
{
    struct pel_smooth_side *const s = &k->side[i];
    struct part *const part = &row->part[i];
    const int32_t top = PEL_PX(y), bottom = top + 256;
    row->lo[i] = INT32_MAX;
    row->hi[i] = INT32_MIN;
    part->first.h = part->last.h = part->from = part->to = 0;
    for (bool first = true; s->from != s->to && k->v[s->from].y < bottom;
         first = false) {
        const struct pel_point *const b = &k->v[s->to];
        const int32_t above = pel_max(k->v[s->from].y, top);
        const bool ends = b->y <= bottom;
        const int32_t h = (ends ? b->y : bottom) - above;
        const int64_t end = ends ? pel_smooth_wide(b->x) : x_below(s, h);
        const struct piece p = piece_of(s->at, end, s->rise, h);
        widen(row, i, &p);
        s->at = end;
        if (!ends) {
            part->last = p;
            break;
        }
        if (first) {
            part->first = p;
            part->from = s->to;
        }
        part->to = s->to;
        pel_smooth_next_edge(k, s);
    }
}

/* Are all pixels from x on, up to the right side, of one coverage? */
static bool is_between(const struct row *row, int32_t x)
{
    return x > row->hi[0] && x < row->lo[1];
}

/* Where a part of the row that begins at x ends. */
static int32_t end_of_part(const struct row *row, int32_t x)
{
    if (is_between(row, x))
        return row->lo[1];
    if (x <= row->hi[0] && row->hi[0] < row->lo[1])
        return row->hi[0] + 1;
    return row->hi[1] + 1;
}

void pel_smooth_vertex_row(struct pel_smooth_walk *k, int32_t y)
{
    const struct pel_rect *const clip = &k->smooth.surface.clip;
    struct row row;
    uint8_t bytes[BYTES];
    struct pel_smooth_row r = {y, 0, 0, 0, 0, bytes};
    part_of_row(k, 0, y, &row);
    part_of_row(k, 1, y, &row);
    const int32_t end = pel_min(row.hi[1] + 1, clip->x1);
    for (r.x = pel_max(row.lo[0], clip->x0); r.x < end;
         r.x += r.left + r.full) {
        const int32_t n = pel_min(end_of_part(&row, r.x), end) - r.x;
        const bool same = is_between(&row, r.x);
        bytes[0] = coverage_at(k, &row, r.x);
        r.full = same && bytes[0] == 255 ? n : 0;
        r.left = r.full ? 0 : pel_min(n, BYTES);
        for (int32_t i = 1; i < r.left; i++)
            bytes[i] = same ? bytes[0] : coverage_at(k, &row, r.x + i);
        pel_smooth_paint(&k->smooth, &r);
    }
}
