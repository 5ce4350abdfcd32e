/* Copies of pictures from surface to surface, between any two formats. */
#ifndef PEL_IMAGE_COPY_H
#define PEL_IMAGE_COPY_H

#include "../base/surface.h"

PEL_BEGIN_DECLS

/* What is copied, and where to. The source is read inside its bounds, whatever
 * its clip, so it may be a picture in flash (pel_image_asset_surface). Its
 * memory must not overlap that of the destination; pel_scroll moves a part of a
 * surface inside it. All coordinates lie in -65,536..65,536; otherwise nothing
 * is copied, which is a broken contract: PEL_ASSERT. */
struct pel_copy_part {
    const struct pel_surface *source;
    struct pel_rect area; /* px of the source; what lies outside is left out */
    int32_t x, y;         /* px: where the pixel (area.x0, area.y0) goes */
};

/* Copies the area inside the destination's clip. Each pixel gets its color
 * packed into the destination's format; alpha is ignored. */
void pel_copy(const struct pel_surface *surface,
              const struct pel_copy_part *copy);

/* The same but for the pixels of one color, which stay as they are. The key is
 * packed into the source's format and compared there, without alpha and unused
 * bits. */
void pel_copy_keyed(const struct pel_surface *surface,
                    const struct pel_copy_part *copy, pel_color key);

/* Each pixel over what is there (pel_mix), weighted by its own alpha times
 * `alpha`: round(a alpha / 255). Sources without an alpha channel have a = 255;
 * argb8888.h is one that has. Weight 0 leaves the pixel untouched, 255 copies
 * it. */
void pel_copy_alpha(const struct pel_surface *surface,
                    const struct pel_copy_part *copy, uint8_t alpha);
PEL_END_DECLS
#endif
