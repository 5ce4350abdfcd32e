/* Textures in perspective, against exact places in the texture: every texel
 * holds its own indices, so that a nearest texel tells u and v. */
#include <string.h>

#include "core/pel.h"
#include "tests/support/any_scene.h"
#include "tests/support/check.h"
#include "tests/support/layouts.h"
#include "tests/support/reference_scene.h"

enum { SIDE = 256, TEXELS = 1024 };

static pel_color texels[TEXELS * TEXELS];
static pel_color pixels[SIDE * SIDE];
static real worst;

struct subject {
    struct pel_point v[3];
    struct pel_texture_corner corner[3];
    int32_t span;
    uint8_t wrap;
};

static void draw(const struct subject *s)
{
    const struct pel_texels t = {NULL, texels, TEXELS, TEXELS, true};
    const struct pel_texture_map none = {{0, 0, 0}, {0, 0, 0}};
    struct pel_surface surface;
    struct pel_plane_setup setup;
    struct pel_texture sampler;
    struct pel_divided_texture paint;
    memset(pixels, 0, sizeof pixels);
    surface = surface_of(&pel_xrgb8888, pixels, sizeof pixels, SIDE, SIDE);
    assert_int_equal(pel_texture_init_nearest(&sampler, &t, &none), PEL_OK);
    sampler.wrap_u = sampler.wrap_v = s->wrap;
    if (!pel_plane_start(&setup, s->v))
        return;
    pel_divided_texture_init(&paint, &sampler, &setup, s->corner, s->span);
    pel_triangle(&surface, s->v, &paint.by.base.paint);
}

/* u, v and 1 / z times the smallest z. */
static void place_at(const struct subject *s, int32_t x, int32_t y, real out[3])
{
    real w[3], nearest = s->corner[0].z;
    reference_weights(s->v, x, y, w);
    for (int i = 1; i < 3; i++)
        nearest = s->corner[i].z < nearest ? s->corner[i].z : nearest;
    out[0] = out[1] = out[2] = 0;
    for (int i = 0; i < 3; i++) {
        w[i] *= nearest / s->corner[i].z;
        out[2] += w[i];
    }
    for (int i = 0; i < 3; i++) {
        out[0] += w[i] / out[2] * s->corner[i].uv[0] / 65536;
        out[1] += w[i] / out[2] * s->corner[i].uv[1] / 65536;
    }
}

/* How far the ends of the span may let axis k be off. */
static real allowed(const struct subject *s, int32_t x, int32_t y, int k)
{
    real a[3], b[3];
    if (s->span == PEL_SPAN_EXACT)
        return 0;
    place_at(s, x & ~(s->span - 1), y, a);
    place_at(s, (x | (s->span - 1)) + 1, y, b);
    if (a[2] <= 0 || b[2] <= 0)
        return 0;
    const real ratio = a[2] > b[2] ? a[2] / b[2] : b[2] / a[2];
    const real du = a[k] > b[k] ? a[k] - b[k] : b[k] - a[k];
    return du * (ratio - 1) / 4;
}

static void check_axis(const struct subject *s, int32_t x, int32_t y, int k,
                       int32_t index)
{
    real want[3];
    place_at(s, x, y, want);
    const real above = want[k] - index - 1, below = index - want[k];
    real off = above > below ? above : below;
    if ((index == 0 && want[k] < 0) || (index == TEXELS - 1 && above > 0))
        off = 0;
    const real bound = allowed(s, x, y, k) + 1.0L / 256;
    if (off > bound)
        fail_msg("pixel %d, %d, span %d: texel %d of axis %d, not %.5f, "
                 "allowed %.5f; %s",
                 x, y, s->span, index, k, (double)want[k], (double)bound,
                 cases_replay());
    if (s->span == PEL_SPAN_EXACT && off > worst)
        worst = off;
}

static void check(const struct subject *s)
{
    draw(s);
    for (int32_t y = 0; y < SIDE; y++)
        for (int32_t x = 0; x < SIDE; x++) {
            const pel_color got = pixels[y * SIDE + x];
            if (!got)
                continue;
            check_axis(s, x, y, 0, (int32_t)(got >> 12 & 0xFFF));
            check_axis(s, x, y, 1, (int32_t)(got & 0xFFF));
        }
}

static void any_subject(struct random *r, struct subject *s)
{
    static const int32_t spans[] = {1, 1, 1, 8, 16, 32, 64};
    const int32_t texels_used = random_between(r, 1, TEXELS * 65536 - 1);
    const int32_t ratio = random_between(r, 1, 256);
    const bool sliver = random_word(r) % 4 == 0;
    s->span = spans[random_word(r) % 7];
    s->wrap = PEL_WRAP_CLAMP;
    for (int i = 0; i < 3; i++) {
        s->v[i].x = random_between(r, -20 * 256, (SIDE + 20) * 256);
        s->v[i].y = random_between(r, -20 * 256, (SIDE + 20) * 256);
        s->corner[i].uv[0] = random_between(r, 0, texels_used);
        s->corner[i].uv[1] = random_between(r, 0, texels_used);
        s->corner[i].z = random_between(r, 1 << 20, (1 << 20) * ratio);
    }
    if (sliver) {
        s->v[2].x = (s->v[0].x + s->v[1].x) / 2 + random_between(r, -40, 40);
        s->v[2].y = (s->v[0].y + s->v[1].y) / 2 + random_between(r, -40, 40);
    }
}

TEST(texels_are_right)
{
    for (int32_t i = 0; i < TEXELS * TEXELS; i++)
        texels[i] = UINT32_C(0xFF000000) | (uint32_t)(i % TEXELS) << 12 |
                    (uint32_t)(i / TEXELS);
    for (struct cases c = cases_of(1500); cases_next(&c);) {
        struct subject s;
        any_subject(&c.random, &s);
        check(&s);
    }
    print_message("exact mode: at most %.2g of 1/256 texel off\n",
                  (double)worst * 256);
}

/* Whole pictures away lies the same picture. */
TEST(far_texels_are_the_same)
{
    static pel_color near_by[SIDE * SIDE];
    for (struct cases c = cases_of(200); cases_next(&c);) {
        struct subject s;
        any_subject(&c.random, &s);
        s.wrap = (uint8_t)(PEL_WRAP_REPEAT + random_word(&c.random) % 2);
        draw(&s);
        memcpy(near_by, pixels, sizeof pixels);
        for (int k = 0; k < 2; k++) {
            const int32_t away = random_between(&c.random, -1023, 1023);
            for (int i = 0; i < 3; i++)
                s.corner[i].uv[k] += away * INT64_C(2) * TEXELS * 65536;
        }
        draw(&s);
        assert_memory_equal(near_by, pixels, sizeof pixels);
    }
}

/* A floor that leads away by a ratio of 256, its far end one texel high a
 * pixel: the span falls back to division where its ends are behind the eye. */
TEST(a_floor_to_the_horizon)
{
    const int32_t spans[] = {1, 16, 64};
    for (int i = 0; i < 3; i++) {
        const struct subject s = {
            {PEL_AT(0, 250), PEL_AT(255, 250), PEL_AT(120, 10)},
            {{{0, 0}, 1 << 20},
             {{1 << 26, 0}, 1 << 20},
             {{1 << 25, 1 << 26}, 1 << 28}},
            spans[i],
            PEL_WRAP_CLAMP};
        check(&s);
        assert_int_not_equal(pixels[100 * SIDE + 120], 0);
    }
}

/* What uv can say of 256 texels must stay below 2^21: 8,192 pictures. */
TEST(what_reaches_too_far_is_refused)
{
    static const struct {
        struct pel_quantization quantum;
        enum pel_status status;
    } rows[] = {{{{0, 0, 0}, 1, 3}, PEL_OK},
                {{{0, 0, 0}, 1, 2}, PEL_ERROR_RANGE},
                {{{0, -65536, 0}, 1, 4}, PEL_OK},
                {{{0, -65536, 0}, 1, 3}, PEL_ERROR_RANGE},
                {{{1 << 30, 0, 0}, 16384, 46}, PEL_OK},
                {{{1 << 30, 0, 0}, 16384, 17}, PEL_ERROR_RANGE},
                {{{0, 0, 0}, 1, -1}, PEL_ERROR_RANGE}};
    static struct any_scene s;
    struct pel_frame frame;
    struct cases c = cases_of(1);
    cases_next(&c);
    any_scene(&c.random, &s, SIDE);
    any_scene_noise(&c.random, &s, 8);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        s.mesh.texture = rows[i].quantum;
        if (pel_scene_prepare(&frame, &s.scene, s.scratch, sizeof s.scratch) !=
            rows[i].status)
            fail_msg("row %zu", i);
    }
}
