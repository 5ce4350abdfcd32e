/* The sides of a walk: their edges, and what they have in a row. */
#include "short_walk.h"

/* In place of where an edge ends: none goes further down. */
enum { ENDED = INT32_MAX };

/* Corner i of a line, whose first one m leads to; at square ends every other
 * one lies a quarter turn further. */
static PEL_NOINLINE void line_corner(const struct pel_smooth_short_walk *k,
                                     int32_t i, struct pel_point *to)
{
    const struct pel_thick_line_shape *const line = k->shape.line;
    const bool turned = k->square && (i & 1);
    const int32_t x = turned ? k->of.m.y : k->of.m.x;
    const int32_t y = turned ? -k->of.m.x : k->of.m.y;
    *to = (i + 1) & 2 ? line->to : line->from;
    to->x += i < 2 ? x : -x;
    to->y += i < 2 ? y : -y;
}

static PEL_NOINLINE void vertex(const struct pel_smooth_short_walk *k,
                                int32_t i, struct pel_point *to)
{
    if (k->line)
        line_corner(k, i, to);
    else
        *to = k->shape.v[i];
}

static int32_t count_of(const struct pel_smooth_short_walk *k)
{
    return k->line ? 4 : k->of.n;
}

static PEL_NOINLINE int32_t next_vertex(const struct pel_smooth_short_walk *k,
                                        int i, int32_t at)
{
    const int32_t n = count_of(k);
    at += (i == 0) == k->backwards ? 1 : -1;
    return at == n ? 0 : at < 0 ? n - 1 : at;
}

/* The edge of side i from where it begins, but for level ones: where it ends.
 */
static PEL_NOINLINE int32_t find_edge(struct pel_smooth_short_walk *k, int i,
                                      struct pel_smooth_short_side *s)
{
    struct pel_point *const edge = k->work.row.edge;
    for (;;) {
        const int32_t to = next_vertex(k, i, s->from);
        vertex(k, s->from, edge);
        vertex(k, to, edge + 1);
        if (edge[0].y != edge[1].y)
            break;
        s->from = to;
    }
    return edge[0].y < edge[1].y ? edge[1].y : ENDED;
}

/* Begins with it; a side that has ended stays where it is. */
static PEL_NOINLINE int32_t enter_edge(struct pel_smooth_short_walk *k, int i,
                                       struct pel_smooth_short_side *s)
{
    struct pel_point *const edge = k->work.row.edge;
    const int32_t end = find_edge(k, i, s);
    s->at = pel_smooth_wide(edge->x);
    s->step = 0;
    if (end != ENDED) {
        s->step = pel_smooth_slope(edge, edge + 1, &k->work.row.piece.rise);
        s->rise = k->work.row.piece.rise.value;
    }
    return end;
}

/* The part of a step is rounded towards 0: it does not pass its end. h is less
 * than the edge is high, or 256, so the product is below 2^24 2^32. */
static PEL_NOINLINE void go_down(struct pel_smooth_short_side *s, int32_t h)
{
    const int64_t part =
        (int64_t)(pel_times((uint64_t)pel_size_of(s->step), h) >> 8);
    s->at += s->step < 0 ? -part : part;
}

/* What the side that is followed has next in the row, of an edge that goes down
 * to `end`. */
static PEL_NOINLINE void next_piece(struct pel_smooth_short_walk *k,
                                    int32_t end)
{
    struct pel_smooth_short_side *const s = &k->work.row.side;
    struct pel_smooth_piece *const p = &k->work.row.piece;
    const struct pel_point *const edge = k->work.row.edge;
    const int32_t bottom = PEL_PX(k->pixels.y) + 256;
    const int32_t above = (int32_t)(s->at >> 16);
    int32_t h = 0;
    pel_smooth_set_whole(s, p);
    if (end != ENDED) {
        h = pel_min(end, bottom) - pel_max(edge->y, bottom - 256);
        go_down(s, h);
    }
    pel_smooth_piece_set(
        p, above, end < bottom ? edge[1].x * 256 : (int32_t)(s->at >> 16));
    p->height = (uint32_t)h * 256;
}

void pel_smooth_set_whole(const struct pel_smooth_short_side *s,
                          struct pel_smooth_piece *p)
{
    pel_smooth_piece_set(p, (int32_t)(s->at >> 16),
                         (int32_t)((s->at + s->step) >> 16));
    p->rise.value = s->rise;
    p->rise.steep = (uint64_t)pel_size_of(s->step) >> 32 == 0;
    p->height = 65536;
}

static void add_piece(struct pel_smooth_short_walk *k, int i, int32_t n)
{
    pel_smooth_add(&k->work.row.piece, 0 - (uint32_t)i, k->pixels.span.x1, n,
                   k->work.row.area);
}

static void note_piece(struct pel_smooth_short_walk *k)
{
    const struct pel_smooth_piece *const p = &k->work.row.piece;
    struct pel_span *const crossed = &k->work.row.crossed;
    crossed->x0 = pel_min(crossed->x0, p->lo >> 16);
    crossed->x1 = pel_max(crossed->x1, (p->hi >> 16) + 1);
    k->height = (uint8_t)(k->height + (p->height >> 8));
}

void pel_smooth_use_piece(struct pel_smooth_short_walk *k, int i, int32_t n)
{
    if (n == 0)
        note_piece(k);
    else
        add_piece(k, i, n);
}

void pel_smooth_follow(struct pel_smooth_short_walk *k, int i, int32_t n)
{
    struct pel_smooth_short_side *const s = &k->work.row.side;
    const int32_t bottom = PEL_PX(k->pixels.y) + 256;
    pel_smooth_copy_side(s, &k->side[i]);
    int32_t end = find_edge(k, i, s), next;
    for (;; end = next) {
        next_piece(k, end);
        pel_smooth_use_piece(k, i, n);
        if (end > bottom)
            return;
        s->from = next_vertex(k, i, s->from);
        next = enter_edge(k, i, s);
        if (end == bottom || next == ENDED)
            return;
    }
}

bool pel_smooth_look_down(struct pel_smooth_short_walk *k)
{
    const int32_t y = k->pixels.y;
    int32_t rows = pel_min(k->pixels.smooth.target->clip.y1 - y, 31);
    bool any = false;
    for (int i = 0; i < 2; i++) {
        const int32_t end = find_edge(k, i, &k->side[i]);
        any = any || (end != ENDED && rows > 0);
        if (end == ENDED || k->work.row.edge->y > PEL_PX(y))
            rows = pel_min(rows, 0);
        rows = pel_min(rows, pel_pixel_of(end - 1) - y);
    }
    k->rows = (unsigned)rows & 31;
    return any;
}

/* Begins at its vertex, and moves on to row k->pixels.y, if that is below; then
 * up by a step. */
static PEL_NOINLINE void start(struct pel_smooth_short_walk *k, int i)
{
    struct pel_smooth_short_side *const s = &k->side[i];
    while (enter_edge(k, i, s) <= PEL_PX(k->pixels.y))
        s->from = next_vertex(k, i, s->from);
    const int32_t above = k->work.row.edge->y, first = (above + 255) >> 8;
    if (above < PEL_PX(k->pixels.y)) {
        go_down(s, PEL_PX(first) - above);
        s->at += (int64_t)pel_times((uint64_t)s->step, k->pixels.y - first);
    }
    s->at -= s->step;
}

void pel_smooth_short_start(struct pel_smooth_short_walk *k)
{
    start(k, 0);
    start(k, 1);
    k->pixels.y--;
    k->rows = 1;
    k->left = k->alike = k->right = 0;
    k->pixels.coverage[0] = 255;
}
