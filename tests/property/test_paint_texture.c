/* Textures against exact places: nearest, bilinear, wrap modes, formats. */
#include "core/format/argb8888.h"
#include "core/paint/paint_texture.h"
#include "tests/support/canvas.h"
#include "tests/support/check.h"
#include "tests/support/paint_math.h"
#include "tests/support/reference.h"
#include "tests/support/shapes.h"

static struct histogram nearest_errors = {.name = "texture_nearest_texel",
                                          .step = 0x1p-19L};
static struct histogram bilinear_errors = {.name = "texture_bilinear_color",
                                           .step = 1.0L / 32};

enum { TEXELS_MAX = 451 * 300 };

struct picture {
    pel_color texel[TEXELS_MAX];
    struct pel_texels texels;
    enum pel_wrap wrap_u, wrap_v;
};

static struct picture picture;

/* One color per texel. */
static void open_picture(int32_t width, int32_t height, bool noise)
{
    struct random r = {(uint64_t)width};
    for (int32_t i = 0; i < width * height; i++)
        picture.texel[i] = noise ? random_word(&r) : 0xFF000000u + (uint32_t)i;
    picture.texels =
        (struct pel_texels){NULL, picture.texel, width, height, !noise};
}

static void open_random_picture(struct random *r, bool noise)
{
    static const int16_t size[][2] = {{451, 300}, {256, 256}, {64, 32},  {1, 1},
                                      {1, 7},     {5, 3},     {32767, 2}};
    const uint32_t i = random_word(r) % 7;
    open_picture(size[i][0], size[i][1], noise);
    picture.wrap_u = (enum pel_wrap)(random_word(r) % 3);
    picture.wrap_v = (enum pel_wrap)(random_word(r) % 3);
}

static pel_color texel_at(int64_t u, int64_t v)
{
    const int64_t w = picture.texels.width, h = picture.texels.height;
    return picture.texel[texel_index(v, h, picture.wrap_v) * w +
                         texel_index(u, w, picture.wrap_u)];
}

/* Twice the signed area of a, b, and the point (x, y). */
static wide area_to(struct pel_point a, struct pel_point b, wide x, wide y)
{
    return ((wide)b.x - a.x) * (y - a.y) - ((wide)b.y - a.y) * (x - a.x);
}

struct mapped {
    struct pel_point v[3];
    struct pel_texel_point t[3];
};

/* In texels, at the centre of (x, y). */
static void place(const struct mapped *m, int32_t x, int32_t y, real uv[2])
{
    const wide px = pel_pixel_center(x), py = pel_pixel_center(y);
    const wide area = area_to(m->v[0], m->v[1], m->v[2].x, m->v[2].y);
    wide u = 0, v = 0;
    for (int i = 0; i < 3; i++) {
        wide w = area_to(m->v[(i + 1) % 3], m->v[(i + 2) % 3], px, py);
        u += w * m->t[i].u;
        v += w * m->t[i].v;
    }
    uv[0] = (real)u / ((real)area * 256);
    uv[1] = (real)v / ((real)area * 256);
}

/* u and v from -2 to 3 pictures, now and then on whole texels. */
static struct mapped random_mapped(struct random *r)
{
    struct mapped m;
    const int32_t w = picture.texels.width * 256;
    const int32_t h = picture.texels.height * 256;
    const int32_t mask = random_word(r) % 2 ? -1 : -256;
    if (random_word(r) % 2)
        shape_random(r, m.v, 3);
    else
        shape_adversarial(r, m.v, 3);
    for (int i = 0; i < 3; i++) {
        m.t[i].u = random_between(r, -2 * w, 3 * w) & mask;
        m.t[i].v = random_between(r, -2 * h, 3 * h) & mask;
    }
    return m;
}

static void fail_at(const struct mapped *m, int32_t x, int32_t y, pel_color got)
{
    real uv[2];
    place(m, x, y, uv);
    fail_msg(
        "picture %dx%d, wrap %d %d, pixel %d,%d: u %Lg v %Lg, got %08x; %s",
        picture.texels.width, picture.texels.height, (int)picture.wrap_u,
        (int)picture.wrap_v, x, y, uv[0], uv[1], got, cases_replay());
}

static real larger(real a, real b)
{
    return a > b ? a : b;
}

/* From a place to a texel: 0 on it. */
static real distance(real at, int64_t texel)
{
    return larger(0, larger((real)texel - at, at - (real)texel - 1));
}

/* The texel shown misses the exact place by 2^-14 texel at most. */
static void check_nearest(const struct mapped *m, int32_t x, int32_t y,
                          pel_color got)
{
    real uv[2], off = 0x1p-14L, least = 1;
    place(m, x, y, uv);
    for (int i = 0; i < 4; i++) {
        const int64_t u = (int64_t)real_floor(uv[0] + (i & 1 ? off : -off));
        const int64_t v = (int64_t)real_floor(uv[1] + (i & 2 ? off : -off));
        const real error = larger(distance(uv[0], u), distance(uv[1], v));
        if (got == texel_at(u, v) && error < least)
            least = error;
    }
    if (least == 1)
        fail_at(m, x, y, got);
    histogram_add(&nearest_errors, least);
}

static void check_bilinear(const struct mapped *m, int32_t x, int32_t y,
                           pel_color got)
{
    real uv[2], t[4];
    place(m, x, y, uv);
    const int64_t i = (int64_t)real_floor(uv[0] - 0.5L);
    const int64_t j = (int64_t)real_floor(uv[1] - 0.5L);
    const real fu = uv[0] - 0.5L - (real)i, fv = uv[1] - 0.5L - (real)j;
    for (int k = 0; k < 32; k += 8) {
        for (int n = 0; n < 4; n++)
            t[n] = texel_at(i + n % 2, j + n / 2) >> k & 255;
        real du = larger(real_abs(t[1] - t[0]), real_abs(t[3] - t[2]));
        real dv = larger(real_abs(t[2] - t[0]), real_abs(t[3] - t[1]));
        real want = (t[0] * (1 - fu) + t[1] * fu) * (1 - fv) +
                    (t[2] * (1 - fu) + t[3] * fu) * fv;
        real error = (real)(got >> k & 255) - want;
        /* 2^-14 texel may lead to the neighbours of these four. */
        if (real_abs(error) > (du + dv) / 512 + 0.5L + 2 * 255 * 0x1p-14L)
            fail_at(m, x, y, got);
        histogram_add(&bilinear_errors, error);
    }
}

typedef enum pel_status init_function(struct pel_texture *,
                                      const struct pel_texels *,
                                      const struct pel_texture_map *);
typedef void check_function(const struct mapped *, int32_t x, int32_t y,
                            pel_color got);

static void check_row(struct random *r, const struct mapped *m,
                      init_function *init, check_function *check)
{
    const struct pel_rect w = shape_window(r, m->v, 3, 24);
    const int32_t y = random_between(r, w.y0, w.y1 - 1);
    struct pel_texture_map map;
    struct pel_texture p;
    assert_int_equal(pel_texture_map_triangle(&map, m->v, m->t), PEL_OK);
    assert_int_equal(init(&p, &picture.texels, &map), PEL_OK);
    p.wrap_u = (uint8_t)picture.wrap_u;
    p.wrap_v = (uint8_t)picture.wrap_v;
    for (int32_t x = w.x0, n; x < w.x1; x += n) {
        pel_color got[24];
        n = 0;
        while (x + n < w.x1 && reference_triangle_at(m->v, x + n, y))
            n++;
        if (n > 0)
            p.base.colors(&p.base, x, y, n, got);
        for (int32_t i = 0; i < n; i++)
            check(m, x + i, y, got[i]);
        n += n == 0;
    }
}

static void check_rows(bool noise, init_function *init, check_function *check)
{
    for (struct cases c = cases_of(40000); cases_next(&c);) {
        struct random shared = cases_shared((c.next - 1) / 64);
        if (c.next % 64 == 1 || cases_alone())
            open_random_picture(&shared, noise);
        const struct mapped m = random_mapped(&c.random);
        check_row(&c.random, &m, init, check);
    }
}

TEST(nearest)
{
    check_rows(false, pel_texture_init_nearest, check_nearest);
    histogram_end(&nearest_errors);
}

TEST(bilinear)
{
    check_rows(true, pel_texture_init_bilinear, check_bilinear);
    histogram_end(&bilinear_errors);
}

/* Texel by pixel, from -2 to 3 pictures: not one texel off, and bilinear the
 * same as nearest. */
static void check_unit_scale(init_function *init)
{
    const int32_t w = picture.texels.width, h = picture.texels.height;
    const struct pel_texture_map map = PEL_TEXTURE_AT(7, -3);
    static pel_color got[5 * 451];
    struct pel_texture p;
    assert_int_equal(init(&p, &picture.texels, &map), PEL_OK);
    p.wrap_u = (uint8_t)picture.wrap_u;
    p.wrap_v = (uint8_t)picture.wrap_v;
    for (int32_t y = -2 * h; y < 3 * h; y++) {
        p.base.colors(&p.base, 7 - 2 * w, y - 3, 5 * w, got);
        for (int32_t x = 0; x < 5 * w; x++)
            if (got[x] != texel_at(x - 2 * w, y))
                fail_msg("%dx%d, wrap %d %d: texel %d, %d: got %08x", w, h,
                         (int)picture.wrap_u, (int)picture.wrap_v, x - 2 * w, y,
                         got[x]);
    }
}

TEST(unit_scale_is_exact)
{
    static const int16_t size[][2] = {{451, 300}, {256, 64}, {1, 1}, {13, 1}};
    for (int s = 0; s < 4; s++)
        for (int wrap = 0; wrap < 9; wrap++) {
            open_picture(size[s][0], size[s][1], false);
            picture.wrap_u = (enum pel_wrap)(wrap % 3);
            picture.wrap_v = (enum pel_wrap)(wrap / 3);
            check_unit_scale(pel_texture_init_nearest);
            check_unit_scale(pel_texture_init_bilinear);
        }
}

/* Any order of the vertices gives the same map. */
TEST(order_changes_nothing)
{
    static const int8_t order[5][3] = {
        {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    open_picture(451, 300, false);
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        const struct mapped m = random_mapped(&c.random);
        struct pel_texture_map map, other;
        assert_int_equal(pel_texture_map_triangle(&map, m.v, m.t), PEL_OK);
        if (area_to(m.v[0], m.v[1], m.v[2].x, m.v[2].y) == 0)
            continue;
        for (int i = 0; i < 5; i++) {
            struct mapped n;
            for (int k = 0; k < 3; k++) {
                n.v[k] = m.v[order[i][k]];
                n.t[k] = m.t[order[i][k]];
            }
            assert_int_equal(pel_texture_map_triangle(&other, n.v, n.t),
                             PEL_OK);
            assert_memory_equal(&map, &other, sizeof map);
        }
    }
}

/* A surface of any format as the picture, drawn on a surface of any other. */
static void check_formats(const struct pel_format *from,
                          const struct pel_format *to, uint8_t wrap)
{
    static struct canvas source, target;
    const struct pel_rect small = {8, -16, 27, -5}, large = {-32, -40, 40, 24};
    const struct pel_texture_map map = PEL_TEXTURE_AT(3, -9);
    struct pel_texels texels = {&source.surface, NULL, 0, 0, false};
    struct pel_texture p;
    canvas_open(&source, from, &small, wrap);
    canvas_open(&target, to, &large, wrap);
    assert_int_equal(pel_texture_init_nearest(&p, &texels, &map), PEL_OK);
    p.wrap_u = p.wrap_v = wrap;
    pel_box(&target.surface, &large, &p.base.paint);
    canvas_check(&target);
    for (int32_t y = large.y0; y < large.y1; y++)
        for (int32_t x = large.x0; x < large.x1; x++) {
            int64_t u = texel_index(x - 3, 19, (enum pel_wrap)wrap) + small.x0;
            int64_t v = texel_index(y + 9, 11, (enum pel_wrap)wrap) + small.y0;
            pel_color texel = layout_unpack(
                source.layout, canvas_pixel(&source, (int32_t)u, (int32_t)v));
            if (canvas_pixel(&target, x, y) !=
                layout_pack(target.layout, texel))
                fail_msg("%s on %s, wrap %u, pixel %d,%d", source.layout->name,
                         target.layout->name, wrap, x, y);
        }
    canvas_check(&source);
}

TEST(formats)
{
    for (int from = 0; from < LAYOUT_COUNT; from++)
        for (int to = 0; to < LAYOUT_COUNT; to++)
            for (uint8_t wrap = 0; wrap < 3; wrap++)
                check_formats(layouts[from].format, layouts[to].format, wrap);
}

/* A surface with alpha shows what the same colors in an array show. */
TEST(alpha_surface)
{
    static uint8_t memory[451 * 300 * 4];
    const struct pel_texture_map map = {{0x12345678, 0x9ABCDEF0, 0x13579BDF},
                                        {0x87654321, 0x2468ACE0, 0xFEDCBA98}};
    struct pel_texture p, q;
    pel_color from_surface[300], from_array[300];
    open_picture(451, 300, true);
    for (size_t i = 0; i < sizeof memory; i++)
        memory[i] = (uint8_t)(picture.texel[i / 4] >> i % 4 * 8);
    struct pel_surface surface =
        surface_of(&pel_argb8888, memory, sizeof memory, 451, 300);
    const struct pel_texels t = {&surface, NULL, 0, 0, false};
    for (int i = 0; i < 2; i++) {
        init_function *init =
            i ? pel_texture_init_bilinear : pel_texture_init_nearest;
        assert_int_equal(init(&p, &t, &map), PEL_OK);
        assert_int_equal(init(&q, &picture.texels, &map), PEL_OK);
        assert_false(p.base.opaque);
        for (int32_t y = -20; y < 200; y++) {
            p.base.colors(&p.base, -9, y, 300, from_surface);
            q.base.colors(&q.base, -9, y, 300, from_array);
            assert_memory_equal(from_surface, from_array, sizeof from_array);
        }
    }
}
