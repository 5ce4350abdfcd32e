/* Icons: parts against fills and strokes of the same paths, and gradients
 * against their formula. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/asset/icon_asset.h"
#include "core/image/icon.h"
#include "core/path/smooth_path.h"
#include "tests/support/canvas.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"

enum { PARTS = 4, VERBS = 6, STOPS = 4, POINTS = 3 * VERBS };

static struct any_icon {
    struct pel_icon_part part[PARTS];
    struct pel_icon_gradient gradient;
    struct pel_icon_stop stop[STOPS];
    uint8_t verb[PARTS * VERBS];
    int16_t point[2 * PARTS * POINTS];
    struct pel_icon_asset asset;
    struct pel_icon_shape shape;
} any;

static struct canvas whole, other;
static uint64_t scratch[1 << 14];
static const struct pel_rect bounds = {-3, -5, 37, 35};

static void print_icon(const void *value)
{
    const struct pel_icon_shape *const s = value;
    const struct pel_transform *const m = &s->transform;
    fprintf(stderr, "icon of %u parts, %d %d %d %d at %d %d scale %d\n",
            any.asset.parts, m->xx, m->xy, m->yx, m->yy, m->at.x, m->at.y,
            s->scale);
}

static void add_verb(struct random *r, struct pel_icon_part *part,
                     enum pel_verb verb)
{
    static const int points[] = {1, 1, 2, 3, 0};
    any.verb[any.asset.verbs++] = (uint8_t)verb;
    part->verbs++;
    for (int i = 0; i < points[verb]; i++) {
        int16_t *const v = any.point + 2 * any.asset.points++;
        v[0] = (int16_t)random_between(r, -200, 1200);
        v[1] = (int16_t)random_between(r, -200, 1200);
        part->points++;
    }
}

static void add_part(struct random *r)
{
    struct pel_icon_part *const part = &any.part[any.asset.parts++];
    const uint32_t how = random_word(r);
    *part = (struct pel_icon_part){
        .color = random_word(r),
        .kind = (uint8_t)(how % 3),
        .gradient = how & 16 ? PEL_ICON_FLAT : PEL_ICON_PROGRAM,
        .cap = how >> 8 & 1 ? PEL_CAP_ROUND : PEL_CAP_BUTT,
        .join = how >> 9 & 1 ? PEL_JOIN_MITER : PEL_JOIN_ROUND,
        .width = (uint16_t)random_between(r, 0, 200)};
    any.asset.strokes |= part->kind == PEL_ICON_STROKE;
    add_verb(r, part, PEL_MOVE);
    while (part->verbs < VERBS)
        add_verb(r, part, (enum pel_verb)(random_word(r) % 5));
}

static void make_icon(struct random *r)
{
    memset(&any, 0, sizeof any);
    any.asset = (struct pel_icon_asset){.magic = PEL_ICON_MAGIC,
                                        .version = PEL_ICON_VERSION,
                                        .width = 1000,
                                        .height = 900,
                                        .left = -600,
                                        .top = -600,
                                        .right = 1600,
                                        .bottom = 1600,
                                        .part = any.part,
                                        .gradient = &any.gradient,
                                        .stop = any.stop,
                                        .verb = any.verb,
                                        .point = any.point};
    for (int32_t n = random_between(r, 1, PARTS); n > 0; n--)
        add_part(r);
    any.shape =
        (struct pel_icon_shape){.icon = &any.asset, .color = random_word(r)};
    pel_icon_place(&any.shape, random_between(r, 0, PEL_PX(60)),
                   random_between(r, -99999, 99999),
                   (struct pel_point){random_between(r, 0, 9999),
                                      random_between(r, 0, 9999)});
    cases_keep(print_icon, &any.shape, sizeof any.shape);
    assert_int_equal(pel_icon_asset_check(&any.asset), PEL_OK);
}

static const struct pel_icon_kind *any_kind(bool smooth)
{
    return smooth
               ? any.asset.strokes ? &pel_icon_smooth_strokes : &pel_icon_smooth
           : any.asset.strokes ? &pel_icon_aliased_strokes
                               : &pel_icon_aliased;
}

static pel_color color_of(const struct pel_icon_part *part)
{
    const uint32_t alpha =
        (2 * pel_alpha(part->color) * pel_alpha(any.shape.color) + 255) / 510;
    return part->gradient == PEL_ICON_FLAT
               ? part->color
               : (any.shape.color & 0xFFFFFF) | alpha << 24;
}

/* The parts by themselves. */
static void draw_parts(const struct pel_surface *surface, bool smooth)
{
    const uint8_t *verb = any.verb;
    const int16_t *point = any.point;
    for (int i = 0; i < any.asset.parts; i++) {
        const struct pel_icon_part *const part = &any.part[i];
        const struct pel_flat ink = PEL_FLAT(color_of(part));
        const struct pel_path path = {.verbs = verb,
                                      .points16 = point,
                                      .verb_count = part->verbs,
                                      .point_count = part->points};
        const double width = part->width * (double)any.shape.scale / 65536;
        const struct pel_path_shape shape = {
            .path = &path,
            .transform = &any.shape.transform,
            .rule =
                part->kind == PEL_ICON_EVEN_ODD ? PEL_EVEN_ODD : PEL_NON_ZERO,
            .stroke = {.width = (int32_t)floor(width + 0.5),
                       .cap = (enum pel_cap)part->cap,
                       .join = (enum pel_join)part->join}};
        const enum pel_status status =
            (part->kind == PEL_ICON_STROKE
                 ? smooth ? pel_smooth_path_stroke : pel_path_stroke
             : smooth ? pel_smooth_path_fill
                      : pel_path_fill)(surface, &shape, &ink.paint, scratch,
                                       sizeof scratch);
        assert_int_equal(status, PEL_OK);
        verb += part->verbs;
        point += 2 * part->points;
    }
}

/* In bands and clips, too. */
TEST(parts_are_paths_one_over_the_other)
{
    for (struct cases c = cases_of(4000); cases_next(&c);) {
        struct random *const r = &c.random;
        const bool smooth = random_word(r) % 2;
        make_icon(r);
        any.shape.kind = any_kind(smooth);
        canvas_open(&whole, &pel_xrgb8888, &bounds, 0);
        canvas_open(&other, &pel_xrgb8888, &bounds, 0);
        draw_parts(&whole.surface, smooth);
        const int32_t rows = random_between(r, 1, 50);
        for (int32_t y = bounds.y0; y < bounds.y1; y += rows) {
            const struct pel_rect band = {bounds.x0, y, bounds.x1, y + rows};
            other.surface.clip =
                pel_rect_intersect(&band, &other.surface.bounds);
            assert_int_equal(
                pel_icon(&other.surface, &any.shape, scratch, sizeof scratch),
                PEL_OK);
        }
        canvas_check_same(&whole, &other);
    }
}

static double channel(pel_color c, int shift)
{
    return c >> shift & 255;
}

/* A channel at a place of the gradient. */
static double level_at(double t, int shift)
{
    const struct pel_icon_gradient *const g = &any.gradient;
    const struct pel_icon_stop *s = any.stop, *const last = s + g->stops - 1;
    if (g->spread == PEL_ICON_REPEAT)
        t -= floor(t);
    if (g->spread == PEL_ICON_REFLECT)
        t = fabs(t - 2 * floor(t / 2 + 0.5));
    while (s < last && s[1].at <= t * 4096)
        s++;
    if (s == last || t * 4096 <= s->at)
        return channel(s->color, shift);
    const double part = (t * 4096 - s->at) / (s[1].at - s->at);
    return channel(s->color, shift) * (1 - part) +
           channel(s[1].color, shift) * part;
}

/* A coordinate of (x, y) by a row of a transform, rounded. */
static double place(int32_t a, int32_t b, int32_t at, const struct pel_point *v)
{
    return floor(((double)a * v->x + (double)b * v->y + 32768) / 65536) + at;
}

/* The place of a pixel on the way, and how many axes it is from the frame's
 * origin, at most; of a frame whose points are rounded. */
static double place_at(int32_t x, int32_t y, int *far)
{
    const struct pel_icon_gradient *const g = &any.gradient;
    const struct pel_transform *const t = &any.shape.transform;
    double px[3], py[3];
    for (int i = 0; i < 3; i++) {
        px[i] = place(t->xx, t->xy, t->at.x, &g->frame[i]);
        py[i] = place(t->yx, t->yy, t->at.y, &g->frame[i]);
    }
    const double ax = px[1] - px[0], ay = py[1] - py[0];
    const double bx = px[2] - px[0], by = py[2] - py[0];
    const double qx = x * 256 + 128 - px[0], qy = y * 256 + 128 - py[0];
    const double area = ax * by - ay * bx;
    const double u = (qx * by - qy * bx) / area;
    const double v = (ax * qy - ay * qx) / area;
    *far = (int)ceil(hypot(u, v));
    return g->radial ? hypot(u, v) + u * g->focus / 65536 : u;
}

static void make_gradient(struct random *r)
{
    static const int16_t corner[] = {-200, -200, 1200, -200,
                                     1200, 1200, -200, 1200};
    static const uint8_t verbs[] = {PEL_MOVE, PEL_LINE, PEL_LINE, PEL_LINE};
    struct pel_icon_gradient *const g = &any.gradient;
    int32_t at = 0;
    make_icon(r);
    memcpy(any.verb, verbs, sizeof verbs);
    memcpy(any.point, corner, sizeof corner);
    any.asset.parts = any.asset.gradients = 1;
    any.asset.strokes = 0;
    any.asset.verbs = any.asset.points = 4;
    any.asset.stops = STOPS;
    any.asset.painter = &pel_icon_gradients;
    any.part[0] = (struct pel_icon_part){
        .verbs = 4, .points = 4, .kind = PEL_ICON_NON_ZERO};
    *g = (struct pel_icon_gradient){
        .frame = {{random_between(r, 0, 1000), random_between(r, 0, 900)}},
        .radial = (uint8_t)(random_word(r) % 2),
        .spread = (uint8_t)(random_word(r) % 3),
        .stops = STOPS};
    g->focus = (uint16_t)(g->radial ? random_word(r) % 65536 : 0);
    const double turn = random_between(r, 0, 6283) / 1000.0;
    const double skew = turn + random_between(r, 800, 2300) / 1000.0;
    const int32_t a = random_between(r, 30, 2000 >> random_word(r) % 6);
    const int32_t b = random_between(r, 30, 2000 >> random_word(r) % 6);
    g->frame[1] = (struct pel_point){g->frame->x + (int32_t)(a * cos(turn)),
                                     g->frame->y + (int32_t)(a * sin(turn))};
    g->frame[2] = (struct pel_point){g->frame->x + (int32_t)(b * cos(skew)),
                                     g->frame->y + (int32_t)(b * sin(skew))};
    for (int i = 0; i < STOPS; i++) {
        at += random_word(r) % 4 ? random_between(r, 0, 1300) : 0;
        any.stop[i] = (struct pel_icon_stop){(uint16_t)pel_min(at, 4096),
                                             random_word(r) | 0xFF000000};
    }
    any.shape.kind = &pel_icon_aliased;
    pel_icon_place(&any.shape, random_between(r, PEL_PX(40), PEL_PX(90)),
                   random_between(r, 0, 65535), pel_at(17, 15));
    assert_int_equal(pel_icon_asset_check(&any.asset), PEL_OK);
}

/* Is the place where the gradient begins anew, or near it? */
static bool is_edge(double t)
{
    return any.gradient.spread == PEL_ICON_REPEAT && fabs(t - round(t)) < 0.002;
}

/* Is it a level between those of places near t, or next to one? Stops may lie
 * at one place. */
static bool is_near(double level, double t, int far, int shift)
{
    double low = 255, high = 0;
    for (int i = -3 - far; i <= 4 + far; i++) {
        const double near = (floor(t * 4096) + i) / 4096;
        low = fmin(low, level_at(near, shift));
        high = fmax(high, level_at(near, shift));
    }
    return level >= low - 2 && level <= high + 2;
}

static void draw_stops(struct canvas *canvas, uint8_t stops)
{
    any.gradient.stops = stops;
    canvas_open(canvas, &pel_xrgb8888, &bounds, 0);
    assert_int_equal(
        pel_icon(&canvas->surface, &any.shape, scratch, sizeof scratch),
        PEL_OK);
}

TEST(gradients_follow_their_formula)
{
    long pixels = 0;
    for (struct cases c = cases_of(1500); cases_next(&c);) {
        make_gradient(&c.random);
        draw_stops(&other, 1); /* where it is */
        draw_stops(&whole, STOPS);
        for (int32_t y = bounds.y0; y < bounds.y1; y++)
            for (int32_t x = bounds.x0; x < bounds.x1; x++) {
                int far;
                const double t = place_at(x, y, &far);
                const uint32_t got = canvas_pixel(&whole, x, y);
                if (is_edge(t) || far > 7 ||
                    canvas_pixel(&other, x, y) ==
                        canvas_pixel_before(&other, x, y))
                    continue;
                pixels++;
                for (int s = 0; s < 24; s += 8)
                    if (!is_near(channel(got, s), t, far, s))
                        fail_msg("pixel %d %d, shift %d: %f, not %f: %s", x, y,
                                 s, channel(got, s), level_at(t, s),
                                 cases_replay());
            }
    }
    assert_true(cases_alone() || pixels > 1000);
}

/* The memory of a row is that of the box, on the widest surface. */
TEST(memory_is_for_the_box)
{
    static uint8_t row[30000];
    const struct pel_rect wide = {0, 0, sizeof row, 1};
    struct pel_surface surface;
    for (struct cases c = cases_of(20); cases_next(&c);) {
        make_icon(&c.random);
        any.shape.kind = any_kind(true);
        assert_int_equal(pel_icon_place(&any.shape, PEL_PX(20), 0,
                                        (struct pel_point){PEL_PX(99), 0}),
                         PEL_OK);
        pel_surface_init(&surface, &pel_gray8, row, sizeof row, &wide);
        assert_int_equal(pel_icon(&surface, &any.shape, scratch,
                                  PEL_ICON_SCRATCH_SIZE(400, 22)),
                         PEL_OK);
    }
}

TEST(wrong_icons_are_refused)
{
    struct random r = {7};
    do
        make_icon(&r);
    while (!any.asset.strokes);
    any.shape.kind = &pel_icon_smooth;
    canvas_open(&whole, &pel_xrgb8888, &bounds, 0);
    assert_int_equal(
        pel_icon(&whole.surface, &any.shape, scratch, sizeof scratch),
        PEL_ERROR_FORMAT);
    any.shape.kind = &pel_icon_smooth_strokes;
    assert_int_equal(pel_icon(&whole.surface, &any.shape, scratch, 8),
                     PEL_ERROR_SCRATCH);
    assert_int_equal(pel_icon(NULL, &any.shape, scratch, sizeof scratch),
                     PEL_ERROR_NULL);
    const struct pel_point edge = {PEL_COORDINATE_MIN, 0};
    assert_int_equal(pel_icon_place(&any.shape, PEL_PX(9), 0, edge),
                     PEL_ERROR_RANGE);
    assert_int_equal(
        pel_icon_place(&any.shape, PEL_PX(32767), 0, (struct pel_point){0, 0}),
        PEL_OK);
    struct pel_icon_asset asset = any.asset;
    assert_int_equal(pel_icon_asset_check(NULL), PEL_ERROR_NULL);
    asset.version++;
    assert_int_equal(pel_icon_asset_check(&asset), PEL_ERROR_RANGE);
    asset = any.asset;
    asset.width = asset.height = 255;
    assert_int_equal(pel_icon_asset_check(&asset), PEL_ERROR_SIZE);
    asset = any.asset;
    asset.verbs--;
    assert_int_equal(pel_icon_asset_check(&asset), PEL_ERROR_SIZE);
    asset = any.asset;
    asset.points--;
    assert_int_equal(pel_icon_asset_check(&asset), PEL_ERROR_SIZE);
    asset = any.asset;
    asset.strokes = 0;
    assert_int_equal(pel_icon_asset_check(&asset), PEL_ERROR_SIZE);
    asset = any.asset;
    asset.gradients = 1;
    assert_int_equal(pel_icon_asset_check(&asset), PEL_ERROR_NULL);
    asset.painter = &pel_icon_gradients;
    assert_int_equal(pel_icon_asset_check(&asset), PEL_ERROR_SIZE);
    any.gradient.stops = 1;
    assert_int_equal(pel_icon_asset_check(&asset), PEL_ERROR_SIZE);
    asset.stops = 1;
    assert_int_equal(pel_icon_asset_check(&asset), PEL_OK);
    any.part[0].gradient = 1;
    assert_int_equal(pel_icon_asset_check(&asset), PEL_ERROR_SIZE);
}
