#include "any_shape.h"

#include <stdio.h>

#include "reference_shape.h"
#include "shapes.h"

static void print(const void *value)
{
    const struct any_shape *s = value;
    fprintf(stderr, "%s", any_name(s));
    for (int32_t i = 0; i < any_points(s); i++)
        fprintf(stderr, " (%.13g, %.13g)", s->v[i].x / 256., s->v[i].y / 256.);
    fprintf(stderr, " px, radius %.13g, inner %.13g, rule %d, turns %d to %d\n",
            s->radius / 256., s->inner / 256., (int)s->rule, s->from, s->to);
}

/* Instead of its points. */
static void keep(const struct any_shape *s)
{
    cases_forget();
    cases_keep(print, s, sizeof *s);
}

/* Rounded down, 32,767 px at most. */
static int32_t distance(const struct pel_point *a, const struct pel_point *b)
{
    int64_t dx = a->x - b->x, dy = a->y - b->y, d = 0;
    for (int64_t bit = 1 << 22; bit; bit >>= 1)
        if ((d + bit) * (d + bit) <= dx * dx + dy * dy)
            d += bit;
    return (int32_t)(d < PEL_PX(32767) ? d : PEL_PX(32767));
}

/* Near a distance of two points, or whole pixels, or anything. */
static int32_t random_radius(struct random *r, const struct any_shape *s)
{
    const struct pel_point *a = &s->v[random_word(r) % ANY_POINTS];
    const struct pel_point *b = &s->v[random_word(r) % ANY_POINTS];
    int32_t d = distance(a, b);
    switch (random_word(r) % 6) {
    case 0:
        d = d / 256 * 256;
        break;
    case 1:
        d = d / 128 * 128;
        break;
    case 2:
        d += random_between(r, -1, 1);
        break;
    case 3:
        d = random_between(r, 0, 1024);
        break;
    default:
        break;
    }
    return pel_max(0, pel_min(d, PEL_PX(32767)));
}

static uint16_t random_turn(struct random *r)
{
    uint32_t turn = random_word(r), kind = random_word(r) % 8;
    if (kind < 4)
        turn &= 0xE000u;
    if (kind == 0)
        turn += (uint32_t)random_between(r, -1, 1);
    return (uint16_t)turn;
}

static void random_numbers(struct random *r, struct any_shape *s)
{
    s->n = random_between(r, 3, ANY_POINTS);
    s->rule = random_word(r) & 1 ? PEL_EVEN_ODD : PEL_NON_ZERO;
    s->radius = random_radius(r, s);
    s->inner = random_radius(r, s);
    if (s->inner > s->radius && random_word(r) % 8) {
        int32_t t = s->inner;
        s->inner = s->radius;
        s->radius = t;
    }
    if (random_word(r) % 8 == 0)
        s->inner = s->radius + random_between(r, 0, 1) * 256;
    s->inner = pel_min(s->inner, PEL_PX(32767));
    s->from = random_turn(r);
    s->to = random_turn(r);
    if (random_word(r) % 8 == 0)
        s->to = (s->from + random_between(r, -1, 1) +
                 (int32_t)(random_word(r) & 0x8000u)) &
                65535;
    if (random_word(r) % 8 == 0)
        s->from -= 65536 * random_between(r, -2, 2);
    if (random_word(r) % 8 == 0) /* a full turn, a little less, or more */
        s->to = s->from + 65536 * random_between(r, 1, 3) +
                random_between(r, -1, 1);
}

void any_random(struct random *r, struct any_shape *s, enum any_kind kind,
                bool adversarial)
{
    s->kind = kind;
    if (adversarial)
        shape_adversarial(r, s->v, ANY_POINTS);
    else
        shape_random(r, s->v, ANY_POINTS);
    random_numbers(r, s);
    keep(s);
}

static bool is_round(enum any_kind kind)
{
    return kind == ANY_CIRCLE || kind == ANY_ELLIPSE || kind == ANY_RING ||
           kind == ANY_SECTOR || kind == ANY_ARC;
}

int32_t any_points(const struct any_shape *s)
{
    if (s->kind == ANY_TRIANGLE)
        return 3;
    if (s->kind == ANY_POLYGON || s->kind >= ANY_PATH)
        return s->n;
    return is_round(s->kind) ? 1 : 2;
}

void any_in_box(struct random *r, struct any_shape *s, enum any_kind kind,
                const struct pel_rect *box)
{
    const int32_t beside = random_between(r, 0, 1) * 6;
    const struct pel_rect around = {
        pel_max(box->x0 - beside, -32768), pel_max(box->y0 - beside, -32768),
        pel_min(box->x1 + beside, 32767), pel_min(box->y1 + beside, 32767)};
    s->kind = kind;
    shape_in_box(r, s->v, ANY_POINTS, &around);
    random_numbers(r, s);
    if (random_word(r) % 8 == 0) {
        cases_forget();
        shape_adversarial(r, s->v, any_points(s) - (any_points(s) > 1));
    }
    if (kind == ANY_THICK_LINE || kind == ANY_STROKE)
        s->radius /= 4;
    keep(s);
}

struct pel_rect any_window(struct random *r, const struct any_shape *s,
                           int32_t size)
{
    if (!is_round(s->kind) || random_word(r) % 8 == 0)
        return shape_window(r, s->v, any_points(s), size);
    const struct pel_point d = reference_direction(
        random_word(r) & 1 ? random_turn(r) : (uint16_t)s->from);
    bool inner = s->kind != ANY_ELLIPSE && random_word(r) & 1;
    int64_t x = inner ? s->inner : s->radius;
    int64_t y = s->kind == ANY_ELLIPSE ? s->inner : x;
    int64_t part = random_word(r) & 1 ? 256 : random_between(r, 0, 256);
    struct pel_point edge = {
        shape_legal(s->v[0].x + x * d.x * part / (32768 * 256)),
        shape_legal(s->v[0].y + y * d.y * part / (32768 * 256))};
    return shape_window(r, &edge, 1, size);
}
