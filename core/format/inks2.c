#include "formats.h"

#define BITS 2
#define PAGES 0
#include "bits.inc"

enum ink { WHITE, BLACK, RED, YELLOW };

static PEL_HOT pel_color unpack(uint32_t ink)
{
    return ink == BLACK    ? PEL_RGB(0, 0, 0)
           : ink == RED    ? PEL_RGB(255, 0, 0)
           : ink == YELLOW ? PEL_RGB(255, 255, 0)
                           : PEL_RGB(255, 255, 255);
}

/* Black, red, yellow and white differ by one channel from each to the next. A
 * channel v is (255 - v)^2 - v^2 = 255 (255 - 2 v) nearer to 0 than to 255; so
 * those sums, divided by -255, tell how much nearer an ink is than black. They
 * are even for black and yellow, odd for red and white: of two that are as near
 * black comes before yellow, and white before red. */
static PEL_HOT uint32_t nearest(uint32_t red, uint32_t green, uint32_t blue)
{
    int32_t nearer = 2 * (int32_t)red - 255, most = 0;
    uint32_t ink = BLACK;
    if (nearer > most) {
        most = nearer;
        ink = RED;
    }
    nearer += 2 * (int32_t)green - 255;
    if (nearer > most) {
        most = nearer;
        ink = YELLOW;
    }
    nearer += 2 * (int32_t)blue - 255;
    return nearer >= most ? WHITE : ink;
}

static PEL_HOT uint32_t pack(pel_color c)
{
    return nearest(pel_red(c), pel_green(c), pel_blue(c));
}

static uint32_t blended(uint32_t ink, const struct pel_premultiplied *s)
{
    const pel_color d = unpack(ink);
    return nearest((pel_red(d) * s->rest + s->red) >> 16,
                   (pel_green(d) * s->rest + s->green) >> 16,
                   (pel_blue(d) * s->rest + s->blue) >> 16);
}

#include "body.inc"

const struct pel_format pel_inks2 = {
    .id = PEL_FORMAT_INKS2,
    .bits = BITS,
    .word = 1,
    .fill = fill_bits,
    .blend = blend,
    FUNCTIONS,
    WHOLE_CHANNELS,
};
