/* Setting up surfaces: what is refused, with which code, and what is not. */
#include "tests/support/check.h"
#include "tests/support/layouts.h"

static uint32_t memory[4096];

/* Each of the arguments in turn. */
TEST(null_is_refused)
{
    struct pel_surface s;
    const struct pel_rect b = {0, 0, 8, 8};
    for (int i = 0; i < 4; i++) {
        struct pel_surface *to = i == 0 ? NULL : &s;
        const struct pel_format *format = i == 1 ? NULL : &pel_gray8;
        void *pixels = i == 2 ? NULL : memory;
        const struct pel_rect *bounds = i == 3 ? NULL : &b;
        assert_int_equal(pel_surface_init(to, format, pixels, 64, bounds),
                         PEL_ERROR_NULL);
        assert_int_equal(pel_surface_init_rect(to, format, pixels, 8, bounds),
                         PEL_ERROR_NULL);
    }
}

TEST(sizes)
{
    static const struct {
        int32_t width, height;
        enum pel_status status;
    } row[] = {
        {1, 1, PEL_OK},
        {32767, 32767, PEL_OK},
        {0, 1, PEL_ERROR_SIZE},
        {1, 0, PEL_ERROR_SIZE},
        {-1, 1, PEL_ERROR_SIZE},
        {1, -1, PEL_ERROR_SIZE},
        {32768, 1, PEL_ERROR_SIZE},
        {1, 32768, PEL_ERROR_SIZE},
        {INT32_MAX, 1, PEL_ERROR_SIZE},
        {1, INT32_MAX, PEL_ERROR_SIZE},
        {INT32_MIN, INT32_MIN, PEL_ERROR_SIZE},
    };
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++)
        for (int f = 0; f < LAYOUT_COUNT; f++) {
            struct pel_surface s;
            if (pel_surface_init(
                    &s, layouts[f].format, memory, SIZE_MAX,
                    &(struct pel_rect){0, 0, row[i].width, row[i].height}) !=
                row[i].status)
                fail_msg("row %zu, %s", i, layouts[f].name);
        }
}

/* The last byte counts, in every format. */
TEST(memory_sizes)
{
    const struct pel_rect bounds = {-16, 8, 5, 31};
    for (int f = 0; f < LAYOUT_COUNT; f++) {
        const struct pel_format *format = layouts[f].format;
        const size_t lines = format->id == PEL_FORMAT_MONO1_PAGES ? 3 : 23;
        const size_t size = (size_t)pel_stride(format, 21) * lines;
        struct pel_surface s;
        assert_int_equal(pel_surface_init(&s, format, memory, size, &bounds),
                         PEL_OK);
        assert_int_equal(
            pel_surface_init(&s, format, memory, size - 1, &bounds),
            PEL_ERROR_SIZE);
        assert_int_equal(pel_surface_init(&s, format, memory, 0, &bounds),
                         PEL_ERROR_SIZE);
    }
}

TEST(bounds)
{
    static const struct {
        struct pel_rect bounds;
        enum pel_status status;
    } row[] = {
        {{-32768, -32768, -1, -1}, PEL_OK},
        {{0, 0, 32767, 32767}, PEL_OK},
        {{8, 8, 32768, 32768}, PEL_OK},
        {{-32768, 0, 0, 1}, PEL_ERROR_SIZE},
        {{-8, 0, 32760, 1}, PEL_ERROR_SIZE},
        {{0, -32768, 1, 0}, PEL_ERROR_SIZE},
        {{-32776, 0, -32760, 1}, PEL_ERROR_SIZE},
        {{0, -32776, 1, -32760}, PEL_ERROR_SIZE},
        {{-32769, 0, -32760, 1}, PEL_ERROR_SIZE},
        {{0, -32769, 1, -32760}, PEL_ERROR_SIZE},
        {{32760, 0, 32769, 1}, PEL_ERROR_SIZE},
        {{0, 32760, 1, 32769}, PEL_ERROR_SIZE},
        {{8, 0, 8, 1}, PEL_ERROR_SIZE},
        {{0, 8, 1, 8}, PEL_ERROR_SIZE},
        {{16, 0, 8, 1}, PEL_ERROR_SIZE},
        {{INT32_MIN, 0, INT32_MAX, 1}, PEL_ERROR_SIZE},
        {{0, INT32_MIN, 1, INT32_MAX}, PEL_ERROR_SIZE},
        {{INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN}, PEL_ERROR_SIZE},
    };
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        struct pel_surface s;
        if (pel_surface_init_rect(&s, &pel_xrgb8888, memory, 131068,
                                  &row[i].bounds) != row[i].status ||
            pel_surface_init(&s, &pel_xrgb8888, memory, SIZE_MAX,
                             &row[i].bounds) != row[i].status)
            fail_msg("row %zu", i);
    }
}

/* Lines may run upwards and have padding, but must not overlap. */
TEST(strides)
{
    const struct pel_rect b = {0, 0, 17, 16};
    for (int f = 0; f < LAYOUT_COUNT; f++) {
        const struct pel_format *format = layouts[f].format;
        const int32_t word = format->word, need = pel_stride(format, 17);
        const bool pages = format->id == PEL_FORMAT_MONO1_PAGES;
        const enum pel_status upwards = pages ? PEL_ERROR_STRIDE : PEL_OK;
        const struct {
            int32_t stride;
            enum pel_status status;
        } row[] = {
            {need, PEL_OK},
            {need + word, PEL_OK},
            {need - word, PEL_ERROR_STRIDE},
            {0, PEL_ERROR_STRIDE},
            {-need, upwards},
            {word - need, PEL_ERROR_STRIDE},
            {INT32_MIN + 8, upwards},
            {INT32_MIN, PEL_ERROR_STRIDE},
        };
        assert_int_equal(need, pages ? 17 : (17 * layouts[f].bits + 7) / 8);
        for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
            struct pel_surface s;
            assert_int_equal(pel_surface_init_rect(&s, format, memory + 1024,
                                                   row[i].stride, &b),
                             row[i].status);
        }
    }
}

TEST(stride_of_nothing)
{
    assert_int_equal(pel_stride(NULL, 8), 0);
    assert_int_equal(pel_stride(&pel_rgb888, 0), 0);
    assert_int_equal(pel_stride(&pel_rgb888, -1), 0);
    assert_int_equal(pel_stride(&pel_rgb888, 1), 3);
    assert_int_equal(pel_stride(&pel_mono1, 1), 1);
    assert_int_equal(pel_stride(&pel_mono1_pages, 1), 1);
    assert_int_equal(pel_stride(&pel_mono1_pages, -1), 0);
    assert_int_equal(pel_stride(&pel_rgb888, 32767), 98301);
    assert_int_equal(pel_stride(&pel_rgb888, 32768), 0);
    assert_int_equal(pel_stride(&pel_rgb888, INT32_MAX), 0);
}

TEST(alignment)
{
    const struct pel_rect b = {0, 0, 8, 8};
    for (int f = 0; f < LAYOUT_COUNT; f++) {
        const struct pel_format *format = layouts[f].format;
        for (int offset = 0; offset < 4; offset++) {
            struct pel_surface s;
            enum pel_status want =
                offset % format->word ? PEL_ERROR_ALIGNMENT : PEL_OK;
            assert_int_equal(pel_surface_init_rect(&s, format,
                                                   (uint8_t *)memory + offset,
                                                   64, &b),
                             want);
            assert_int_equal(
                pel_surface_init_rect(&s, format, memory, 64 + offset, &b),
                want);
        }
    }
}

/* Tiles of packed formats begin at a byte. */
TEST(origins)
{
    for (int f = 0; f < LAYOUT_COUNT; f++)
        for (int32_t o = -9; o < 10; o++) {
            const struct pel_format *format = layouts[f].format;
            const struct pel_rect right = {o, 0, o + 16, 16};
            const struct pel_rect down = {0, o, 16, o + 16};
            bool pages = format->id == PEL_FORMAT_MONO1_PAGES;
            struct pel_surface s;
            assert_int_equal(
                pel_surface_init_rect(&s, format, memory, 64, &right),
                pages || o * layouts[f].bits % 8 == 0 ? PEL_OK
                                                      : PEL_ERROR_ALIGNMENT);
            assert_int_equal(
                pel_surface_init_rect(&s, format, memory, 64, &down),
                pages && o % 8 ? PEL_ERROR_ALIGNMENT : PEL_OK);
        }
}

TEST(surface_is_what_was_said)
{
    const struct pel_rect b = {-16, 8, 5, 24};
    struct pel_surface s;
    assert_int_equal(pel_surface_init_rect(&s, &pel_rgb888, memory, -66, &b),
                     PEL_OK);
    assert_ptr_equal(s.pixels, memory);
    assert_int_equal(s.stride, -66);
    assert_memory_equal(&s.bounds, &b, sizeof b);
    assert_memory_equal(&s.clip, &b, sizeof b);
    assert_ptr_equal(s.format, &pel_rgb888);
    assert_int_equal(pel_surface_init(&s, &pel_mono1, memory, sizeof memory,
                                      &(struct pel_rect){0, 0, 17, 3}),
                     PEL_OK);
    assert_int_equal(s.stride, 3);
    assert_memory_equal(&s.bounds, (&(struct pel_rect){0, 0, 17, 3}), sizeof b);
}

TEST(clip_stays_inside)
{
    const struct pel_rect outside = {INT32_MIN, INT32_MIN, INT32_MAX,
                                     INT32_MAX};
    const struct pel_rect part = {3, -5, 70, 4}, apart = {20, 20, 30, 30};
    struct pel_surface s;
    assert_int_equal(pel_surface_init(&s, &pel_gray8, memory, sizeof memory,
                                      &(struct pel_rect){0, 0, 16, 8}),
                     PEL_OK);
    pel_surface_clip(&s, &part);
    assert_memory_equal(&s.clip, (&(struct pel_rect){3, 0, 16, 4}),
                        sizeof s.clip);
    pel_surface_clip(&s, &outside);
    assert_memory_equal(&s.clip, &s.bounds, sizeof s.clip);
    pel_surface_clip(&s, &apart);
    assert_memory_equal(&s.clip, &(struct pel_rect){0}, sizeof s.clip);
}

TEST(names_of_statuses)
{
    assert_string_equal(pel_status_name(PEL_OK), "PEL_OK");
    assert_string_equal(pel_status_name(PEL_ERROR_RANGE), "PEL_ERROR_RANGE");
    for (int s = PEL_ERROR_FORMAT; s < PEL_OK; s++)
        for (int other = PEL_ERROR_FORMAT; other < s; other++)
            assert_string_not_equal(pel_status_name((enum pel_status)s),
                                    pel_status_name((enum pel_status)other));
    assert_string_equal(pel_status_name(PEL_ERROR_DEVICE), "PEL_ERROR_DEVICE");
    assert_string_equal(pel_status_name((enum pel_status) - 9), "PEL_ERROR");
}

/* Where init failed there is no pixel, whatever the surface was before. */
TEST(failed_surfaces)
{
    static const struct pel_rect row = {0, 0, 64, 1}, none = {0, 0, 64, 0};
    static const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));
    for (int i = 0; i < 3; i++) {
        struct pel_surface s;
        memory[0] = 0;
        assert_int_equal(
            pel_surface_init(&s, &pel_gray8, memory, sizeof memory, &row),
            PEL_OK);
        assert_int_equal(
            pel_surface_init(&s, &pel_gray8, memory, sizeof memory, &s.bounds),
            PEL_OK);
        assert_true((i == 0 ? pel_surface_init(&s, NULL, memory, 64, &row)
                     : i == 1
                         ? pel_surface_init(&s, &pel_gray8, memory, 1, &row)
                         : pel_surface_init_rect(&s, &pel_gray8, memory, 64,
                                                 &none)) < 0);
        pel_surface_clip(&s, &row);
        pel_box(&s, &row, &white.paint);
        assert_int_equal(*(const uint8_t *)memory, 0);
    }
}
