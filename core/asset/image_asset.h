/* Pictures in flash, as `pel import` writes them: pixels in one pixel format,
 * ready to be read as a surface. */
#ifndef PEL_ASSET_IMAGE_ASSET_H
#define PEL_ASSET_IMAGE_ASSET_H

#include "../base/surface.h"

PEL_BEGIN_DECLS

/* "PELI", and the version of the struct. */
#define PEL_IMAGE_MAGIC UINT32_C(0x494C4550)
enum { PEL_IMAGE_VERSION = 1 };

struct pel_image_asset {
    uint32_t magic;         /* PEL_IMAGE_MAGIC */
    uint8_t version;        /* PEL_IMAGE_VERSION */
    uint8_t format;         /* enum pel_format_id of the pixels */
    uint16_t width, height; /* px, 1..32,767 */
    int32_t stride;         /* bytes to the next row (page) down */
    uint32_t size;          /* bytes of pixels */
    const void *pixels;     /* aligned to 4 bytes */
};

/* Rows of memory: rows of pixels, or pages of eight of them. */
static inline uint32_t pel_image_rows(const struct pel_image_asset *image)
{
    return image->format == PEL_FORMAT_MONO1_PAGES ? (image->height + 7u) / 8
                                                   : image->height;
}

/* Checks that the program can read this asset as `format`. PEL_ERROR_NULL;
 * PEL_ERROR_RANGE: no image asset, or one of another version; PEL_ERROR_FORMAT:
 * its pixels are of another format; PEL_ERROR_SIZE; PEL_ERROR_STRIDE: a row
 * does not fit its stride, or the rows do not fit the size. */
static inline enum pel_status pel_image_asset_check(
    const struct pel_image_asset *image, const struct pel_format *format)
{
    if (!image || !format || !image->pixels)
        return PEL_ERROR_NULL;
    if (image->magic != PEL_IMAGE_MAGIC || image->version != PEL_IMAGE_VERSION)
        return PEL_ERROR_RANGE;
    if (image->format != format->id)
        return PEL_ERROR_FORMAT;
    if (image->width < 1 || image->width > 32767 || image->height < 1 ||
        image->height > 32767)
        return PEL_ERROR_SIZE;
    if (image->stride < pel_stride(format, image->width) ||
        image->size / PEL_CAST(uint32_t, image->stride) < pel_image_rows(image))
        return PEL_ERROR_STRIDE;
    return PEL_OK;
}

/* A surface that shows the picture, for reading only: its clip is empty, so
 * that no draw call writes to it. Errors of pel_image_asset_check and of
 * pel_surface_init_rect. */
enum pel_status pel_image_asset_surface(struct pel_surface *surface,
                                        const struct pel_image_asset *image,
                                        const struct pel_format *format);
PEL_END_DECLS
#endif
