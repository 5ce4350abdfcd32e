/* Discs of every whole radius from 0 to 1024 px, and next to it, around several
 * centres; and of every sub-pixel radius up to 16 px around a lattice of them.
 * Each row against an integer square root found by search. */
#include <string.h>

#include "tests/support/check.h"
#include "core/pel.h"

enum { RADIUS_MAX = 1025, SIDE = 2 * RADIUS_MAX + 6, LEFT = -RADIUS_MAX - 3 };

/* The one run that each row may have. */
struct picture {
    struct pel_paint paint;
    struct pel_span row[SIDE];
    uint64_t pixels;
};

static struct picture picture;
static struct pel_surface surface;

static void take_rows(const struct pel_paint *paint,
                      const struct pel_spans *rows)
{
    struct picture *p = (struct picture *)(uintptr_t)paint;
    for (int32_t i = 0; i < rows->n; i++) {
        int32_t y = rows->y + i * rows->step;
        struct pel_span *row = &p->row[y - LEFT];
        if (row->x0 < row->x1)
            fail_msg("row %d has two runs", y);
        *row = rows->span[i];
    }
}

static void setup(void)
{
    static uint8_t nothing;
    const struct pel_rect bounds = {LEFT, LEFT, LEFT + SIDE, LEFT + SIDE};
    picture.paint = (struct pel_paint){.fill = take_rows};
    assert_int_equal(
        pel_surface_init_rect(&surface, &pel_gray8, &nothing, SIDE, &bounds),
        PEL_OK);
}

/* The largest s with s^2 <= square; square < 2^40. */
static int64_t root_of(int64_t square)
{
    int64_t low = 0, high = 1 << 20; /* low^2 <= square < high^2 */
    while (high - low > 1) {
        int64_t middle = (low + high) / 2;
        if (middle * middle <= square)
            low = middle;
        else
            high = middle;
    }
    return low;
}

static int64_t ceil_256(int64_t v)
{
    int64_t q = v / 256;
    return q + (v % 256 > 0);
}

/* Pixels whose centre lies within `reach` of the disc's centre line. */
static struct pel_span expected_row(struct pel_point center, int32_t radius,
                                    int32_t y)
{
    const int64_t v = (int64_t)y * 256 + 128 - center.y;
    const int64_t square = (int64_t)radius * radius - v * v;
    if (square < 0)
        return (struct pel_span){0, 0};
    const int64_t reach = root_of(square);
    return (struct pel_span){
        (int32_t)ceil_256(center.x - reach - 128),
        (int32_t)-ceil_256(-(center.x + reach - 128)) + 1,
    };
}

static bool same(const struct pel_span *a, const struct pel_span *b)
{
    return (a->x0 == b->x0 && a->x1 == b->x1) ||
           (a->x0 >= a->x1 && b->x0 >= b->x1);
}

static void check_circle(struct pel_point center, int32_t radius)
{
    const int32_t reach = radius / 256 + 3;
    memset(&picture.row[-reach - LEFT], 0,
           (size_t)(2 * reach + 1) * sizeof picture.row[0]);
    pel_circle(&surface, center, radius, &picture.paint);
    for (int32_t y = -reach; y <= reach; y++) {
        const struct pel_span want = expected_row(center, radius, y);
        const struct pel_span *got = &picture.row[y - LEFT];
        if (!same(&want, got))
            fail_msg("centre %d, %d, radius %d: row %d: expected %d..%d, got "
                     "%d..%d",
                     center.x, center.y, radius, y, want.x0, want.x1, got->x0,
                     got->x1);
        if (want.x0 < want.x1)
            picture.pixels += (uint64_t)(want.x1 - want.x0);
    }
}

static void test_root(void)
{
    for (int64_t s = 0; s < 1 << 19; s += s / 64 + 1) {
        assert_true(root_of(s * s) == s);
        assert_true(root_of(s * s + 2 * s) == s);
    }
    assert_true(ceil_256(-256) == -1 && ceil_256(-255) == 0);
    assert_true(ceil_256(0) == 0 && ceil_256(1) == 1 && ceil_256(256) == 1);
}

static void test_whole_radii(void)
{
    static const struct pel_point centers[] = {
        {128, 128}, {0, 0},   {128, 0},  {0, 128},    {127, 128},
        {129, 127}, {1, 255}, {37, 201}, {-100, -129}};
    picture.pixels = 0;
    for (int32_t r = 0; r <= 1024; r++)
        for (size_t i = 0; i < sizeof centers / sizeof centers[0]; i++) {
            check_circle(centers[i], PEL_PX(r));
            check_circle(centers[i], PEL_PX(r) + 1);
            if (r > 0)
                check_circle(centers[i], PEL_PX(r) - 1);
        }
    print_message("%llu pixels\n", (unsigned long long)picture.pixels);
}

static void test_subpixel_radii(void)
{
    picture.pixels = 0;
    for (int32_t radius = 0; radius <= PEL_PX(16); radius++)
        for (int32_t y = 0; y < 256; y += 32)
            for (int32_t x = 0; x < 256; x += 32)
                check_circle((struct pel_point){x, y}, radius);
    print_message("%llu pixels\n", (unsigned long long)picture.pixels);
}

/* Every centre in a pixel, every radius up to a pixel and a half. */
static void test_all_small(void)
{
    for (int32_t radius = 0; radius <= 384; radius += 1 + radius / 32)
        for (int32_t y = 0; y < 256; y++)
            for (int32_t x = 0; x < 256; x++)
                check_circle((struct pel_point){x, y}, radius);
}

int main(void)
{
    setup();
    return RUN_TESTS(test_root, test_whole_radii, test_subpixel_radii,
                     test_all_small);
}
