#include "selftest.h"

#include <pel/pel.h>

#include "crc.h"

enum { WIDTH = 48, HEIGHT = 32, LINES = 8 };

static void draw_shapes(const struct pel_surface *s)
{
    static const struct pel_flat sun = PEL_FLAT(PEL_RGB(255, 200, 40));
    static const struct pel_flat glass = PEL_FLAT(PEL_RGBA(90, 200, 255, 144));
    static const struct pel_point hill[4] = {
        PEL_AT(-3.5, 30), PEL_AT(17.2, 3.1), PEL_AT(44.9, 33.3), PEL_AT(50, 1)};
    static const pel_color slope[4] = {
        PEL_RGB(10, 60, 20), PEL_RGB(80, 250, 80), PEL_RGBA(200, 30, 90, 200),
        PEL_RGBA(255, 255, 255, 16)};
    const struct pel_point center = PEL_AT(35.5, 9), drop = PEL_AT(11, 17.7);
    pel_circle(s, center, PEL_PX(7.3), &sun.paint);
    pel_triangle_gouraud(s, hill, slope);
    pel_triangle_gouraud(s, hill + 1, slope + 1);
    pel_triangle(s, hill, &glass.paint);
    pel_circle(s, drop, PEL_PX(9), &glass.paint);
}

static enum pel_status draw(const struct pel_surface *s)
{
    static const pel_color blues[2] = {PEL_RGB(10, 20, 60),
                                       PEL_RGB(240, 120, 190)};
    static const struct pel_ramp ramp = {blues, 2, PEL_REFLECT};
    const struct pel_point from = PEL_AT(3, 1), to = PEL_AT(29.5, 22);
    struct pel_linear sky;
    struct pel_dither soft;
    enum pel_status status = pel_linear_init(&sky, from, to, &ramp);
    if (status == PEL_OK)
        status = pel_dither_init(&soft, &sky.base.paint);
    if (status == PEL_OK)
        pel_box(s, &s->bounds, &soft.paint);
    draw_shapes(s);
    return status;
}

/* By enum pel_format_id. */
static const uint32_t expected[PEL_FORMAT_GRAY2 + 1] = {
    0,          0x7C817372, 0x594B9C68, 0xBC8E8D42, 0x5730AABA, 0xC0CB67C9,
    0x190514B8, 0xC09F5E43, 0x30F9295B, 0x7C2AA800, 0x15CEF490, 0x7696331E,
    0x135A003E, 0x0849F292, 0x1DE60919, 0x8A426665, 0,          0,
    0,          0x045E9C54, 0x8FAA5CA2};

enum pel_status pel_selftest(const struct pel_format *format, void *memory,
                             size_t size)
{
    uint32_t crc = 0;
    if (!format)
        return PEL_ERROR_NULL;
    if (format->id > PEL_FORMAT_GRAY2 || !expected[format->id] ||
        !format->blend)
        return PEL_ERROR_FORMAT;
    const size_t band = (size_t)(WIDTH * LINES / 8 * format->bits);
    for (int32_t y = 0; y < HEIGHT; y += LINES) {
        const struct pel_rect lines = {0, y, WIDTH, y + LINES};
        struct pel_surface s;
        enum pel_status status =
            pel_surface_init(&s, format, memory, size, &lines);
        if (status == PEL_OK)
            status = draw(&s);
        if (status != PEL_OK)
            return status;
        crc = pel_crc(crc, memory, band);
    }
    return crc == expected[format->id] ? PEL_OK : PEL_ERROR_DEVICE;
}

/* A weak reference links nothing: it is NULL unless something else does. */
#if defined(__GNUC__) && defined(__ELF__)
#pragma weak pel_rgb565_le
#pragma weak pel_rgb565_be
#pragma weak pel_bgr565_le
#pragma weak pel_xrgb1555_le
#pragma weak pel_rgb888
#pragma weak pel_bgr888
#pragma weak pel_xrgb8888
#pragma weak pel_xbgr8888
#pragma weak pel_rgbx8888
#pragma weak pel_bgrx8888
#pragma weak pel_rgb332
#pragma weak pel_gray8
#pragma weak pel_gray4
#pragma weak pel_mono1
#pragma weak pel_mono1_pages
#pragma weak pel_inks2
#pragma weak pel_gray2
static const struct pel_format *const linked[] = {
    &pel_rgb565_le, &pel_rgb565_be, &pel_bgr565_le,   &pel_xrgb1555_le,
    &pel_rgb888,    &pel_bgr888,    &pel_xrgb8888,    &pel_xbgr8888,
    &pel_rgbx8888,  &pel_bgrx8888,  &pel_rgb332,      &pel_gray8,
    &pel_gray4,     &pel_mono1,     &pel_mono1_pages, &pel_inks2,
    &pel_gray2};
enum { LINKED = sizeof linked / sizeof *linked };
#else
static const struct pel_format *const linked[] = {NULL};
enum { LINKED = 0 };
#endif

enum pel_status pel_selftest_all(void *memory, size_t size)
{
    enum pel_status status = LINKED ? PEL_OK : PEL_ERROR_FORMAT;
    for (int i = 0; i < LINKED && status == PEL_OK; i++)
        if (linked[i])
            status = pel_selftest(linked[i], memory, size);
    return status;
}
