/* The order of sides that cross some rows from top to bottom. */
#include "short_outline.h"

#if PEL_SMOOTH_TINY && !PEL_SMALL_CODE
enum { BITS = 4, SIDES = 4 };

/* Notes the first height below the top of the row. */
static void note(int32_t height, int32_t y, int32_t *end)
{
    if (height > y * 256)
        *end = pel_min(*end, height);
}

/* Where a curve begins or ends, and less than 4 sub-pixels from there: a strip
 * of its kth quarter is cut at that distance from its centre. */
static void note_cut(struct pel_smooth_short_outline *t,
                     const struct pel_smooth_kind *kind, int32_t i, int32_t k,
                     int32_t *end)
{
    const struct pel_smooth_curve *const c = &t->of.window.curve;
    struct pel_smooth_strip *const s = &t->of.window.crossing.strip;
    s->near = 0;
    s->far = INT32_MAX;
    kind->cut(t, i, k);
    for (int32_t n = 0; n < 2; n++) {
        const int32_t away = (n ? s->far : s->near) >> 8;
        const int32_t height =
            c->center.y + ((c->circle.first + k) & 2 ? -away : away);
        note(height - 5, t->seen.y, end);
        note(height + 5, t->seen.y, end);
    }
}

/* Where it passes an axis, and where it ends. */
static void note_curve(struct pel_smooth_short_outline *t,
                       const struct pel_smooth_kind *kind, int32_t i,
                       int32_t *end)
{
    const struct pel_smooth_curve *const c = &t->of.window.curve;
    const int32_t y = t->seen.y;
    kind->curve(t, i, true, &t->of.window.curve);
    const int32_t top = c->center.y, bottom = top + c->spread.y;
    note(top - c->circle.radius, y, end);
    note(top, y, end);
    note(bottom, y, end);
    note(bottom + c->circle.radius, y, end);
    if (!kind->cut)
        return;
    note_cut(t, kind, i, 0, end);
    note_cut(t, kind, i, c->circle.count - 1, end);
}

/* Begins a row, which may be the first one of some whose order is to be found.
 */
void pel_smooth_begin_row(struct pel_smooth_short_outline *t,
                          const struct pel_smooth_kind *kind)
{
    int32_t end = INT16_MAX * 256;
    t->rows.passed = 0;
    if (t->rows.order == PEL_SMOOTH_NEVER)
        return;
    if (t->rows.left > 0) {
        t->rows.left--;
        return;
    }
    for (uint32_t list = kind->sides; (list & 15) - 1 < PEL_SMOOTH_OTHER - 1;
         list >>= BITS)
        note_curve(t, kind, (int32_t)(list & 15) >> 1, &end);
    const int32_t rows = (end >> 8) - t->seen.y;
    pel_smooth_no_order(t, false);
    t->rows.left = (uint8_t)pel_max(0, pel_min(rows, 256) - 1);
    if (rows > 0) {
        pel_smooth_search_of(t)->seek = true;
        t->rows.order = 0;
    }
}

/* Where a side is at its leftmost, 2^-16 px but for the last digit: that of one
 * that falls is 1, so that it is behind one that rises there. */
static int32_t key_of(const struct pel_smooth_crossing *c, int32_t x)
{
    const uint32_t at = (uint32_t)c->center << 8;
    const uint32_t end = c->left ? ~(at + (uint32_t)c->strip.at_near)
                                 : at + (uint32_t)c->strip.at_far;
    return (int32_t)((uint32_t)x << 16 | (end & 0xFFFE) | !c->rising);
}

/* Puts a side, which begins in column x, into the order, as one of some.x1. Not
 * more than fit, that go from top to bottom, and not those of two half discs,
 * which may cross each other: else there is no order. */
bool pel_smooth_put_in_order(struct pel_smooth_short_outline *t, int32_t side,
                             int32_t x)
{
    const struct pel_smooth_crossing *const c = &t->of.window.crossing;
    int32_t *const key = t->of.window.sum, own = key_of(c, x);
    int32_t i = t->part.some.x1++;
    const int32_t order = t->rows.order;
    if (side < PEL_SMOOTH_OTHER)
        side = 2 * ((side - 1) >> 1) + 1 + c->left;
    if (i == SIDES || x != (int16_t)x ||
        pel_smooth_height(&c->strip) != 32768 ||
        (side > 6 && side < PEL_SMOOTH_OTHER && t->part.some.x0 == INT32_MIN)) {
        t->rows.order = PEL_SMOOTH_NO_ORDER;
        return false;
    }
    if (side == 5 || side == 6)
        t->part.some.x0 = INT32_MIN;
    for (; i > 0 && own < key[i - 1]; i--)
        key[i] = key[i - 1];
    key[i] = own;
    const int32_t low = order & ((1 << BITS * i) - 1);
    t->rows.order =
        (uint16_t)(low + (side << BITS * i) + ((order - low) << BITS));
    return true;
}

/* Ends to look for an order: there is none where sides do not rise and fall in
 * turn. */
void pel_smooth_end_order(struct pel_smooth_short_outline *t)
{
    const int32_t n = t->part.some.x1;
    pel_smooth_search_of(t)->seek = false;
    if (pel_smooth_has_order(t))
        for (int32_t i = 0; i < n; i++)
            if ((t->of.window.sum[i] & 1) != (i & 1) || n % 2)
                t->rows.order = PEL_SMOOTH_NO_ORDER;
}
#endif
