/* Surfaces: a view of the caller's pixels, which it does not own. */
#ifndef PEL_BASE_SURFACE_H
#define PEL_BASE_SURFACE_H

#include <stddef.h>

#include "format.h"
#include "status.h"

PEL_BEGIN_DECLS

struct pel_surface {
    void *pixels;           /* the address of pixel (bounds.x0, bounds.y0) */
    int32_t stride;         /* bytes to the next row down (mono1_pages: to the
                               next page of 8); may be negative */
    struct pel_rect bounds; /* the pixels that memory holds, absolute */
    struct pel_rect clip;   /* the pixels that may change; inside bounds */
    const struct pel_format *format;
};

/* Bytes of a row of `width` pixels, 1..32,767, without padding (mono1_pages: of
 * a page of 8 rows); 0 when width or format is not legal. */
int32_t pel_stride(const struct pel_format *format, int32_t width);

/* A surface over `size` bytes of memory, rows packed without padding:
 *
 *     static uint16_t band[64 * 8];
 *     const struct pel_rect rows = {0, y, 64, y + 8};
 *     pel_surface_init(&screen, &pel_rgb565_le, band, sizeof band, &rows);
 *
 * `bounds` are absolute pixels inside -32,768..32,767 (x1 and y1 up to 32,768),
 * at most 32,767 wide and high: {0, 0, width, height} for a whole picture. A
 * band or tile of a larger picture is a surface with the bounds of that part,
 * and what is drawn into the parts equals what is drawn into the whole. For
 * formats with less than 8 bits a tile begins at a byte (x0 even for gray4, a
 * multiple of 8 for mono1; y0 a multiple of 8 for mono1_pages). The clip is the
 * whole surface. PEL_ERROR_NULL, PEL_ERROR_SIZE (bounds out of range, or more
 * than the memory holds), PEL_ERROR_ALIGNMENT: the surface has no pixel then,
 * and shapes draw nothing. */
enum pel_status pel_surface_init(struct pel_surface *surface,
                                 const struct pel_format *format, void *pixels,
                                 size_t size, const struct pel_rect *bounds);

/* The same with the bytes from a row to the one below: negative for a bottom-up
 * picture (not in mono1_pages, and not INT32_MIN), larger than pel_stride() for
 * padding, which is never written. The caller knows that the memory is there.
 * Errors as above, and PEL_ERROR_STRIDE. */
enum pel_status pel_surface_init_rect(struct pel_surface *surface,
                                      const struct pel_format *format,
                                      void *pixels, int32_t stride,
                                      const struct pel_rect *bounds);

/* True for bounds that a surface of some format may have. */
bool pel_bounds_legal(const struct pel_rect *bounds);

/* Sets the clip to the part of `clip` inside the bounds. Any rectangle will do;
 * where nothing is left the clip is empty, at the corner of the bounds. */
void pel_surface_clip(struct pel_surface *surface, const struct pel_rect *clip);

/* The address of pixel (bounds.x0, y); not for mono1_pages. */
static inline uint8_t *pel_surface_line(const struct pel_surface *s, int32_t y)
{
    return PEL_CAST(uint8_t *, s->pixels) +
           PEL_CAST(ptrdiff_t, y - s->bounds.y0) * s->stride;
}
PEL_END_DECLS
#endif
