/* Core built twice, with and without the walk and the vectors of 64-bit CPUs:
 * the same bytes. The second build's names begin with portable_. */
#include <string.h>

#include "tests/support/canvas.h"
#include "tests/support/check.h"
#include "tests/support/items.h"
#include "tests/support/shapes.h"

void portable_pel_triangle(const struct pel_surface *, const struct pel_point *,
                           const struct pel_paint *);
void portable_pel_triangle_gouraud(const struct pel_surface *,
                                   const struct pel_point *, const pel_color *);
enum pel_status portable_pel_polygon(const struct pel_surface *,
                                     const struct pel_outline *,
                                     const struct pel_paint *, void *, size_t);
void portable_pel_circle(const struct pel_surface *, struct pel_point, int32_t,
                         const struct pel_paint *);
void portable_pel_line(const struct pel_surface *, struct pel_point,
                       struct pel_point, const struct pel_paint *);
void portable_pel_rectangle(const struct pel_surface *, struct pel_point,
                            struct pel_point, const struct pel_paint *);
void portable_pel_flat_fill(const struct pel_paint *, const struct pel_rows *);

#define PORTABLE(name) extern const struct pel_format portable_pel_##name
PORTABLE(rgb565_le);
PORTABLE(rgb565_be);
PORTABLE(bgr565_le);
PORTABLE(xrgb1555_le);
PORTABLE(rgb888);
PORTABLE(bgr888);
PORTABLE(xrgb8888);
PORTABLE(xbgr8888);
PORTABLE(rgbx8888);
PORTABLE(bgrx8888);
PORTABLE(rgb332);
PORTABLE(gray8);
PORTABLE(gray4);
PORTABLE(mono1);
PORTABLE(mono1_pages);

/* In the order of layouts[]. */
static const struct pel_format *const portable_formats[LAYOUT_COUNT] = {
    &portable_pel_rgb565_le,   &portable_pel_rgb565_be,
    &portable_pel_bgr565_le,   &portable_pel_xrgb1555_le,
    &portable_pel_rgb888,      &portable_pel_bgr888,
    &portable_pel_xrgb8888,    &portable_pel_xbgr8888,
    &portable_pel_rgbx8888,    &portable_pel_bgrx8888,
    &portable_pel_rgb332,      &portable_pel_gray8,
    &portable_pel_gray4,       &portable_pel_mono1,
    &portable_pel_mono1_pages,
};

static const struct core core_portable = {portable_pel_triangle,
                                          portable_pel_triangle_gouraud,
                                          portable_pel_polygon,
                                          portable_pel_circle,
                                          portable_pel_line,
                                          portable_pel_rectangle,
                                          {portable_pel_flat_fill, NULL}};

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

static void test_small(void **state)
{
    (void)state;
    check_items(200000, 24);
}

static void test_large(void **state)
{
    (void)state;
    check_items(3000, 300);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_small),
        cmocka_unit_test(test_large),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
