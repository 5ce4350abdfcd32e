#include "path.h"

#include "../base/divide.h"

void pel_smooth_path_bow(struct pel_smooth_path *path,
                         const struct pel_smooth_bow *bow, int32_t radius)
{
    struct pel_smooth_bow *const b = &path->bow[path->bows++];
    *b = *bow;
    pel_smooth_circle_set(&b->circle, radius);
    b->most = radius * 256;
    b->most = pel_max(b->most, pel_magnitude(b->from.y));
    b->most = pel_max(b->most, pel_magnitude(b->to.y));
}

void pel_smooth_path_line(struct pel_smooth_path *path, struct pel_point base,
                          struct pel_point direction, int64_t from, int64_t to)
{
    struct pel_smooth_line *const l = &path->line[path->lines];
    if (from == to)
        return;
    path->lines++;
    l->base = base;
    l->direction = direction;
    l->left = to < from;
    l->top = l->left ? to : from;
    l->bottom = l->left ? from : to;
}

/* Heights far away are as good as those just outside of the circle. */
static int32_t height_of(const struct pel_smooth_bow *b, int32_t y)
{
    const int32_t r = b->circle.radius + 1;
    const int32_t v = pel_max(-r, pel_min(y * 256 - b->center.y, r));
    return pel_max(-b->most, pel_min(v * 256, b->most));
}

void pel_smooth_path_row(struct pel_smooth_path *path, int32_t y)
{
    for (int32_t i = 0; i < path->bows; i++) {
        struct pel_smooth_bow *const b = &path->bow[i];
        for (int32_t k = 0; k < 2; k++) {
            b->v[k] = height_of(b, y + k);
            b->at[k] = pel_smooth_arc_at(&b->circle, b->v[k] >> 8);
        }
    }
}

int32_t pel_smooth_path_pieces(const struct pel_smooth_path *path)
{
    int32_t pieces = path->lines;
    for (int32_t i = 0; i < path->bows; i++)
        pieces += path->bow[i].count;
    return pieces;
}

/* Sets where a quarter's piece begins, near the axis, and where it ends. */
static void set_ends(const struct pel_smooth_bow *b, int32_t k,
                     struct pel_smooth_strip *s)
{
    const bool outwards = (b->first + k) % 2 == 0;
    const bool begins = k == 0, ends = k == b->count - 1;
    const struct pel_smooth_place axis = {b->circle.radius * 256, 0};
    const struct pel_smooth_place pole = {0, b->most};
    struct pel_smooth_place from = outwards ? axis : pole;
    struct pel_smooth_place to = outwards ? pole : axis;
    from = begins ? b->from : from;
    to = ends ? b->to : to;
    s->near = pel_magnitude(outwards ? from.y : to.y);
    s->far = pel_magnitude(outwards ? to.y : from.y);
    s->at_near = pel_magnitude(outwards ? from.x : to.x);
    s->at_far = pel_magnitude(outwards ? to.x : from.x);
}

/* Cuts it to the row. */
static void cut_to_row(const struct pel_smooth_bow *b, bool below,
                       struct pel_smooth_strip *s)
{
    const int32_t near = below ? b->v[0] : -b->v[1];
    const int32_t far = below ? b->v[1] : -b->v[0];
    if (s->near < near) {
        s->near = near;
        s->at_near = b->at[below ? 0 : 1];
    }
    if (s->far > far) {
        s->far = far;
        s->at_far = b->at[below ? 1 : 0];
    }
    s->at_far = pel_min(s->at_far, s->at_near);
}

/* The part of a quarter of a circle that is in the row. */
static bool bow_piece(const struct pel_smooth_bow *b, int32_t k,
                      struct pel_smooth_piece_side *side)
{
    struct pel_smooth_strip *const s = &side->strip;
    const int32_t quadrant = (b->first + k) & 3;
    set_ends(b, k, s);
    cut_to_row(b, quadrant < 2, s);
    if (s->near >= s->far)
        return false;
    s->circle = &b->circle;
    pel_smooth_strip_set(s);
    side->left = quadrant == 1 || quadrant == 2;
    side->rising = side->left != b->hole;
    side->center = side->left ? -b->center.x : b->center.x;
    return true;
}

/* x of a line at a height, 2^-16 px from its base. */
static int64_t line_at(const struct pel_smooth_line *l, int64_t y)
{
    int64_t rest;
    const bool up = l->direction.y < 0;
    const int64_t v = y - (int64_t)l->base.y * 256;
    const int64_t n = v * (up ? -l->direction.x : l->direction.x);
    return pel_divide_64(n, up ? -l->direction.y : l->direction.y, &rest);
}

static bool line_piece(const struct pel_smooth_line *l, int32_t y,
                       struct pel_smooth_piece_side *side)
{
    struct pel_smooth_strip *const s = &side->strip;
    int64_t top = (int64_t)y * 65536, bottom = top + 65536;
    top = l->top > top ? l->top : top;
    bottom = l->bottom < bottom ? l->bottom : bottom;
    if (top >= bottom)
        return false;
    int64_t a = line_at(l, top), b = line_at(l, bottom);
    side->left = l->left;
    side->rising = l->left;
    side->center = l->left ? -l->base.x : l->base.x;
    if (l->left) {
        a = -a;
        b = -b;
    }
    const int64_t low = a < b ? a : b, high = a < b ? b : a;
    const int32_t far = (int32_t)(low >> 8); /* 1/256 px */
    side->center += far;
    s->circle = NULL;
    s->near = 0;
    s->far = (int32_t)(bottom - top);
    s->at_far = (int32_t)(low - (int64_t)far * 256);
    s->at_near = (int32_t)(high - (int64_t)far * 256);
    s->bulge = 0;
    s->small = s->steep = false;
    return true;
}

bool pel_smooth_path_piece(const struct pel_smooth_path *path, int32_t y,
                           int32_t id, struct pel_smooth_piece_side *side)
{
    for (int32_t i = 0; i < path->bows; i++) {
        if (id < path->bow[i].count)
            return bow_piece(&path->bow[i], id, side);
        id -= path->bow[i].count;
    }
    return line_piece(&path->line[id], y, side);
}

/* The height of a line at u, 2^-16 px from its upper end, over `width`. */
static uint32_t line_height(const struct pel_smooth_strip *s, int32_t u)
{
    const uint32_t width = (uint32_t)(s->at_near - s->at_far);
    const uint32_t h = (uint32_t)s->far, left = (uint32_t)(s->at_near - u);
    return left >= width ? h : pel_divide(pel_multiply(h, left), width);
}

void pel_smooth_line_areas(const struct pel_smooth_strip *s, int32_t center,
                           int32_t x, int32_t n, uint16_t *area)
{
    const uint32_t h = (uint32_t)s->far;
    int32_t u = (x * 256 - center) * 256;
    for (; n > 0; n--, u += 65536, area++) {
        const int32_t full = pel_max(u, pel_min(s->at_far, u + 65536));
        const int32_t end = pel_max(full, pel_min(s->at_near, u + 65536));
        uint32_t sum = ((uint32_t)(full - u) >> 1) * h >> 16;
        if (end > full)
            sum += ((uint32_t)(end - full) >> 1) *
                       ((line_height(s, full) + line_height(s, end)) >> 1) >>
                   16;
        *area = (uint16_t)sum;
    }
}
