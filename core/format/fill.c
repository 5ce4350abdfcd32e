/* Spans of one pixel value, by the size of the pixel. */
#include <string.h>

#include "span16.h"
#include "span32.h"

void pel_fill8(const struct pel_spans *spans, uint32_t pixel)
{
    const struct pel_span *span = spans->span;
    int32_t y = spans->y;
    for (int i = 0; i < spans->n; i++, span++, y += spans->step)
        if (span->x0 < span->x1)
            memset((void *)pel_address(spans->surface, span->x0, y, 1),
                   (int)pixel, (size_t)(span->x1 - span->x0));
}

void pel_fill16(const struct pel_spans *spans, uint32_t pixel)
{
    const struct pel_span *span = spans->span;
    const pel_value16 value = pel_make_value16(pixel);
    const uintptr_t pitch = (uintptr_t)pel_spans_pitch(spans);
    uintptr_t row = pel_column_zero(spans->surface, spans->y, 2);
    const struct pel_span *const end = span + spans->n;
    do {
        pel_span16((pel_word16 *)(row + 2 * (uintptr_t)span->x0),
                   span->x1 - span->x0, value);
        span++;
        row += pitch;
    } while (span < end);
}

/* Four pixels are three words, which begin with a pixel where the address is a
 * multiple of 4: after as many pixels as it is above one. */
static PEL_NOINLINE int32_t put_fours24(uint8_t *p, int32_t n, uint32_t pixel)
{
    const uint32_t a = PEL_LE32(pixel | pixel << 24);
    const uint32_t b = PEL_LE32(pixel >> 8 | pixel << 16);
    const uint32_t c = PEL_LE32(pixel >> 16 | pixel << 8);
    for (; n >= 4; n -= 4, p += 12) {
        pel_word32 *const q = (pel_word32 *)(void *)p;
        q[0] = a;
        q[1] = b;
        q[2] = c;
    }
    return n;
}

void pel_fill24(const struct pel_spans *spans, uint32_t pixel)
{
    const struct pel_span *span = spans->span;
    int32_t y = spans->y;
    for (int i = 0; i < spans->n; i++, span++, y += spans->step) {
        uint8_t *p = (uint8_t *)pel_address(spans->surface, span->x0, y, 3);
        for (int32_t n = span->x1 - span->x0; n > 0; n--, p += 3) {
            if (n >= 8 && ((uintptr_t)p & 3) == 0) {
                const int32_t rest = put_fours24(p, n, pixel);
                p += 3 * (n - rest);
                n = rest;
                if (n == 0)
                    break;
            }
            p[0] = (uint8_t)pixel;
            p[1] = (uint8_t)(pixel >> 8);
            p[2] = (uint8_t)(pixel >> 16);
        }
    }
}

void pel_fill32(const struct pel_spans *spans, uint32_t pixel)
{
    const struct pel_span *span = spans->span;
    const pel_value32 value = pel_make_value32(pixel);
    const uintptr_t pitch = (uintptr_t)pel_spans_pitch(spans);
    uintptr_t row = pel_column_zero(spans->surface, spans->y, 4);
    for (int32_t n = spans->n; n > 0; n--, span++, row += pitch)
        pel_span32((pel_word32 *)(row + 4 * (uintptr_t)span->x0),
                   span->x1 - span->x0, value, pitch);
}
