#include "smooth_row.h"

#include <string.h>

/* Does a side cross the first column that is left? All those before *end are
 * like it. */
static bool is_crossed(const struct pel_smooth_columns *c, int32_t *end)
{
    const int32_t x = c->left.x0;
    bool crossed = false;
    *end = c->left.x1;
    for (int i = 0; i < c->n; i++) {
        const struct pel_span *const s = &c->crossed[i];
        if (x < s->x1)
            *end = pel_min(*end, x < s->x0 ? s->x0 : s->x1);
        crossed |= x >= s->x0 && x < s->x1;
    }
    return crossed && x < *end;
}

/* Those of a side up to `end`, as many as there is room for. */
static void put_crossed(struct pel_smooth_columns *c,
                        struct pel_smooth_batch *b, int side, int32_t end)
{
    const int32_t room = PEL_SMOOTH_BATCH_BYTES - (side ? b->count[0] : 0);
    uint8_t *const to = b->coverage + PEL_SMOOTH_BATCH_BYTES - room;
    const int32_t n = pel_min(end - c->left.x0, room);
    for (int32_t i = 0; i < n; i += PEL_SMOOTH_PIXELS)
        c->cover(c->shape, c->left.x0 + i, pel_min(n - i, PEL_SMOOTH_PIXELS),
                 to + i);
    b->count[side] = (uint8_t)n;
    c->left.x0 += n;
}

/* Those of one coverage: full ones, or as many bytes as there is room for. */
static void put_even(struct pel_smooth_columns *c, struct pel_smooth_batch *b,
                     int32_t end)
{
    const int32_t room = PEL_SMOOTH_BATCH_BYTES - b->count[0];
    const int32_t n = pel_min(end - c->left.x0, room);
    uint8_t *const to = b->coverage + b->count[0];
    if (n == 0)
        return;
    *to = (uint8_t)c->even;
    if (c->even < 0)
        c->cover(c->shape, c->left.x0, 1, to);
    if (*to == 255) {
        b->at.full[0].x1 = end;
    } else if (*to > 0) {
        memset(to, *to, (size_t)n);
        b->count[0] = (uint8_t)(b->count[0] + n);
        end = c->left.x0 + n;
        b->at.full[0] = (struct pel_span){end, end};
    }
    c->left.x0 = end;
}

void pel_smooth_cover(struct pel_smooth_columns *c, struct pel_smooth_batch *b)
{
    struct pel_span *const full = b->at.full;
    b->n = 1;
    b->count[0] = b->count[1] = 0;
    for (int side = 0; side < 2; side++) {
        int32_t end;
        if (is_crossed(c, &end))
            put_crossed(c, b, side, end);
        if (side == 1)
            break;
        full->x0 = full->x1 = c->left.x0;
        if (!is_crossed(c, &end))
            put_even(c, b, end);
        if (full->x1 != c->left.x0)
            break;
    }
}
