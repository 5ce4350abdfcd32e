/* Core built twice, with and without the walk and the vectors of 64-bit CPUs:
 * the same bytes. */
#include <string.h>

#include "tests/support/canvas.h"
#include "tests/support/check.h"
#include "tests/support/portable.h"
#include "tests/support/shapes.h"

static struct canvas ours, theirs;

/* Boxes of up to `size` px, one item each, mostly unclipped. */
static void check_items(uint64_t count, int32_t size)
{
    for (struct cases c = cases_of(count); cases_next(&c);) {
        struct random *r = &c.random;
        const uint32_t i = random_word(r) % LAYOUT_COUNT;
        struct pel_rect b = {random_between(r, -50, 50) & ~7,
                             random_between(r, -50, 50) & ~7, 0, 0};
        b.x1 = b.x0 + random_between(r, 1, size);
        b.y1 = b.y0 + random_between(r, 1, size);
        struct item item;
        item_random(r, &item, &b, random_word(r) & 1);
        const unsigned style = random_word(r) % CANVAS_STYLES;
        canvas_open(&ours, layouts[i].format, &b, style);
        canvas_open(&theirs, portable_formats[i], &b, style);
        item_draw(&core_default, &ours.surface, &item);
        item_draw(&core_portable, &theirs.surface, &item);
        if (ours.size != theirs.size ||
            memcmp(ours.memory, theirs.memory, ours.size) != 0) {
            canvas_check_same(&theirs, &ours);
            fail_msg("padding differs; %s", cases_replay());
        }
    }
}

static void test_small(void)
{
    check_items(200000, 24);
}

static void test_large(void)
{
    check_items(3000, 300);
}

int main(void)
{
    return RUN_TESTS(test_small, test_large);
}
