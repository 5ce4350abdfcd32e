/* One run of one color, opaque and blended: every length from 0 to 40 px (and
 * to 150 opaque), every place against 16 bytes, every alpha; over pixels whose
 * bits are random, unused ones included. Every byte is judged by the formats'
 * rule, those around the run too. */
#include <string.h>

#include "tests/support/cases.h"
#include "tests/support/check.h"
#include "tests/support/layouts.h"

enum { PIXELS = 200, LENGTH_MAX = 150 };

static uint32_t memory[PIXELS], before[PIXELS];

static uint32_t pixel_at(const uint32_t *from, const struct layout *l,
                         int32_t i)
{
    const uint8_t *p = (const uint8_t *)from + i * l->bits / 8;
    uint32_t v = 0;
    for (int k = 0; k < l->bits; k += 8)
        v |= (uint32_t)*p++ << k;
    return v;
}

static void check_run(const struct layout *l, int32_t from, int32_t n,
                      pel_color color)
{
    const struct pel_flat flat = PEL_FLAT(color);
    const int32_t count = (int32_t)sizeof memory * 8 / l->bits;
    struct pel_surface s;
    s = surface_of(l->format, memory, sizeof memory, count, 1);
    memcpy(memory, before, sizeof memory);
    pel_rectangle(&s, (struct pel_point){PEL_PX(from), 0},
                  (struct pel_point){PEL_PX(from + n), 256}, &flat.paint);
    for (int32_t i = 0; i < count; i++) {
        uint32_t want = pixel_at(before, l, i);
        if (i >= from && i < from + n)
            want = layout_over(l, want, color);
        if (pixel_at(memory, l, i) != want)
            fail_msg("%s, %d pixels from %d, colour %08x: pixel %d: before %x, "
                     "expected %x, got %x",
                     l->name, n, from, color, i, pixel_at(before, l, i), want,
                     pixel_at(memory, l, i));
    }
}

static void setup(void)
{
    struct random r = {1};
    for (int i = 0; i < PIXELS; i++)
        before[i] = random_word(&r);
}

static bool is_words(const struct layout *l)
{
    return l->bits >= 8;
}

TEST(opaque)
{
    for (int f = 0; f < LAYOUT_COUNT; f++) {
        const struct layout *l = &layouts[f];
        for (int32_t from = 0; is_words(l) && from < 16; from++)
            for (int32_t n = 0; n <= LENGTH_MAX; n++)
                check_run(l, from, n, 0xFF9ABCDE);
    }
}

TEST(blended)
{
    for (int f = 0; f < LAYOUT_COUNT; f++) {
        const struct layout *l = &layouts[f];
        for (int32_t from = 0; is_words(l) && from < 16; from++)
            for (int32_t n = 0; n <= 40; n++)
                check_run(l, from, n, 0x5F9ABCDE + (pel_color)n * 0x1010305);
    }
}

/* Nothing is read behind the surface: address sanitizers look at its end. */
TEST(last_pixels)
{
    for (int f = 0; f < LAYOUT_COUNT; f++) {
        const struct layout *l = &layouts[f];
        const int32_t count = (int32_t)sizeof memory * 8 / l->bits;
        for (int32_t n = 1; is_words(l) && n <= 40; n++) {
            check_run(l, count - n, n, 0xFF9ABCDE);
            check_run(l, count - n, n, 0x5F9ABCDE);
        }
    }
}

int main(void)
{
    setup();
    return run_all_tests();
}
