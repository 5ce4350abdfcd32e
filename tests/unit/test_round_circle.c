/* Small circles as pictures, and what happens between two pixels. All radii and
 * diameters: exhaustive/test_round_radii.c. */
#include "tests/support/check.h"
#include "tests/support/hits.h"

static struct hits hits;

static void draw_circle(struct pel_point at, int32_t radius)
{
    hits_open(&hits, &(struct pel_rect){0, 0, 16, 16});
    pel_circle(&hits.surface, at, radius, &hits.paint);
}

static void check_rows(const char *const *rows)
{
    for (int32_t y = 0; rows[y]; y++)
        for (int32_t x = 0; rows[y][x]; x++)
            if ((hits_at(&hits, x, y) != 0) != (rows[y][x] == '#'))
                fail_msg("%d, %d: expected %c", x, y, rows[y][x]);
}

/* A corner, less or more the least step: one column in reach, the
 * left or the right one. */
static void test_sides(void)
{
    static const char *const left[] = {"...", ".#.", "...", NULL};
    static const char *const right[] = {"...", "..#", "...", NULL};
    draw_circle((struct pel_point){PEL_PX(2) - 1, PEL_PX(1) + 128}, 127);
    check_rows(left);
    draw_circle((struct pel_point){PEL_PX(2) + 1, PEL_PX(1) + 128}, 127);
    check_rows(right);
}

static void test_pictures(void)
{
    static const char *const radius_0[] = {"...", ".#.", "...", NULL};
    static const char *const radius_1[] = {".#.", "###", ".#.", NULL};
    static const char *const radius_2[] = {"..#..", ".###.", "#####",
                                           ".###.", "..#..", NULL};
    static const char *const radius_3[] = {"...#...", ".#####.", ".#####.",
                                           "#######", ".#####.", ".#####.",
                                           "...#...", NULL};
    static const char *const diameter_2[] = {"##", "##", NULL};
    static const char *const diameter_4[] = {".##.", "####", "####", ".##.",
                                             NULL};
    static const struct {
        int32_t at, radius;
        const char *const *rows;
    } row[] = {{384, 0, radius_0},     {384, 256, radius_1},
               {640, 512, radius_2},   {896, 768, radius_3},
               {256, 256, diameter_2}, {512, 512, diameter_4}};
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        draw_circle((struct pel_point){row[i].at, row[i].at}, row[i].radius);
        check_rows(row[i].rows);
    }
}

/* Radius 0 is the pixel whose centre is the disc's, and nothing elsewhere. */
static void test_radius_0_between_pixels(void)
{
    for (int32_t k = 0; k < 256; k++) {
        draw_circle((struct pel_point){PEL_PX(7) + k, PEL_PX(7) + 128}, 0);
        assert_int_equal(hits_at(&hits, 7, 7), k == 128);
        assert_int_equal(hits.pixels, k == 128);
    }
}

int main(void)
{
    return RUN_TESTS(test_sides, test_pictures, test_radius_0_between_pixels);
}
