#include "path.h"

#include "../base/divide.h"

void pel_smooth_path_bow(struct pel_smooth_path *path,
                         const struct pel_smooth_path_arc *bow, int32_t radius)
{
    struct pel_smooth_path_arc *const b = &path->bow[path->bows++];
    *b = *bow;
    pel_smooth_circle_set(&b->circle, radius);
    b->most = radius * 256;
    b->most = pel_max(b->most, pel_magnitude(b->from.y));
    b->most = pel_max(b->most, pel_magnitude(b->to.y));
}

void pel_smooth_path_line(struct pel_smooth_path *path,
                          const struct pel_smooth_way *way, int64_t from,
                          int64_t to)
{
    struct pel_smooth_path_side *const l = &path->line[path->lines];
    if (from == to)
        return;
    path->lines++;
    l->way = *way;
    l->left = to < from;
    l->top = l->left ? to : from;
    l->bottom = l->left ? from : to;
    l->first = (int32_t)(l->top >> 16);
    l->last = (int32_t)((l->bottom - 1) >> 16);
    l->row = INT32_MIN;
}

/* Heights far away are as good as those just outside of the circle. */
static int32_t height_of(const struct pel_smooth_path_arc *b, int32_t y)
{
    const int32_t r = b->circle.radius + 1;
    const int32_t v = pel_max(-r, pel_min(y * 256 - b->center.y, r));
    return pel_max(-b->most, pel_min(v * 256, b->most));
}

static void go_to(struct pel_smooth_path_arc *b, int32_t y)
{
    b->v[0] = b->v[1];
    b->at[0] = b->at[1];
    b->v[1] = height_of(b, y);
    if (b->v[0] != b->v[1])
        b->at[1] = pel_smooth_arc_at(&b->circle, b->v[1] >> 8);
}

/* x of a line at a height, 2^-16 px from its base: |v| < 2^33, and a direction
 * has 25 bits. */
static int64_t line_at(const struct pel_smooth_way *w, int64_t y)
{
    int64_t rest;
    const bool up = w->direction.y < 0;
    const int64_t v = y - (int64_t)w->base.y * 256 - w->offset.y;
    const int64_t n = v * (up ? -w->direction.x : w->direction.x);
    return w->offset.x +
           pel_divide_64(n, up ? -w->direction.y : w->direction.y, &rest);
}

/* Where the row begins and ends on the line. */
static int64_t upper_end(const struct pel_smooth_path_side *l, int32_t y)
{
    const int64_t top = (int64_t)y * 65536;
    return l->top > top ? l->top : top;
}

static int64_t lower_end(const struct pel_smooth_path_side *l, int32_t y)
{
    const int64_t bottom = (int64_t)y * 65536 + 65536;
    return l->bottom < bottom ? l->bottom : bottom;
}

static void line_to(struct pel_smooth_path_side *l, int32_t y)
{
    if (y < l->first || y > l->last)
        return;
    l->x[0] = l->row == y - 1 ? l->x[1] : line_at(&l->way, upper_end(l, y));
    l->x[1] = line_at(&l->way, lower_end(l, y));
    l->row = y;
}

void pel_smooth_path_row(struct pel_smooth_path *path, int32_t y)
{
    for (int32_t i = 0; i < path->bows; i++)
        go_to(&path->bow[i], y + 1);
    for (int32_t i = 0; i < path->lines; i++)
        line_to(&path->line[i], y);
}

void pel_smooth_path_start(struct pel_smooth_path *path, int32_t y)
{
    for (int32_t i = 0; i < path->bows; i++) {
        path->bow[i].v[1] = INT32_MAX;
        go_to(&path->bow[i], y);
    }
}

/* A quarter's piece is cut at an end: where it begins, near the axis, or where
 * it ends. */
static void cut_at(struct pel_smooth_strip *s,
                   const struct pel_smooth_path_place *p, bool begins)
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

/* The part of a quarter of a circle that is in the row. */
static bool bow_piece(const struct pel_smooth_path_arc *b, int32_t k,
                      struct pel_smooth_piece_side *side)
{
    struct pel_smooth_strip *const s = &side->strip;
    const int32_t quadrant = (b->first + k) & 3, below = quadrant < 2;
    const int32_t near = below ? b->v[0] : -b->v[1];
    s->near = pel_max(near, 0);
    s->far = below ? b->v[1] : -b->v[0];
    s->at_near = near > 0 ? b->at[!below] : b->circle.radius * 256;
    s->at_far = b->at[below];
    if (k == 0)
        cut_at(s, &b->from, quadrant % 2 == 0);
    if (k == b->count - 1)
        cut_at(s, &b->to, quadrant % 2 == 1);
    s->at_far = pel_min(s->at_far, s->at_near);
    s->circle = &b->circle;
    side->left = quadrant == 1 || quadrant == 2;
    side->rising = side->left != b->hole;
    side->center = side->left ? -b->center.x : b->center.x;
    return s->near < s->far;
}

static bool line_piece(const struct pel_smooth_path_side *l, int32_t y,
                       struct pel_smooth_piece_side *side)
{
    struct pel_smooth_strip *const s = &side->strip;
    const int64_t a = l->left ? -l->x[0] : l->x[0];
    const int64_t b = l->left ? -l->x[1] : l->x[1];
    const int64_t low = a < b ? a : b, high = a < b ? b : a;
    const int32_t far = (int32_t)(low >> 8); /* 1/256 px */
    side->left = l->left;
    side->rising = l->left;
    side->center = (l->left ? -l->way.base.x : l->way.base.x) + far;
    s->circle = NULL;
    s->near = 0;
    s->far = (int32_t)(lower_end(l, y) - upper_end(l, y));
    s->at_far = (int32_t)((low & 255) + 4) >> 3;
    s->at_near = (int32_t)((high - (int64_t)far * 256 + 4) >> 3);
    return true;
}

bool pel_smooth_path_piece(const struct pel_smooth_path *path, int32_t y,
                           int32_t id, struct pel_smooth_piece_side *side)
{
    const int32_t i = id >> 3;
    if (i < path->bows)
        return bow_piece(&path->bow[i], id & 7, side);
    return line_piece(&path->line[id & 7], y, side);
}

int32_t pel_smooth_path_next(const struct pel_smooth_path *path, int32_t y,
                             int32_t id)
{
    int32_t i = ++id >> 3, k = id & 7;
    for (; i < path->bows; i++, k = 0)
        if (k < path->bow[i].count && path->bow[i].v[0] != path->bow[i].v[1])
            return i * 8 + k;
    for (; i == path->bows && k < path->lines; k++)
        if (path->line[k].first <= y && y <= path->line[k].last)
            return i * 8 + k;
    return -1;
}

/* The height of a line at u, 2^-13 px from its centre. */
static uint32_t line_height(const struct pel_smooth_strip *s, int32_t u)
{
    const uint32_t width = (uint32_t)(s->at_near - s->at_far);
    const uint32_t h = (uint32_t)s->far, left = (uint32_t)(s->at_near - u);
    if (u <= s->at_far)
        return h;
    return u < s->at_near ? pel_divide(pel_multiply(h, left), width) : 0;
}

void pel_smooth_line_areas(const struct pel_smooth_strip *s, int32_t center,
                           int32_t x, int32_t n, uint16_t *area)
{
    const uint32_t h = (uint32_t)s->far;
    int32_t u = (x * 256 - center) * 32;
    uint32_t before = line_height(s, u);
    for (; n > 0; n--, area++) {
        const int32_t full = pel_max(u, pel_min(s->at_far, u + 8192));
        const int32_t end = pel_max(full, pel_min(s->at_near, u + 8192));
        const uint32_t after = line_height(s, u + 8192);
        *area = (uint16_t)(((uint32_t)(full - u) * h >> 14) +
                           ((uint32_t)(end - full) * (before + after) >> 15));
        before = after;
        u += 8192;
    }
}
