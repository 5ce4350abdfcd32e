/* Scrolls in every format: as if all pixels moved at once; the area that is
 * exposed is the one that no pixel moved to. */
#include "core/image/scroll.h"
#include "tests/support/canvas.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"
#include "tests/support/shapes.h"

enum { SIZE = 70 };

static struct canvas canvas;

static bool holds(const struct pel_rect *r, int32_t x, int32_t y)
{
    return x >= r->x0 && x < r->x1 && y >= r->y0 && y < r->y1;
}

static int32_t random_distance(struct random *r)
{
    static const int32_t reach[] = {0, 1, 3, 20, 100, 65536};
    int32_t d = reach[random_word(r) % 6];
    return random_between(r, -d, d);
}

static void check(const struct pel_rect *all, int32_t dx, int32_t dy,
                  const struct pel_exposed *e)
{
    const struct pel_rect *b = &canvas.surface.bounds;
    for (int32_t y = b->y0; y < b->y1; y++)
        for (int32_t x = b->x0; x < b->x1; x++) {
            bool moved = holds(all, x, y) && holds(all, x - dx, y - dy);
            uint32_t want = moved ? canvas_pixel_before(&canvas, x - dx, y - dy)
                                  : canvas_pixel_before(&canvas, x, y);
            int exposed = 0;
            for (int i = 0; i < e->n; i++)
                exposed += holds(&e->rect[i], x, y);
            if (exposed != (holds(all, x, y) && !moved))
                fail_msg("%s: pixel %d, %d is exposed %d times; %s",
                         canvas.layout->name, x, y, exposed, cases_replay());
            if (canvas_pixel(&canvas, x, y) != want)
                fail_msg("%s: pixel %d, %d: expected %x, got %x; %s",
                         canvas.layout->name, x, y, want,
                         canvas_pixel(&canvas, x, y), cases_replay());
        }
}

TEST(scroll)
{
    for (struct cases c = cases_of(15000); cases_next(&c);) {
        struct random *r = &c.random;
        const struct pel_rect b = shape_bounds(r, SIZE, SIZE);
        canvas_open(&canvas, layouts[c.next % LAYOUT_COUNT].format, &b,
                    random_word(r) % CANVAS_STYLES);
        const struct pel_rect clip = shape_clip(r, &b);
        const struct pel_rect area = shape_clip(r, &b);
        pel_surface_clip(&canvas.surface, &clip);
        const struct pel_rect all =
            pel_rect_intersect(&area, &canvas.surface.clip);
        const int32_t dx = random_distance(r), dy = random_distance(r);
        const struct pel_exposed e = pel_scroll(&canvas.surface, &area, dx, dy);
        canvas_check(&canvas);
        check(&all, dx, dy, &e);
    }
}

TEST(out_of_range)
{
    const struct pel_rect b = {0, 0, 16, 16};
    canvas_open(&canvas, &pel_gray8, &b, 0);
    assert_int_equal(pel_scroll(&canvas.surface, &b, 65537, 0).n, 0);
    assert_int_equal(pel_scroll(&canvas.surface, &b, 0, INT32_MIN).n, 0);
    assert_memory_equal(canvas.memory, canvas.before, canvas.size);
}
