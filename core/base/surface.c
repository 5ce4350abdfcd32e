#include "surface.h"

int32_t pel_stride(const struct pel_format *format, int32_t width)
{
    if (!format || width < 1 || width > 32767)
        return 0;
    if (format->id == PEL_FORMAT_MONO1_PAGES)
        return width;
    return (width * format->bits + 7) / 8;
}

bool pel_bounds_legal(const struct pel_rect *b)
{
    return b->x0 >= -32768 && b->y0 >= -32768 && b->x1 <= 32768 &&
           b->y1 <= 32768 && !pel_rect_empty(b) && b->x1 - b->x0 <= 32767 &&
           b->y1 - b->y0 <= 32767;
}

/* Tiles of packed formats start at a byte. */
static bool origin_legal(const struct pel_format *f, const struct pel_rect *b)
{
    if (f->id == PEL_FORMAT_MONO1_PAGES)
        return (b->y0 & 7) == 0;
    return ((b->x0 * f->bits) & 7) == 0;
}

static enum pel_status check(const struct pel_format *format,
                             const void *pixels, int32_t stride,
                             const struct pel_rect *bounds)
{
    if (!format || !pixels || !bounds)
        return PEL_ERROR_NULL;
    if (!pel_bounds_legal(bounds))
        return PEL_ERROR_SIZE;
    if (!origin_legal(format, bounds))
        return PEL_ERROR_ALIGNMENT;
    int32_t needed = pel_stride(format, bounds->x1 - bounds->x0);
    if (stride < needed && (stride > -needed || stride == INT32_MIN ||
                            format->id == PEL_FORMAT_MONO1_PAGES))
        return PEL_ERROR_STRIDE;
    if ((uintptr_t)pixels % format->word || stride % format->word)
        return PEL_ERROR_ALIGNMENT;
    return PEL_OK;
}

enum pel_status pel_surface_init_rect(struct pel_surface *surface,
                                      const struct pel_format *format,
                                      void *pixels, int32_t stride,
                                      const struct pel_rect *bounds)
{
    const enum pel_status status = check(format, pixels, stride, bounds);
    if (!surface)
        return PEL_ERROR_NULL;
    if (status != PEL_OK) {
        *surface = (struct pel_surface){0};
        return status;
    }
    surface->pixels = pixels;
    surface->stride = stride;
    surface->clip = *bounds;
    surface->bounds = surface->clip;
    surface->format = format;
    return PEL_OK;
}

void pel_surface_clip(struct pel_surface *surface, const struct pel_rect *clip)
{
    const struct pel_rect *b = &surface->bounds;
    surface->clip = pel_rect_intersect(b, clip);
    if (pel_rect_empty(&surface->clip))
        surface->clip = (struct pel_rect){b->x0, b->y0, b->x0, b->y0};
}

enum pel_status pel_surface_init(struct pel_surface *surface,
                                 const struct pel_format *format, void *pixels,
                                 size_t size, const struct pel_rect *bounds)
{
    static const struct pel_rect nothing = {0, 0, 0, 0};
    int32_t stride = 0;
    if (format && bounds && pel_bounds_legal(bounds)) {
        int32_t lines = bounds->y1 - bounds->y0;
        if (format->id == PEL_FORMAT_MONO1_PAGES)
            lines = (lines + 7) / 8;
        stride = pel_stride(format, bounds->x1 - bounds->x0);
        if (size < (uint32_t)stride * (uint32_t)lines) /* 131,068 by 32,767 */
            bounds = &nothing; /* refused by its size, as memory is */
    }
    return pel_surface_init_rect(surface, format, pixels, stride, bounds);
}
