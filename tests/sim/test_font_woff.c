/* Fonts of WOFF beside what was packed in them. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "sim/font/font.h"
#include "tests/support/check.h"

static const char path[] = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

static bool is_ascii(long code)
{
    return code < 127;
}

static uint32_t word_at(const uint8_t *p)
{
    return (uint32_t)p[0] << 24 | (uint32_t)p[1] << 16 | (uint32_t)p[2] << 8 |
           p[3];
}

static void put_word(uint8_t *p, uint32_t v)
{
    for (int i = 0; i < 4; i++)
        p[i] = (uint8_t)(v >> (24 - 8 * i));
}

enum { SFNT_HEAD = 12, SFNT_ENTRY = 16, WOFF_HEAD = 44, WOFF_ENTRY = 20 };

/* The tables of an sfnt as WOFF, none of them packed; returns its size. */
static size_t make_woff(uint8_t *to, const uint8_t *from)
{
    const uint32_t n = word_at(from + 4) >> 16;
    size_t size = WOFF_HEAD + (size_t)n * WOFF_ENTRY;
    for (uint32_t i = 0; i < n; i++) {
        const uint8_t *const entry = from + SFNT_HEAD + i * SFNT_ENTRY;
        const uint32_t length = word_at(entry + 12);
        uint8_t *const woff = to + WOFF_HEAD + i * WOFF_ENTRY;
        memcpy(woff, entry, 4);
        put_word(woff + 4, (uint32_t)size);
        put_word(woff + 8, length);
        put_word(woff + 12, length);
        memcpy(woff + 16, entry + 4, 4);
        memcpy(to + size, from + word_at(entry + 8), length);
        size += (length + 3) & ~(size_t)3;
    }
    put_word(to, 0x774F4646);
    memcpy(to + 4, from, 4);
    put_word(to + 8, (uint32_t)size);
    put_word(to + 12, n << 16);
    put_word(to + 16, (uint32_t)(size - WOFF_HEAD - n * WOFF_ENTRY + SFNT_HEAD +
                                 n * SFNT_ENTRY));
    return size;
}

/* What FreeType unpacks has the glyphs and the pairs of what was packed. */
TEST(woff_is_what_was_packed)
{
    enum { MOST = 1 << 20 };
    static const struct font_options options = {
        .size = 20, .bits = 4, .is_wanted = is_ascii};
    static uint8_t sfnt[MOST], woff[2 * MOST];
    char name[] = "/tmp/pel-woff-XXXXXX";
    const int out = mkstemp(name);
    FILE *in = fopen(path, "rb");
    struct font font, packed;
    assert_true(in && out >= 0);
    assert_true(fread(sfnt, 1, MOST, in) > 0 && feof(in));
    const size_t size = make_woff(woff, sfnt);
    assert_int_equal(write(out, woff, size), size);
    fclose(in);
    close(out);
    assert_true(font_load(&font, path, &options));
    const bool loaded = font_load(&packed, name, &options);
    unlink(name);
    assert_true(loaded && font.pair_count > 0);
    assert_int_equal(packed.pair_count, font.pair_count);
    assert_memory_equal(packed.pairs, font.pairs,
                        font.pair_count * sizeof *font.pairs);
    assert_int_equal(packed.size, font.size);
    assert_memory_equal(packed.bits, font.bits, font.size);
    font_free(&packed);
    font_free(&font);
}
