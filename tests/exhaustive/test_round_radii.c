/* Circles, rings and sectors of every radius up to 512 px around several
 * centres: fill against the squares of distances, the outline against the
 * neighbours, both against the hit test, on every pixel. */
#include <string.h>

#include "core/hit/hit.h"
#include "core/outline/outline.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"
#include "tests/support/reference_shape.h"

enum { RADIUS_MAX = 512, SIDE = 2 * RADIUS_MAX + 6, LEFT = -RADIUS_MAX - 3 };

/* A bitmap that a paint fills; a second hit of a pixel fails. */
struct plane {
    struct pel_paint paint;
    uint8_t hit[SIDE][SIDE];
};

static struct plane fill, outline;
static struct pel_surface surface;

static void plane_fill(const struct pel_paint *paint,
                       const struct pel_spans *rows)
{
    struct plane *p = (struct plane *)(uintptr_t)paint;
    int32_t y = rows->y - LEFT;
    for (int32_t i = 0; i < rows->n; i++, y += rows->step)
        for (int32_t x = rows->span[i].x0; x < rows->span[i].x1; x++)
            if (p->hit[y][x - LEFT]++)
                fail_msg("%d, %d is painted twice", x, y + LEFT);
}

/* All that a shape of this reach can have hit, and a margin. */
static void plane_clear(struct plane *p, int32_t reach)
{
    for (int32_t y = -reach; y <= reach; y++)
        memset(&p->hit[y - LEFT][-reach - LEFT], 0, (size_t)(2 * reach + 1));
    p->paint = (struct pel_paint){.fill = plane_fill};
}

static void setup(void)
{
    static uint8_t nothing;
    const struct pel_rect bounds = {LEFT, LEFT, LEFT + SIDE, LEFT + SIDE};
    assert_int_equal(
        pel_surface_init_rect(&surface, &pel_gray8, &nothing, SIDE, &bounds),
        PEL_OK);
}

static const struct pel_point centers[] = {{128, 128}, {0, 0},   {128, 0},
                                           {127, 129}, {1, 254}, {37, 201}};
enum { CENTERS = sizeof centers / sizeof *centers };

/* The radius of a whole number of pixels, and next to it. */
static const int32_t offsets[] = {0, 1, -1, 128, 77};
enum { OFFSETS = sizeof offsets / sizeof *offsets };

static int64_t square(int32_t x, int32_t y, struct pel_point center)
{
    int64_t u = x * 256 + 128 - center.x, v = y * 256 + 128 - center.y;
    return u * u + v * v;
}

/* Only pixels near the shape: the whole box of the largest radius would take
 * as long for the smallest. */
static int32_t reach_of(int32_t radius)
{
    return radius / 256 + 2;
}

/* Where hit tests are worth their time: at edges, and here and there. */
static bool is_asked(bool in, bool *last, int32_t x, int32_t y)
{
    bool asked = in != *last || (x * 5 + y) % 16 == 0;
    *last = in;
    return asked;
}

static void check_circle(struct pel_point center, int32_t radius)
{
    const int32_t reach = reach_of(radius);
    const int64_t limit = (int64_t)radius * radius;
    plane_clear(&fill, reach);
    plane_clear(&outline, reach);
    pel_circle(&surface, center, radius, &fill.paint);
    pel_circle_outline(&surface, center, radius, &outline.paint);
    bool last = false;
    for (int32_t y = -reach; y <= reach; y++)
        for (int32_t x = -reach; x <= reach; x++) {
            bool in = square(x, y, center) <= limit;
            bool edge = in && (square(x - 1, y, center) > limit ||
                               square(x + 1, y, center) > limit ||
                               square(x, y - 1, center) > limit ||
                               square(x, y + 1, center) > limit);
            if (in != fill.hit[y - LEFT][x - LEFT] ||
                edge != outline.hit[y - LEFT][x - LEFT] ||
                (is_asked(in, &last, x, y) &&
                 in != pel_hit_circle(center, radius, x, y)))
                fail_msg("circle %d,%d r %d at %d,%d", center.x, center.y,
                         radius, x, y);
        }
}

static void check_ring(struct pel_point center, int32_t inner, int32_t outer)
{
    const int32_t reach = reach_of(outer);
    const struct pel_ring_shape ring = {center, inner, outer};
    plane_clear(&fill, reach);
    pel_ring(&surface, &ring, &fill.paint);
    bool last = false;
    for (int32_t y = -reach; y <= reach; y++)
        for (int32_t x = -reach; x <= reach; x++) {
            int64_t d = square(x, y, center);
            bool in = d > (int64_t)inner * inner && d <= (int64_t)outer * outer;
            if (in != fill.hit[y - LEFT][x - LEFT] ||
                (is_asked(in, &last, x, y) && in != pel_hit_ring(&ring, x, y)))
                fail_msg("ring %d,%d r %d..%d at %d,%d", center.x, center.y,
                         inner, outer, x, y);
        }
}

static void check_sector(const struct pel_sector_shape *s)
{
    const int32_t reach = reach_of(s->radius);
    const int64_t limit = (int64_t)s->radius * s->radius;
    plane_clear(&fill, reach);
    pel_sector(&surface, s, &fill.paint);
    bool last = false;
    for (int32_t y = -reach; y <= reach; y++)
        for (int32_t x = -reach; x <= reach; x++) {
            bool in = square(x, y, s->center) <= limit;
            bool hit = fill.hit[y - LEFT][x - LEFT];
            if (is_asked(hit, &last, x, y)) {
                in = in && reference_angle_at(s->center, s->from, s->to, x, y);
                if (in != hit || in != pel_hit_sector(s, x, y))
                    fail_msg("sector %d,%d r %d %u..%u at %d,%d", s->center.x,
                             s->center.y, s->radius, s->from, s->to, x, y);
            } else if (hit && !in) {
                fail_msg("sector %d,%d r %d %u..%u at %d,%d", s->center.x,
                         s->center.y, s->radius, s->from, s->to, x, y);
            }
        }
}

static int32_t radius_of(int32_t pixels, uint32_t which)
{
    int32_t radius = PEL_PX(pixels) + offsets[which % OFFSETS];
    return radius < 0 ? 0 : radius;
}

/* Small radii around every centre, large ones around two each. */
static bool is_skipped(int32_t pixels, uint32_t which)
{
    return pixels > 64 && ((uint32_t)pixels + which) % 3;
}

static void test_circles(void)
{
    for (int32_t r = 0; r <= RADIUS_MAX; r++)
        for (uint32_t c = 0; c < CENTERS; c++)
            if (!is_skipped(r, c))
                check_circle(centers[c], radius_of(r, c + (uint32_t)r));
}

static void test_rings(void)
{
    struct random random = {1};
    for (int32_t r = 0; r <= RADIUS_MAX; r++)
        for (uint32_t c = 0; c < CENTERS; c++) {
            int32_t outer = radius_of(r, c + (uint32_t)r / CENTERS);
            if (!is_skipped(r, c)) {
                check_ring(centers[c], random_between(&random, 0, outer),
                           outer);
                check_ring(centers[c], pel_max(outer - 256, 0), outer);
            }
        }
}

static void test_sectors(void)
{
    struct random random = {2};
    for (int32_t r = 0; r <= RADIUS_MAX; r++)
        for (uint32_t c = 0; c < CENTERS; c++) {
            struct pel_sector_shape s = {centers[c], radius_of(r, c), 0, 0};
            s.from = (uint16_t)random_word(&random);
            s.to = (uint16_t)random_word(&random);
            if (!is_skipped(r, c))
                check_sector(&s);
            s.from &= 0xE000;
            if (!is_skipped(r, c))
                check_sector(&s);
        }
}

/* A disc of whole diameter d in a box of d x d touches all four sides. */
static void test_diameters(void)
{
    for (int32_t d = 1; d <= RADIUS_MAX; d++) {
        const int32_t reach = d + 2, near = -LEFT, far = d - 1 - LEFT;
        const int32_t middle = d / 2 - LEFT;
        plane_clear(&fill, reach);
        pel_circle(&surface, (struct pel_point){d * 128, d * 128}, d * 128,
                   &fill.paint);
        assert_true(fill.hit[middle][near] && fill.hit[middle][far]);
        assert_true(fill.hit[near][middle] && fill.hit[far][middle]);
        assert_false(fill.hit[middle][near - 1] || fill.hit[middle][far + 1]);
        assert_false(fill.hit[near - 1][middle] || fill.hit[far + 1][middle]);
    }
}

static bool same_at(const struct plane *p, int32_t x, int32_t y)
{
    uint8_t hit = p->hit[y - LEFT][x - LEFT];
    return hit == p->hit[-y - LEFT][x - LEFT] &&
           hit == p->hit[y - LEFT][-x - LEFT] &&
           hit == p->hit[x - LEFT][y - LEFT];
}

/* Eight-fold, across both axes and the diagonal, and 2 r + 1 px wide. */
static void test_symmetry(void)
{
    const struct pel_point center = {128, 128};
    for (int32_t r = 0; r <= RADIUS_MAX; r++) {
        const int32_t reach = r + 2;
        plane_clear(&fill, reach);
        plane_clear(&outline, reach);
        pel_circle(&surface, center, PEL_PX(r), &fill.paint);
        pel_circle_outline(&surface, center, PEL_PX(r), &outline.paint);
        for (int32_t y = 0; y <= r; y++)
            for (int32_t x = 0; x <= r; x++)
                if (!same_at(&fill, x, y) || !same_at(&outline, x, y))
                    fail_msg("radius %d is not symmetric at %d, %d", r, x, y);
        assert_true(fill.hit[-LEFT][r - LEFT] && outline.hit[-LEFT][r - LEFT]);
        assert_false(fill.hit[-LEFT][r + 1 - LEFT]);
    }
}

int main(void)
{
    setup();
    return RUN_TESTS(test_circles, test_rings, test_sectors, test_diameters,
                     test_symmetry);
}
