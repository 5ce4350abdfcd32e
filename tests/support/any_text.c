#include "any_text.h"

#include <stdio.h>
#include <string.h>

#include "check.h"

enum { PARTS = 3, STEPS = 5 };

struct any_text any_text;

static void put_byte(int32_t byte)
{
    any_text.bytes[any_text.font.size++] = (uint8_t)byte;
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
    const uint32_t x = form_of(r, v[0] - any_text.x),
                   y = form_of(r, v[1] - any_text.y);
    put_byte(
        (int32_t)((uint32_t)kind | x << 2 | y << 4 | random_word(r) % 4 << 6));
    put_move(x, v[0] - any_text.x);
    put_move(y, v[1] - any_text.y);
    any_text.x = v[0];
    any_text.y = v[1];
}

/* The next point of the path. */
static int16_t *add_point(struct any_outline *o, int32_t x, int32_t y)
{
    int16_t *const v = o->points + 2 * o->path.point_count++;
    v[0] = (int16_t)x;
    v[1] = (int16_t)y;
    return v;
}

static int16_t *add_random(struct random *r, struct any_outline *o)
{
    const int32_t most = random_word(r) % 8 ? 400 : 32767;
    return add_point(o, random_between(r, -most - 1, most),
                     random_between(r, -most - 1, most));
}

#define ADD_VERB(o, verb) ((o)->verbs[(o)->path.verb_count++] = (uint8_t)(verb))

/* A curve or several; the last one ends where the part began if it is closed,
 * and is the last of the part then. */
static void make_curve(struct random *r, struct any_outline *o,
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
        o->is_middle[o->path.point_count] = true;
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

static void make_part(struct random *r, struct any_outline *o)
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
    struct any_outline *const o = &any_text.outline[i];
    const uint32_t from = any_text.font.size;
    o->path = (struct pel_path){.verbs = o->verbs, .points16 = o->points};
    any_text.x = any_text.y = 0;
    for (int32_t n = random_between(r, 0, PARTS); n > 0; n--)
        make_part(r, o);
    any_text.glyph[i] =
        (struct pel_outline_glyph){from, (uint16_t)(any_text.font.size - from),
                                   (uint16_t)random_between(r, 0, 400)};
}

static void print_text(const void *value)
{
    const struct pel_outline_text_block *const t = value;
    const struct pel_transform *const m = &t->transform;
    fprintf(stderr, "text %d %d %d %d at %d %d align %d \"%s\"\n", m->xx, m->xy,
            m->yx, m->yy, m->at.x, m->at.y, (int)t->align, any_text.string);
}

void any_text_make(struct random *r)
{
    static const char letters[] = "abcd\n\n";
    memset(&any_text, 0, sizeof any_text);
    any_text.font.points = any_text.bytes;
    for (int i = 0; i < ANY_GLYPHS; i++)
        make_glyph(r, i);
    any_text.range = (struct pel_font_range){'a', ANY_GLYPHS, 0};
    any_text.pair[0] = (struct pel_outline_pair){0, 1, -60};
    any_text.font = (struct pel_outline_font_asset){
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
        .glyphs = ANY_GLYPHS,
        .pairs = 1,
        .missing = random_word(r) % 2 ? 2 : PEL_FONT_NONE,
        .size = any_text.font.size,
        .range = &any_text.range,
        .glyph = any_text.glyph,
        .points = any_text.bytes,
        .pair = any_text.pair};
    for (size_t i = 0; i + 1 < sizeof any_text.string; i++)
        any_text.string[i] = letters[random_word(r) % sizeof letters];
    any_text.text = (struct pel_outline_text_block){
        .font = &any_text.font,
        .string = any_text.string,
        .transform = pel_outline_transform(
            &any_text.font,
            random_between(r, 0,
                           (random_word(r) % 8 ? 40 : 500) * any_text.font.em),
            random_between(r, -99999, 99999),
            (struct pel_point){random_between(r, -4999, 9999),
                               random_between(r, -4999, 9999)}),
        .align = (enum pel_text_align)(random_word(r) % 3)};
    cases_keep(print_text, &any_text.text, sizeof any_text.text);
    assert_int_equal(pel_outline_font_asset_check(&any_text.font), PEL_OK);
}
