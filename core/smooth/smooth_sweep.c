#include "smooth_sweep.h"

#include "../base/divide.h"

/* Numbers of x, in 2^-16 px, that are so close lie within the error. */
enum { SAME = 4 };

/* y in 256ths of row y0. */
static uint16_t in_row(int32_t y, int32_t y0)
{
    return (uint16_t)pel_max(0, pel_min(y - PEL_PX(y0), 256));
}

/* Where it begins in the row, and ends, in 2^-16. */
static inline int32_t begin_of(const struct pel_smooth_edge *e)
{
    return e->begin * 256;
}

static inline int32_t end_of(const struct pel_smooth_edge *e)
{
    return e->end * 256;
}

/* step t; the product is below 2^57, of 2^15 px a row or less two of 32 bits.
 */
static uint64_t way_of(int64_t step, int32_t t)
{
    if (t == 0)
        return 0;
    if (t == PEL_SMOOTH_ROW)
        return (uint64_t)step << 16;
    if ((step + INT64_C(0x80000000)) >> 32)
        return pel_times((uint64_t)step, t);
    const int32_t high = (int32_t)step >> 16;
    return ((uint64_t)(int64_t)(high * t) << 16) +
           ((uint32_t)step & 0xFFFF) * (uint32_t)t;
}

/* px 2^-16 at t. A unit beyond the ends of the range is cut off. */
static int32_t x_at(const struct pel_smooth_edge *e, int32_t t)
{
    const uint64_t way = way_of(e->step >> 16, t);
    const int64_t x = (e->at + (int64_t)way) >> 16;
    return x == (int32_t)x ? (int32_t)x : x < 0 ? INT32_MIN : INT32_MAX;
}

/* By x at the top of a part, where those that lie SAME px apart or less count
 * as equal, or at its bottom. */
static bool is_before(const struct pel_smooth_edge *a,
                      const struct pel_smooth_edge *b)
{
    if (pel_magnitude((a->x0 >> 1) - (b->x0 >> 1)) > SAME / 2)
        return a->x0 < b->x0;
    return a->x1 < b->x1;
}

/* Where the next edge begins or ends. */
static int32_t next_end(const struct pel_smooth_sweep *w, int32_t t)
{
    int32_t end = PEL_SMOOTH_ROW;
    for (int32_t i = 0; i < w->active; i++) {
        const struct pel_smooth_edge *const e = &w->edge[w->order[i]];
        const int32_t begin = begin_of(e), cut = begin > t ? begin : end_of(e);
        if (cut > t && cut < end)
            end = cut;
    }
    return end;
}

/* Sorts those that cross the part from t to `end` by x: how many. Behind them
 * are those that begin below it, behind w->active those that ended above. Where
 * one begins in the row and ends is known. */
static int32_t sort_part(struct pel_smooth_sweep *w, int32_t t, int32_t end)
{
    struct pel_smooth_edge *const edge = w->edge;
    int32_t *const order = w->order;
    int32_t live = 0, left = w->active;
    for (int32_t i = 0; i < left;) {
        const int32_t at = order[i];
        struct pel_smooth_edge *const e = &edge[at];
        if (end_of(e) <= t) {
            order[i] = order[--left];
            order[left] = at;
            continue;
        }
        if (begin_of(e) <= t) {
            int32_t k = live++;
            if (begin_of(e) < t)
                e->x0 = e->x1; /* where the part above ended */
            if (begin_of(e) < t || end_of(e) > end)
                e->x1 = x_at(e, end);
            order[i] = order[k];
            for (; k > 0 && is_before(e, &edge[order[k - 1]]); k--)
                order[k] = order[k - 1];
            order[k] = at;
        }
        i++;
    }
    w->active = left;
    return live;
}

/* The first place from t on where two neighbours cross, or `end`. */
static int32_t first_crossing(const struct pel_smooth_sweep *w, int32_t live,
                              int32_t t, int32_t end)
{
    int32_t first = end;
    for (int32_t i = 1; i < live; i++) {
        const struct pel_smooth_edge *const a = &w->edge[w->order[i - 1]];
        const struct pel_smooth_edge *const b = &w->edge[w->order[i]];
        if (a->x1 < b->x1 || (uint32_t)a->x1 - (uint32_t)b->x1 <= SAME)
            continue;
        const uint32_t before = ((uint32_t)b->x0 - (uint32_t)a->x0) >> 1;
        const uint32_t after = ((uint32_t)a->x1 - (uint32_t)b->x1) >> 1;
        const uint64_t n = pel_multiply(before, (uint32_t)(end - t));
        first = pel_min(first, t + (int32_t)pel_divide(n, before + after));
    }
    return pel_max(first, t + 1);
}

/* floor(v h / 512); v <= 2^17, h <= 2^16: one bit more than 32. */
static inline uint32_t product_of(uint32_t v, uint32_t h)
{
    if (h == PEL_SMOOTH_ROW)
        return v << 7;
    return ((v >> 1) * h + ((v & 1) * h >> 1)) >> 8;
}

/* The area right of a piece of an edge, in pixel x; h in 2^-16. */
static uint32_t area_at(const struct pel_smooth_edge *e, int32_t x, uint32_t h)
{
    const int32_t lo = pel_min(e->x0, e->x1), hi = pel_max(e->x0, e->x1);
    const int32_t a = lo >> 16, b = hi >> 16;
    const uint32_t low = (uint32_t)lo & 0xFFFF, high = (uint32_t)hi & 0xFFFF;
    if (a == b)
        return product_of(131072 - low - high, h) * 255;
    if (x == a)
        return pel_smooth_corner(&e->rise, 65536 - low);
    if (x == b)
        return h * (255 << 8) - pel_smooth_corner(&e->rise, high);
    return pel_smooth_between(&e->rise, 65536 - low) +
           (uint32_t)(x - a - 1) * e->rise.value;
}

static void add_piece(struct pel_smooth_sweep *w,
                      const struct pel_smooth_edge *e, uint32_t h, int32_t sign)
{
    const struct pel_rect *const clip = &w->smooth.target->clip;
    const int32_t a = pel_min(e->x0, e->x1) >> 16;
    const int32_t b = pel_max(e->x0, e->x1) >> 16;
    const int32_t from = pel_max(a, clip->x0), end = pel_min(b + 1, clip->x1);
    int32_t *sum = w->sum + (from - clip->x0), before = 0, here;
    if (from >= clip->x1)
        return;
    w->lo = pel_min(w->lo, from);
    for (int32_t x = from; x < end; x++) {
        here = (int32_t)(area_at(e, x, h) >> 2);
        *sum++ += sign * (here - before);
        before = here;
    }
    *sum += sign * ((int32_t)(h * (255 << 8) >> 2) - before);
    w->end = pel_max(w->end, pel_max(from, end) + 1);
}

/* Edges of a row, those in w->order, whose x no other one reaches. */
struct group {
    int32_t from;  /* only edges from there on, px 2^-16, are still to add */
    int32_t base;  /* the winding number left of it .. */
    int32_t right; /* .. and right of it, or of the last border */
    bool level;    /* that is the same all the way down */
};

/* Adds an edge over a height, if it is a border: the next one from the left. */
static PEL_NOINLINE_32 void add_border(struct pel_smooth_sweep *w,
                                       struct group *g,
                                       const struct pel_smooth_edge *e,
                                       int32_t h)
{
    const bool outside = (g->right & w->mask) == 0;
    g->right += e->winding;
    if (outside != ((g->right & w->mask) == 0) && e->x0 >= g->from)
        add_piece(w, e, (uint32_t)h, outside ? 1 : -1);
}

/* Adds what is inside from t on, down to the next cut: where that is. */
static PEL_NOINLINE_32 int32_t add_part(struct pel_smooth_sweep *w,
                                        struct group *g, int32_t t)
{
    const int32_t bottom = next_end(w, t);
    const int32_t live = sort_part(w, t, bottom);
    const int32_t crossing = first_crossing(w, live, t, bottom);
    const int32_t end = pel_min(crossing, bottom), right = g->right;
    g->right = g->base;
    for (int32_t i = 0; i < live; i++) {
        struct pel_smooth_edge *const e = &w->edge[w->order[i]];
        if (crossing < bottom)
            e->x1 = x_at(e, crossing);
        add_border(w, g, e, end - t);
    }
    g->level = g->level && (t == 0 || g->right == right);
    return end;
}

/* Cuts the row at what begins, ends or crosses another one in the group. */
static PEL_NOINLINE_32 void add_group(struct pel_smooth_sweep *w,
                                      struct group *g, int32_t begin,
                                      int32_t end)
{
    int32_t *const order = w->order;
    const int32_t active = w->active;
    w->order = order + begin;
    w->active = end - begin;
    g->level = true;
    for (int32_t t = 0; t < PEL_SMOOTH_ROW;)
        t = add_part(w, g, t);
    w->order = order;
    w->active = active;
}

/* Sets what part of a row an edge crosses, and x where it begins and ends. */
static inline void set_ends(struct pel_smooth_edge *e, int32_t y)
{
    e->begin = in_row(e->top, y);
    e->end = in_row(e->bottom, y);
    e->x0 = x_at(e, begin_of(e));
    e->x1 = x_at(e, end_of(e));
}

static inline int32_t left_of(const struct pel_smooth_edge *e)
{
    return pel_min(e->x0, e->x1);
}

/* Sorts the edges of a row by where they are leftmost. Nothing depends on how
 * they were ordered. */
static PEL_NOINLINE_32 void sort_row(struct pel_smooth_sweep *w)
{
    for (int32_t i = 0; i < w->active; i++) {
        const int32_t at = w->order[i];
        struct pel_smooth_edge *const e = &w->edge[at];
        int32_t k = i;
        set_ends(e, w->row.y);
        const int32_t left = left_of(e);
        for (; k > 0; k--) {
            const int32_t before = w->order[k - 1];
            const int32_t x = left_of(&w->edge[before]);
            if (x < left || (x == left && before < at))
                break;
            w->order[k] = before;
        }
        w->order[k] = at;
    }
}

/* Where the group ends that begins with edge i. */
static int32_t group_end(const struct pel_smooth_sweep *w, int32_t i)
{
    int32_t right = INT32_MIN;
    do {
        const struct pel_smooth_edge *const e = &w->edge[w->order[i]];
        right = pel_max(right, pel_max(e->x0, e->x1));
    } while (++i < w->active &&
             (left_of(&w->edge[w->order[i]]) >> 1) - (right >> 1) <= SAME);
    return i;
}

/* Does it go down the whole row? */
static bool is_whole(const struct pel_smooth_edge *e)
{
    return e->begin == 0 && e->end == 256;
}

/* A group is cut on its own, unless a level line joins it to the one on its
 * left: then the winding number between both changes in the row. */
void pel_smooth_add_row(struct pel_smooth_sweep *w)
{
    struct group g = {0, 0, 0, true};
    int32_t begin = 0, end;
    sort_row(w);
    for (int32_t i = 0; i < w->active; i = end) {
        const struct pel_smooth_edge *const e = &w->edge[w->order[i]];
        end = group_end(w, i);
        g.from = left_of(e);
        if (begin + 1 == end && is_whole(e))
            add_border(w, &g, e, PEL_SMOOTH_ROW);
        else
            add_group(w, &g, begin, end);
        if (g.level) {
            begin = end;
            g.base = g.right;
        }
        for (int32_t k = begin; k < end; k++)
            set_ends(&w->edge[w->order[k]], w->row.y);
    }
}
