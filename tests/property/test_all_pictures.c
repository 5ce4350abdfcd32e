/* What changes no byte: bands and tiles, clipping, vertex order, translation,
 * stride and direction of lines. And what every byte must be, in every format:
 * the source packed, or blended by the rule. Every shape and outline, on fenced
 * canvases. */
#include "tests/support/any_shape.h"
#include "tests/support/canvas.h"
#include "tests/support/check.h"
#include "tests/support/hits.h"
#include "tests/support/items.h"
#include "tests/support/shapes.h"

static struct canvas whole, other;
static struct hits hits;

static const struct pel_format *random_format(struct random *r)
{
    return layouts[random_word(r) % LAYOUT_COUNT].format;
}

/* One of the three. */
struct drawing {
    struct item item;
    struct any_shape shape;
    enum { ITEM, SHAPE, OUTLINE } what;
};

static struct drawing open_case(struct cases *c, bool opaque)
{
    struct random *r = &c->random;
    struct drawing d;
    const struct pel_rect bounds = shape_bounds(r, 40, 40);
    canvas_open(&whole, random_format(r), &bounds, random_word(r) % 8);
    item_random(r, &d.item, &bounds, opaque);
    any_in_box(r, &d.shape, (enum any_kind)(random_word(r) % ANY_KINDS),
               &bounds);
    d.what = random_word(r) % 2 ? ITEM : random_word(r) % 2 ? SHAPE : OUTLINE;
    return d;
}

static void cover(const struct pel_surface *surface, const struct drawing *d,
                  const struct pel_paint *paint)
{
    if (d->what == ITEM)
        item_cover(surface, &d->item, paint);
    else if (d->what == SHAPE)
        any_draw(surface, &d->shape, paint);
    else
        any_draw_outline(surface, &d->shape, paint);
}

static void draw(const struct pel_surface *surface, const struct drawing *d)
{
    const struct pel_flat flat = PEL_FLAT(d->item.color[0]);
    if (d->what == ITEM)
        item_draw(&core_default, surface, &d->item);
    else
        cover(surface, d, &flat.paint);
}

static bool is_gouraud(const struct drawing *d)
{
    return d->what == ITEM && d->item.kind == ITEM_GOURAUD;
}

static void check_tile(const struct drawing *d, const struct pel_rect *tile,
                       unsigned style)
{
    canvas_open(&other, whole.layout->format, tile, style);
    draw(&other.surface, d);
    canvas_check_part(&whole, &other);
}

/* Columns and rows where a tile of any format may begin: all, or every 8th. */
static int32_t next_cut(struct random *r, int32_t from, int32_t end,
                        bool aligned)
{
    int32_t cut = from + random_between(r, 1, 24);
    if (aligned)
        cut = (cut + 7) & ~7;
    return pel_min(cut, end);
}

static void test_tiles_equal_the_whole(void)
{
    for (struct cases c = cases_of(80000); cases_next(&c);) {
        struct random *r = &c.random;
        struct drawing d = open_case(&c, false);
        const struct pel_rect b = whole.surface.bounds;
        bool aligned = whole.layout->bits < 8, bands = random_word(r) % 2;
        struct pel_rect t;
        draw(&whole.surface, &d);
        canvas_check(&whole);
        for (t.y0 = b.y0; t.y0 < b.y1; t.y0 = t.y1) {
            t.y1 = next_cut(r, t.y0, b.y1, aligned);
            for (t.x0 = b.x0; t.x0 < b.x1; t.x0 = t.x1) {
                t.x1 = bands ? b.x1 : next_cut(r, t.x0, b.x1, aligned);
                check_tile(&d, &t, random_word(r) % 8);
            }
        }
    }
}

static void test_clip_is_crop(void)
{
    for (struct cases c = cases_of(100000); cases_next(&c);) {
        struct drawing d = open_case(&c, false);
        const struct pel_rect b = whole.surface.bounds;
        const struct pel_rect clip = shape_clip(&c.random, &b);
        canvas_open(&other, whole.layout->format, &b,
                    random_word(&c.random) % 8);
        draw(&whole.surface, &d);
        pel_surface_clip(&other.surface, &clip);
        draw(&other.surface, &d);
        canvas_check_part(&whole, &other);
    }
}

struct source {
    const struct drawing *drawing;
    struct pel_gouraud gouraud;
};

static pel_color source_at(const void *context, int32_t x, int32_t y)
{
    const struct source *s = context;
    const struct pel_gouraud *g = &s->gouraud;
    if (!is_gouraud(s->drawing))
        return s->drawing->item.color[0];
    pel_color c = 0;
    for (int k = 0; k < 4; k++)
        c |= (g->at[k] + (uint32_t)x * g->dx[k] + (uint32_t)y * g->dy[k]) >>
             24 << 8 * k;
    return c;
}

/* Alpha 255: the source packed; 0: what was there; else the blend. */
static void check_bytes(const struct drawing *d)
{
    struct source source = {.drawing = d};
    if (is_gouraud(d))
        pel_gouraud_init(&source.gouraud, d->item.v, d->item.color);
    hits_open(&hits, &whole.surface.bounds);
    cover(&hits.surface, d, &hits.paint);
    canvas_check_drawn(&whole, &hits, source_at, &source);
}

static void test_bytes_follow_the_rule(void)
{
    for (struct cases c = cases_of(100000); cases_next(&c);) {
        struct drawing d = open_case(&c, c.next % 2);
        draw(&whole.surface, &d);
        check_bytes(&d);
    }
}

/* Every order of three; of polygons every start, in both directions. */
static struct item reordered(const struct item *item, int32_t i)
{
    struct item p = *item;
    for (int32_t k = 0; k < item->n; k++) {
        int32_t from = i % 2 ? item->n - 1 - k : k;
        from = (from + i / 2) % item->n;
        p.v[k] = item->v[from];
        if (item->kind == ITEM_GOURAUD)
            p.color[k] = item->color[from];
    }
    return p;
}

static void test_vertex_order_changes_nothing(void)
{
    for (struct cases c = cases_of(30000); cases_next(&c);) {
        const struct item item = open_case(&c, false).item;
        const struct pel_rect b = whole.surface.bounds;
        if (item.kind == ITEM_RECTANGLE || item.kind == ITEM_CIRCLE)
            continue;
        item_draw(&core_default, &whole.surface, &item);
        for (int32_t i = 1; i < 2 * item.n; i++) {
            struct item p = reordered(&item, i);
            canvas_open(&other, whole.layout->format, &b, (unsigned)i % 8);
            item_draw(&core_default, &other.surface, &p);
            canvas_check_same(&whole, &other);
        }
    }
}

/* A shift by whole pixels that keeps it in range: of bits 3 and up,
 * so that tiles of every format may begin there. */
static int32_t random_shift(struct random *r, int32_t lo, int32_t hi)
{
    int32_t room_down = (lo - PEL_COORDINATE_MIN) / 2048;
    int32_t room_up = (PEL_COORDINATE_MAX - hi) / 2048;
    return 8 * random_between(r, -room_down, room_up);
}

/* Grows by the points. */
static void extend(struct pel_rect *e, const struct pel_point *v, int32_t n)
{
    for (; n > 0; n--, v++) {
        e->x0 = pel_min(e->x0, v->x);
        e->y0 = pel_min(e->y0, v->y);
        e->x1 = pel_max(e->x1, v->x);
        e->y1 = pel_max(e->y1, v->y);
    }
}

static void shift(struct pel_point *v, int32_t n, int32_t dx, int32_t dy)
{
    for (; n > 0; n--, v++) {
        v->x += PEL_PX(dx);
        v->y += PEL_PX(dy);
    }
}

/* A thick line is not drawn where one of its corners is out of range. */
static bool is_drawn(const struct any_shape *s)
{
    struct pel_point v[4];
    return s->kind != ANY_THICK_LINE || pel_thick_line_corners(THICK(s), v);
}

static void test_translation_changes_nothing(void)
{
    for (struct cases c = cases_of(100000); cases_next(&c);) {
        struct drawing d = open_case(&c, false);
        struct pel_rect b = whole.surface.bounds;
        struct pel_rect e = {PEL_PX(b.x0), PEL_PX(b.y0), PEL_PX(b.x1) - 1,
                             PEL_PX(b.y1) - 1};
        extend(&e, d.item.v, d.item.n);
        extend(&e, d.shape.v, ANY_POINTS);
        int32_t dx = random_shift(&c.random, e.x0, e.x1);
        int32_t dy = random_shift(&c.random, e.y0, e.y1);
        b = (struct pel_rect){b.x0 + dx, b.y0 + dy, b.x1 + dx, b.y1 + dy};
        canvas_open(&other, whole.layout->format, &b,
                    random_word(&c.random) % 8);
        canvas_copy(&other, &whole);
        const bool drawn = is_drawn(&d.shape);
        draw(&whole.surface, &d);
        shift(d.item.v, d.item.n, dx, dy);
        shift(d.shape.v, ANY_POINTS, dx, dy);
        draw(&other.surface, &d);
        if (drawn == is_drawn(&d.shape))
            canvas_check_same(&whole, &other);
    }
}

/* Clips with no pixel, far away or turned round: nothing is drawn. */
static void test_empty_clips(void)
{
    static const struct pel_rect clip[] = {
        {8388608, 0, 8388672, 64},
        {0, 0, -536870912, 64},
        {INT32_MAX, 0, INT32_MIN, 24},
        {0, INT32_MAX, 64, INT32_MIN},
        {INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN},
        {INT32_MIN, INT32_MIN, INT32_MIN, INT32_MIN},
        {40, 0, 20, 64},
        {0, 40, 64, 20},
    };
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        const struct drawing d = open_case(&c, false);
        pel_surface_clip(
            &whole.surface,
            &clip[random_word(&c.random) % (sizeof clip / sizeof *clip)]);
        draw(&whole.surface, &d);
        canvas_check(&whole);
    }
}

int main(void)
{
    return RUN_TESTS(test_tiles_equal_the_whole, test_clip_is_crop,
                     test_bytes_follow_the_rule,
                     test_vertex_order_changes_nothing,
                     test_translation_changes_nothing, test_empty_clips);
}
