/* Which of Pel's formats a framebuffer's mode is. */
#include <stddef.h>

#include <pel/pel.h>
#include "display_linux_fb.h"

struct layout {
    const struct pel_format *format;
    uint8_t red, red_length, green, green_length, blue, blue_length;
};

static const struct layout layouts[] = {
    {&pel_rgb565_le, 11, 5, 5, 6, 0, 5},   {&pel_bgr565_le, 0, 5, 5, 6, 11, 5},
    {&pel_xrgb1555_le, 10, 5, 5, 5, 0, 5}, {&pel_rgb888, 16, 8, 8, 8, 0, 8},
    {&pel_bgr888, 0, 8, 8, 8, 16, 8},      {&pel_xrgb8888, 16, 8, 8, 8, 0, 8},
    {&pel_xbgr8888, 0, 8, 8, 8, 16, 8},    {&pel_rgbx8888, 24, 8, 16, 8, 8, 8},
    {&pel_bgrx8888, 8, 8, 16, 8, 24, 8},   {&pel_rgb332, 5, 3, 2, 3, 0, 2}};

static uint32_t top_bit(const struct fb_var_screeninfo *v)
{
    uint32_t red = v->red.offset + v->red.length;
    uint32_t green = v->green.offset + v->green.length;
    uint32_t blue = v->blue.offset + v->blue.length;
    uint32_t top = red > green ? red : green;
    return top > blue ? top : blue;
}

/* Bytes of a pixel: what the channels need, and more when lines are long enough
 * for it: as many as bits_per_pixel says, which some drivers get wrong, and 4
 * rather than 3 unless it says 24. */
static uint32_t pixel_bytes(const struct pel_fb_mode *mode)
{
    const struct fb_var_screeninfo *v = &mode->variable;
    uint32_t needed = (top_bit(v) + 7) / 8;
    uint32_t width = v->xres_virtual > v->xres ? v->xres_virtual : v->xres;
    uint32_t room = width ? mode->fixed.line_length / width : 0;
    uint32_t told = (v->bits_per_pixel + 7) / 8;
    if (needed == 3 && room >= 4 && told != 3)
        return 4;
    return told > needed && told <= room ? told : needed;
}

/* On palettes all channels have the same field: an index of that many bits. */
static bool is_palette(const struct pel_fb_mode *mode)
{
    const struct fb_var_screeninfo *v = &mode->variable;
    return mode->fixed.visual == FB_VISUAL_PSEUDOCOLOR &&
           v->bits_per_pixel == 8;
}

static bool is_gray(const struct pel_fb_mode *mode)
{
    const struct fb_var_screeninfo *v = &mode->variable;
    return v->grayscale == 1 && v->bits_per_pixel == 8;
}

uint32_t pel_fb_few_bits(const struct pel_fb_mode *mode)
{
    const struct fb_var_screeninfo *v = &mode->variable;
    const uint32_t visual = mode->fixed.visual;
    const bool known = visual == FB_VISUAL_MONO01 ||
                       visual == FB_VISUAL_MONO10 ||
                       visual == FB_VISUAL_PSEUDOCOLOR ||
                       visual == FB_VISUAL_STATIC_PSEUDOCOLOR;
    const bool whole = v->xoffset * v->bits_per_pixel % 8 == 0;
    return known && whole && !v->red.msb_right && v->bits_per_pixel <= 2
               ? v->bits_per_pixel
               : 0;
}

static bool is_true_color(const struct pel_fb_mode *mode)
{
    const struct fb_var_screeninfo *v = &mode->variable;
    return (mode->fixed.visual == FB_VISUAL_TRUECOLOR ||
            mode->fixed.visual == FB_VISUAL_DIRECTCOLOR) &&
           v->grayscale == 0 && !v->red.msb_right && !v->green.msb_right &&
           !v->blue.msb_right;
}

static const struct pel_format *find(const struct pel_fb_mode *mode)
{
    const struct fb_var_screeninfo *v = &mode->variable;
    const uint32_t bits = pixel_bytes(mode) * 8;
    if (mode->fixed.type != FB_TYPE_PACKED_PIXELS)
        return NULL;
    if (pel_fb_few_bits(mode))
        return pel_fb_few_bits(mode) == 1 ? &pel_mono1 : &pel_gray8;
    if (is_gray(mode))
        return &pel_gray8;
    if (is_palette(mode))
        return &pel_rgb332;
    if (!is_true_color(mode))
        return NULL;
    for (size_t i = 0; i < sizeof(layouts) / sizeof(layouts[0]); i++) {
        const struct layout *l = &layouts[i];
        if (l->format->bits == bits && v->red.offset == l->red &&
            v->red.length == l->red_length && v->green.offset == l->green &&
            v->green.length == l->green_length && v->blue.offset == l->blue &&
            v->blue.length == l->blue_length)
            return l->format;
    }
    return NULL;
}

/* Value i of a channel of that many bits, the last one from there on. */
static uint16_t ramp(uint32_t i, uint32_t bits)
{
    const uint32_t last = (1u << bits) - 1;
    return (uint16_t)((i < last ? i : last) * 65535 / last);
}

uint32_t pel_fb_color_map(const struct pel_fb_mode *mode,
                          const struct pel_format *format,
                          uint16_t map[3][PEL_FB_COLORS])
{
    const struct fb_var_screeninfo *v = &mode->variable;
    const bool palette = mode->fixed.visual == FB_VISUAL_PSEUDOCOLOR;
    if (!palette &&
        (mode->fixed.visual != FB_VISUAL_DIRECTCOLOR || is_gray(mode)))
        return 0;
    const uint32_t few = pel_fb_few_bits(mode);
    const uint32_t n = few       ? 1u << few
                       : palette ? PEL_FB_COLORS
                                 : 1u << v->green.length;
    for (uint32_t i = 0; i < n; i++) {
        const uint32_t gray = few ? i * 255 / (n - 1) : 0;
        pel_color c = few       ? PEL_RGB(gray, gray, gray)
                      : palette ? format->unpack(i)
                                : 0;
        map[0][i] =
            palette ? (uint16_t)(pel_red(c) * 257) : ramp(i, v->red.length);
        map[1][i] =
            palette ? (uint16_t)(pel_green(c) * 257) : ramp(i, v->green.length);
        map[2][i] =
            palette ? (uint16_t)(pel_blue(c) * 257) : ramp(i, v->blue.length);
    }
    return n;
}

/* Does the visible part lie inside the memory, with lines apart? The height of
 * the memory does not follow from smem_len; it only bounds it. */
static bool fits(const struct pel_fb_mode *mode, uint32_t bits)
{
    const struct fb_var_screeninfo *v = &mode->variable;
    const uint64_t line = mode->fixed.line_length;
    const uint64_t width = ((uint64_t)v->xoffset + v->xres) * bits / 8;
    const uint64_t lines = (uint64_t)v->yoffset + v->yres;
    return v->xres >= 1 && v->xres <= 32767 && v->yres >= 1 &&
           v->yres <= 32767 && line <= INT32_MAX && width <= line &&
           (lines - 1) * line + width <= mode->fixed.smem_len;
}

const struct pel_format *pel_fb_format(const struct pel_fb_mode *mode,
                                       struct pel_message *message)
{
    const struct fb_var_screeninfo *v = &mode->variable;
    const struct fb_fix_screeninfo *f = &mode->fixed;
    const struct pel_format *format = find(mode);
    const uint32_t few = pel_fb_few_bits(mode);
    if (format && fits(mode, few ? few : format->bits) &&
        (few || f->line_length % format->word == 0))
        return format;
    pel_message_set(
        message, 0,
        "%.16s: %s: %ux%u (virtual %ux%u, offset %u,%u), %u bits, "
        "line_length %u, smem_len %u, type %u, visual %u, grayscale %u, "
        "red %u/%u green %u/%u blue %u/%u (offset/length); set another mode, "
        "16 or 32 bits are the usual ones",
        f->id, format ? "its memory does not hold its mode" : "unknown layout",
        v->xres, v->yres, v->xres_virtual, v->yres_virtual, v->xoffset,
        v->yoffset, v->bits_per_pixel, f->line_length, f->smem_len, f->type,
        f->visual, v->grayscale, v->red.offset, v->red.length, v->green.offset,
        v->green.length, v->blue.offset, v->blue.length);
    return NULL;
}
