/* Smooth edges: each pixel is painted with the weight of its part that the
 * shape covers, the exact area, rounded to 0..255.
 *
 * Smooth shapes are named like the others, pel_smooth_triangle beside
 * pel_triangle, and take the same points, shapes and paints:
 *
 *  - a pixel of coverage 255 gets, byte for byte, what the paint stores there
 *    without smoothing; one of 0 stays untouched;
 *  - in between the color of the paint at the pixel's centre is put there with
 *    its alpha times coverage: round(alpha coverage / 255). Coverage is mixed
 *    like alpha, in sRGB as it is (base/color.h);
 *  - bands, tiles and clips change nothing: coverage is a function of the shape
 *    and the pixel.
 *
 * Shapes that share an edge let the background shine through there: half over
 * half leaves a quarter. So meshes are drawn without smoothing, and a smooth
 * polygon that belongs together is one polygon.
 *
 * The formats pel_rgb565_le_fill and pel_rgb565_be_fill cannot be blended: a
 * smooth shape on them is a broken contract, PEL_ASSERT, and draws nothing.
 *
 * The rest of this header is for those who write a smooth shape. It hands over
 * its rows. Full pixels go to the paint on the real surface, with all that is
 * fast there; the colors of the others, of some rows at once, go into a short
 * buffer, a surface before the surface, are weighed there and put into the real
 * one. Paints and formats know nothing of coverage. */
#ifndef PEL_SMOOTH_SMOOTH_H
#define PEL_SMOOTH_SMOOTH_H

#include "../raster/paint.h"

PEL_BEGIN_DECLS

/* Part of a row of a shape: `left` pixels with a coverage each, `full` ones of
 * 255, then `right` ones. Each number may be 0; left and right are at most 255.
 */
struct pel_smooth_row {
    int32_t y, x;              /* px: the first one */
    int32_t left, full, right; /* px */
    const uint8_t *coverage;   /* of the left ones, then the right ones */
};

/* Where flash or stack is scarce there is one way for all rows, which is
 * slower; what finds them has returned (PEL_SMOOTH_APART) when something is
 * painted. */
#if PEL_SMALL_CODE || PEL_SHORT_STACK
#define PEL_SMOOTH_TINY 1
#define PEL_SMOOTH_APART PEL_NOINLINE
#else
#define PEL_SMOOTH_TINY 0
#define PEL_SMOOTH_APART inline
#endif

/* The room of a batch: rows, and bytes of coverage. */
#if PEL_SMOOTH_TINY
enum { PEL_SMOOTH_BATCH_ROWS = 1, PEL_SMOOTH_BATCH_BYTES = 16 };
#elif PEL_64BIT
enum { PEL_SMOOTH_BATCH_ROWS = 16, PEL_SMOOTH_BATCH_BYTES = 128 };
#else
enum { PEL_SMOOTH_BATCH_ROWS = 8, PEL_SMOOTH_BATCH_BYTES = 40 };
#endif

/* n rows one below the other, the first is row y. In row i the pixels
 * at.full[i] are full; count[2 i] pixels before them and count[2 i + 1] behind
 * them have a coverage each, in `coverage` from left to right, row by row.
 * Where x0 >= x1 no pixel is full. Only core makes batches: their room depends
 * on how it is compiled. */
struct pel_smooth_batch {
    int32_t y, n;
    uint8_t count[2 * PEL_SMOOTH_BATCH_ROWS];
    uint8_t coverage[PEL_SMOOTH_BATCH_BYTES];
    union {
        struct pel_span full[PEL_SMOOTH_BATCH_ROWS];
        int32_t x[2 * PEL_SMOOTH_BATCH_ROWS];
    } at;
};

struct pel_smooth {
    const struct pel_surface *target;
    const struct pel_paint *paint;
};

/* The id of the buffer's format. Those of a dither and a mask are above it. */
enum { PEL_SMOOTH_FORMAT = 253 };

/* The surface that gets the colors of pixels which are weighed. */
struct pel_smooth_surface {
    struct pel_surface surface; /* first */
    const struct pel_surface *target;
};

static inline bool pel_is_smooth(const struct pel_surface *surface)
{
    return surface->format->id == PEL_SMOOTH_FORMAT;
}

/* The real surface, whose pixels a blend loads. */
static inline const struct pel_surface *pel_smooth_target(
    const struct pel_surface *surface)
{
    return pel_is_smooth(surface)
               ? PEL_CAST_ADDRESS(const struct pel_smooth_surface *, surface)
                     ->target
               : surface;
}

/* The depths that a dither has to show: those of the real surface. */
static inline const uint8_t *pel_smooth_depth(const struct pel_surface *surface)
{
    return pel_smooth_target(surface)->format->depth;
}

/* Begins a shape. False, and PEL_ASSERT, when the format cannot be blended.
 * The surface and the paint must live until the end. Without a format
 * (raster/dirty.h) the paint sees the spans alone. */
bool pel_smooth_begin(struct pel_smooth *smooth,
                      const struct pel_surface *surface,
                      const struct pel_paint *paint);

/* Paints a part of a row, which lies inside the clip. Its bytes are not used
 * after the call. No pixel may be painted twice. */
void pel_smooth_paint(const struct pel_smooth *smooth,
                      const struct pel_smooth_row *row);

/* Paints rows that lie inside the clip. pel_smooth_clip_batch cuts off what of
 * other ones lies left or right of it. */
void pel_smooth_paint_batch(const struct pel_smooth *smooth,
                            const struct pel_smooth_batch *batch);
void pel_smooth_clip_batch(struct pel_smooth_batch *batch,
                           const struct pel_rect *clip);

/* Paints the first row of a batch as row y, and each of the others above the
 * one before; the batch is the same in the end. Not where PEL_SMOOTH_TINY is 1.
 */
void pel_smooth_paint_upwards(const struct pel_smooth *smooth,
                              struct pel_smooth_batch *batch, int32_t y);
PEL_END_DECLS
#endif
