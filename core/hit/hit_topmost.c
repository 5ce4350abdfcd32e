#include "hit.h"

int32_t pel_hit_topmost(const struct pel_target *const *targets, int32_t n,
                        int32_t x, int32_t y)
{
    do
        n--;
    while (n >= 0 && !targets[n]->hit(targets[n], x, y));
    return n;
}
