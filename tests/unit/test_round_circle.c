/* The sizes that users count on: a radius of r whole pixels around a pixel is
 * 2 r + 1 wide and high, a diameter of d is d wide and high, for every r and d
 * up to 200; both symmetric eight ways. */
#include <string.h>

#include "tests/support/check.h"
#include "tests/support/hits.h"

enum { SIDE = 401 + 4, MIDDLE = SIDE / 2 };

/* Hits per pixel, as struct hits has them, but larger. */
struct plane {
    struct pel_paint paint;
    struct pel_surface surface;
    uint8_t hit[SIDE][SIDE];
};

static struct plane plane;

static void take_rows(const struct pel_paint *paint,
                      const struct pel_spans *rows)
{
    struct plane *p = (struct plane *)(uintptr_t)paint;
    for (int32_t i = 0; i < rows->n; i++)
        for (int32_t x = rows->span[i].x0; x < rows->span[i].x1; x++)
            p->hit[rows->y + i * rows->step][x]++;
}

static void plane_draw(struct pel_point at, int32_t radius)
{
    static uint8_t nothing;
    memset(plane.hit, 0, sizeof plane.hit);
    plane.paint = (struct pel_paint){.fill = take_rows};
    assert_int_equal(pel_surface_init(&plane.surface, &pel_gray8, &nothing,
                                      SIZE_MAX,
                                      &(struct pel_rect){0, 0, SIDE, SIDE}),
                     PEL_OK);
    pel_circle(&plane.surface, at, radius, &plane.paint);
}

/* Of the whole picture. */
static struct pel_rect extent(void)
{
    struct pel_rect e = {SIDE, SIDE, 0, 0};
    for (int32_t y = 0; y < SIDE; y++)
        for (int32_t x = 0; x < SIDE; x++)
            if (plane.hit[y][x]) {
                e.x0 = pel_min(e.x0, x);
                e.y0 = pel_min(e.y0, y);
                e.x1 = pel_max(e.x1, x + 1);
                e.y1 = pel_max(e.y1, y + 1);
            }
    return e;
}

/* The box [low, low + width) in x and y is the extent, and its picture stays
 * the same when it is mirrored at both axes and at the diagonal. */
static void check_symmetric(int32_t low, int32_t width)
{
    const struct pel_rect e = extent();
    if (e.x0 != low || e.y0 != low || e.x1 != low + width ||
        e.y1 != low + width)
        fail_msg("width %d: got %d..%d, %d..%d", width, e.x0, e.x1, e.y0, e.y1);
    for (int32_t y = 0; y < width; y++)
        for (int32_t x = 0; x < width; x++) {
            const uint8_t hit = plane.hit[low + y][low + x];
            const int32_t mx = low + width - 1 - x, my = low + width - 1 - y;
            if (hit > 1 || hit != plane.hit[low + y][mx] ||
                hit != plane.hit[my][low + x] ||
                hit != plane.hit[low + x][low + y])
                fail_msg("width %d: %d, %d is not symmetric", width, x, y);
        }
}

static void test_radius(void)
{
    const int32_t at = PEL_PX(MIDDLE) + 128;
    for (int32_t r = 0; r <= 200; r++) {
        plane_draw((struct pel_point){at, at}, PEL_PX(r));
        check_symmetric(MIDDLE - r, 2 * r + 1);
    }
}

static void test_diameter(void)
{
    for (int32_t d = 1; d <= 200; d++) {
        const int32_t at = PEL_PX(100) + d * 128;
        plane_draw((struct pel_point){at, at}, d * 128);
        check_symmetric(100, d);
    }
}

static void check_rows(const char *const *rows)
{
    for (int32_t y = 0; rows[y]; y++)
        for (int32_t x = 0; rows[y][x]; x++)
            if ((plane.hit[y][x] != 0) != (rows[y][x] == '#'))
                fail_msg("%d, %d: expected %c", x, y, rows[y][x]);
}

/* A corner, less or more the least step: one column in reach, the
 * left or the right one. */
static void test_sides(void)
{
    static const char *const left[] = {"...", ".#.", "...", NULL};
    static const char *const right[] = {"...", "..#", "...", NULL};
    plane_draw((struct pel_point){PEL_PX(2) - 1, PEL_PX(1) + 128}, 127);
    check_rows(left);
    plane_draw((struct pel_point){PEL_PX(2) + 1, PEL_PX(1) + 128}, 127);
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
        plane_draw((struct pel_point){row[i].at, row[i].at}, row[i].radius);
        check_rows(row[i].rows);
    }
}

/* Radius 0 is the pixel whose centre is the disc's, and nothing elsewhere. */
static void test_radius_0_between_pixels(void)
{
    for (int32_t k = 0; k < 256; k++) {
        plane_draw((struct pel_point){PEL_PX(7) + k, PEL_PX(7) + 128}, 0);
        assert_int_equal(plane.hit[7][7], k == 128);
        const struct pel_rect e = extent();
        assert_int_equal(pel_rect_empty(&e), k != 128);
    }
}

int main(void)
{
    return RUN_TESTS(test_radius, test_diameter, test_sides, test_pictures,
                     test_radius_0_between_pixels);
}
