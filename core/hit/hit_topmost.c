#include "hit.h"

static bool may_hit(const struct pel_rect *box, int32_t x, int32_t y)
{
    if (x >= box->x0 && x < box->x1)
        return (y >= box->y0 && y < box->y1) || box->y0 >= box->y1;
    return pel_rect_empty(box);
}

int32_t pel_hit_topmost(const struct pel_target *const *targets, int32_t n,
                        int32_t x, int32_t y)
{
    if (n < 0)
        return -1;
    while (--n >= 0) {
        const struct pel_target *t = targets[n];
        if (may_hit(&t->box, x, y) && t->hit(t, x, y))
            break;
    }
    return n;
}
