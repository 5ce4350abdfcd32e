/* Very tall and very wide shapes into real memory, by the default build and by
 * the portable one: the same bytes. Heights around the 4,094 rows up to which
 * triangles go the fast way, one row of 20,000 px, and surfaces of 32,767 px,
 * the largest that there are. */
#include <string.h>

#include "tests/support/check.h"
#include "tests/support/portable.h"
#include "tests/support/shapes.h"

enum { BYTES = 17 << 20 };

static uint32_t memory[2][BYTES / 4];

/* Both memories begin alike, other for every case. */
static size_t clear(struct random *r, const struct pel_format *format,
                    int32_t width, int32_t height)
{
    const size_t size = (size_t)pel_stride(format, width) * (size_t)height;
    const int value = (int)(random_word(r) & 255);
    assert_true(size <= BYTES);
    memset(memory[0], value, size);
    memset(memory[1], value, size);
    return size;
}

static void check_item(struct random *r, const struct pel_rect *b, uint32_t f,
                       const struct item *item)
{
    const struct pel_format *format[2] = {layouts[f].format,
                                          portable_formats[f]};
    const int32_t width = b->x1 - b->x0, height = b->y1 - b->y0;
    const size_t size = clear(r, format[0], width, height);
    for (int k = 0; k < 2; k++) {
        struct pel_surface s;
        assert_int_equal(pel_surface_init_rect(&s, format[k], memory[k],
                                               pel_stride(format[k], width), b),
                         PEL_OK);
        item_draw(k ? &core_portable : &core_default, &s, item);
    }
    if (memcmp(memory[0], memory[1], size) != 0)
        fail_msg("%s, %d x %d, shape %d: bytes differ; %s", layouts[f].name,
                 width, height, item->kind, cases_replay());
}

/* The formats that have a fast writer, and one that has none. */
static uint32_t random_format(struct random *r)
{
    static const uint32_t index[] = {0, 1, 2, 6, 7, 11};
    return index[random_word(r) % 6];
}

/* An item whose first three points touch the sides of its box. */
static struct item item_in(struct random *r, const struct pel_rect *box)
{
    const struct pel_rect px = {PEL_PX(box->x0), PEL_PX(box->y0),
                                pel_min(PEL_PX(box->x1), PEL_COORDINATE_MAX),
                                pel_min(PEL_PX(box->y1), PEL_COORDINATE_MAX)};
    const int32_t inset = random_between(r, 0, 300);
    struct item item;
    item_random(r, &item, box, random_word(r) & 1);
    if (random_word(r) % 4)
        item.kind = random_word(r) & 1 ? ITEM_TRIANGLE : ITEM_GOURAUD;
    for (int i = 0; i < 3; i++) {
        item.v[i].x = random_between(r, px.x0, px.x1);
        item.v[i].y = random_between(r, px.y0, px.y1);
    }
    item.v[0].y = px.y0 + pel_min(inset, (px.y1 - px.y0) / 4);
    item.v[1].y = px.y1;
    item.v[random_word(r) % 3].x = px.x0;
    item.v[random_word(r) % 2].x = px.x1;
    return item;
}

static void check_sizes(uint64_t count, const int32_t width[2],
                        const int32_t height[2])
{
    for (struct cases c = cases_of(count); cases_next(&c);) {
        struct random *r = &c.random;
        const int32_t w = random_between(r, width[0], width[1]);
        const int32_t h = random_between(r, height[0], height[1]);
        const int32_t x = random_between(r, -32768, 32767 - w);
        const int32_t y = random_between(r, -32768, 32767 - h);
        struct pel_rect b = {x, y, x + w, y + h};
        if (random_word(r) & 1)
            b = (struct pel_rect){0, 0, w, h};
        const struct item item = item_in(r, &b);
        check_item(r, &b, random_format(r), &item);
    }
}

static void test_around_4094_rows(void)
{
    check_sizes(400, (const int32_t[]){1, 30}, (const int32_t[]){4090, 4100});
    check_sizes(40, (const int32_t[]){900, 1000},
                (const int32_t[]){4093, 4096});
}

static void test_one_row_of_20000_px(void)
{
    check_sizes(1000, (const int32_t[]){20000, 20000}, (const int32_t[]){1, 1});
    check_sizes(1000, (const int32_t[]){16382, 16386}, (const int32_t[]){1, 4});
}

static void test_largest_width(void)
{
    check_sizes(200, (const int32_t[]){32767, 32767}, (const int32_t[]){1, 33});
}

static void test_largest_height(void)
{
    check_sizes(200, (const int32_t[]){1, 33}, (const int32_t[]){32767, 32767});
}

int main(void)
{
    return RUN_TESTS(test_around_4094_rows, test_one_row_of_20000_px,
                     test_largest_width, test_largest_height);
}
