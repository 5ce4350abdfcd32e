#include "image_asset.h"

enum pel_status pel_image_asset_surface(struct pel_surface *surface,
                                        const struct pel_image_asset *image,
                                        const struct pel_format *format)
{
    const struct pel_rect nothing = {0, 0, 0, 0};
    struct pel_rect bounds = {0, 0, 0, 0};
    enum pel_status status = pel_image_asset_check(image, format);
    if (status != PEL_OK)
        return status;
    bounds.x1 = image->width;
    bounds.y1 = image->height;
    status =
        pel_surface_init_rect(surface, format, (void *)(uintptr_t)image->pixels,
                              image->stride, &bounds);
    if (status == PEL_OK)
        pel_surface_clip(surface, &nothing);
    return status;
}
