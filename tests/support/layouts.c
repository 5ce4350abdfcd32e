#include "layouts.h"

#include "check.h"

#define LAYOUT(name) #name, &pel_##name

const struct layout layouts[LAYOUT_COUNT] = {
    {LAYOUT(rgb565_le), 16, false, false, {11, 5}, {5, 6}, {0, 5}, 0, false},
    {LAYOUT(rgb565_be), 16, false, true, {11, 5}, {5, 6}, {0, 5}, 0, false},
    {LAYOUT(bgr565_le), 16, false, false, {0, 5}, {5, 6}, {11, 5}, 0, false},
    {LAYOUT(xrgb1555_le),
     16,
     false,
     false,
     {10, 5},
     {5, 5},
     {0, 5},
     0x8000,
     false},
    {LAYOUT(rgb888), 24, false, false, {16, 8}, {8, 8}, {0, 8}, 0, false},
    {LAYOUT(bgr888), 24, false, false, {0, 8}, {8, 8}, {16, 8}, 0, false},
    {LAYOUT(xrgb8888),
     32,
     false,
     false,
     {16, 8},
     {8, 8},
     {0, 8},
     0xFF000000,
     false},
    {LAYOUT(xbgr8888),
     32,
     false,
     false,
     {0, 8},
     {8, 8},
     {16, 8},
     0xFF000000,
     false},
    {LAYOUT(rgbx8888), 32, false, false, {24, 8}, {16, 8}, {8, 8}, 0xFF, false},
    {LAYOUT(bgrx8888), 32, false, false, {8, 8}, {16, 8}, {24, 8}, 0xFF, false},
    {LAYOUT(rgb332), 8, false, false, {5, 3}, {2, 3}, {0, 2}, 0, false},
    {LAYOUT(gray8), 8, true, false, {0, 8}, {0, 8}, {0, 8}, 0, false},
    {LAYOUT(gray4), 4, true, false, {0, 4}, {0, 4}, {0, 4}, 0, false},
    {LAYOUT(gray2), 2, true, false, {0, 2}, {0, 2}, {0, 2}, 0, false},
    {LAYOUT(mono1), 1, true, false, {0, 1}, {0, 1}, {0, 1}, 0, false},
    {LAYOUT(mono1_pages), 1, true, false, {0, 1}, {0, 1}, {0, 1}, 0, false},
    {LAYOUT(inks2), 2, false, false, {0, 0}, {0, 0}, {0, 0}, 0, true},
};

const struct layout *layout_of(const struct pel_format *format)
{
    for (int i = 0; i < LAYOUT_COUNT; i++)
        if (layouts[i].format->id == format->id)
            return &layouts[i];
    return NULL;
}

static uint32_t swapped(const struct layout *l, uint32_t v)
{
    return l->swapped ? (v & 255) << 8 | v >> 8 : v;
}

static uint32_t channel_in(const int field[2], uint32_t value)
{
    return value >> (8 - field[1]) << field[0];
}

/* The n bits again and again until there are 8. */
static uint32_t channel_out(const int field[2], uint32_t pixel)
{
    uint32_t bits = pixel >> field[0] & ((1u << field[1]) - 1), v = 0;
    int n = 0;
    for (; n < 8; n += field[1])
        v = v << field[1] | bits;
    return v >> (n - 8);
}

static const pel_color inks[4] = {0xFFFFFFFF, 0xFF000000, 0xFFFF0000,
                                  0xFFFFFF00};

/* By the squares of all distances. */
static uint32_t nearest_ink(const int32_t want[3])
{
    uint32_t best = 0;
    int32_t least = INT32_MAX;
    for (uint32_t i = 0; i < 4; i++) {
        int32_t sum = 0;
        for (int k = 0; k < 3; k++) {
            const int32_t off = (int32_t)(inks[i] >> 8 * k & 255) - want[k];
            sum += off * off;
        }
        if (sum >= least)
            continue;
        least = sum;
        best = i;
    }
    return best;
}

uint32_t layout_pack(const struct layout *l, pel_color color)
{
    uint32_t r = color >> 16 & 255, g = color >> 8 & 255, b = color & 255;
    if (l->inks)
        return nearest_ink((int32_t[]){(int32_t)b, (int32_t)g, (int32_t)r});
    if (l->gray)
        return channel_in(l->red, (77 * r + 150 * g + 29 * b + 128) / 256);
    return swapped(l, channel_in(l->red, r) | channel_in(l->green, g) |
                          channel_in(l->blue, b) | l->unused);
}

pel_color layout_unpack(const struct layout *l, uint32_t pixel)
{
    if (l->inks)
        return inks[pixel];
    pixel = swapped(l, pixel);
    return UINT32_C(0xFF000000) | channel_out(l->red, pixel) << 16 |
           channel_out(l->green, pixel) << 8 | channel_out(l->blue, pixel);
}

pel_color layout_mix(pel_color d, pel_color s, uint32_t a)
{
    pel_color result = UINT32_C(0xFF000000);
    for (int shift = 0; shift < 24; shift += 8) {
        uint32_t t = (s >> shift & 255) * a + (d >> shift & 255) * (255 - a);
        result |= (2 * t + 255) / 510 << shift;
    }
    return result;
}

uint32_t layout_over(const struct layout *l, uint32_t pixel, pel_color color)
{
    if (color >> 24 == 0)
        return pixel;
    return layout_pack(l,
                       layout_mix(layout_unpack(l, pixel), color, color >> 24));
}

struct pel_surface surface_of(const struct pel_format *format, void *memory,
                              size_t size, int32_t width, int32_t height)
{
    const struct pel_rect bounds = {0, 0, width, height};
    struct pel_surface s;
    assert_int_equal(pel_surface_init(&s, format, memory, size, &bounds),
                     PEL_OK);
    return s;
}
