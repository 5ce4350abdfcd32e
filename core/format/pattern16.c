#include "word.h"

/* Where speed counts: the first eight pixels, and one more where the address
 * asks for it; then pairs, each like the one eight pixels before it. */
void pel_pattern16(const struct pel_surface *s, int32_t x, int32_t y, int32_t n,
                   const uint32_t pixels[8])
{
    pel_word16 *p = pel_address16(s, x, y);
    pel_word16 *const end = p + n;
    const int32_t odd = ((uintptr_t)p & 2) != 0;
    for (n = PEL_KNOW_SIDES ? pel_min(n, 8 + odd) : n; n > 0; n--)
        *p++ = (pel_word16)pixels[x++ & 7];
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
