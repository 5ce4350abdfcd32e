/* All lines of a small lattice of pixels that straddles zero, against exact
 * fractions at every pixel; the same through every clip of a smaller one.
 */
#include <string.h>

#include "tests/support/canvas.h"
#include "tests/support/check.h"
#include "tests/support/hits.h"
#include "tests/support/reference.h"

static struct hits hits;

static bool in_line(const void *ends, int32_t x, int32_t y)
{
    const struct pel_point *v = ends;
    return reference_line_at(v[0], v[1], x, y);
}

/* From pixel i to pixel j of a square of `side` pixels around zero; the points
 * lie somewhere in their pixels. */
static void check_line(int32_t side, int32_t i, int32_t j)
{
    const int32_t half = side / 2;
    const struct pel_point v[2] = {
        {PEL_PX(i % side - half) + (i * 5 + j) % 256,
         PEL_PX(i / side - half) + (i * 3 + j * 7) % 256},
        {PEL_PX(j % side - half) + (j * 11 + i) % 256,
         PEL_PX(j / side - half) + (j + i * 13) % 256}};
    hits.pixels = 0;
    for (int32_t k = 0; k < HITS_MAX && k < (side + 2) * (side + 2); k++)
        hits.count[k] = 0;
    pel_line(&hits.surface, v[0], v[1], &hits.paint);
    hits_check(&hits, in_line, v, "line");
}

static struct pel_rect around(int32_t side)
{
    const int32_t low = -side / 2 - 1;
    return (struct pel_rect){low, low, low + side + 2, low + side + 2};
}

TEST(all_lines)
{
    enum { SIDE = 17 };
    const struct pel_rect bounds = around(SIDE);
    hits_open(&hits, &bounds);
    for (int32_t i = 0; i < SIDE * SIDE; i++)
        for (int32_t j = 0; j < SIDE * SIDE; j++) {
            check_line(SIDE, i, j);
            const int32_t dx = i % SIDE - j % SIDE, dy = i / SIDE - j / SIDE;
            const int32_t longer = pel_max(pel_max(dx, -dx), pel_max(dy, -dy));
            assert_int_equal(hits.pixels, longer + 1);
        }
}

static void check_clip(const struct pel_rect *clip)
{
    enum { SIDE = 6 };
    const struct pel_rect bounds = around(SIDE);
    hits_open(&hits, &bounds);
    pel_surface_clip(&hits.surface, clip);
    for (int32_t i = 0; i < SIDE * SIDE; i++)
        for (int32_t j = 0; j < SIDE * SIDE; j++)
            check_line(SIDE, i, j);
}

/* Flat lines are written pixel by pixel: the same ones in every format, and
 * nothing else. */
TEST(all_flat_lines)
{
    enum { SIDE = 11 };
    static struct canvas canvas;
    const struct pel_flat flat = PEL_FLAT(0xFF9ABCDE);
    const struct pel_rect b = {-8, -8, 8, 8};
    for (int f = 0; f < LAYOUT_COUNT; f++)
        for (int32_t i = 0; i < SIDE * SIDE; i++)
            for (int32_t j = 0; j < SIDE * SIDE; j += f % 3 + 1) {
                const struct pel_point v[2] = {
                    {PEL_PX(i % SIDE - 5), PEL_PX(i / SIDE - 5) + 200},
                    {PEL_PX(j % SIDE - 5) + 255, PEL_PX(j / SIDE - 5)}};
                struct hits line;
                hits_open(&line, &b);
                canvas_open(&canvas, layouts[f].format, &b,
                            (unsigned)(i + j) % CANVAS_STYLES);
                pel_line(&line.surface, v[0], v[1], &line.paint);
                pel_line(&canvas.surface, v[0], v[1], &flat.paint);
                canvas_check_drawn(&canvas, &line, canvas_flat, &flat);
            }
}

/* Opaque pixels are the same in both, as pel_xrgb8888 sets what it does not
 * use. */
TEST(lines_of_argb8888)
{
    static uint32_t pixels[2][16 * 16];
    static const struct pel_format *const formats[2] = {&pel_xrgb8888,
                                                        &pel_argb8888};
    const struct pel_flat flat = PEL_FLAT(0xFF9ABCDE);
    const struct pel_rect b = {0, 0, 16, 16};
    for (int32_t i = 0; i < 256; i++) {
        memset(pixels, 0, sizeof pixels);
        for (int f = 0; f < 2; f++) {
            struct pel_surface s;
            pel_surface_init(&s, formats[f], pixels[f], sizeof *pixels, &b);
            pel_line(&s, (struct pel_point)PEL_AT(i % 16, i / 16),
                     (struct pel_point)PEL_AT(7, 9), &flat.paint);
        }
        assert_int_equal(pixels[1][9 * 16 + 7], 0xFF9ABCDE);
        assert_memory_equal(pixels[0], pixels[1], sizeof *pixels);
    }
}

TEST(all_clips)
{
    struct pel_rect c;
    for (c.y0 = -3; c.y0 < 3; c.y0++)
        for (c.y1 = c.y0 + 1; c.y1 <= 3; c.y1++)
            for (c.x0 = -3; c.x0 < 3; c.x0++)
                for (c.x1 = c.x0 + 1; c.x1 <= 3; c.x1++)
                    check_clip(&c);
}
