#include "word.h"

/* In pairs where speed counts, once the address allows it. */
void pel_pattern16(pel_word16 *p, int32_t n)
{
    pel_word16 *const end = p + n;
    for (; p < end && (!PEL_KNOW_SIDES || (uintptr_t)p % 4); p++)
        *p = p[-8];
    if (!PEL_KNOW_SIDES)
        return;
    pel_word32 *q = (pel_word32 *)(void *)p;
    for (; end - p >= 8; p += 8, q += 4) {
        q[0] = q[-4];
        q[1] = q[-3];
        q[2] = q[-2];
        q[3] = q[-1];
    }
    for (; p < end; p++)
        *p = p[-8];
}
