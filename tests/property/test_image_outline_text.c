/* Text of outlines against fills of the same outlines as paths, each where the
 * header says that its pen is. */
#include "core/image/smooth_outline_text.h"
#include "tests/support/any_text.h"
#include "tests/support/canvas.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"

static struct canvas whole, other;
static uint64_t scratch[1 << 14];
static const struct pel_rect bounds = {-3, -5, 37, 35};
static const struct pel_flat ink = PEL_FLAT(PEL_RGBA(200, 40, 90, 120));

/* The glyph of a letter, or -1. */
static int index_of(char letter)
{
    return letter <= 'c'                            ? letter - 'a'
           : any_text.font.missing == PEL_FONT_NONE ? -1
                                                    : any_text.font.missing;
}

/* The pen at the letter `to` of its line, which begins at `from`. */
static int32_t pen_at(size_t from, size_t to)
{
    int32_t x = 0;
    int before = -1;
    for (size_t i = from; i <= to; i++) {
        const bool ends = !any_text.string[i] || any_text.string[i] == '\n';
        const int glyph = ends ? -1 : index_of(any_text.string[i]);
        if (before == 0 && glyph == 1)
            x -= 60;
        if (i == to || ends)
            return x;
        x += glyph < 0 ? 0 : any_text.glyph[glyph].advance;
        before = glyph < 0 ? before : glyph;
    }
    return x;
}

/* The coordinate of x and y by a row of the transform, rounded; what is out of
 * range is one beyond it. */
static int32_t place(int32_t a, int32_t b, int32_t at, int32_t x, int32_t y)
{
    const int64_t to = (((int64_t)a * x + (int64_t)b * y + 32768) >> 16) + at;
    return to < PEL_COORDINATE_MIN || to > PEL_COORDINATE_MAX
               ? PEL_COORDINATE_MAX + 1
               : (int32_t)to;
}

/* The points of an outline where a transform places them. */
static void place_points(int32_t *to, const struct any_outline *o,
                         const struct pel_transform *t)
{
    for (int32_t i = 0; i < o->path.point_count; i++) {
        const int16_t *const v = o->points + 2 * i;
        to[2 * i] = place(t->xx, t->xy, t->at.x, v[0], v[1]);
        to[2 * i + 1] = place(t->yx, t->yy, t->at.y, v[0], v[1]);
    }
    for (int32_t i = 2; i < 2 * o->path.point_count; i++)
        if (o->is_middle[i / 2])
            to[i] = (to[i - 2] + to[i + 2]) >> 1;
}

/* Its letters as paths; the first error ends it. */
static enum pel_status fill_paths(const struct pel_surface *surface,
                                  bool smooth)
{
    const struct pel_transform *const t = &any_text.text.transform;
    int32_t y = 0;
    size_t start = 0;
    enum pel_status status = PEL_OK;
    for (size_t i = 0; any_text.string[i] && status == PEL_OK; i++) {
        if (any_text.string[i] == '\n') {
            start = i + 1;
            y -= any_text.font.ascent + any_text.font.descent;
            continue;
        }
        const int glyph = index_of(any_text.string[i]);
        if (glyph < 0)
            continue;
        const int32_t width = pen_at(start, sizeof any_text.string);
        const int32_t x = pen_at(start, i) -
                          (any_text.text.align == PEL_TEXT_LEFT    ? 0
                           : any_text.text.align == PEL_TEXT_RIGHT ? width
                                                                   : width / 2);
        struct pel_transform own = *t;
        own.at.x = place(t->xx, t->xy, t->at.x, x, y);
        own.at.y = place(t->yx, t->yy, t->at.y, x, y);
        int32_t points[6 * ANY_VERBS];
        struct pel_path path = any_text.outline[glyph].path;
        place_points(points, &any_text.outline[glyph], &own);
        path.points16 = NULL;
        path.points32 = points;
        const struct pel_path_shape shape = {.path = &path,
                                             .rule = PEL_NON_ZERO};
        if (any_text.glyph[glyph].size > 0)
            status = (smooth ? pel_smooth_path_fill : pel_path_fill)(
                surface, &shape, &ink.paint, scratch, sizeof scratch);
    }
    return status;
}

static enum pel_status draw(const struct pel_surface *surface, bool smooth)
{
    return (smooth ? pel_smooth_outline_text : pel_outline_text)(
        surface, &any_text.text, &ink.paint, scratch, sizeof scratch);
}

/* To a box around the outlines. */
static void set_box(struct pel_outline_font_asset *font)
{
    font->left = font->bottom = INT16_MAX;
    font->right = font->top = INT16_MIN;
    for (int i = 0; i < ANY_GLYPHS; i++)
        for (int32_t k = 0; k < any_text.outline[i].path.point_count; k++) {
            const int16_t *const v = any_text.outline[i].points + 2 * k;
            font->left = (int16_t)pel_min(font->left, v[0]);
            font->right = (int16_t)pel_max(font->right, v[0]);
            font->bottom = (int16_t)pel_min(font->bottom, v[1]);
            font->top = (int16_t)pel_max(font->top, v[1]);
        }
}

static void draw_bands(struct random *r, bool smooth)
{
    const int32_t rows = random_between(r, 1, 20);
    for (int32_t y = bounds.y0; y < bounds.y1; y += rows) {
        const int32_t x = random_between(r, bounds.x0 - 1, bounds.x1);
        const struct pel_rect halves[2] = {{bounds.x0, y, x, y + rows},
                                           {x, y, bounds.x1, y + rows}};
        for (int i = 0; i < 2; i++) {
            other.surface.clip =
                pel_rect_intersect(&halves[i], &other.surface.bounds);
            assert_int_equal(draw(&other.surface, smooth), PEL_OK);
        }
    }
}

/* Whole, or with a box around the outlines, in bands and in any clip. */
TEST(letters_are_paths_at_their_pens)
{
    long errors = 0;
    for (struct cases c = cases_of(25000); cases_next(&c);) {
        const bool smooth = random_word(&c.random) % 2;
        any_text_make(&c.random);
        canvas_open(&whole, &pel_xrgb8888, &bounds, 0);
        canvas_open(&other, &pel_xrgb8888, &bounds, 0);
        const enum pel_status status = fill_paths(&whole.surface, smooth);
        errors += status != PEL_OK;
        if (status != PEL_OK || random_word(&c.random) % 5) {
            const enum pel_status got = draw(&other.surface, smooth);
            if (got != status)
                fail_msg("%d, not %d: %s", got, status, cases_replay());
        } else {
            set_box(&any_text.font);
            draw_bands(&c.random, smooth);
        }
        canvas_check_same(&whole, &other);
    }
    assert_true(cases_alone() || errors > 0);
}

TEST(hits_are_what_is_filled)
{
    for (struct cases c = cases_of(500); cases_next(&c);) {
        uint8_t level[40 * 40] = {0};
        struct pel_surface s;
        const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));
        any_text_make(&c.random);
        assert_int_equal(
            pel_surface_init(&s, &pel_gray8, level, sizeof level, &bounds),
            PEL_OK);
        if (pel_outline_text(&s, &any_text.text, &white.paint, scratch,
                             sizeof scratch) != PEL_OK)
            continue;
        for (int32_t y = bounds.y0; y < bounds.y1; y++)
            for (int32_t x = bounds.x0; x < bounds.x1; x++)
                if (pel_hit_outline_text(&any_text.text, x, y) !=
                    (level[(y - bounds.y0) * s.stride + x - bounds.x0] > 0))
                    fail_msg("(%d, %d): %s", x, y, cases_replay());
    }
}

/* Whatever the bytes are, they are read inside of their glyph. */
TEST(random_bytes_are_drawn_or_refused)
{
    const uint32_t size = 64;
    for (struct cases c = cases_of(50000); cases_next(&c);) {
        struct random *const r = &c.random;
        any_text_make(r);
        uint8_t *const bytes =
            test_calloc(size, 1); /* cmocka finds what is read behind it */
        for (uint32_t i = 0; i < size; i++)
            bytes[i] = (uint8_t)random_word(r);
        any_text.font.points = bytes;
        any_text.font.size = size;
        for (int i = 0; i < ANY_GLYPHS; i++)
            any_text.glyph[i] = (struct pel_outline_glyph){
                random_word(r) % (size + 1), (uint16_t)(random_word(r) % 40),
                (uint16_t)random_word(r)};
        canvas_open(&other, &pel_xrgb8888, &bounds, 0);
        if (pel_outline_font_asset_check(&any_text.font) == PEL_OK)
            pel_smooth_outline_text(&other.surface, &any_text.text, &ink.paint,
                                    scratch, random_word(r) % sizeof scratch);
        canvas_check(&other);
        test_free(bytes);
    }
}

TEST(arguments_are_checked)
{
    for (struct cases c = cases_of(1); cases_next(&c);)
        any_text_make(&c.random);
    canvas_open(&other, &pel_xrgb8888, &bounds, 0);
    const struct pel_surface *const s = &other.surface;
    assert_int_equal(pel_outline_text(s, &any_text.text, &ink.paint, NULL, 9),
                     PEL_ERROR_NULL);
    any_text.text.tolerance = 3;
    assert_int_equal(pel_smooth_outline_text(s, &any_text.text, &ink.paint,
                                             scratch, sizeof scratch),
                     PEL_ERROR_RANGE);
    any_text.font.em = 255;
    assert_int_equal(pel_outline_font_asset_check(&any_text.font),
                     PEL_ERROR_SIZE);
    any_text.font.em = 256;
    any_text.glyph[1] =
        (struct pel_outline_glyph){any_text.font.size - 1, 2, 0};
    assert_int_equal(pel_outline_font_asset_check(&any_text.font),
                     PEL_ERROR_SIZE);
    any_text.font.version++;
    assert_int_equal(pel_outline_font_asset_check(&any_text.font),
                     PEL_ERROR_RANGE);
    assert_int_equal(pel_outline_font_asset_check(NULL), PEL_ERROR_NULL);
}
