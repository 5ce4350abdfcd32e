#include "../asset/image_asset.h"
#include "work.h"

enum pel_status pel_mesh_texture_of_image(struct pel_mesh_texture *texture,
                                          struct pel_surface *surface,
                                          const struct pel_mesh_image *image,
                                          const struct pel_format *format)
{
    const struct pel_texels texels = {surface, NULL, 0, 0, false};
    if (!texture || !image)
        return PEL_ERROR_NULL;
    texture->texels = texels;
    texture->wrap_u = (enum pel_wrap)image->wrap_u;
    texture->wrap_v = (enum pel_wrap)image->wrap_v;
    texture->alpha = image->cut_out ? pel_texture_cut_out : NULL;
    return pel_image_asset_surface(surface, image->image, format);
}
