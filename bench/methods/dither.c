#include <pel/pel.h>

#include "color.h"

static int widened(int five)
{
    return five << 3 | five >> 2;
}

/* Green would have 6 bits: red is shown. */
static int pel(int channel, int x, int y)
{
    static uint16_t pixel[64];
    static int drawn = -1;
    if (drawn != channel) {
        const struct pel_rect bounds = {0, 0, 8, 8};
        const struct pel_point corner[2] = {PEL_AT(0, 0), PEL_AT(8, 8)};
        const struct pel_flat flat = PEL_FLAT(PEL_RGB(channel, 0, 0));
        struct pel_surface s;
        struct pel_dither dither;
        if (pel_surface_init(&s, &pel_rgb565_le, pixel, sizeof pixel,
                             &bounds) ||
            pel_dither_init(&dither, &flat.paint))
            return -1;
        pel_rectangle(&s, corner[0], corner[1], &dither.paint);
        drawn = channel;
    }
    return (int)pel_red(pel_rgb565_le.unpack(pixel[8 * (y & 7) + (x & 7)]));
}

static int truncated(int channel, int x, int y)
{
    (void)x;
    (void)y;
    return widened(channel >> 3);
}

static int nearest(int channel, int x, int y)
{
    (void)x;
    (void)y;
    return widened((channel * 62 + 255) / 510);
}

/* The 4 x 4 matrix of Bayer, its steps in the middle of sixteenths. */
static int ordered(int channel, int x, int y)
{
    static const int rank[4][4] = {
        {0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
    const int threshold = (2 * rank[y & 3][x & 3] + 1) * 255;
    return widened((channel * 31 * 32 + threshold) / (255 * 32));
}

const struct dither_method dither_methods[] = {
    {"pel 8x8", pel},
    {"truncated", truncated},
    {"nearest", nearest},
    {"ordered 4x4", ordered},
    {0, 0},
};
