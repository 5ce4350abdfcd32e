/* A paint behind a mask: a picture of 8, 4 or 1 bits of grey says how much of
 * the paint is seen at each pixel, from nothing at black to all of it at white:
 *
 *     pel_image_asset_surface(&cloud, &cloud_asset, &pel_gray8);
 *     pel_masked_init(&soft, &cloud, 20, 10, &sky.base.paint);
 *     pel_box(&screen, &soft.box, &soft.base.paint);
 *
 * `pel import icon.png --format gray4` makes one of a white, transparent icon.
 * Any shape may be painted so; a dither goes around it, not inside. */
#ifndef PEL_PAINT_PAINT_MASK_H
#define PEL_PAINT_PAINT_MASK_H

#include "paint_colors.h"

PEL_BEGIN_DECLS

struct pel_masked {
    struct pel_color_paint base;
    const struct pel_surface *mask;
    const struct pel_paint *paint;
    struct pel_rect box; /* px of the screen that the mask lies on */
};

/* The mask, in gray8, gray4 or mono1 (of other formats blue counts), lies with
 * its top left pixel at (x, y), -32,768..32,767 px; beside it nothing is
 * painted. Each color's alpha becomes round(alpha grey / 255). Mask and paint
 * must live as long as this paint. Draws the inner paint into a surface of a
 * format of its own, of id 254, so through the format's functions alone. On a
 * Cortex-M it takes 260 bytes of stack beside the inner paint's.
 * PEL_ERROR_NULL, PEL_ERROR_FORMAT (the mask cannot be read), PEL_ERROR_RANGE
 * (x, y; or the inner paint is this one). */
enum pel_status pel_masked_init(struct pel_masked *paint,
                                const struct pel_surface *mask, int32_t x,
                                int32_t y, const struct pel_paint *inner);
PEL_END_DECLS
#endif
