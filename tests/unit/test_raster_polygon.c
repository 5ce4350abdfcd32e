/* What a polygon refuses, and with which code; nothing is drawn then. */
#include <string.h>

#include "tests/support/check.h"
#include "tests/support/hits.h"

enum { WORDS = 9 * 8 };

static struct hits hits;
static uint32_t scratch[WORDS + 2];
static const struct pel_point square[4] = {PEL_AT(1, 1), PEL_AT(5, 1),
                                           PEL_AT(5, 5), PEL_AT(1, 5)};
static const struct pel_polygon_shape outline = {square, 4, PEL_EVEN_ODD};

static void setup(void)
{
    const struct pel_rect bounds = {0, 0, 8, 8};
    hits_open(&hits, &bounds);
    memset(scratch, 0x5A, sizeof scratch);
}

/* The status, and what of `outline` was drawn: all or nothing. */
static void expect(enum pel_status want, const struct pel_polygon_shape *p,
                   void *memory, size_t size)
{
    const uint64_t before = hits.pixels;
    enum pel_status got =
        pel_polygon(&hits.surface, p, &hits.paint, memory, size);
    if (got != want)
        fail_msg("expected %d, got %d", want, got);
    if (want != PEL_OK)
        assert_int_equal(hits.pixels, before);
}

TEST(scratch_size)
{
    assert_int_equal(pel_polygon_scratch_size(0), 0);
    assert_int_equal(pel_polygon_scratch_size(-1), 0);
    assert_int_equal(pel_polygon_scratch_size(INT32_MIN), 0);
    assert_int_equal(pel_polygon_scratch_size(4), 4 * 36);
    static char polygon[PEL_POLYGON_SCRATCH_SIZE(9)];
    static char rim[PEL_POLYGON_OUTLINE_SCRATCH_SIZE(9)];
    assert_int_equal(pel_polygon_scratch_size(9), sizeof polygon);
    assert_int_equal(pel_polygon_outline_scratch_size(9), sizeof rim);
    assert_true(pel_polygon_scratch_size(100000) == (size_t)100000 * 36);
    if (sizeof(size_t) > 4)
        assert_true(pel_polygon_scratch_size(INT32_MAX) ==
                    (size_t)INT32_MAX * 36);
}

TEST(exact_size_is_enough)
{
    setup();
    expect(PEL_OK, &outline, scratch, 4 * 36);
    assert_int_equal(hits.pixels, 16);
    for (size_t i = 36; i < sizeof scratch / sizeof scratch[0]; i++)
        assert_int_equal(scratch[i], 0x5A5A5A5A);
}

TEST(small_scratch_is_refused)
{
    setup();
    for (size_t size = 0; size < 4 * 36; size++)
        expect(PEL_ERROR_SCRATCH, &outline, scratch, size);
}

TEST(misaligned_scratch_is_refused)
{
    setup();
    for (size_t offset = 1; offset < 4; offset++)
        expect(PEL_ERROR_SCRATCH, &outline, (uint8_t *)scratch + offset,
               4 * WORDS);
    expect(PEL_OK, &outline, (uint8_t *)scratch + 4, 4 * 36);
}

TEST(null_is_refused)
{
    const struct pel_polygon_shape without_points = {NULL, 4, PEL_EVEN_ODD};
    setup();
    expect(PEL_ERROR_NULL, &without_points, scratch, sizeof scratch);
    expect(PEL_ERROR_NULL, &outline, NULL, 1000);
    expect(PEL_ERROR_NULL, NULL, scratch, sizeof scratch);
    assert_int_equal(
        pel_polygon(NULL, &outline, &hits.paint, scratch, sizeof scratch),
        PEL_ERROR_NULL);
    assert_int_equal(
        pel_polygon(&hits.surface, &outline, NULL, scratch, sizeof scratch),
        PEL_ERROR_NULL);
}

/* Fewer than three vertices cover nothing and need no memory. */
TEST(few_vertices)
{
    static const int32_t few[] = {2, 1, 0, -1, INT32_MIN};
    setup();
    for (size_t i = 0; i < sizeof few / sizeof few[0]; i++) {
        const struct pel_polygon_shape p = {square, few[i], PEL_NON_ZERO};
        expect(PEL_OK, &p, scratch, sizeof scratch);
        expect(PEL_OK, &p, NULL, 0);
    }
    assert_int_equal(hits.batches, 0);
}

/* The memory is refused before a vertex is looked at. */
TEST(huge_counts_are_refused)
{
    static const int32_t huge[] = {INT32_MAX, INT32_MAX / 36, 1 << 26};
    setup();
    for (size_t i = 0; i < sizeof huge / sizeof huge[0]; i++) {
        const struct pel_polygon_shape p = {square, huge[i], PEL_NON_ZERO};
        expect(PEL_ERROR_SCRATCH, &p, scratch, sizeof scratch);
        expect(PEL_ERROR_SCRATCH, &p, scratch, 0);
    }
}

/* Whatever the clip, as the fill is. */
TEST(outlines_out_of_range_are_refused)
{
    static uint32_t memory[PEL_POLYGON_OUTLINE_SCRATCH_SIZE(3) / 4];
    static const struct pel_point v[3] = {
        PEL_AT(1, 1), PEL_AT(5, 1), {0, PEL_COORDINATE_MAX + 1}};
    const struct pel_polygon_shape p = {v, 3, PEL_EVEN_ODD};
    const struct pel_rect clips[2] = {{0, 0, 8, 8}, {3, 3, 3, 8}};
    setup();
    for (int i = 0; i < 2; i++) {
        pel_surface_clip(&hits.surface, &clips[i]);
        assert_int_equal(pel_polygon_outline(&hits.surface, &p, &hits.paint,
                                             memory, sizeof memory),
                         PEL_ERROR_RANGE);
    }
}

/* An empty clip, and outlines of which no row is visible, are no errors. */
TEST(nothing_to_see)
{
    const struct pel_rect none = {3, 3, 3, 8};
    static const struct pel_point flat[3] = {{0, 10}, {500, 10}, {900, 10}};
    const struct pel_polygon_shape p = {flat, 3, PEL_NON_ZERO};
    setup();
    expect(PEL_OK, &p, scratch, sizeof scratch);
    pel_surface_clip(&hits.surface, &none);
    expect(PEL_OK, &outline, scratch, sizeof scratch);
    assert_int_equal(hits.pixels, 0);
}
