/* The writers of spans by vectors, and the one that owns the row loop of a
 * triangle (fast_flat.c), against the portable build, byte for byte: first rows
 * of every width from 0 to 40 px, at every place of a row against 16 bytes,
 * heights on both sides of the one from which rows are prefetched. */
#include <string.h>

#include "tests/support/check.h"
#include "tests/support/portable.h"

enum { WIDTH = 60, HEIGHT = 140, STRIDE_MAX = 4 * WIDTH + 20 };
enum { BYTES = HEIGHT * STRIDE_MAX + 64 };

/* The same memory twice, aligned to 16. */
static uint64_t memory[2][BYTES / 8];

struct setting {
    uint32_t format; /* index of layouts[] */
    int32_t offset;  /* bytes from a multiple of 16 to the first line */
    int32_t padding; /* bytes of a line beside its pixels */
    struct item item;
};

static void check_setting(const struct setting *t)
{
    const struct pel_format *format[2] = {layouts[t->format].format,
                                          portable_formats[t->format]};
    const struct pel_rect b = {0, 0, WIDTH, HEIGHT};
    const int32_t stride = pel_stride(format[0], WIDTH) + t->padding;
    for (int k = 0; k < 2; k++) {
        struct pel_surface s;
        for (uint64_t i = 0; i < BYTES / 8; i++)
            memory[k][i] = i * UINT64_C(0x9E3779B97F4A7C15);
        uint8_t *first = (uint8_t *)memory[k] + t->offset;
        assert_int_equal(
            pel_surface_init_rect(&s, format[k], first, stride, &b), PEL_OK);
        item_draw(k ? &core_portable : &core_default, &s, &t->item);
    }
    if (memcmp(memory[0], memory[1], sizeof memory[0]) != 0)
        fail_msg("%s, offset %d, padding %d, shape %d, colour %08x, "
                 "%d,%d %d,%d %d,%d: bytes differ",
                 layouts[t->format].name, t->offset, t->padding, t->item.kind,
                 t->item.color[0], t->item.v[0].x, t->item.v[0].y,
                 t->item.v[1].x, t->item.v[1].y, t->item.v[2].x,
                 t->item.v[2].y);
}

/* A first row of `width` pixels from `x` on, then narrower ones to the left,
 * the middle or the right; or the same upside down. */
static void set_triangle(struct item *item, int32_t x, int32_t width,
                         int32_t height, int form)
{
    const int32_t top = 128 + PEL_PX(2), left = PEL_PX(x) + 128;
    const int32_t third = left + PEL_PX(width) * (form % 3) / 2;
    item->v[0] = (struct pel_point){left, top};
    item->v[1] = (struct pel_point){left + PEL_PX(width), top};
    item->v[2] = (struct pel_point){third, top + PEL_PX(height)};
    if (form < 3)
        return;
    item->v[0].y = item->v[1].y = top + PEL_PX(height) - 1;
    item->v[2].y = top - 1;
}

static void check_colors(struct setting *t)
{
    static const pel_color colors[] = {0xFF123456, 0x80FF40C0, 0x01FFFFFF,
                                       0xFE000102, 0x00FFFFFF};
    t->item.kind = ITEM_TRIANGLE;
    for (size_t i = 0; i < sizeof colors / sizeof colors[0]; i++) {
        t->item.color[0] = colors[i];
        check_setting(t);
    }
    t->item.kind = ITEM_GOURAUD;
    t->item.color[0] = 0xFFFF0040;
    t->item.color[1] = 0xFF0080FF;
    t->item.color[2] = 0xFF20FF00;
    check_setting(t);
}

/* xrgb8888 and xbgr8888, the three 5-6-5 formats and xrgb1555; one without any
 * writer of its own. */
static const uint32_t formats[] = {6, 7, 0, 1, 2, 3, 11};
enum { FORMATS = sizeof formats / sizeof formats[0] };

static void check_places(struct setting *t)
{
    const int32_t word = layouts[t->format].format->word;
    for (t->offset = 0; t->offset < 16; t->offset += word)
        check_colors(t);
}

static void check_heights(const int32_t *heights, int32_t n, int32_t step)
{
    struct setting t = {.item = {.n = 3}};
    for (uint32_t f = 0; f < FORMATS; f++)
        for (int32_t width = 0; width <= 41; width += step)
            for (int32_t h = 0; h < n; h++) {
                t.format = formats[f];
                t.padding = (width + h) % 4 * 4;
                set_triangle(&t.item, 3 + h, width, heights[h],
                             (width + (int)f) % 6);
                check_places(&t);
            }
}

static void test_one_row(void)
{
    check_heights((const int32_t[]){1, 2}, 2, 1);
}

static void test_around_16_rows(void)
{
    check_heights((const int32_t[]){15, 16, 17}, 3, 1);
}

static void test_many_rows(void)
{
    check_heights((const int32_t[]){40}, 1, 1);
}

/* Rows are fetched into the cache there. */
static void test_around_128_rows(void)
{
    check_heights((const int32_t[]){127, 128, 129}, 3, 10);
}

int main(void)
{
    return RUN_TESTS(test_one_row, test_around_16_rows, test_many_rows,
                     test_around_128_rows);
}
