#include "outline.h"

#if !PEL_SMOOTH_TINY
#include "line_side.h"
#include "outline_row.h"

/* From where on rows have mirror images that can be seen, too. */
static void set_mirror(struct pel_smooth_outline *o)
{
    const int32_t sum = 2 * o->curve->center.y + o->curve->spread.y;
    o->mirror_y = (sum >> 8) - 1;
    o->mirror_from = pel_max(o->mirror_from,
                             pel_max(o->seen.y0, o->mirror_y - o->seen.y1 + 1));
    if (sum & 255 || o->mirror_from > o->mirror_y >> 1)
        o->mirror_from = INT32_MAX;
}

bool pel_smooth_outline_begin(struct pel_smooth_outline *o,
                              const struct pel_rect *box)
{
    const struct pel_rect *const clip = &o->smooth.target->clip;
    o->seen = pel_rect_intersect(box, clip);
    o->row = INT32_MAX;
    o->inside = box->x0 >= clip->x0 && box->x1 <= clip->x1;
    o->mirrored = false;
    o->alike = INT32_MIN;
    set_mirror(o);
    return !pel_rect_empty(&o->seen) &&
           pel_smooth_begin(&o->smooth, o->smooth.target, o->smooth.paint);
}

/* On to row y; -1 where a curve is not there. */
static void go_to(struct pel_smooth_outline *o, int32_t y)
{
    struct pel_smooth_curve *const end = o->curve + o->curves;
    for (struct pel_smooth_curve *c = o->curve; c < end; c++) {
        c->at[0] = o->row == y - 1 ? c->at[1] : -1;
        c->at[1] = -1;
        if (!pel_smooth_curve_in(c, y))
            continue;
        if (c->at[0] < 0)
            c->at[0] = pel_smooth_curve_at(c, y);
        c->at[1] = pel_smooth_curve_at(c, y + 1);
    }
    o->row = y;
}

static inline bool find_quarter(const struct pel_smooth_outline *o, int32_t i,
                                int32_t k, struct pel_smooth_crossing *c)
{
    const struct pel_smooth_curve *const curve = &o->curve[i];
    const bool upright = (curve->circle.first + k) & 1;
    if (!pel_smooth_find_quarter(curve, o->row, k, c))
        return false;
    pel_smooth_place_quarter(c, curve->at);
    return !o->sides || !o->sides->cut ||
           o->sides->cut(o, i, k, upright, &c->strip);
}

struct finder {
    struct pel_smooth_crossing crossing;
    struct pel_smooth_crossing *to;
    int32_t first, most, n;
};

static void add(struct finder *f)
{
    const int32_t i = f->n++ - f->first;
    if (i >= 0 && i < f->most)
        f->to[i] = f->crossing;
}

/* All sides of row y. */
static void find_all(struct pel_smooth_outline *o, int32_t y, struct finder *f)
{
    struct pel_smooth_crossing *const c = &f->crossing;
    if (o->row != y)
        go_to(o, y);
    for (int32_t i = 0; i < o->curves; i++)
        if (pel_smooth_curve_in(&o->curve[i], y))
            for (int32_t k = o->curve[i].circle.count - 1; k >= 0; k--)
                if (find_quarter(o, i, k, c))
                    add(f);
    for (int32_t i = 0; i < o->count; i++) {
        c->other = (int8_t)i;
        if (o->sides->other(o, y, i, c))
            add(f);
    }
}

int32_t pel_smooth_find_crossings(struct pel_smooth_outline *o, int32_t y,
                                  int32_t first, int32_t most,
                                  struct pel_smooth_crossing *to)
{
    struct finder f;
    f.to = to;
    f.first = first;
    f.most = most;
    f.n = 0;
    find_all(o, y, &f);
    return f.n;
}

/* Makes *end the height, if that is above it, but not above row y. */
static void note(int32_t height, int32_t y, int32_t *end)
{
    if (height >= y * 256)
        *end = pel_min(*end, height);
}

/* Sides of a circle begin and end where it passes an axis; other ones, less
 * than 4 sub-pixels from the ends of curves. */
static void note_curve(const struct pel_smooth_outline *o, int32_t i, int32_t y,
                       int32_t *end)
{
    const struct pel_smooth_curve *const curve = &o->curve[i];
    const struct pel_smooth_circle *const c = &curve->circle;
    const int32_t top = curve->center.y, bottom = top + curve->spread.y;
    for (int32_t k = c->first; k < c->first + c->count - 1; k++) {
        const bool level = k & 1, upper = k & 2;
        note(level   ? top
             : upper ? top - c->radius
                     : bottom + c->radius,
             y, end);
        if (level)
            note(bottom, y, end);
    }
    if (!o->sides || !o->sides->cut)
        return;
    const struct pel_smooth_ends *const ends = pel_smooth_ends_of(o, i);
    for (int32_t k = -4; k <= 4; k += 8) {
        note(top + (ends->from.y >> 8) + k, y, end);
        note(top + (ends->to.y >> 8) + k, y, end);
    }
}

/* Halves of wide lines begin and end anywhere: they are found in each row. */
int32_t pel_smooth_find_end(const struct pel_smooth_outline *o, int32_t y)
{
    int32_t end = INT32_MAX;
    if (o->sides && o->sides->cut &&
        ((const struct pel_smooth_lines *)(const void *)o)->wide)
        return y * 256;
    for (int32_t i = 0; i < o->curves; i++)
        note_curve(o, i, y, &end);
    return end;
}
#endif

bool pel_smooth_upright(struct pel_smooth_crossing *c, int32_t y, int64_t from,
                        int64_t to)
{
    const int64_t top = (int64_t)y * 65536;
    from = from > top ? from - top : 0;
    to = to - top < 65536 ? to - top : 65536;
    c->strip.circle = NULL;
    c->strip.near = 0;
    c->strip.far = (int32_t)(to - from);
    return from < to;
}
