/* What a polygon refuses, and with which code; nothing is drawn then. */
#include <string.h>

#include "tests/support/check.h"
#include "tests/support/hits.h"

enum { WORDS = 9 * 8, NEED = 4 * 36 + 20 };

static struct hits hits;
static uint32_t scratch[WORDS + 2];
static const struct pel_point square[4] = {PEL_AT(1, 1), PEL_AT(5, 1),
                                           PEL_AT(5, 5), PEL_AT(1, 5)};

static void setup(void)
{
    const struct pel_rect bounds = {0, 0, 8, 8};
    hits_open(&hits, &bounds);
    hits.limit = 255;
    memset(scratch, 0x5A, sizeof scratch);
}

/* The status, and what was drawn: the square or nothing. */
static void expect(enum pel_status want, const struct pel_polygon_shape *p,
                   void *memory, size_t size)
{
    const uint64_t before = hits.pixels;
    const enum pel_status got =
        pel_polygon(&hits.surface, p, &hits.paint, memory, size);
    if (got != want)
        fail_msg("expected %d, got %d", want, got);
    assert_int_equal(hits.pixels - before,
                     want == PEL_OK && p->n == 4 ? 16 : 0);
}

TEST(scratch_size)
{
    static char polygon[PEL_POLYGON_SCRATCH_SIZE(9)];
    static char rim[PEL_POLYGON_OUTLINE_SCRATCH_SIZE(9)];
    assert_int_equal(pel_polygon_scratch_size(0), 0);
    assert_int_equal(pel_polygon_scratch_size(-1), 0);
    assert_int_equal(pel_polygon_scratch_size(INT32_MIN), 0);
    assert_int_equal(pel_polygon_scratch_size(4), NEED);
    assert_int_equal(pel_polygon_scratch_size(9), sizeof polygon);
    assert_int_equal(pel_polygon_outline_scratch_size(9), sizeof rim);
    assert_true(pel_polygon_scratch_size(100000) == (size_t)100000 * 36 + 20);
    if (sizeof(size_t) > 4)
        assert_true(pel_polygon_scratch_size(INT32_MAX) ==
                    (size_t)INT32_MAX * 36 + 20);
}

TEST(smooth_scratch_size)
{
    static char polygon[PEL_SMOOTH_POLYGON_SCRATCH_SIZE(9, 40)];
    static const struct pel_point v[3] = {PEL_AT(1, 1), PEL_AT(3, 1),
                                          PEL_AT(2, 3)};
    const struct pel_polygon_shape shape = {v, 3, PEL_EVEN_ODD};
    const size_t need = pel_smooth_polygon_scratch_size(3, 8);
    static uint64_t memory[100];
    setup();
    assert_int_equal(pel_smooth_polygon_scratch_size(9, 40), sizeof polygon);
    assert_int_equal(pel_smooth_polygon_scratch_size(0, 40), 0);
    assert_int_equal(pel_smooth_polygon_scratch_size(9, -1), 0);
    assert_int_equal(pel_smooth_polygon_scratch_size(INT32_MIN, INT32_MIN), 0);
    if (sizeof(size_t) > 4)
        assert_true(pel_smooth_polygon_scratch_size(INT32_MAX, INT32_MAX) ==
                    (size_t)INT32_MAX * 52 + ((size_t)INT32_MAX + 1) * 4 +
                        52 * sizeof(void *));
    assert_int_equal(pel_smooth_polygon(&hits.surface, &shape, &hits.paint,
                                        memory, need - 1),
                     PEL_ERROR_SCRATCH);
}

/* Fewer than three vertices cover nothing and need no memory; that of too many
 * is refused before a vertex is looked at. */
TEST(what_is_refused)
{
    static const struct {
        const struct pel_point *v;
        int32_t n;
        void *memory;
        size_t size;
        enum pel_status status;
    } rows[] = {
        {square, 4, scratch, NEED, PEL_OK},
        {square, 4, scratch + 1, NEED, PEL_OK},
        {square, 4, (char *)scratch + 1, 4 * WORDS, PEL_ERROR_SCRATCH},
        {square, 4, (char *)scratch + 2, 4 * WORDS, PEL_ERROR_SCRATCH},
        {square, 4, (char *)scratch + 3, 4 * WORDS, PEL_ERROR_SCRATCH},
        {NULL, 4, scratch, sizeof scratch, PEL_ERROR_NULL},
        {square, 4, NULL, 1000, PEL_ERROR_NULL},
        {square, 2, scratch, sizeof scratch, PEL_OK},
        {square, 2, NULL, 0, PEL_OK},
        {square, 0, NULL, 0, PEL_OK},
        {square, -1, NULL, 0, PEL_OK},
        {square, INT32_MIN, NULL, 0, PEL_OK},
        {square, INT32_MAX, scratch, sizeof scratch, PEL_ERROR_SCRATCH},
        {square, INT32_MAX / 36, scratch, sizeof scratch, PEL_ERROR_SCRATCH},
        {square, 1 << 26, scratch, 0, PEL_ERROR_SCRATCH}};
    const struct pel_polygon_shape p = {square, 4, PEL_EVEN_ODD};
    setup();
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const struct pel_polygon_shape row = {rows[i].v, rows[i].n,
                                              PEL_NON_ZERO};
        expect(rows[i].status, &row, rows[i].memory, rows[i].size);
        if (i == 0) /* no byte more than asked for */
            assert_int_equal(scratch[NEED / 4], 0x5A5A5A5A);
    }
    for (size_t size = 0; size < NEED; size++)
        expect(PEL_ERROR_SCRATCH, &p, scratch, size);
    assert_int_equal(
        pel_polygon(&hits.surface, NULL, &hits.paint, scratch, NEED),
        PEL_ERROR_NULL);
    assert_int_equal(pel_polygon(NULL, &p, &hits.paint, scratch, NEED),
                     PEL_ERROR_NULL);
    assert_int_equal(pel_polygon(&hits.surface, &p, NULL, scratch, NEED),
                     PEL_ERROR_NULL);
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

/* Outlines of which no row is visible, and an empty clip, are no errors. */
TEST(nothing_to_see)
{
    const struct pel_rect none = {3, 3, 3, 8};
    static const struct pel_point flat[3] = {{0, 10}, {500, 10}, {900, 10}};
    const struct pel_polygon_shape p = {flat, 3, PEL_NON_ZERO};
    setup();
    expect(PEL_OK, &p, scratch, sizeof scratch);
    pel_surface_clip(&hits.surface, &none);
    expect(PEL_OK, &p, scratch, sizeof scratch);
}
