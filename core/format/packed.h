/* Loops over pixels that share a byte with others. A format gives get and put
 * of one pixel; they are inlined. */
#ifndef PEL_FORMAT_PACKED_H
#define PEL_FORMAT_PACKED_H

#include "word.h"

typedef uint32_t pel_get_function(const struct pel_surface *, int32_t x,
                                  int32_t y);
typedef void pel_put_function(const struct pel_surface *, int32_t x, int32_t y,
                              uint32_t pixel);

/* Runs of gray4 and mono1, in fill_bits.c: `byte` is the pixel repeated over 8
 * bits. */
void pel_fill_bits(const struct pel_rows *rows, uint32_t byte);

/* Grey formats unpack to equal channels, so one of them stands for all. */
static PEL_ALWAYS_INLINE void pel_blend_packed(const struct pel_rows *rows,
                                               pel_color color,
                                               const struct pel_format *format,
                                               pel_get_function get,
                                               pel_put_function put)
{
    const struct pel_row *row = rows->row;
    const uint32_t alpha = pel_alpha(color);
    int32_t y = rows->y;
    for (int i = 0; i < rows->n; i++, row++, y += rows->step)
        for (int32_t x = row->x0; x < row->x1; x++) {
            pel_color under = format->unpack(get(rows->surface, x, y));
            put(rows->surface, x, y,
                format->pack(pel_mix(under, color, alpha)));
        }
}

#endif
