/* Who is in front: the painter's sort, and depth buffers. */
#include <string.h>

#include "tests/support/any_scene.h"
#include "tests/support/canvas.h"
#include "tests/support/check.h"
#include "tests/support/reference.h"
#include "tests/support/reference_scene.h"

enum { SIDE = 64, ENTRIES = 300 };

TEST(farthest_first_then_lowest_index)
{
    static struct pel_depth_entry e[ENTRIES], same[ENTRIES], spare[ENTRIES];
    for (struct cases c = cases_of(3000); cases_next(&c);) {
        const uint32_t n = random_word(&c.random) % ENTRIES;
        const int32_t range = random_between(&c.random, 0, 3)
                                  ? random_between(&c.random, 0, 20)
                                  : INT32_MAX;
        uint64_t sum = 0, sum_after = 0;
        for (uint32_t i = 0; i < n; i++) {
            e[i].depth = random_between(&c.random, -range, range);
            e[i].index = i * 7;
            sum += (uint32_t)e[i].depth * (uint64_t)(i * 7 + 1);
        }
        memcpy(same, e, sizeof same);
        pel_depth_sort.sort(e, n, NULL);
        pel_depth_sort_radix.sort(same, n, spare);
        assert_memory_equal(e, same, n * sizeof *e);
        for (uint32_t i = 0; i < n; i++)
            sum_after += (uint32_t)e[i].depth * (uint64_t)(e[i].index + 1);
        assert_true(sum == sum_after);
        for (uint32_t i = 1; i < n; i++)
            if (e[i - 1].depth < e[i].depth ||
                (e[i - 1].depth == e[i].depth && e[i - 1].index >= e[i].index))
                fail_msg("%u: %d of %u before %d of %u; %s", i, e[i - 1].depth,
                         e[i - 1].index, e[i].depth, e[i].index,
                         cases_replay());
    }
}

/* near / z of triangle t at a pixel; 0 outside of it. */
static real nearness(const struct any_scene *s, const struct pel_frame *frame,
                     uint32_t t, int32_t x, int32_t y)
{
    struct pel_point at[3];
    real w[3], sum = 0, place[3], screen[3];
    for (uint32_t i = 0; i < 3; i++) {
        const struct pel_projected *p = &frame->vertex[3 * t + i].at;
        at[i] = (struct pel_point){p->x, p->y};
    }
    if (!reference_triangle_at(at, x, y))
        return 0;
    reference_weights(at, x, y, w);
    for (uint32_t i = 0; i < 3; i++) {
        reference_place(&s->scene, 3 * t + i, place);
        reference_project(&s->scene, place, screen);
        sum += w[i] * s->scene.camera.near_plane / 65536 / screen[2];
    }
    return sum;
}

/* Numbers as of any_scene_numbers, but on every other pixel there is nothing
 * to see. */
static bool is_clear(int32_t x, int32_t y)
{
    return (x + y) % 2 != 0;
}

struct numbers {
    struct pel_color_paint base;
    pel_color color;
};

static void half_clear(const struct pel_color_paint *paint, int32_t x,
                       int32_t y, int32_t n, pel_color *out)
{
    for (; n > 0; n--, x++)
        *out++ = is_clear(x, y) ? 0 : ((const struct numbers *)paint)->color;
}

static const struct pel_paint *clear_paint(
    struct pel_frame *frame, const struct pel_color_paint *surface,
    const pel_color color[3])
{
    static struct numbers numbers;
    const struct pel_flat *flat =
        (const void *)any_scene_numbers.paint(frame, surface, color);
    pel_color_paint_init(&numbers.base, half_clear, false);
    numbers.color = flat->color;
    return &numbers.base.paint;
}

static const struct pel_shading numbers_or_clear = {NULL, NULL, clear_paint, 0};

/* The one that is seen is the nearest, but for what the buffer's bits cannot
 * tell apart. */
static void check_pixel(const struct any_scene *s,
                        const struct pel_frame *frame, const struct canvas *c,
                        const struct pel_point at, int bits)
{
    const uint32_t got = canvas_pixel(c, at.x, at.y) & 0xFFFFFFu;
    real nearest = 0, seen = 0;
    for (uint32_t t = 0; t < s->mesh.triangles; t++) {
        const real near = nearness(s, frame, t, at.x, at.y);
        nearest = near > nearest ? near : nearest;
        seen = t + 1 == got ? near : seen;
    }
    if (!s->texture.texels.opaque && is_clear(at.x, at.y))
        nearest = 0;
    const real step = bits == 16 ? 1.01L / 65536 : 1.0L / (1 << 26);
    if (nearest - seen > step || (nearest > 0) != (got > 0))
        fail_msg("%d bits, pixel %d, %d: triangle %u at near / z = %.9f, the "
                 "nearest %.9f; %s",
                 bits, at.x, at.y, got, (double)seen, (double)nearest,
                 cases_replay());
}

TEST(the_nearest_is_seen)
{
    static uint32_t memory[SIDE * SIDE];
    static struct any_scene s;
    static struct canvas c;
    const struct pel_flat black = PEL_FLAT(UINT32_C(0xFF000000));
    for (struct cases k = cases_of(3000); cases_next(&k);) {
        const int bits = random_word(&k.random) % 2 ? 16 : 32;
        const struct pel_rect *v = &s.scene.viewport;
        struct pel_depth depth;
        struct pel_frame frame;
        any_scene(&k.random, &s, SIDE);
        s.scene.camera.projection = PEL_PERSPECTIVE;
        s.scene.camera.focal = 40000;
        s.scene.camera.sensor[0] = s.scene.camera.sensor[1] = 36000;
        any_scene_noise(&k.random, &s, 1);
        s.texture.texels.opaque = random_word(&k.random) % 2;
        s.scene.shading =
            s.texture.texels.opaque ? &any_scene_numbers : &numbers_or_clear;
        s.scene.sort = NULL;
        any_scene_prepare(&s, &frame);
        canvas_open(&c, &pel_xrgb8888, v, 0);
        pel_rectangle(&c.surface, (struct pel_point)PEL_AT(v->x0, v->y0),
                      (struct pel_point)PEL_AT(v->x1, v->y1), &black.paint);
        assert_int_equal(pel_depth_init(&depth, v, bits, memory, sizeof memory),
                         PEL_OK);
        pel_scene_draw_depth(&frame, &c.surface, &depth);
        for (int32_t y = v->y0; y < v->y1; y += 3)
            for (int32_t x = v->x0; x < v->x1; x += 3)
                check_pixel(&s, &frame, &c, (struct pel_point){x, y}, bits);
    }
}

/* Is a pixel at distance z seen in front of one at z + gap? */
static bool told_apart(int64_t near, int64_t z, int64_t gap)
{
    const struct pel_rect pixel = {0, 0, 1, 1};
    const struct pel_span row = {0, 1};
    const struct pel_flat flat = PEL_FLAT(PEL_RGB(1, 2, 3));
    uint16_t memory[1];
    uint32_t color = 0;
    struct pel_depth depth;
    struct pel_surface s;
    const struct pel_spans rows = {&s, &row, 0, 1, 1};
    assert_int_equal(pel_depth_init(&depth, &pixel, 16, memory, 2), PEL_OK);
    s = surface_of(&pel_xrgb8888, &color, sizeof color, 1, 1);
    for (int i = 0; i < 2; i++) {
        const int64_t at = i ? z : z + gap;
        const struct pel_plane plane = {
            (uint64_t)(PEL_DEPTH_NEAR * near / at) << 24, 0, 0};
        struct pel_depth_paint paint;
        color = 0;
        pel_depth_paint_init(&paint, &flat.paint, &depth, &plane, true);
        paint.base.paint.fill(&paint.base.paint, &rows);
    }
    return color != 0;
}

/* far / near = 1000: below a gap of z^2 / (near 65,536) 16 bits fail, and more
 * often the smaller it is; above it never. */
TEST(16_bits_end_where_they_should)
{
    const int64_t near = 1000000;
    uint64_t failures = 0, tries = 0;
    for (struct cases c = cases_of(5000); cases_next(&c);) {
        const int64_t z = near * random_between(&c.random, 10, 1000);
        const int64_t gap = z / 65536 * (z / near);
        if (!told_apart(near, z, gap + gap / 32 + 64))
            fail_msg("%lld units apart at %lld; %s", (long long)gap,
                     (long long)z, cases_replay());
        failures += !told_apart(near, z, gap / 4);
        tries++;
    }
    if (!cases_alone())
        assert_in_range(failures * 100 / tries, 50, 90);
}
