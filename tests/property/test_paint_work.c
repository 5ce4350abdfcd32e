/* What a gradient costs is bounded by what is visible: colors that it looks up
 * are counted, by a format. */
#include <stdio.h>

#include "core/pel.h"
#include "tests/support/canvas.h"
#include "tests/support/check.h"
#include "tests/support/reference_gradient.h"

static pel_color colors[32767];
static struct canvas canvas;
static int32_t colors_taken;

static uint32_t counted_pack(pel_color color)
{
    colors_taken++;
    return pel_xrgb8888.pack(color);
}

struct work {
    enum kind kind;
    uint32_t direction;
    int32_t cells, size;
    enum pel_spread spread;
};

static void print(const void *value)
{
    const struct work *const w = value;
    fprintf(stderr,
            "gradient of kind %d, direction %u, %d cells, size %d, spread %d\n",
            (int)w->kind, (unsigned)w->direction, w->cells, w->size,
            (int)w->spread);
}

static void sized_gradient(struct gradient *g, enum kind kind, int32_t size,
                           uint32_t direction)
{
    const struct pel_point at = pel_at(0, 32);
    const struct pel_point to = {at.x + (direction != 1 ? size : 0),
                                 at.y + (direction != 2 ? size : 0)};
    const struct pel_rings rings = {at, pel_max(size, 256), 0};
    const enum pel_status status =
        kind == LINEAR   ? pel_linear_init(&g->u.linear, at, to, &g->ramp)
        : kind == RADIAL ? pel_radial_init(&g->u.radial, &rings, &g->ramp)
                         : pel_conic_init(&g->u.conic, at, 0, &g->ramp);
    assert_int_equal(status, PEL_OK);
}

/* Work is bounded by what is visible: for 9 colors a row of a vertical
 * gradient, and 5 a pixel of others, however many cells it has, and however
 * many of them are alike; but a batch of rows passes all sectors. In the least
 * code a row looks for its cell again after 64 of them. */
TEST(bounded_work)
{
    static const int32_t counts[] = {2, 3, 300, 4096, 32767};
    static const int32_t sizes[] = {1, 40, 300, 2560, 30000, 46080};
    static struct gradient g;
    const struct pel_rect box = {-30, 0, 70, 64};
    struct pel_format counted = pel_xrgb8888;
    counted.pack = counted_pack;
    for (struct cases c = cases_of(1200); cases_next(&c);) {
        struct random *r = &c.random;
        const uint32_t other = random_word(r) % 3 ? 0xFFFFFF : 0;
        const int32_t size = sizes[random_word(r) % 6];
        const enum kind kind = (enum kind)(random_word(r) % 3);
        const uint32_t direction = random_word(r) % 3;
        g.ramp = (struct pel_ramp){colors, counts[random_word(r) % 5],
                                   (enum pel_spread)(random_word(r) % 3)};
        for (int32_t i = 0; i < g.ramp.n; i++)
            colors[i] = 0xFF000000 | (i & 1 ? other : 0);
        const int32_t most = PEL_SMALL_CODE                     ? 66 * 6400
                             : kind == LINEAR && direction == 1 ? 9 * 64
                             : kind == CONIC ? 5 * 6400 + 16 * g.ramp.n
                                             : 5 * 6400;
        const struct work work = {kind, direction, g.ramp.n, size,
                                  g.ramp.spread};
        cases_keep(print, &work, sizeof work);
        sized_gradient(&g, kind, size, direction);
        canvas_open(&canvas, &pel_xrgb8888, &box, 0);
        canvas.surface.format = &counted;
        counted.id = 128;
        colors_taken = 0;
        pel_box(&canvas.surface, &box, &g.u.paint);
        if (colors_taken > most)
            fail_msg("%d colors, %d at most; %s", colors_taken, most,
                     cases_replay());
    }
}
