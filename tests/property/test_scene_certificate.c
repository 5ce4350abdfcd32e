/* The painter's certificate against depths in 128-bit arithmetic, and against
 * the depth buffer. */
#include <string.h>

#include "core/scene/certificate.h"
#include "tests/support/any_scene.h"
#include "tests/support/canvas.h"
#include "tests/support/check.h"
#include "tests/support/reference.h"

enum { SIDE = 28, POOL = 8 };

static struct any_scene s;
static struct pel_frame frame;
static uint32_t shown[SIDE * SIDE], depths[SIDE * SIDE];

/* Points that triangles share: any, on a coarse lattice, on one plane of it, or
 * the ends of slats that lie over each other in a circle. */
static void any_points(struct random *r, int16_t at[POOL][3], uint32_t kind)
{
    const int32_t tilt = random_between(r, -1, 1),
                  slope = random_between(r, 0, 1);
    for (int i = 0; i < POOL; i++) {
        for (int k = 0; k < 3; k++)
            at[i][k] = (int16_t)(kind == 0 ? random_between(r, -32767, 32767)
                                           : random_between(r, -2, 2) * 12000);
        if (kind == 2)
            at[i][2] = (int16_t)(tilt * at[i][0] / 2 + slope * at[i][1] / 4);
        if (random_word(r) % 16 == 0)
            at[i][i % 3]++;
    }
}

/* Three slats around the middle, each over the next. */
static void make_circle(struct random *r)
{
    static const int16_t slat[3][3][2] = {{{-30, -12}, {30, -20}, {-30, -20}},
                                          {{10, -30}, {22, -30}, {0, 30}},
                                          {{26, 20}, {-30, 6}, {-30, -6}}};
    const int16_t slope = (int16_t)(random_between(r, -9, 9) * 700);
    for (int i = 0; i < 9; i++) {
        const int16_t *from = slat[i / 3][i % 3];
        s.positions[i][0] = (int16_t)(from[0] * 1000);
        s.positions[i][1] = (int16_t)(from[1] * 1000);
        s.positions[i][2] =
            (int16_t)(i % 3 == 0 ? slope : -slope + random_between(r, -9, 9));
    }
}

static void make_scene(struct random *r)
{
    const uint32_t kind = random_word(r) % 5;
    int16_t pool[POOL][3];
    any_scene(r, &s, SIDE);
    s.mesh.triangles = (uint32_t)random_between(r, 2, kind == 3 ? 3 : 9);
    s.mesh.vertices = 3 * s.mesh.triangles;
    s.scene.shading = &any_scene_numbers;
    s.scene.cull = random_word(r) % 4 ? PEL_CULL_NONE : PEL_CULL_BACK;
    if (random_word(r) % 8 == 0)
        s.scene.camera.near_plane *= random_between(r, 60, 250);
    any_points(r, pool, kind);
    for (uint32_t i = 0; i < s.mesh.vertices && kind < 4; i++)
        memcpy(s.positions[i], pool[random_word(r) % POOL], sizeof *pool);
    if (kind == 3)
        make_circle(r);
}

/* Twice the area of p, q and the centre of a pixel. */
static wide turn(struct pel_point p, struct pel_point q, int32_t x, int32_t y)
{
    return (wide)(q.x - p.x) * (y * 256 + 128 - p.y) -
           (wide)(q.y - p.y) * (x * 256 + 128 - p.x);
}

/* near / z there, from the numbers at the corners. False: not covered, or cut.
 */
static bool nearness(uint32_t t, int32_t x, int32_t y, struct fraction *out)
{
    const struct pel_frame_vertex *v = &frame.vertex[3 * t];
    const struct pel_point at[3] = {
        {v[0].at.x, v[0].at.y}, {v[1].at.x, v[1].at.y}, {v[2].at.x, v[2].at.y}};
    *out = (struct fraction){0, 0};
    for (int i = 0; i < 3; i++)
        if (at[i].x == PEL_NOT_ON_SCREEN)
            return false;
    if (!pel_side_drawn(s.scene.cull, pel_triangle_area(at)) ||
        !reference_triangle_at(at, x, y))
        return false;
    for (int i = 0; i < 3; i++) {
        const wide part = turn(at[(i + 1) % 3], at[(i + 2) % 3], x, y);
        out->n += part * pel_nearness(&frame.projector, v[i].at.z);
        out->d += part;
    }
    if (out->d < 0)
        *out = (struct fraction){-out->n, -out->d};
    return true;
}

/* No triangle is nearer than the one that the painter shows, nor as near. */
static bool is_right(uint32_t number, int32_t x, int32_t y)
{
    struct fraction seen, other;
    if (number == 0 || !nearness(number - 1, x, y, &seen))
        return true;
    for (uint32_t t = 0; t < s.mesh.triangles; t++)
        if (t != number - 1 && nearness(t, x, y, &other) &&
            other.n * seen.d >= seen.n * other.d)
            return false;
    return true;
}

static void open_surface(struct pel_surface *surface, uint32_t *pixels)
{
    memset(pixels, 0, SIDE * SIDE * 4);
    assert_int_equal(pel_surface_init(surface, &pel_xrgb8888, pixels,
                                      SIDE * SIDE * 4, &s.scene.viewport),
                     PEL_OK);
}

/* The picture that `auto` has to show. */
static void draw_nearest(uint32_t *pixels)
{
    struct pel_surface surface;
    struct pel_depth depth;
    struct pel_frame mesh = frame;
    mesh.order = NULL;
    mesh.triangles = s.mesh.triangles;
    open_surface(&surface, pixels);
    pel_depth_init(&depth, &s.scene.viewport, 32, depths, sizeof depths);
    pel_scene_draw_depth(&mesh, &surface, &depth);
}

static void draw_certified(uint32_t *pixels, const struct pel_doubt *doubt)
{
    struct pel_surface surface;
    struct pel_depth depth;
    const bool needed = doubt->triangles > 0;
    open_surface(&surface, pixels);
    if (needed)
        pel_depth_init(&depth, &doubt->bounds, 32, depths, sizeof depths);
    pel_scene_draw_certified(&frame, &surface, &doubt->bounds,
                             needed ? &depth : NULL);
}

static bool in_rect(const struct pel_rect *r, int32_t x, int32_t y)
{
    return x >= r->x0 && x < r->x1 && y >= r->y0 && y < r->y1;
}

/* Outside of the doubt both agree, and inside there are as many wrong ones as
 * it says at most. */
static void check_painter(const uint32_t *right, const struct pel_doubt *doubt)
{
    const struct pel_rect *v = &s.scene.viewport;
    struct pel_surface surface;
    uint32_t wrong = 0;
    const uint32_t *a = shown;
    open_surface(&surface, shown);
    pel_scene_draw(&frame, &surface);
    for (int32_t y = v->y0; y < v->y1; y++)
        for (int32_t x = v->x0; x < v->x1; x++, a++, right++) {
            if (*a != *right)
                wrong++;
            if (!in_rect(&doubt->bounds, x, y) &&
                (*a != *right || !is_right(*a & 0xFFFFFF, x, y)))
                fail_msg("pixel %d, %d: the painter shows %x, right is %x; %s",
                         x, y, *a, *right, cases_replay());
        }
    if (wrong > doubt->pixels)
        fail_msg("%u pixels are wrong, the certificate says %u; %s", wrong,
                 doubt->pixels, cases_replay());
}

/* Is no triangle cut, or thinner than a sub-pixel? */
static bool is_simple(void)
{
    for (uint32_t t = 0; t < s.mesh.triangles; t++) {
        const struct pel_frame_vertex *v = &frame.vertex[3 * t];
        struct pel_point at[3];
        int32_t around = 0;
        for (int i = 0; i < 3; i++) {
            const struct pel_projected *p = &v[i].at, *q = &v[(i + 1) % 3].at;
            if (p->x == PEL_NOT_ON_SCREEN || q->x == PEL_NOT_ON_SCREEN)
                return false;
            at[i] = (struct pel_point){p->x, p->y};
            around += pel_magnitude(p->x - q->x) + pel_magnitude(p->y - q->y);
        }
        if (pel_size_of(pel_triangle_area(at)) < around)
            return false;
    }
    return true;
}

/* How often a triangle is not nearer than one below it in the order by half a
 * number at least. */
static uint32_t unclear_at(int32_t x, int32_t y)
{
    struct fraction near[ANY_TRIANGLES];
    uint32_t n = 0, unclear = 0;
    for (uint32_t rank = 0; rank < frame.triangles; rank++) {
        if (!nearness(frame.order[rank].index, x, y, &near[n]))
            continue;
        for (uint32_t i = 0; i < n; i++)
            unclear += 2 * (near[n].n * near[i].d - near[i].n * near[n].d) <
                       near[n].d * near[i].d;
        n++;
    }
    return unclear;
}

/* There is no more doubt than that. */
static void check_doubt(const struct pel_doubt *doubt)
{
    const struct pel_rect *v = &s.scene.viewport;
    uint32_t unclear = 0;
    for (int32_t y = v->y0; y < v->y1; y++)
        for (int32_t x = v->x0; x < v->x1; x++)
            unclear += unclear_at(x, y);
    if (doubt->pixels > unclear || (doubt->triangles > 0) > unclear)
        fail_msg("%u pixels are in doubt, and %u not clear; %s", doubt->pixels,
                 unclear, cases_replay());
}

TEST(no_wrong_frame_is_accepted)
{
    static uint32_t memory[PEL_CERTIFICATE_SCRATCH_SIZE(ANY_TRIANGLES) / 4];
    static uint32_t right[SIDE * SIDE], got[SIDE * SIDE];
    for (struct cases c = cases_of(100000); cases_next(&c);) {
        const uint32_t work = random_word(&c.random) % 16
                                  ? UINT32_MAX
                                  : random_word(&c.random) % 999;
        struct pel_doubt doubt;
        make_scene(&c.random);
        any_scene_prepare(&s, &frame);
        assert_int_equal(
            pel_scene_certify(&frame, memory, sizeof memory, work, &doubt),
            PEL_OK);
        if (work == UINT32_MAX && random_word(&c.random) % 64 == 0 &&
            is_simple())
            check_doubt(&doubt);
        draw_nearest(right);
        check_painter(right, &doubt);
        draw_certified(got, &doubt);
        if (memcmp(got, right, sizeof got) != 0)
            fail_msg("not the picture of the depth buffer; %s", cases_replay());
    }
}

TEST(arguments)
{
    uint32_t memory[PEL_CERTIFICATE_SCRATCH_SIZE(1) / 4];
    const struct pel_frame none = {.triangles = 0}, one = {.triangles = 1};
    struct pel_doubt d = {.triangles = 1};
    assert_int_equal(pel_scene_certify(NULL, memory, 4, 9, &d), PEL_ERROR_NULL);
    assert_int_equal(pel_scene_certify(&one, NULL, 4, 9, &d), PEL_ERROR_NULL);
    assert_int_equal(pel_scene_certify(&one, memory, 4, 9, NULL),
                     PEL_ERROR_NULL);
    assert_int_equal(pel_scene_certify(&one, memory, sizeof memory - 1, 9, &d),
                     PEL_ERROR_SCRATCH);
    assert_int_equal(
        pel_scene_certify(&one, (char *)memory + 1, sizeof memory, 9, &d),
        PEL_ERROR_SCRATCH);
    assert_int_equal(pel_scene_certify(&none, memory, 4, 9, &d), PEL_OK);
    assert_true(d.triangles == 0 && d.pixels == 0 && pel_rect_empty(&d.bounds));
}
