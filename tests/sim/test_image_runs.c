/* What pel import makes of pictures in runs: drawn, they are the pictures; they
 * take no more than pixels as they are and a count for each row of them. */
#include <string.h>

#include "core/pel.h"
#include "sim/image/runs.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"
#include "tests/support/layouts.h"

enum { SIDE = 70 };

static uint8_t memory[SIDE * SIDE * 4], plain[SIDE * SIDE * 4],
    drawn[SIDE * SIDE * 4];

/* Rows of runs of bytes that are often equal, to each other too. */
static void fill(uint8_t *row, size_t n, struct random *r)
{
    const uint8_t bytes[] = {0, 255, 0x77, (uint8_t)random_word(r)};
    for (size_t i = 0; i < n; i++)
        row[i] = i > 3 && random_word(r) % 8
                     ? row[i - (random_word(r) % 8 ? 4 : 1)]
                     : bytes[random_word(r) % 4];
}

TEST(runs_are_the_picture)
{
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        struct random *r = &c.random;
        const struct pel_format *f = layouts[c.next % LAYOUT_COUNT].format;
        if (f == &pel_mono1_pages)
            f = &pel_argb8888;
        const int32_t width = random_between(r, 1, SIDE);
        const int32_t height = random_between(r, 1, SIDE);
        const struct pel_surface s =
            surface_of(f, memory, sizeof memory, width, height);
        const struct pel_surface shown[2] = {
            surface_of(&pel_xrgb8888, plain, sizeof plain, width, height),
            surface_of(&pel_xrgb8888, drawn, sizeof drawn, width, height)};
        const size_t stride = (size_t)s.stride;
        for (int32_t y = 0; y < height; y++)
            if (y > 0 && random_word(r) % 3 == 0)
                memcpy(memory + (size_t)y * stride,
                       memory + (size_t)random_between(r, 0, y - 1) * stride,
                       stride);
            else
                fill(memory + (size_t)y * stride, stride, r);
        pel_clear(&shown[0], PEL_RGB(9, 80, 200));
        pel_clear(&shown[1], PEL_RGB(9, 80, 200));
        pel_copy_alpha(&shown[0], &(struct pel_copy_part){&s, s.bounds, 0, 0},
                       255);
        struct runs runs;
        assert_true(runs_make(&runs, &s));
        assert_true(runs_are_short(&runs));
        const size_t words = stride / runs.bytes;
        assert_true(runs.size <= (words + 1) * (size_t)height);
        const struct pel_runs_asset asset = {
            PEL_RUNS_MAGIC,   PEL_RUNS_VERSION, f->id,      (uint16_t)width,
            (uint16_t)height, runs.size,        runs.words, NULL,
            runs.rows};
        assert_int_equal(pel_runs_asset_check(&asset, f), PEL_OK);
        pel_copy_runs(&shown[1], &(struct pel_runs_part){&asset, f, 0, 0}, 255);
        runs_free(&runs);
        assert_memory_equal(plain, drawn, (size_t)(width * height) * 4);
    }
}

/* Small pictures, and what they become. */
static const struct {
    const struct pel_format *format;
    int32_t width, height;
    const char *pixels, *words;
    size_t size; /* bytes of words */
} pictures[] = {
    /* A run; two beside it are no longer as a run; one alone. */
    {&pel_gray8, 6, 1, "aaaaaa",
     "\x0D"
     "a",
     2},
    {&pel_gray8, 6, 1, "aaabbc",
     "\x07"
     "a\x06"
     "bbc",
     6},
    {&pel_gray8, 6, 1, "aabbcc",
     "\x05"
     "a\x05"
     "b\x05"
     "c",
     6},
    {&pel_gray8, 6, 1, "abaaab",
     "\x04"
     "ab\x07"
     "a\x02"
     "b",
     7},
    {&pel_gray8, 6, 1, "abaaba",
     "\x0C"
     "abaaba",
     7},
    {&pel_gray8, 3, 1, "abb",
     "\x06"
     "abb",
     4},
    /* Rows that are equal. */
    {&pel_gray8, 3, 3, "aaabbbaaa",
     "\x07"
     "a\x07"
     "b",
     4},
    /* Words of two bytes and of four. */
    {&pel_rgb565_le, 3, 1, "ababab", "\x07\0ab", 4},
    {&pel_argb8888, 2, 1, "abcdabcd", "\x05\0\0\0abcd", 8},
    /* Runs of equal pixels alone; the end of a row belongs to one. */
    {&pel_mono1, 28, 1, "\xFF\xFF\xFF\xF0", "\x09\xFF", 2},
    {&pel_mono1, 27, 1, "\0\0\0\x1F", "\x09\0", 2},
    {&pel_mono1, 24, 1, "\xF0\xF0\xF0", "\x06\xF0\xF0\xF0", 4},
    {&pel_gray4, 7, 1, "\x77\x77\x77\x70", "\x09\x77", 2},
    {&pel_gray4, 5, 1, "\x12\x12\x12", "\x06\x12\x12\x11", 4},
};

TEST(words)
{
    for (size_t i = 0; i < sizeof pictures / sizeof *pictures; i++) {
        const struct pel_format *f = pictures[i].format;
        const int32_t width = pictures[i].width, height = pictures[i].height;
        struct runs runs;
        print_message("%zu\n", i);
        memcpy(memory, pictures[i].pixels,
               (size_t)(pel_stride(f, width) * height));
        const struct pel_surface s =
            surface_of(f, memory, sizeof memory, width, height);
        assert_true(runs_make(&runs, &s));
        assert_int_equal(runs.size * runs.bytes, pictures[i].size);
        assert_memory_equal(runs.words, pictures[i].words, pictures[i].size);
        runs_free(&runs);
    }
}
