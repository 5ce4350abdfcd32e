/* Every value: the mix of two channels, every pixel and color of every format,
 * through pack and unpack and through memory, and every blend of a channel. */
#include <string.h>

#include "tests/support/cases.h"
#include "tests/support/check.h"
#include "tests/support/layouts.h"

/* From one value of 24 bits to the next that is tried: 1, or an odd number that
 * reaches all bits where PEL_SCALE asks for less. */
static uint32_t step(void)
{
    return (1u << 24) / (uint32_t)cases_scaled(1u << 24) | 1;
}

TEST(all_mixes)
{
    for (uint32_t a = 0; a < 256; a++)
        for (uint32_t s = 0; s < 256; s++)
            for (uint32_t d = 0; d < 256; d++) {
                uint32_t want = (2 * (s * a + d * (255 - a)) + 255) / 510;
                pel_color got = pel_mix(d * 0x010101u, s * 0x010101u, a);
                if (got != (0xFF000000u | want * 0x010101u))
                    fail_msg("s %u, d %u, a %u: expected %u, got %08x", s, d, a,
                             want, got);
            }
}

/* A channel does not reach into its neighbours. */
TEST(mixes_of_one_channel)
{
    for (uint32_t a = 0; a < 256; a++)
        for (uint32_t s = 0; s < 256; s++)
            for (int shift = 0; shift < 24; shift += 8) {
                pel_color low = pel_mix(0, s << shift, a);
                pel_color high = pel_mix(~(s << shift), 0xFFFFFFFFu, a);
                assert_int_equal(low, layout_mix(0, s << shift, a));
                assert_int_equal(high,
                                 layout_mix(~(s << shift), 0xFFFFFFFFu, a));
            }
}

TEST(round_div255)
{
    for (uint32_t t = 0; t <= 255 * 255; t++)
        assert_int_equal(pel_round_div255(t), (2 * t + 255) / 510);
}

/* pack and unpack work on the CPU's value of the word; memory has its bytes. */
static uint32_t in_memory(const struct layout *l, uint32_t pixel)
{
    uint8_t byte[4] = {0, 0, 0, 0};
    uint16_t half = (uint16_t)pixel;
    uint32_t v = 0;
    if (l->bits == 32)
        memcpy(byte, &pixel, 4);
    else if (l->bits == 16)
        memcpy(byte, &half, 2);
    else
        return pixel;
    for (int i = 3; i >= 0; i--)
        v = v << 8 | byte[i];
    return v;
}

static void check_pixels(const struct layout *l)
{
    const uint32_t count = l->bits < 24 ? 1u << l->bits : 1u << 24;
    const uint32_t apart = count < 1u << 24 ? 1 : step();
    for (uint32_t i = 0; i < count; i += apart) {
        uint32_t p =
            l->bits == 32 && l->unused == 0xFF ? i << 8 | 0xFF : i | l->unused;
        uint32_t word = in_memory(l, p); /* an involution on every CPU */
        pel_color c = l->format->unpack(word);
        if (c != layout_unpack(l, p) || l->format->pack(c) != word)
            fail_msg("%s: pixel %x: unpacked %08x, expected %08x; packed %x",
                     l->name, p, c, layout_unpack(l, p), l->format->pack(c));
    }
}

TEST(channels_are_taken_modulo_256)
{
    const uint8_t byte = 200;
    assert_int_equal(PEL_RGBA(256, -1, 511, 1000), 0xE800FFFF);
    assert_int_equal(PEL_RGB(byte + byte, INT32_MIN, UINT64_MAX), 0xFF9000FF);
}

TEST(all_pixels)
{
    for (int f = 0; f < LAYOUT_COUNT; f++)
        check_pixels(&layouts[f]);
}

/* Alpha is ignored. */
TEST(all_colors)
{
    const uint32_t apart = step();
    for (int f = 0; f < LAYOUT_COUNT; f++) {
        const struct layout *l = &layouts[f];
        for (uint32_t c = 0; c < 1u << 24; c += apart) {
            uint32_t got = in_memory(l, l->format->pack(c ^ c << 24));
            if (got != layout_pack(l, c))
                fail_msg("%s: colour %06x: expected %x, got %x", l->name, c,
                         layout_pack(l, c), got);
        }
    }
}

/* One color over the first n pixels, by runs of `length`, or by put when 0. */
static void draw(const struct pel_surface *s, int n, pel_color color,
                 int length)
{
    pel_color colors[256];
    for (int i = 0; i < n; i++)
        colors[i] = color;
    if (length == 0)
        s->format->put(s, 0, 0, n, colors);
    for (int x = 0; length != 0 && x < n; x += length) {
        const struct pel_span row = {x, x + length};
        s->format->blend(&(struct pel_spans){s, &row, 0, 1, 1}, color);
    }
}

/* Over a line that has every value of every channel: red and blue rise from 0,
 * green falls to 0. */
static void check_blends(const struct layout *l, pel_color color)
{
    pel_color memory[256], below[256], want[256], got[256];
    const int n = 1 << l->green[1]; /* the widest channel's values */
    struct pel_surface s;
    for (int i = 0; i < n; i++) {
        const int v = 256 / n * i;
        below[i] = PEL_RGB(v, 255 - v, v);
        want[i] =
            layout_unpack(l, layout_over(l, layout_pack(l, below[i]), color));
    }
    const struct pel_rect line = {0, 0, n, 1};
    assert_int_equal(
        pel_surface_init(&s, l->format, memory, sizeof memory, &line), PEL_OK);
    for (int length = 0; length <= n; length = length ? 4 * length : 1) {
        s.format->put(&s, 0, 0, n, below);
        draw(&s, n, color, length);
        s.format->load(&s, 0, 0, n, got);
        for (int i = 0; i < n; i++)
            if (got[i] != want[i])
                fail_msg("%s: %08x over %06x in runs of %d: expected %08x, got "
                         "%08x",
                         l->name, color, below[i] & 0xFFFFFFu, length, want[i],
                         got[i]);
    }
}

/* Every source and alpha, but for channels of 8 bits, which are mixed as in
 * test_all_mixes. */
TEST(all_blends)
{
    for (int f = 0; f < LAYOUT_COUNT; f++) {
        const int apart = layouts[f].green[1] == 8 ? 15 : 1;
        for (int a = 0; a < 255; a++)
            for (int v = 0; v < 256; v += apart)
                check_blends(&layouts[f], PEL_RGBA(v, 255 - v, v, a));
    }
}
