/* Broken contracts: PEL_ASSERT fires where it is compiled in, and nothing is
 * drawn, whether it is or not. */
#define _DEFAULT_SOURCE /* alarm */
#include <unistd.h>

#include "tests/support/any_shape.h"
#include "tests/support/check.h"
#include "tests/support/hits.h"
#include "tests/support/layouts.h"

static int broken;

void assert_broken(void);
void assert_broken(void)
{
    broken++;
}

static int hints;

void hint_given(void);
void hint_given(void)
{
    hints++;
}

#ifdef PEL_CONFIG_FILE
enum { ASSERTS = 1 };
#else
enum { ASSERTS = 0 };
#endif

static struct hits hits;

static const int32_t illegal[] = {PEL_COORDINATE_MIN - 1,
                                  PEL_COORDINATE_MAX + 1,
                                  -16777216,
                                  16777215,
                                  16777216,
                                  INT32_MIN,
                                  INT32_MAX};
enum { ILLEGAL = sizeof illegal / sizeof illegal[0] };

static void expect_broken(const char *name, int32_t value)
{
    if ((broken > 0) != (ASSERTS == 1))
        fail_msg("%s, %d: PEL_ASSERT fired %d times", name, value, broken);
    if (hits.pixels)
        fail_msg("%s, %d: %llu pixels drawn", name, value,
                 (unsigned long long)hits.pixels);
    broken = 0;
}

static void open_hits(void)
{
    const struct pel_rect bounds = {0, 0, 16, 16};
    hits_open(&hits, &bounds);
    broken = 0;
}

/* The k-th of six coordinates of a legal triangle is replaced. */
static void spoil(struct pel_point v[3], int k, int32_t value)
{
    v[0] = (struct pel_point){0, 0};
    v[1] = (struct pel_point){4000, 100};
    v[2] = (struct pel_point){100, 4000};
    if (k % 2)
        v[k / 2].y = value;
    else
        v[k / 2].x = value;
}

/* A shape with a point at `base` that covers the pixel there; the others lie
 * from it by `way` sub-pixels in x and y. */
static struct any_shape shape_at(enum any_kind kind, int32_t base, int32_t way)
{
    const int32_t far = base + way, small = way / 64;
    struct any_shape s = {.kind = kind,
                          .v = {{base, base}, {far, base}, {base, far}},
                          .n = 3,
                          .radius = PEL_PX(9),
                          .inner = kind == ANY_ELLIPSE ? PEL_PX(9) : 64,
                          .from = 0x1000,
                          .to = 0xF000};
    if (kind == ANY_RECTANGLE || kind == ANY_ROUNDED_RECTANGLE) {
        const int32_t low = pel_min(base, far), high = pel_max(base, far);
        s.v[0] = (struct pel_point){low, low};
        s.v[1] = (struct pel_point){high, high};
        s.radius = 64;
    }
    if (kind == ANY_THICK_LINE) {
        s.v[0] = (struct pel_point){base + small, base + 3 * small};
        s.v[1] = (struct pel_point){far, base + 3 * small};
        s.radius = 80;
    }
    return s;
}

/* Draws around the pixel; polygons tell by their status. */
static void draw_around(const struct any_shape *s, int32_t pixel, bool outline)
{
    const int32_t low = pel_max(pixel - 16, -32768);
    const int32_t high = pel_min(pixel + 16, 32768);
    uint32_t scratch[PEL_POLYGON_SCRATCH_SIZE(3) / 4];
    hits_open(&hits, &(struct pel_rect){low, low, high, high});
    broken = 0;
    if (s->kind != ANY_POLYGON) {
        (outline ? any_draw_outline : any_draw)(&hits.surface, s, &hits.paint);
        expect_broken(any_name(s), pixel);
        struct any_shape way = *s; /* with other ends */
        for (; way.n < 6; way.n++)
            if (any_draw_smooth(&hits.surface, &way, &hits.paint))
                expect_broken("smooth", pixel);
    } else {
        assert_int_equal(pel_polygon(&hits.surface, POLYGON(s), &hits.paint,
                                     scratch, sizeof scratch),
                         PEL_ERROR_RANGE);
        assert_int_equal(broken + (int)hits.pixels, 0);
    }
}

/* One number changed: nothing is hit or drawn; then back again. */
static void check_number(struct any_shape *s, int32_t *number, int32_t to,
                         int32_t pixel)
{
    const int32_t from = *number;
    assert_true(any_hit(s, pixel, pixel));
    *number = to;
    if (any_hit(s, pixel, pixel))
        fail_msg("%s at %d: hit with %d instead of %d", any_name(s), pixel, to,
                 from);
    draw_around(s, pixel, false);
    draw_around(s, pixel, true);
    *number = from;
}

static void check_pixel(const struct any_shape *s, int32_t x, int32_t y,
                        int32_t pixel)
{
    assert_true(any_hit(s, pixel, pixel));
    if (any_hit(s, x, y))
        fail_msg("%s at %d: pixel %d, %d", any_name(s), pixel, x, y);
}

static void check_ranges(struct any_shape *s, int32_t pixel)
{
    static const int32_t far_pixel[] = {INT32_MIN, -32769, 32768, INT32_MAX};
    static const int32_t radius[] = {INT32_MIN, -1, PEL_PX(32767) + 1,
                                     INT32_MAX};
    const bool is_round = any_points(s) == 1;
    const bool is_thick =
        s->kind == ANY_THICK_LINE || s->kind == ANY_ROUNDED_RECTANGLE;
    for (int k = 0; k < any_points(s) * ILLEGAL; k++) {
        check_number(s, &s->v[k / ILLEGAL].x, illegal[k % ILLEGAL], pixel);
        check_number(s, &s->v[k / ILLEGAL].y, illegal[k % ILLEGAL], pixel);
    }
    for (int i = 0; i < 4; i++) {
        check_pixel(s, far_pixel[i], pixel, pixel);
        check_pixel(s, pixel, far_pixel[i], pixel);
        if (is_round || is_thick)
            check_number(s, &s->radius, radius[i], pixel);
        if (s->kind == ANY_ELLIPSE || s->kind == ANY_RING || s->kind == ANY_ARC)
            check_number(s, &s->inner, radius[i], pixel);
    }
}

/* Of paths and strokes test_path_errors.c. */
TEST(ranges)
{
    for (int kind = 0; kind < ANY_PATH; kind++) {
        const enum any_kind k = (enum any_kind)kind;
        struct any_shape low = shape_at(k, PEL_COORDINATE_MIN, PEL_PX(9));
        struct any_shape middle = shape_at(k, 0, PEL_PX(9));
        struct any_shape high = shape_at(k, PEL_COORDINATE_MAX, -PEL_PX(9));
        check_ranges(&low, -32768);
        check_ranges(&middle, 0);
        check_ranges(&high, 32767);
    }
}

/* The paint's set-up must not trip over what the triangle then refuses. */
TEST(gouraud)
{
    static uint32_t pixels[256];
    const pel_color c[3] = {PEL_RGB(255, 0, 0), PEL_RGB(0, 255, 0), 0};
    struct pel_surface s;
    struct pel_point v[3];
    open_hits();
    s = surface_of(&pel_xrgb8888, pixels, sizeof pixels, 16, 16);
    alarm(20);
    for (int k = 0; k < 6; k++)
        for (int i = 0; i < ILLEGAL; i++) {
            spoil(v, k, illegal[i]);
            pel_triangle_gouraud(&s, v, c);
            expect_broken("gouraud", illegal[i]);
            pel_smooth_triangle_gouraud(&s, v, c);
            expect_broken("smooth gouraud", illegal[i]);
            pel_triangle_or_line(&hits.surface, v, &hits.paint);
            expect_broken("triangle or line", illegal[i]);
        }
    v[0] = v[1] = v[2] = (struct pel_point){INT32_MIN, INT32_MAX};
    v[1].x = INT32_MAX;
    v[1].y = INT32_MIN;
    pel_triangle_gouraud(&s, v, c);
    expect_broken("gouraud", INT32_MIN);
    for (int i = 0; i < 256; i++)
        assert_int_equal(pixels[i], 0);
    alarm(0);
}

/* Places of text, copies and the rim of a fan. */
TEST(places)
{
    static const struct pel_font_glyph glyph = {0, 8, 1, 0, 1, 255};
    static const uint8_t bits[1] = {255};
    static const struct pel_font_asset font = {
        PEL_FONT_MAGIC, PEL_FONT_VERSION, 255,  255,  0,    1, 0,   1,
        NULL,           &glyph,           bits, NULL, NULL, 0, NULL};
    static const int32_t place[] = {INT32_MIN, -65537, 65537, INT32_MAX};
    struct pel_point rim[3] = {{1, 2}, {3, 4}, {5, 6}};
    uint32_t pixel = 0;
    struct pel_surface s;
    open_hits();
    s = surface_of(&pel_xrgb8888, &pixel, sizeof pixel, 1, 1);
    for (int k = 0; k < 24; k++) {
        int32_t at[6] = {0, 0, 1, 1, 0, 0};
        at[k / 4] = place[k % 4];
        const struct pel_copy_part part = {
            &s, {at[0], at[1], at[2], at[3]}, at[4], at[5]};
        const struct pel_text_block text = {&font, "a\na", at[0], at[1]};
        pel_copy(&s, &part);
        expect_broken("copy", at[k / 4]);
        pel_copy_alpha(&s, &part, 128);
        expect_broken("copy alpha", at[k / 4]);
        if (k < 8) {
            pel_text(&hits.surface, &text, &hits.paint);
            expect_broken("text", at[k / 4]);
            pel_text_scaled(&hits.surface, &text, 2, &hits.paint);
            expect_broken("scaled text", at[k / 4]);
        }
        if (k < 12) {
            const struct pel_text_column column = {
                text, k < 8 ? 0 : place[k % 4], 0, PEL_TEXT_LEFT};
            pel_text_column_draw(&hits.surface, &column, &hits.paint);
            expect_broken("column of text", at[k / 4]);
        }
    }
    for (int i = 0; i < ILLEGAL; i++) {
        pel_fan_perimeter(rim, 3, (struct pel_point){illegal[i], 0}, 99, 5);
        expect_broken("fan's centre", illegal[i]);
        pel_fan_perimeter(rim, 3, (struct pel_point){0, 0}, illegal[i], 5);
        expect_broken("fan's radius", illegal[i]);
    }
    assert_int_equal(rim[2].y, 6);
}

/* A fill-only twin has no blend, load and store. */
static void check_twin(const struct pel_format *twin)
{
    static uint16_t pixels[64];
    const struct pel_flat half = PEL_FLAT(PEL_RGBA(255, 255, 255, 128));
    const struct pel_flat full = PEL_FLAT(PEL_RGB(255, 255, 255));
    const struct pel_point clipped[3] = {PEL_AT(0, 0), PEL_AT(16, 0),
                                         PEL_AT(0, 16)};
    const struct pel_point inside[3] = {PEL_AT(0, 0), PEL_AT(8, 0),
                                        PEL_AT(0, 8)};
    const struct pel_point *const v[] = {clipped, inside};
    const pel_color clear[3] = {PEL_RGB(255, 0, 0), PEL_RGB(0, 255, 0),
                                PEL_RGBA(0, 0, 255, 10)};
    const pel_color opaque[3] = {PEL_RGB(255, 0, 0), PEL_RGB(0, 255, 0),
                                 PEL_RGB(0, 0, 255)};
    struct pel_blend blend;
    struct pel_surface s, other;
    s = surface_of(twin, pixels, sizeof pixels, 8, 8);
    other = surface_of(&pel_gray8, pixels, sizeof pixels, 8, 8);
    pel_clear(&s, 0);
    pel_circle(&s, clipped[0], PEL_PX(4), &half.paint);
    expect_broken("twin, circle", 0);
    pel_copy_keyed(&other, &(struct pel_copy_part){&s, s.bounds, 0, 0}, 0);
    expect_broken("twin, copy", 0);
    assert_int_equal(pel_blend_init(&blend, &full.paint, PEL_BLEND_XOR),
                     PEL_OK);
    pel_circle(&s, clipped[0], PEL_PX(4), &blend.paint);
    expect_broken("twin, blend", 0);
    for (int kind = 0; kind < ANY_PATH; kind++) {
        const struct any_shape shape = shape_at(kind, 500, 1000);
        if (any_draw_smooth(&s, &shape, &full.paint))
            expect_broken("twin, smooth", kind);
    }
    for (int k = 0; k < 2; k++) {
        pel_triangle(&s, v[k], &half.paint);
        expect_broken("twin, flat", k);
        pel_triangle_gouraud(&s, v[k], clear);
        expect_broken("twin, alpha", k);
        pel_triangle_gouraud(&s, v[k], opaque);
        expect_broken("twin, opaque", k);
    }
    for (int i = 0; i < 64; i++)
        assert_int_equal(pixels[i], 0);
    pel_triangle(&s, clipped, &full.paint);
    for (int i = 0; i < 64; i++)
        assert_int_equal(pixels[i], 0xFFFF);
    assert_int_equal(broken, 0);
}

TEST(fill_only_twins)
{
    open_hits();
    check_twin(&pel_rgb565_le_fill);
    check_twin(&pel_rgb565_be_fill);
}

/* Palettes are sources: nothing can be drawn into them. */
TEST(palettes)
{
    static const pel_color colors[2] = {PEL_RGB(0, 0, 0),
                                        PEL_RGB(255, 255, 255)};
    static const struct pel_palette palette = PEL_PALETTE(8, colors);
    static const struct pel_flat red = PEL_FLAT(PEL_RGB(255, 0, 0));
    static const struct pel_rect all = {0, 0, 8, 8};
    uint8_t pixels[64] = {0};
    struct pel_surface s;
    struct pel_blend blend;
    pel_blend_init(&blend, &red.paint, PEL_BLEND_XOR);
    assert_int_equal(
        pel_surface_init(&s, &palette.format, pixels, sizeof pixels, &all),
        PEL_OK);
    open_hits();
    pel_box(&s, &all, &blend.paint);
    expect_broken("palette, blend", 0);
    pel_clear(&s, red.color);
    for (int i = 0; i < 64; i++)
        assert_int_equal(pixels[i], 0);
}

/* A shape in pixels where sub-pixels are asked for is told; the same in
 * sub-pixels is not, wherever it is. */
TEST(pixels_for_sub_pixels)
{
    const struct any_shape px = {
        .v = {{120, 100}, {200, 110}, {150, 240}, {10, 99}},
        .n = 4,
        .radius = 30,
        .inner = 20,
        .to = 20000};
    static const struct pel_flat paint = PEL_FLAT(PEL_RGB(1, 2, 3));
    static uint32_t pixels[16 * 16];
    const struct pel_surface surface =
        surface_of(&pel_xrgb8888, pixels, sizeof pixels, 16, 16);
    for (int kind = 0; kind < ANY_KINDS; kind++)
        for (int times = 1; times <= 256; times *= 16)
            for (int smooth = 0; smooth < 2; smooth++) {
                struct any_shape s = px;
                hints = 0;
                s.kind = (enum any_kind)kind;
                if (s.kind == ANY_PATH) /* units of its own */
                    continue;
                s.radius *= times;
                s.inner *= times;
                for (int i = 0; i < 4; i++)
                    s.v[i] = pel_point_of(s.v[i].x * times, s.v[i].y * times);
                if (!smooth)
                    any_draw(&surface, &s, &paint.paint);
                else if (!any_draw_smooth(&surface, &s, &paint.paint))
                    continue;
                if ((hints > 0) != (ASSERTS == 1 && times == 1))
                    fail_msg("%s%s, times %d: %d hints",
                             smooth ? "smooth " : "", any_name(&s), times,
                             hints);
            }
    assert_int_equal(pel_at(-3, 7.5).x, -768);
    assert_int_equal(pel_at(-3, 7.5).y, 1920);
}
