/* Boxes and clears: which pixels, which bytes, and what draws nothing. */
#include "tests/support/canvas.h"
#include "tests/support/check.h"

static struct canvas canvas;

static const struct pel_rect bounds = {-8, -8, 16, 9};

/* The clip holds `want`, and nothing else has changed. */
static void check_clip(const struct pel_rect *clip, uint32_t want)
{
    canvas_check(&canvas);
    for (int32_t y = clip->y0; y < clip->y1; y++)
        for (int32_t x = clip->x0; x < clip->x1; x++)
            if (canvas_pixel(&canvas, x, y) != want)
                fail_msg("%s: %d, %d: expected %x, got %x", canvas.layout->name,
                         x, y, want, canvas_pixel(&canvas, x, y));
}

/* Alpha is ignored, and no other bit. */
TEST(clear_sets_the_color)
{
    static const pel_color colors[] = {0,          0xFF000000, 0x00FFFFFF,
                                       0x12345678, 0x80FEFCF8, 0xFF102040};
    static const struct pel_rect clips[] = {
        {-8, -8, 16, 9}, {-3, 1, 5, 2}, {0, -8, 1, 9}};
    for (int f = 0; f < LAYOUT_COUNT; f++)
        for (size_t i = 0; i < sizeof colors / sizeof colors[0]; i++)
            for (size_t k = 0; k < sizeof clips / sizeof clips[0]; k++) {
                canvas_open(&canvas, layouts[f].format, &bounds,
                            (unsigned)i % CANVAS_STYLES);
                pel_surface_clip(&canvas.surface, &clips[k]);
                pel_clear(&canvas.surface, colors[i]);
                check_clip(&clips[k], layout_pack(&layouts[f], colors[i]));
            }
}

/* Whole surfaces: where rows follow one another without a gap they are one
 * run, whatever is left of bytes and pages at their ends. */
TEST(clear_of_whole_surfaces)
{
    static const int32_t sides[][2] = {{1, 1},  {1, 8},  {8, 1},   {2, 3},
                                       {3, 8},  {4, 5},  {8, 16},  {13, 16},
                                       {24, 7}, {40, 9}, {128, 64}};
    const pel_color color = 0xFF9ABCDE;
    for (int f = 0; f < LAYOUT_COUNT; f++)
        for (size_t i = 0; i < sizeof sides / sizeof sides[0]; i++)
            for (unsigned style = 0; style < CANVAS_STYLES; style++) {
                const struct pel_rect b = {-8, 8, sides[i][0] - 8,
                                           sides[i][1] + 8};
                canvas_open(&canvas, layouts[f].format, &b, style);
                pel_clear(&canvas.surface, color);
                check_clip(&b, layout_pack(&layouts[f], color));
                pel_clear(&canvas.surface, 0);
                check_clip(&b, layout_pack(&layouts[f], 0));
            }
}

TEST(clear_of_an_empty_clip)
{
    static const struct pel_rect clips[] = {
        {4, 4, 4, 8}, {4, 4, 8, 4}, {9, 0, 3, 8}, {40, 40, 50, 50}};
    for (size_t k = 0; k < sizeof clips / sizeof clips[0]; k++) {
        canvas_open(&canvas, &pel_xrgb8888, &bounds, 0);
        pel_surface_clip(&canvas.surface, &clips[k]);
        pel_clear(&canvas.surface, 0xFFFFFFFF);
        assert_memory_equal(canvas.memory, canvas.before, canvas.size);
    }
}

/* Boxes of whole pixels, of any numbers. */
TEST(boxes)
{
    static const struct pel_rect box[] = {
        {1, 2, 3, 4},
        {INT32_MIN, 1, 2, INT32_MAX},
        {INT32_MIN, INT32_MIN, INT32_MAX, INT32_MAX},
        {INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN},
        {3, 1, 1, 4},
        {1, 4, 3, 4},
        {1, INT32_MAX, 3, INT32_MIN},
        {INT32_MAX - 1, 0, INT32_MAX, 5},
    };
    const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));
    for (size_t i = 0; i < sizeof box / sizeof box[0]; i++) {
        const struct pel_rect *b = &box[i];
        canvas_open(&canvas, &pel_gray8, &bounds, 0);
        pel_clear(&canvas.surface, 0);
        pel_box(&canvas.surface, b, &white.paint);
        canvas_check(&canvas);
        for (int32_t y = 0; y < 5; y++)
            for (int32_t x = 0; x < 4; x++)
                if ((canvas_pixel(&canvas, x, y) == 255) !=
                    (x >= b->x0 && x < b->x1 && y >= b->y0 && y < b->y1))
                    fail_msg("row %zu: %d, %d", i, x, y);
    }
}

/* In pages, whose bytes hold eight rows of a box. */
TEST(boxes_of_pages)
{
    const struct pel_flat colors[] = {PEL_FLAT(PEL_RGB(255, 255, 255)),
                                      PEL_FLAT(PEL_RGB(0, 0, 0))};
    const struct pel_rect pages = {-8, -8, 16, 25};
    for (int32_t y0 = -9; y0 <= 25; y0++)
        for (int32_t y1 = y0; y1 <= 26; y1++)
            for (int32_t x1 = 2; x1 <= 17; x1 += 5)
                for (size_t i = 0; i < 2; i++) {
                    const struct pel_rect box = {2, y0, x1, y1};
                    canvas_open(&canvas, &pel_mono1_pages, &pages, 0);
                    const struct pel_rect seen =
                        pel_rect_intersect(&box, &pages);
                    pel_surface_clip(&canvas.surface, &box);
                    pel_box(&canvas.surface, &pages, &colors[i].paint);
                    check_clip(&seen, i == 0);
                }
}
