/* Text of outlines against fills of the same outlines as paths, each where the
 * header says that its pen is. */
#include <stdio.h>
#include <string.h>

#include "core/image/smooth_outline_text.h"
#include "tests/support/canvas.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"

enum { GLYPHS = 3, PARTS = 3, STEPS = 5, VERBS = 64, BYTES = 1024 };

/* A glyph as a path, whose points all stand in it. */
struct outline {
    uint8_t verbs[VERBS];
    int16_t points[6 * VERBS];
    struct pel_path path;
};

struct any_font {
    struct outline outline[GLYPHS];
    uint8_t bytes[BYTES];
    struct pel_outline_glyph glyph[GLYPHS];
    struct pel_outline_pair pair[1];
    struct pel_font_range range;
    struct pel_outline_font_asset font;
    int32_t x, y; /* of the last point */
    char string[8];
    struct pel_outline_text_block text;
};

static struct any_font any;
static struct canvas whole, other;
static uint64_t scratch[1 << 14];
static const struct pel_rect bounds = {-3, -5, 37, 35};
static const struct pel_flat ink = PEL_FLAT(PEL_RGBA(200, 40, 90, 120));

static void put_byte(int32_t byte)
{
    any.bytes[any.font.size++] = (uint8_t)byte;
}

/* One of the forms that have room for a move. */
static uint32_t form_of(struct random *r, int32_t move)
{
    const bool is_short = move > -256 && move < 256;
    return move == 0 && random_word(r) % 4  ? 0
           : is_short && random_word(r) % 4 ? move < 0 ? 2u : 1u
                                            : 3u;
}

static void put_move(uint32_t form, int32_t move)
{
    if (form > 0)
        put_byte(form == 2 ? -move : move);
    if (form == 3)
        put_byte(move >> 8);
}

static void put_point(struct random *r, enum pel_outline_point kind,
                      const int16_t *v)
{
    const uint32_t x = form_of(r, v[0] - any.x), y = form_of(r, v[1] - any.y);
    put_byte(
        (int32_t)((uint32_t)kind | x << 2 | y << 4 | random_word(r) % 4 << 6));
    put_move(x, v[0] - any.x);
    put_move(y, v[1] - any.y);
    any.x = v[0];
    any.y = v[1];
}

/* The next point of the path. */
static int16_t *add_point(struct outline *o, int32_t x, int32_t y)
{
    int16_t *const v = o->points + 2 * o->path.point_count++;
    v[0] = (int16_t)x;
    v[1] = (int16_t)y;
    return v;
}

static int16_t *add_random(struct random *r, struct outline *o)
{
    const int32_t most = random_word(r) % 8 ? 400 : 32767;
    return add_point(o, random_between(r, -most - 1, most),
                     random_between(r, -most - 1, most));
}

#define ADD_VERB(o, verb) ((o)->verbs[(o)->path.verb_count++] = (uint8_t)(verb))

/* A curve or several; the last one ends where the part began if it is closed,
 * and is the last of the part then. */
static void make_curve(struct random *r, struct outline *o,
                       const int16_t *start, bool closes)
{
    const bool cubic = random_word(r) % 3 == 0;
    int32_t more = cubic ? 1 : random_between(r, 0, 2);
    const int16_t *v = add_random(r, o), *before;
    put_point(r, cubic ? PEL_OUTLINE_CUBIC : PEL_OUTLINE_QUAD, v);
    for (; more > 0; more--) {
        before = v;
        if (cubic) {
            v = add_random(r, o);
            put_point(r, PEL_OUTLINE_CUBIC, v);
            continue;
        }
        const int32_t x = random_between(r, -300, 300);
        const int32_t y = random_between(r, -300, 300);
        add_point(o, (before[0] + x) >> 1, (before[1] + y) >> 1);
        ADD_VERB(o, PEL_QUAD);
        v = add_point(o, x, y);
        put_point(r, PEL_OUTLINE_QUAD, v);
    }
    if (closes)
        add_point(o, start[0], start[1]);
    else
        put_point(r, PEL_OUTLINE_ON, add_random(r, o));
    ADD_VERB(o, cubic ? PEL_CUBIC : PEL_QUAD);
}

static void make_part(struct random *r, struct outline *o)
{
    const int16_t *const start = add_random(r, o);
    put_point(r, PEL_OUTLINE_BEGIN, start);
    ADD_VERB(o, PEL_MOVE);
    for (int32_t n = random_between(r, 0, STEPS); n > 0; n--) {
        const bool closes = n == 1 && random_word(r) % 2;
        if (random_word(r) % 2) {
            make_curve(r, o, start, closes);
            continue;
        }
        put_point(r, PEL_OUTLINE_ON, add_random(r, o));
        ADD_VERB(o, PEL_LINE);
    }
}

static void make_glyph(struct random *r, int i)
{
    struct outline *const o = &any.outline[i];
    const uint32_t from = any.font.size;
    o->path = (struct pel_path){.verbs = o->verbs, .points16 = o->points};
    any.x = any.y = 0;
    for (int32_t n = random_between(r, 0, PARTS); n > 0; n--)
        make_part(r, o);
    any.glyph[i] =
        (struct pel_outline_glyph){from, (uint16_t)(any.font.size - from),
                                   (uint16_t)random_between(r, 0, 400)};
}

static void print_text(const void *value)
{
    const struct pel_outline_text_block *const t = value;
    const struct pel_transform *const m = &t->transform;
    fprintf(stderr, "text %d %d %d %d at %d %d align %d \"%s\"\n", m->xx, m->xy,
            m->yx, m->yy, m->at.x, m->at.y, (int)t->align, any.string);
}

static void make_text(struct random *r)
{
    static const char letters[] = "abcd\n\n";
    memset(&any, 0, sizeof any);
    any.font.points = any.bytes;
    for (int i = 0; i < GLYPHS; i++)
        make_glyph(r, i);
    any.range = (struct pel_font_range){'a', GLYPHS, 0};
    any.pair[0] = (struct pel_outline_pair){0, 1, -60};
    any.font = (struct pel_outline_font_asset){
        .magic = PEL_OUTLINE_FONT_MAGIC,
        .version = PEL_OUTLINE_FONT_VERSION,
        .em = (uint16_t)random_between(r, 256, 16384),
        .ascent = 300,
        .descent = (uint16_t)random_between(r, 0, 99),
        .left = INT16_MIN,
        .bottom = INT16_MIN,
        .right = INT16_MAX,
        .top = INT16_MAX,
        .ranges = 1,
        .glyphs = GLYPHS,
        .pairs = 1,
        .missing = random_word(r) % 2 ? 2 : PEL_FONT_NONE,
        .size = any.font.size,
        .range = &any.range,
        .glyph = any.glyph,
        .points = any.bytes,
        .pair = any.pair};
    for (size_t i = 0; i + 1 < sizeof any.string; i++)
        any.string[i] = letters[random_word(r) % sizeof letters];
    any.text = (struct pel_outline_text_block){
        .font = &any.font,
        .string = any.string,
        .transform = pel_outline_transform(
            &any.font,
            random_between(r, 0, (random_word(r) % 8 ? 40 : 500) * any.font.em),
            random_between(r, -99999, 99999),
            (struct pel_point){random_between(r, -4999, 9999),
                               random_between(r, -4999, 9999)}),
        .align = (enum pel_text_align)(random_word(r) % 3)};
    cases_keep(print_text, &any.text, sizeof any.text);
    assert_int_equal(pel_outline_font_asset_check(&any.font), PEL_OK);
}

/* The glyph of a letter, or -1. */
static int index_of(char letter)
{
    return letter <= 'c'                       ? letter - 'a'
           : any.font.missing == PEL_FONT_NONE ? -1
                                               : any.font.missing;
}

/* The pen at the letter `to` of its line, which begins at `from`. */
static int32_t pen_at(size_t from, size_t to)
{
    int32_t x = 0;
    int before = -1;
    for (size_t i = from; i <= to; i++) {
        const bool ends = !any.string[i] || any.string[i] == '\n';
        const int glyph = ends ? -1 : index_of(any.string[i]);
        if (before == 0 && glyph == 1)
            x -= 60;
        if (i == to || ends)
            return x;
        x += glyph < 0 ? 0 : any.glyph[glyph].advance;
        before = glyph < 0 ? before : glyph;
    }
    return x;
}
typedef enum pel_status filler(const struct pel_surface *surface,
                               const struct pel_path_shape *shape,
                               const struct pel_paint *paint, void *memory,
                               size_t size);

/* Its letters as paths; the first error ends it. */
static enum pel_status fill_paths(const struct pel_surface *surface,
                                  filler *fill, const struct pel_paint *paint)
{
    const struct pel_transform *const t = &any.text.transform;
    int32_t y = 0;
    size_t start = 0;
    enum pel_status status = PEL_OK;
    for (size_t i = 0; any.string[i] && status == PEL_OK; i++) {
        if (any.string[i] == '\n') {
            start = i + 1;
            y -= any.font.ascent + any.font.descent;
            continue;
        }
        const int glyph = index_of(any.string[i]);
        if (glyph < 0)
            continue;
        const int32_t width = pen_at(start, sizeof any.string);
        const int32_t x =
            pen_at(start, i) - (any.text.align == PEL_TEXT_LEFT    ? 0
                                : any.text.align == PEL_TEXT_RIGHT ? width
                                                                   : width / 2);
        struct pel_transform own = *t;
        own.at.x +=
            (int32_t)(((int64_t)t->xx * x + (int64_t)t->xy * y + 32768) >> 16);
        own.at.y +=
            (int32_t)(((int64_t)t->yx * x + (int64_t)t->yy * y + 32768) >> 16);
        const struct pel_path_shape shape = {.path = &any.outline[glyph].path,
                                             .transform = &own,
                                             .rule = PEL_NON_ZERO};
        if (any.glyph[glyph].size > 0)
            status = fill(surface, &shape, paint, scratch, sizeof scratch);
    }
    return status;
}

TEST(letters_are_paths_at_their_pens)
{
    long errors = 0;
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        const bool smooth = random_word(&c.random) % 2;
        make_text(&c.random);
        canvas_open(&whole, &pel_xrgb8888, &bounds, 0);
        canvas_open(&other, &pel_xrgb8888, &bounds, 0);
        const enum pel_status status = fill_paths(
            &whole.surface, smooth ? pel_smooth_path_fill : pel_path_fill,
            &ink.paint);
        const enum pel_status got =
            (smooth ? pel_smooth_outline_text : pel_outline_text)(
                &other.surface, &any.text, &ink.paint, scratch, sizeof scratch);
        if (got != status)
            fail_msg("%d, not %d: %s", got, status, cases_replay());
        errors += status != PEL_OK;
        canvas_check_same(&whole, &other);
    }
    assert_true(cases_alone() || errors > 0);
}

/* With a box around the outlines, in bands and in any clip. */
TEST(boxes_and_bands_change_no_pixel)
{
    for (struct cases c = cases_of(5000); cases_next(&c);) {
        struct random *const r = &c.random;
        const bool smooth = random_word(r) % 2;
        make_text(r);
        canvas_open(&whole, &pel_xrgb8888, &bounds, 0);
        canvas_open(&other, &pel_xrgb8888, &bounds, 0);
        if (fill_paths(&whole.surface,
                       smooth ? pel_smooth_path_fill : pel_path_fill,
                       &ink.paint) != PEL_OK)
            continue;
        any.font.left = any.font.bottom = INT16_MAX;
        any.font.right = any.font.top = INT16_MIN;
        for (int i = 0; i < GLYPHS; i++)
            for (int32_t k = 0; k < any.outline[i].path.point_count; k++) {
                const int16_t *const v = any.outline[i].points + 2 * k;
                any.font.left = (int16_t)pel_min(any.font.left, v[0]);
                any.font.right = (int16_t)pel_max(any.font.right, v[0]);
                any.font.bottom = (int16_t)pel_min(any.font.bottom, v[1]);
                any.font.top = (int16_t)pel_max(any.font.top, v[1]);
            }
        const int32_t rows = random_between(r, 1, 20);
        for (int32_t y = bounds.y0; y < bounds.y1; y += rows) {
            const int32_t x = random_between(r, bounds.x0 - 1, bounds.x1);
            const struct pel_rect halves[2] = {{bounds.x0, y, x, y + rows},
                                               {x, y, bounds.x1, y + rows}};
            for (int i = 0; i < 2; i++) {
                other.surface.clip =
                    pel_rect_intersect(&halves[i], &other.surface.bounds);
                assert_int_equal(
                    (smooth ? pel_smooth_outline_text : pel_outline_text)(
                        &other.surface, &any.text, &ink.paint, scratch,
                        sizeof scratch),
                    PEL_OK);
            }
        }
        canvas_check_same(&whole, &other);
    }
}

TEST(hits_are_what_is_filled)
{
    for (struct cases c = cases_of(500); cases_next(&c);) {
        uint8_t level[40 * 40] = {0};
        struct pel_surface s;
        const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));
        make_text(&c.random);
        assert_int_equal(
            pel_surface_init(&s, &pel_gray8, level, sizeof level, &bounds),
            PEL_OK);
        if (pel_outline_text(&s, &any.text, &white.paint, scratch,
                             sizeof scratch) != PEL_OK)
            continue;
        for (int32_t y = bounds.y0; y < bounds.y1; y++)
            for (int32_t x = bounds.x0; x < bounds.x1; x++)
                if (pel_hit_outline_text(&any.text, x, y) !=
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
        make_text(r);
        uint8_t *const bytes =
            test_calloc(size, 1); /* cmocka finds what is read behind it */
        for (uint32_t i = 0; i < size; i++)
            bytes[i] = (uint8_t)random_word(r);
        any.font.points = bytes;
        any.font.size = size;
        for (int i = 0; i < GLYPHS; i++)
            any.glyph[i] = (struct pel_outline_glyph){
                random_word(r) % (size + 1), (uint16_t)(random_word(r) % 40),
                (uint16_t)random_word(r)};
        canvas_open(&other, &pel_xrgb8888, &bounds, 0);
        if (pel_outline_font_asset_check(&any.font) == PEL_OK)
            pel_smooth_outline_text(&other.surface, &any.text, &ink.paint,
                                    scratch, random_word(r) % sizeof scratch);
        canvas_check(&other);
        test_free(bytes);
    }
}

TEST(arguments_are_checked)
{
    struct cases c = cases_of(1);
    cases_next(&c);
    make_text(&c.random);
    assert_false(cases_next(&c));
    canvas_open(&other, &pel_xrgb8888, &bounds, 0);
    const struct pel_surface *const s = &other.surface;
    assert_int_equal(pel_outline_text(s, &any.text, &ink.paint, NULL, 9),
                     PEL_ERROR_NULL);
    any.text.tolerance = 3;
    assert_int_equal(pel_smooth_outline_text(s, &any.text, &ink.paint, scratch,
                                             sizeof scratch),
                     PEL_ERROR_RANGE);
    any.font.em = 255;
    assert_int_equal(pel_outline_font_asset_check(&any.font), PEL_ERROR_SIZE);
    any.font.em = 256;
    any.glyph[1] = (struct pel_outline_glyph){any.font.size - 1, 2, 0};
    assert_int_equal(pel_outline_font_asset_check(&any.font), PEL_ERROR_SIZE);
    any.font.version++;
    assert_int_equal(pel_outline_font_asset_check(&any.font), PEL_ERROR_RANGE);
    assert_int_equal(pel_outline_font_asset_check(NULL), PEL_ERROR_NULL);
}
