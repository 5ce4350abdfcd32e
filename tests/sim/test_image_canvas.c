/* Canvases: bands of every height give the bytes of the whole, in every format.
 */
#include <string.h>

#include "tests/support/check.h"

#include "core/pel.h"
#include "sim/image/canvas.h"
#include "sim/image/format_names.h"

enum { WIDTH = 41, HEIGHT = 37 };

/* Every shape, opaque and translucent, partly outside; the clip is what the
 * surface has. */
static void draw_shapes(struct pel_surface *surface, void *context)
{
    static const struct pel_point v[6] = {{-300, 200},   {9000, 1111},
                                          {4000, 9999},  {6000, -500},
                                          {10600, 8000}, {300, 7000}};
    static const pel_color c[3] = {PEL_RGBA(255, 0, 64, 255),
                                   PEL_RGBA(0, 255, 0, 96),
                                   PEL_RGBA(16, 32, 255, 200)};
    const struct pel_flat solid = PEL_FLAT(PEL_RGB(200, 180, 40));
    const struct pel_flat glass = PEL_FLAT(PEL_RGBA(90, 220, 250, 128));
    const struct pel_polygon_shape outline = {v, 6, PEL_EVEN_ODD};
    uint32_t scratch[256];
    int *calls = context;
    (*calls)++;
    pel_triangle(surface, v, &solid.paint);
    pel_triangle_gouraud(surface, v + 3, c);
    pel_circle(surface, v[1], 3000, &glass.paint);
    pel_rectangle(surface, v[0], v[2], &glass.paint);
    pel_line(surface, v[3], v[5], &solid.paint);
    assert_int_equal(
        pel_polygon(surface, &outline, &glass.paint, scratch, sizeof scratch),
        PEL_OK);
}

static void picture_of(const struct pel_format *format, int rows,
                       struct picture *picture)
{
    struct canvas canvas;
    int calls = 0;
    assert_true(canvas_init(&canvas, format, WIDTH, HEIGHT));
    pel_clear(&canvas.surface, PEL_RGB(30, 60, 90));
    assert_true(canvas_draw(&canvas, rows, draw_shapes, &calls));
    assert_int_equal(calls, rows ? (HEIGHT + rows - 1) / rows : 1);
    assert_true(canvas_picture(&canvas, picture));
    canvas_free(&canvas);
}

static void check_same(const struct picture *want, const struct picture *got,
                       const char *format, int rows)
{
    const size_t size = sizeof(pel_color) * WIDTH * HEIGHT;
    if (memcmp(want->pixels, got->pixels, size) != 0)
        fail_msg("%s in bands of %d rows differs", format, rows);
}

TEST(bands)
{
    for (const struct format_name *f = format_names; f->name; f++) {
        struct picture whole;
        picture_of(f->format, 0, &whole);
        for (int rows = 1; rows <= HEIGHT + 3; rows++) {
            struct picture parts;
            if (!canvas_bands_legal(f->format, rows))
                continue;
            picture_of(f->format, rows, &parts);
            check_same(&whole, &parts, f->name, rows);
            picture_free(&parts);
        }
        picture_free(&whole);
    }
}

TEST(legal)
{
    assert_true(canvas_bands_legal(&pel_rgb888, 1));
    assert_true(canvas_bands_legal(&pel_mono1_pages, 16));
    assert_false(canvas_bands_legal(&pel_mono1_pages, 12));
    assert_false(canvas_bands_legal(&pel_rgb888, -1));
    assert_false(picture_size_legal(0, 1));
    assert_false(picture_size_legal(1, 32768));
    assert_false(picture_size_legal(32767, 32767));
    assert_true(picture_size_legal(16384, 16384));
}

/* The list for messages is the table. */
TEST(names)
{
    const char *list = format_list();
    for (const struct format_name *f = format_names; f->name; f++) {
        const size_t length = strlen(f->name);
        assert_ptr_equal(format_find(f->name), f->format);
        assert_memory_equal(list, f->name, length);
        list += length;
        if (f[1].name) {
            assert_memory_equal(list, ", ", 2);
            list += 2;
        }
    }
    assert_string_equal(list, "");
    assert_null(format_find("rgb565"));
}
