/* Spans of one pixel value, by the size of the pixel. */
#include <string.h>

#include "span16.h"
#include "span32.h"

/* How many spans to draw: one where all are like it and wide, so that the
 * others are copied from it. memcpy may have wider registers than fills. */
static PEL_ALWAYS_INLINE int32_t count_to_draw(const struct pel_spans *spans,
                                               int bytes)
{
    const struct pel_span *const span = spans->span;
    if (!PEL_VECTORS || (span->x1 - span->x0) * bytes < 512)
        return spans->n;
    for (int32_t i = 1; i < spans->n; i++)
        if (span[i].x0 != span->x0 || span[i].x1 != span->x1)
            return spans->n;
    return 1;
}

static PEL_NOINLINE void copy_first(const struct pel_spans *spans, int bytes)
{
    const struct pel_span *const span = spans->span;
    const size_t size = (size_t)((span->x1 - span->x0) * bytes);
    uint8_t *const first =
        (uint8_t *)pel_address(spans->surface, span->x0, spans->y, bytes);
    for (int32_t i = 1; i < spans->n; i++)
        memcpy(first + i * pel_spans_pitch(spans), first, size);
}

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
    const int32_t n = count_to_draw(spans, 2);
    const struct pel_span *const end = span + n;
    do {
        pel_span16((pel_word16 *)(row + 2 * (uintptr_t)span->x0),
                   span->x1 - span->x0, value);
        span++;
        row += pitch;
    } while (span < end);
    if (PEL_VECTORS && n < spans->n)
        copy_first(spans, 2);
}

void pel_fill24(const struct pel_spans *spans, uint32_t pixel)
{
    const struct pel_span *span = spans->span;
    int32_t y = spans->y;
    for (int i = 0; i < spans->n; i++, span++, y += spans->step) {
        uint8_t *p = (uint8_t *)pel_address(spans->surface, span->x0, y, 3);
        for (int32_t n = span->x1 - span->x0; n > 0; n--, p += 3) {
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
    const int32_t n = count_to_draw(spans, 4);
    for (int32_t i = n; i > 0; i--, span++, row += pitch)
        pel_span32((pel_word32 *)(row + 4 * (uintptr_t)span->x0),
                   span->x1 - span->x0, value, pitch);
    if (PEL_VECTORS && n < spans->n)
        copy_first(spans, 4);
}
