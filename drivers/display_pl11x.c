#include "display_pl11x.h"

/* Registers, in words; the control register and the mask of interrupts are 6
 * and 7, in a PL110 7 and 6. */
enum { UPPER_BASE = 4, CONTROL_OR_MASK = 6 };

enum {
    ENABLE = 1 << 0,
    BITS_16 = 4 << 1, /* 5-5-5, or what the board makes of it */
    BITS_24 = 5 << 1, /* in words of 32 */
    BITS_565 = 6 << 1,
    TFT = 1 << 5,
    RED_HIGH =
        1 << 8, /* red in the high bits of a pixel, not in the low ones */
    BIG_ENDIAN_BYTES = 1 << 9,
    POWER = 1 << 11
};

/* 0 for a format that the controller does not have. */
static uint32_t control_of(enum pel_format_id format, enum pel_pl11x_kind kind)
{
    const uint32_t bits16 = kind == PEL_PL111 ? BITS_565 : BITS_16;
    switch (format) {
    case PEL_FORMAT_RGB565_LE:
        return bits16 | RED_HIGH;
    case PEL_FORMAT_RGB565_BE:
        return bits16 | RED_HIGH | BIG_ENDIAN_BYTES;
    case PEL_FORMAT_BGR565_LE:
        return bits16;
    case PEL_FORMAT_XRGB8888:
        return BITS_24 | RED_HIGH;
    case PEL_FORMAT_XBGR8888:
        return BITS_24;
    case PEL_FORMAT_BGRX8888:
        return BITS_24 | RED_HIGH | BIG_ENDIAN_BYTES;
    case PEL_FORMAT_RGBX8888:
        return BITS_24 | BIG_ENDIAN_BYTES;
    default:
        return 0;
    }
}

static enum pel_status check(const struct pel_surface *screen)
{
    const struct pel_rect *b = &screen->bounds;
    if (!screen->pixels)
        return PEL_ERROR_NULL;
    if (b->x0 || b->y0 || b->x1 < 16 || b->x1 > 1024 || b->x1 % 16 ||
        b->y1 < 1 || b->y1 > 1024)
        return PEL_ERROR_SIZE;
    if (screen->stride != pel_stride(screen->format, b->x1))
        return PEL_ERROR_STRIDE;
    return (uintptr_t)screen->pixels & 7 ||
                   (uintptr_t)screen->pixels > 0xFFFFFFFF
               ? PEL_ERROR_ALIGNMENT
               : PEL_OK;
}

static enum pel_status lcd_begin(const struct pel_display *display,
                                 const struct pel_rect *area,
                                 struct pel_surface *surface)
{
    const struct pel_display_pl11x *lcd = display->context;
    *surface = lcd->screen;
    pel_surface_clip(surface, area);
    return PEL_OK;
}

static enum pel_status lcd_flush(const struct pel_display *display,
                                 const struct pel_surface *surface)
{
    (void)display;
    (void)surface;
    return PEL_OK;
}

enum pel_status pel_display_pl11x_init(struct pel_display *display,
                                       struct pel_display_pl11x *lcd)
{
    if (!display || !lcd || !lcd->registers)
        return PEL_ERROR_NULL;
    const struct pel_surface *screen = &lcd->screen;
    const enum pel_status status = check(screen);
    if (status != PEL_OK)
        return status;
    const uint32_t control = control_of(screen->format->id, lcd->kind);
    if (!control)
        return PEL_ERROR_FORMAT;
    volatile uint32_t *r = lcd->registers;
    const int swapped = lcd->kind == PEL_PL110;
    const uint32_t width = (uint32_t)screen->bounds.x1;
    const uint32_t height = (uint32_t)screen->bounds.y1;
    r[0] = lcd->timing[0] | (width / 16 - 1) << 2;
    r[1] = lcd->timing[1] | (height - 1);
    r[2] = lcd->timing[2] | (width - 1) << 16;
    r[3] = lcd->timing[3];
    r[UPPER_BASE] = (uint32_t)(uintptr_t)screen->pixels;
    r[CONTROL_OR_MASK + !swapped] = 0;
    r[CONTROL_OR_MASK + swapped] = control | TFT | ENABLE | POWER;
    *display = (struct pel_display){.context = lcd,
                                    .width = screen->bounds.x1,
                                    .height = screen->bounds.y1,
                                    .format = screen->format,
                                    .flush = lcd_flush,
                                    .begin = lcd_begin};
    return PEL_OK;
}
