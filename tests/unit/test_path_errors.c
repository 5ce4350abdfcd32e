/* What paths and strokes refuse, and with which code; nothing is drawn then. */
#include <string.h>

#include "core/pel.h"
#include "tests/support/check.h"

enum { SIDE = 8, WORDS = 400 };

static uint8_t pixels[SIDE * SIDE];
static struct pel_surface window;
static const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));
static uint64_t scratch[WORDS];
static const uint8_t verbs[] = {PEL_MOVE, PEL_LINE, PEL_LINE, PEL_CLOSE};
static const int16_t points[] = {256, 256, 1280, 256, 1280, 1280};
static const struct pel_path triangle = {verbs, points, NULL, 4, 3};
static const struct pel_path_shape plain = {.path = &triangle,
                                            .stroke = {.width = 256}};

static void open_window(void)
{
    const struct pel_rect bounds = {0, 0, SIDE, SIDE};
    memset(pixels, 0, sizeof pixels);
    memset(scratch, 0x5A, sizeof scratch);
    assert_int_equal(
        pel_surface_init(&window, &pel_gray8, pixels, sizeof pixels, &bounds),
        PEL_OK);
}

static bool is_drawn(void)
{
    for (int i = 0; i < SIDE * SIDE; i++)
        if (pixels[i])
            return true;
    return false;
}

/* Fill, stroke, smooth fill, smooth stroke. */
enum { FILL = 1, STROKE = 2, BOTH = 3 };

static void expect_with(enum pel_status want, int which,
                        const struct pel_path_shape *shape, void *memory,
                        size_t size)
{
    static enum pel_status (*const draw[4])(
        const struct pel_surface *, const struct pel_path_shape *,
        const struct pel_paint *, void *,
        size_t) = {pel_path_fill, pel_path_stroke, pel_smooth_path_fill,
                   pel_smooth_path_stroke};
    for (int i = 0; i < 4; i++) {
        if (!(which >> i % 2 & 1))
            continue;
        open_window();
        const enum pel_status got =
            draw[i](&window, shape, &white.paint, memory, size);
        if (got != want || (want == PEL_OK) != is_drawn())
            fail_msg("function %d: %d, not %d", i, got, want);
    }
}

static void expect(enum pel_status want, int which,
                   const struct pel_path_shape *shape)
{
    expect_with(want, which, shape, scratch, sizeof scratch);
    if (want == PEL_OK || !shape)
        return;
    if (which & FILL)
        assert_false(pel_hit_path_fill(shape, 3, 3));
    if (which & STROKE)
        assert_false(pel_hit_path_stroke(shape, 3, 1));
}

static void expect_path(enum pel_status want, const struct pel_path *path)
{
    struct pel_path_shape shape = plain;
    shape.path = path;
    expect(want, BOTH, &shape);
    assert_int_equal(pel_path_check(path), want);
}

TEST(nothing_is_missing)
{
    static const struct pel_path paths[] = {
        {NULL, points, NULL, 4, 3},
        {verbs, NULL, NULL, 4, 3},
        {verbs, points, (int32_t *)scratch, 4, 3}};
    expect(PEL_OK, BOTH, &plain);
    expect(PEL_ERROR_NULL, BOTH, NULL);
    expect_path(PEL_ERROR_NULL, NULL);
    for (int i = 0; i < 3; i++)
        expect_path(PEL_ERROR_NULL, &paths[i]);
    expect_with(PEL_ERROR_NULL, BOTH, &plain, NULL, 999);
}

TEST(broken_data_is_refused)
{
    static const uint8_t early[] = {PEL_LINE, PEL_LINE, PEL_LINE},
                         unknown[] = {PEL_MOVE, PEL_LINE, PEL_CLOSE + 1};
    static const struct pel_path paths[] = {
        {early, points, NULL, 3, 3},      {unknown, points, NULL, 3, 3},
        {verbs, points, NULL, 3, 2},      {verbs, points, NULL, 2, 3},
        {verbs, points, NULL, -1, 3},     {verbs, points, NULL, 4, -1},
        {verbs, points, NULL, 4, 1 << 30}};
    for (unsigned i = 0; i < sizeof paths / sizeof *paths; i++)
        expect_path(PEL_ERROR_FORMAT, &paths[i]);
}

/* Both sides of every limit. */
TEST(numbers_have_limits)
{
    static const struct {
        int32_t width, limit, cap, join, tolerance;
        enum pel_status status;
    } rows[] = {{PEL_PX(100), 256, 2, 2, 4, PEL_OK},
                {256, 4096, 0, 1, 65535, PEL_OK},
                {-1, 0, 0, 0, 0, PEL_ERROR_RANGE},
                {PEL_PX(32767) + 1, 0, 0, 0, 0, PEL_ERROR_RANGE},
                {256, 255, 0, 0, 0, PEL_ERROR_RANGE},
                {256, 4097, 0, 0, 0, PEL_ERROR_RANGE},
                {256, 0, 3, 0, 0, PEL_ERROR_RANGE},
                {256, 0, 0, 3, 0, PEL_ERROR_RANGE},
                {256, 0, 0, 0, 3, PEL_ERROR_RANGE},
                {256, 0, 0, 0, 65536, PEL_ERROR_RANGE}};
    for (unsigned i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct pel_path_shape shape = plain;
        shape.stroke.width = rows[i].width;
        shape.stroke.miter_limit = rows[i].limit;
        shape.stroke.cap = (enum pel_cap)rows[i].cap;
        shape.stroke.join = (enum pel_join)rows[i].join;
        shape.tolerance = rows[i].tolerance;
        expect(rows[i].status, STROKE, &shape);
    }
}

TEST(dashes_have_limits)
{
    static const int32_t pair[2] = {100, 156}, short_one[2] = {100, 155},
                         negative[2] = {300, -1},
                         long_one[2] = {PEL_PX(32767), 1}, one[1] = {128},
                         whole[2] = {PEL_PX(32767), 0}, many[64] = {256};
    static const struct {
        struct pel_dashes dashes;
        enum pel_status status;
    } rows[] = {{{&pel_dashed, pair, 2, PEL_PX(32767)}, PEL_OK},
                {{&pel_dashed, one, 1, 0}, PEL_OK},
                {{&pel_dashed, many, 64, 0}, PEL_OK},
                {{&pel_dashed, whole, 2, 0}, PEL_OK},
                {{NULL, pair, 2, 0}, PEL_ERROR_NULL},
                {{&pel_dashed, NULL, 2, 0}, PEL_ERROR_NULL},
                {{&pel_dashed, pair, 0, 0}, PEL_ERROR_RANGE},
                {{&pel_dashed, pair, 65, 0}, PEL_ERROR_RANGE},
                {{&pel_dashed, pair, 2, -1}, PEL_ERROR_RANGE},
                {{&pel_dashed, pair, 2, PEL_PX(32767) + 1}, PEL_ERROR_RANGE},
                {{&pel_dashed, short_one, 2, 0}, PEL_ERROR_RANGE},
                {{&pel_dashed, negative, 2, 0}, PEL_ERROR_RANGE},
                {{&pel_dashed, long_one, 2, 0}, PEL_ERROR_RANGE}};
    for (unsigned i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct pel_path_shape shape = plain;
        shape.stroke.dashes = &rows[i].dashes;
        expect(rows[i].status, STROKE, &shape);
    }
}

/* A stroke keeps away from the ends of the range, a fill need not. */
TEST(points_have_limits)
{
    static const int32_t most = PEL_COORDINATE_MAX, least = PEL_COORDINATE_MIN;
    const int32_t inside[6] = {0, 0, most, 0, 0, most},
                  outside[6] = {0, 0, most, 0, 0, most + 1},
                  below[6] = {0, 0, least - 1, 0, 0, most};
    struct pel_path path = {verbs, NULL, inside, 4, 3};
    struct pel_path_shape shape = plain;
    shape.path = &path;
    expect(PEL_OK, FILL, &shape);
    expect(PEL_ERROR_RANGE, STROKE, &shape);
    path.points32 = outside;
    expect(PEL_ERROR_RANGE, BOTH, &shape);
    path.points32 = below;
    expect(PEL_ERROR_RANGE, BOTH, &shape);
}

/* Memory for one row is enough, a byte less or another place is not. */
TEST(memory_is_enough_or_refused)
{
    const size_t row = PEL_STROKE_SCRATCH_SIZE(SIDE, 1),
                 fill = PEL_PATH_SCRATCH_SIZE(2);
    char *const bytes = (char *)scratch;
    expect_with(PEL_ERROR_SCRATCH, BOTH, &plain, bytes + 4, 2000);
    expect_with(PEL_ERROR_SCRATCH, BOTH, &plain, bytes, 0);
    open_window();
    assert_int_equal(
        pel_path_stroke(&window, &plain, &white.paint, scratch, row), PEL_OK);
    assert_int_equal(
        pel_path_stroke(&window, &plain, &white.paint, scratch, row - 1),
        PEL_ERROR_SCRATCH);
    open_window();
    assert_int_equal(
        pel_path_fill(&window, &plain, &white.paint, scratch, fill), PEL_OK);
    assert_int_equal(
        pel_path_fill(&window, &plain, &white.paint, scratch, fill - 1),
        PEL_ERROR_SCRATCH);
}

/* The state of smooth shapes lies there, and is not begun in less. */
TEST(smooth_memory_is_enough_or_refused)
{
    static const struct pel_outline_font_asset font = {.em = 256};
    const struct pel_outline_text_block text = {.font = &font, .string = ""};
    const size_t fill = PEL_SMOOTH_PATH_SCRATCH_SIZE(2, SIDE),
                 none = PEL_SMOOTH_PATH_SCRATCH_SIZE(0, 0);
    const uint8_t *const bytes = (const uint8_t *)scratch;
    open_window();
    assert_int_equal(pel_smooth_outline_text(&window, &text, &white.paint,
                                             scratch, none - 1),
                     PEL_ERROR_SCRATCH);
    for (size_t i = 0; i < sizeof scratch; i++)
        assert_int_equal(bytes[i], 0x5A);
    assert_int_equal(
        pel_smooth_outline_text(&window, &text, &white.paint, scratch, none),
        PEL_OK);
    assert_int_equal(
        pel_smooth_path_fill(&window, &plain, &white.paint, scratch, fill),
        PEL_OK);
    assert_int_equal(
        pel_smooth_path_fill(&window, &plain, &white.paint, scratch, fill - 1),
        PEL_ERROR_SCRATCH);
}
