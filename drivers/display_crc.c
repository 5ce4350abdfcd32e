#include "display_crc.h"

#include "crc.h"

static uint32_t row_crc(const struct pel_surface *s, int32_t y)
{
    const int32_t x0 = s->clip.x0;
    const uint8_t place[4] = {(uint8_t)x0, (uint8_t)(x0 >> 8), (uint8_t)y,
                              (uint8_t)(y >> 8)};
    uint32_t crc = pel_crc(0, place, sizeof place);
    for (int32_t x = x0; x < s->clip.x1; x++) {
        pel_color color;
        s->format->load(s, x, y, 1, &color);
        const uint8_t bytes[4] = {(uint8_t)color, (uint8_t)(color >> 8),
                                  (uint8_t)(color >> 16),
                                  (uint8_t)(color >> 24)};
        crc = pel_crc(crc, bytes, sizeof bytes);
    }
    return crc;
}

/* Reads the pixels before they are in flight. */
static enum pel_status crc_flush(const struct pel_display *display,
                                 const struct pel_surface *surface)
{
    struct pel_display_crc *crc = display->context;
    if (!surface->format->load)
        return PEL_ERROR_FORMAT;
    for (int32_t y = surface->clip.y0; y < surface->clip.y1; y++)
        crc->sum += row_crc(surface, y);
    return pel_display_flush(crc->inner, surface);
}

static enum pel_status crc_begin(const struct pel_display *display,
                                 const struct pel_rect *area,
                                 struct pel_surface *surface)
{
    const struct pel_display_crc *crc = display->context;
    return pel_display_begin(crc->inner, area, surface);
}

static enum pel_status crc_wait(const struct pel_display *display)
{
    const struct pel_display_crc *crc = display->context;
    return pel_display_wait(crc->inner);
}

static enum pel_status crc_flip(const struct pel_display *display)
{
    struct pel_display_crc *crc = display->context;
    const enum pel_status status = pel_display_flip(crc->inner);
    if (status == PEL_OK && crc->report)
        crc->report(crc);
    crc->sum = 0;
    return status;
}

static void crc_align(const struct pel_display *display, struct pel_rect *area)
{
    const struct pel_display_crc *crc = display->context;
    pel_display_align(crc->inner, area);
}

enum pel_status pel_display_crc_init(struct pel_display *display,
                                     struct pel_display_crc *crc)
{
    if (!display || !crc || !crc->inner)
        return PEL_ERROR_NULL;
    *display = *crc->inner;
    display->context = crc;
    display->flush = crc_flush;
    display->begin = crc->inner->begin ? crc_begin : NULL;
    display->wait = crc_wait;
    display->flip = crc_flip;
    display->align = crc_align;
    crc->sum = 0;
    return PEL_OK;
}
