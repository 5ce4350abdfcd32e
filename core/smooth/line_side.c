#include "line_side.h"

#include "smooth_edge.h"

/* The first row whose top a line down crosses, or begins at; and x there, px
 * 2^-32. */
static inline int32_t first_row(const struct pel_smooth_far_place *end)
{
    return (int32_t)((end->y + 65535) >> 16);
}

static inline int64_t first_at(const struct pel_smooth_far_place *end,
                               int64_t step)
{
    const uint64_t size = (uint64_t)pel_size_of(step);
    const int64_t way =
        (int64_t)(pel_times(size, (int32_t)(-end->y & 65535)) >> 16);
    return end->x * 65536 + (step < 0 ? -way : way);
}

#if PEL_SMOOTH_TINY
int64_t pel_smooth_line_at(const struct pel_smooth_far_place end[2],
                           const int64_t *step, int32_t y, bool bottom)
{
    y += bottom;
    if (bottom ? end[1].y <= (int64_t)y * 65536 : end->y >= (int64_t)y * 65536)
        return end[bottom].x;
    return (first_at(end, *step) +
            (int64_t)pel_times((uint64_t)*step, y - first_row(end))) >>
           16;
}
#else
bool pel_smooth_cut(const struct pel_smooth_outline *o, int32_t i, int32_t k,
                    bool upright, struct pel_smooth_strip *s)
{
    const struct pel_smooth_ends *const e = pel_smooth_ends_of(o, i);
    if (k == 0)
        pel_smooth_cut_at(s, &e->from, !upright);
    if (k == o->curve[i].circle.count - 1)
        pel_smooth_cut_at(s, &e->to, upright);
    return pel_smooth_is_left(s);
}

static void set_place(struct pel_smooth_far_place *far,
                      const struct pel_smooth_outline *o, int32_t k, bool last)
{
    const struct pel_smooth_curve *const curve = &o->curve[k];
    const struct pel_smooth_ends *const ends = pel_smooth_ends_of(o, k);
    const struct pel_smooth_place *const p =
        last == curve->circle.hole ? &ends->from : &ends->to;
    far->x = (int64_t)curve->center.x * 256 + p->x;
    far->y = (int64_t)curve->center.y * 256 + p->y;
}

void pel_smooth_joint(const struct pel_smooth_outline *o, int32_t k,
                      bool flipped, struct pel_smooth_far_place place[2])
{
    set_place(&place[flipped], o, k, true);
    set_place(&place[!flipped], o, k + 1 == o->curves ? 0 : k + 1, false);
}

/* x at the top of a row that the line crosses. */
static int64_t line_at(struct pel_smooth_line *l, int32_t y)
{
    l->at += (int64_t)pel_times((uint64_t)l->step, y - l->row);
    l->row = y;
    return l->at >> 16;
}

/* A line, or the upper or lower half of one that may be too wide. */
static PEL_NOINLINE bool find_part(struct pel_smooth_outline *outline,
                                   int32_t y, int32_t i,
                                   struct pel_smooth_crossing *c)
{
    const struct pel_smooth_lines *const lines = (const void *)outline;
    struct pel_smooth_line *const l = &lines->line[lines->wide ? i >> 1 : i];
    const int64_t row = (int64_t)y * 65536;
    struct pel_smooth_far_place end[2];
    pel_smooth_joint(&lines->outline, l->curve, l->rising, end);
    if (lines->wide) {
        const int64_t x = end[0].x + end[1].x, middle = end[0].y + end[1].y;
        end[~i & 1].x = x >> 1;
        end[~i & 1].y = middle >> 1;
    }
    if (!pel_smooth_upright(c, y, end[0].y, end[1].y))
        return false;
    const int64_t a = end[0].y < row ? line_at(l, y) : end[0].x;
    const int64_t b = end[1].y > row + 65536 ? line_at(l, y + 1) : end[1].x;
    c->strip.slope = l->slope;
    c->rising = l->rising;
    pel_smooth_line_cross(c, a < b ? a : b, (int32_t)(b - a));
    return true;
}

/* Moves a line on by a whole row. */
static inline void cross_row(struct pel_smooth_line *l,
                             struct pel_smooth_crossing *c)
{
    const int64_t at = l->at, next = at + l->step;
    l->at = next;
    l->row++;
    pel_smooth_line_cross(
        c, (l->step < 0 ? next : at) >> 16,
        (int32_t)((uint32_t)(next >> 16) - (uint32_t)(at >> 16)));
}

static void go_down(struct pel_smooth_outline *outline, int32_t i,
                    struct pel_smooth_crossing *c)
{
    const struct pel_smooth_lines *const lines = (const void *)outline;
    cross_row(&lines->line[i], c);
}

/* The same, or stays where it has been moved to. False: it begins or ends
 * there, or has not been in the row above. */
static bool move_line(struct pel_smooth_line *l, int32_t y,
                      struct pel_smooth_crossing *c)
{
    if (y + 1 == l->row) {
        l->at -= l->step;
        l->row = y;
    }
    if (y != l->row || y < l->first || y >= l->end)
        return false;
    c->strip.circle = NULL;
    c->strip.slope = l->slope;
    c->strip.near = 0;
    c->strip.far = 65536;
    c->rising = l->rising;
    cross_row(l, c);
    return true;
}

static bool find_line(struct pel_smooth_outline *outline, int32_t y, int32_t i,
                      struct pel_smooth_crossing *c)
{
    const struct pel_smooth_lines *const lines = (const void *)outline;
    return move_line(&lines->line[i], y, c) || find_part(outline, y, i, c);
}

static const struct pel_smooth_sides line_sides = {pel_smooth_cut, find_line,
                                                   go_down};
static const struct pel_smooth_sides wide_sides = {pel_smooth_cut, find_part,
                                                   NULL};

/* From one place down to another, in a direction, or that of the line before.
 */
static void set_line(struct pel_smooth_line *l, const struct pel_point *d,
                     const struct pel_smooth_far_place end[2])
{
    const struct pel_point zero = {0, 0};
    struct pel_rise rise;
    if (d) {
        const struct pel_point down = {d->y < 0 ? -d->x : d->x,
                                       pel_magnitude(d->y)};
        l->step = pel_smooth_slope(&zero, &down, &rise);
        pel_smooth_slope_set(&l->slope, (uint64_t)pel_size_of(l->step));
    } else {
        l->step = l[-1].step;
        l->slope = l[-1].slope;
    }
    l->first = l->row = first_row(end);
    l->end = (int32_t)((end[1].y - 1) >> 16);
    l->at = first_at(end, l->step);
}

void pel_smooth_lines_begin(struct pel_smooth_lines *lines,
                            struct pel_smooth_curve *curve,
                            struct pel_smooth_ends *ends,
                            struct pel_smooth_line *line, bool wide)
{
    struct pel_smooth_outline *const o = &lines->outline;
    lines->line = line;
    lines->wide = wide;
    o->curve = curve;
    o->curves = 2;
    lines->ends = ends;
    o->sides = wide ? &wide_sides : &line_sides;
    o->count = 0;
    o->mirror_from = INT32_MAX;
}

void pel_smooth_lines_add(struct pel_smooth_lines *lines,
                          const struct pel_point *d, int32_t k)
{
    struct pel_smooth_outline *const o = &lines->outline;
    struct pel_smooth_line *const l =
        &lines->line[lines->wide ? o->count / 2 : o->count];
    struct pel_smooth_far_place end[2];
    pel_smooth_joint(o, k, false, end);
    l->curve = (uint8_t)k;
    l->rising = end[1].y < end[0].y;
    if (l->rising)
        pel_smooth_joint(o, k, true, end);
    if (end[0].y == end[1].y)
        return;
    set_line(l, d, end);
    o->count = (uint8_t)(o->count + (lines->wide ? 2 : 1));
}
#endif
