/* Circles, rings and sectors of every radius up to 512 px around several
 * centres: fill against the squares of distances, the outline against the
 * neighbours, both against the hit test, on every pixel. */
#include <string.h>

#include "core/outline/outline.h"
#include "tests/support/any_shape.h"
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

static bool at(const struct plane *p, int32_t x, int32_t y)
{
    return p->hit[y - LEFT][x - LEFT];
}

/* By the distance from the centre. */
static bool reaches(const struct any_shape *s, int32_t x, int32_t y)
{
    const int64_t d = square(x, y, s->v[0]);
    return d <= pel_square(s->radius) &&
           (s->kind != ANY_RING || d > pel_square(s->inner));
}

/* Of sectors, angles count where hit tests are asked. */
static void check_fill(const struct any_shape *s)
{
    const int32_t reach = reach_of(s->radius);
    bool last = false;
    plane_clear(&fill, reach);
    any_draw(&surface, s, &fill.paint);
    for (int32_t y = -reach; y <= reach; y++)
        for (int32_t x = -reach; x <= reach; x++) {
            const bool hit = at(&fill, x, y);
            const bool asked = is_asked(hit, &last, x, y);
            bool in = reaches(s, x, y);
            if (s->kind == ANY_SECTOR)
                in = in &&
                     (asked ? reference_angle_at(s->v[0], s->from, s->to, x, y)
                            : hit);
            if (in != hit || (asked && in != any_hit(s, x, y)))
                fail_msg("%s %d,%d r %d..%d, %d..%d at %d,%d", any_name(s),
                         s->v[0].x, s->v[0].y, s->inner, s->radius, s->from,
                         s->to, x, y);
        }
}

static void check_circle(struct pel_point center, int32_t radius)
{
    const struct any_shape s = {
        .kind = ANY_CIRCLE, .v = {center}, .radius = radius};
    const int32_t reach = reach_of(radius);
    check_fill(&s);
    plane_clear(&outline, reach);
    pel_circle_outline(&surface, center, radius, &outline.paint);
    for (int32_t y = -reach; y <= reach; y++)
        for (int32_t x = -reach; x <= reach; x++) {
            const bool edge =
                reaches(&s, x, y) &&
                !(reaches(&s, x - 1, y) && reaches(&s, x + 1, y) &&
                  reaches(&s, x, y - 1) && reaches(&s, x, y + 1));
            if (edge != at(&outline, x, y))
                fail_msg("outline %d,%d r %d at %d,%d", center.x, center.y,
                         radius, x, y);
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

/* All whole and half radii around the centre of a pixel: those discs are 2 r +
 * 1 px wide, or d, and symmetric. */
static void test_circles(void)
{
    for (int32_t r = 0; r <= RADIUS_MAX; r++) {
        check_circle(centers[0], PEL_PX(r));
        check_circle(centers[0], PEL_PX(r) + 128);
        for (uint32_t c = 0; c < CENTERS; c++)
            if (!is_skipped(r, c))
                check_circle(centers[c], radius_of(r, c + (uint32_t)r));
    }
}

static void test_rings(void)
{
    struct random random = {1};
    struct any_shape s = {.kind = ANY_RING};
    for (int32_t r = 0; r <= RADIUS_MAX; r++)
        for (uint32_t c = 0; c < CENTERS; c++) {
            if (is_skipped(r, c))
                continue;
            s.v[0] = centers[c];
            s.radius = radius_of(r, c + (uint32_t)r / CENTERS);
            s.inner = random_between(&random, 0, s.radius);
            check_fill(&s);
            s.inner = pel_max(s.radius - 256, 0);
            check_fill(&s);
        }
}

static void test_sectors(void)
{
    struct random random = {2};
    struct any_shape s = {.kind = ANY_SECTOR};
    for (int32_t r = 0; r <= RADIUS_MAX; r++)
        for (uint32_t c = 0; c < CENTERS; c++) {
            s.v[0] = centers[c];
            s.radius = radius_of(r, c);
            s.from = (uint16_t)random_word(&random);
            s.to = (uint16_t)random_word(&random);
            if (is_skipped(r, c))
                continue;
            check_fill(&s);
            s.from &= 0xE000;
            check_fill(&s);
        }
}

int main(void)
{
    setup();
    return RUN_TESTS(test_circles, test_rings, test_sectors);
}
