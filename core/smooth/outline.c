#include "outline.h"

void pel_smooth_bow_set(struct pel_smooth_bow *b, int32_t radius)
{
    pel_smooth_circle_set(&b->circle, radius);
    b->row = INT32_MIN;
}

/* The top of row y, 2^-16 px below a height; those far away are as good as just
 * outside of `most`, 1/256 px. */
static int32_t height_of(int32_t y, int32_t center, int32_t most)
{
    return pel_max(-most, pel_min(y * 256 - center, most)) * 256;
}

/* A place may lie a unit outside of the circle. */
static int32_t bow_height(const struct pel_smooth_bow *b, int32_t y)
{
    const int32_t radius = b->circle.radius;
    return height_of(y, b->center.y, pel_min(radius + 1, 0x7FFFFF));
}

/* The ends of a row, below the centre. */
struct ends {
    int32_t v[2];
};

static struct ends go_to(struct pel_smooth_bow *b, int32_t y)
{
    const struct ends row = {{bow_height(b, y), bow_height(b, y + 1)}};
    if (b->row == y)
        return row;
    b->at[0] = b->row == y - 1 ? b->at[1]
                               : pel_smooth_arc_at(&b->circle, row.v[0] >> 8);
    b->at[1] = pel_smooth_arc_at(&b->circle, row.v[1] >> 8);
    b->row = y;
    return row;
}

/* A quarter's piece is cut at an end: where it begins, near the axis, or where
 * it ends. */
static void cut_at(struct pel_smooth_strip *s, const struct pel_smooth_place *p,
                   bool begins)
{
    const int32_t v = pel_magnitude(p->y), u = pel_magnitude(p->x);
    if (begins && v > s->near) {
        s->near = v;
        s->at_near = u;
    }
    if (!begins && v < s->far) {
        s->far = v;
        s->at_far = u;
    }
}

/* The quadrant of its kth quarter, and whether the row may have a part of it.
 */
static int32_t quadrant_of(const struct pel_smooth_bow *b, int32_t k)
{
    return (b->first + k) & 3;
}

static bool is_crossed(const struct ends *row, int32_t quadrant)
{
    return quadrant < 2 ? row->v[1] > 0 : row->v[0] < 0;
}

/* The part of its kth quarter in the row; false: none. */
static bool strip_of(const struct pel_smooth_bow *b, const struct ends *row,
                     int32_t k, struct pel_smooth_strip *s)
{
    const int32_t quadrant = quadrant_of(b, k), below = quadrant < 2;
    const int32_t near = below ? row->v[0] : -row->v[1];
    const int32_t most = b->circle.radius * 256;
    s->near = pel_max(near, 0);
    s->far = pel_min(below ? row->v[1] : -row->v[0], most);
    s->at_near = near > 0 ? b->at[!below] : most;
    s->at_far = b->at[below];
    if (k == 0)
        cut_at(s, &b->from, quadrant % 2 == 0);
    if (k == b->count - 1)
        cut_at(s, &b->to, quadrant % 2 == 1);
    s->at_far = pel_min(s->at_far, s->at_near);
    s->circle = &b->circle;
    return s->near < s->far;
}

void pel_smooth_bow_add(struct pel_smooth_bow *b, struct pel_smooth_window *w)
{
    const struct ends row = go_to(b, w->y);
    if (row.v[0] == row.v[1])
        return;
    for (int32_t k = 0; k < b->count; k++) {
        struct pel_smooth_strip s;
        const int32_t quadrant = quadrant_of(b, k);
        const bool left = quadrant == 1 || quadrant == 2;
        if (is_crossed(&row, quadrant) && strip_of(b, &row, k, &s))
            pel_smooth_window_strip(w, &s, left ? -b->center.x : b->center.x,
                                    left, left != b->hole);
    }
}

void pel_smooth_line_set(struct pel_smooth_line *l, struct pel_point base,
                         struct pel_point direction,
                         struct pel_smooth_place from,
                         struct pel_smooth_place to)
{
    const struct pel_point zero = {0, 0};
    const struct pel_point down = {direction.y < 0 ? -direction.x : direction.x,
                                   pel_magnitude(direction.y)};
    l->base = base;
    l->left = to.y < from.y;
    l->top = l->left ? to : from;
    l->bottom = l->left ? from : to;
    l->step = pel_smooth_slope(&zero, &down, &l->rise);
}

/* x at a height in the line: the product is below 2^63, since the line's ends
 * are less than 2^31 apart. */
static int32_t line_at(const struct pel_smooth_line *l, int32_t v)
{
    if (v == l->bottom.y)
        return l->bottom.x;
    const uint64_t way =
        pel_times((uint64_t)pel_size_of(l->step), v - l->top.y) >> 32;
    return l->top.x + (l->step < 0 ? -(int32_t)way : (int32_t)way);
}

/* Cuts two heights below a base to the window's row; false: none of it is left.
 */
static bool cut_to_row(const struct pel_smooth_window *w, int32_t base,
                       int32_t *top, int32_t *bottom)
{
    *top = pel_max(*top, height_of(w->y, base, 0x7FFFFF));
    *bottom = pel_min(*bottom, height_of(w->y + 1, base, 0x7FFFFF));
    return *top < *bottom;
}

void pel_smooth_line_add(const struct pel_smooth_line *l,
                         struct pel_smooth_window *w)
{
    int32_t top = l->top.y, bottom = l->bottom.y;
    if (!cut_to_row(w, l->base.y, &top, &bottom))
        return;
    struct pel_smooth_line_piece piece = {0, 0, 0, bottom - top, l->rise};
    pel_smooth_line_piece_set(&piece, l->base.x, line_at(l, top),
                              line_at(l, bottom));
    pel_smooth_window_line(w, &piece, l->left);
}

void pel_smooth_gap_add(const struct pel_smooth_gap *g,
                        struct pel_smooth_window *w)
{
    int32_t top = pel_min(g->from, g->to), bottom = pel_max(g->from, g->to);
    if (!cut_to_row(w, g->base.y, &top, &bottom))
        return;
    struct pel_smooth_line_piece piece = {0, 0, 0, bottom - top, {0, true}};
    pel_smooth_line_piece_set(&piece, g->base.x, g->x, g->x);
    pel_smooth_window_line(w, &piece, g->to < g->from);
}
