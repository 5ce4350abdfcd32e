/* The references themselves: two that share no code, and Pel, agree on fixed
 * cases. One is tests/support/reference.c, which judges pixel by pixel in 128
 * bits; the other goes along rows. */
#include "tests/support/reference.h"

#include <stdlib.h>

#include "cases.h"
#include "generate.h"
#include "sheet.h"

enum { CASES = 100000, SIDE = 8 };

/* Who differs from the first reference. */
struct differs {
    bool second, pel;
};

static uint32_t pixel_at(const struct sheet *s, int32_t x, int32_t y)
{
    return s->pixels[y * SIDE + x];
}

static void clear(struct sheet *s)
{
    for (int i = 0; i < SIDE * SIDE; i++)
        s->pixels[i] = 0;
}

static void make_triangle(struct random *r, struct pel_point v[3])
{
    const struct place p = {0, 0, SIDE};
    do {
        if (random_between(r, 0, 1))
            tied_triangle(r, &p, v);
        else
            any_triangle(r, &p, v);
    } while (pel_triangle_area(v) == 0);
}

static void check_triangle(struct random *r, struct sheet *s, struct differs *c)
{
    const struct pel_flat flat = PEL_FLAT(PEL_RGB(255, 255, 255));
    struct pel_point v[3];
    make_triangle(r, v);
    pel_triangle(&s->surface, v, &flat.paint);
    for (int32_t y = 0; y < SIDE; y++) {
        const struct pel_span row = exact_row(v, y, 8);
        for (int32_t x = 0; x < SIDE; x++) {
            const bool in = reference_triangle_at(v, x, y);
            c->second |= in != (x >= row.x0 && x < row.x1);
            c->pel |= in != (pixel_at(s, x, y) != 0);
        }
    }
}

/* Place and value where an edge crosses a row's centre, both times `down`. */
struct crossing {
    wide x, value, down;
};

/* The crossings of row y: two, unless it passes the triangle by. */
static int crossings(const struct pel_point v[3], const int32_t value[3],
                     int32_t y, struct crossing out[2])
{
    const wide center = 256 * (wide)y + 128;
    int n = 0;
    for (int i = 0; i < 3; i++) {
        const int k = (i + 1) % 3;
        const int a = v[i].y <= v[k].y ? i : k, b = i + k - a;
        if (center < v[a].y || center >= v[b].y)
            continue;
        const wide down = v[b].y - v[a].y, t = center - v[a].y;
        const struct crossing c = {v[a].x * down + t * (v[b].x - v[a].x),
                                   value[a] * down + t * (value[b] - value[a]),
                                   down};
        out[n++] = c;
    }
    return n;
}

static wide gcd(wide a, wide b)
{
    while (b) {
        const wide rest = a % b;
        a = b;
        b = rest;
    }
    return a < 0 ? -a : a;
}

/* The value at a covered pixel, by edges and then along the row, as a reduced
 * fraction: between 256-fold places it is exact. */
static struct fraction along_row(const struct pel_point v[3],
                                 const int32_t value[3], int32_t x, int32_t y)
{
    const wide center = 256 * (wide)x + 128;
    struct crossing c[2] = {{0, 0, 1}, {0, 0, 1}};
    crossings(v, value, y, c);
    struct fraction f = {c[0].value * (c[1].x - center * c[1].down) +
                             c[1].value * (center * c[0].down - c[0].x),
                         c[1].x * c[0].down - c[0].x * c[1].down};
    const wide common = gcd(f.n, f.d) * (f.d < 0 ? -1 : 1);
    f.n /= common;
    f.d /= common;
    return f;
}

static bool same(struct fraction a, struct fraction b)
{
    return a.n * b.d == b.n * a.d;
}

static void check_gradient(struct random *r, struct sheet *s, struct differs *c)
{
    struct pel_point v[3];
    pel_color color[3];
    int32_t value[3];
    make_triangle(r, v);
    for (int i = 0; i < 3; i++) {
        value[i] = random_between(r, 0, 255);
        color[i] = PEL_RGB(0, 0, value[i]);
    }
    pel_triangle_gouraud(&s->surface, v, color);
    for (int32_t i = 0; i < SIDE * SIDE; i++) {
        const int32_t x = i % SIDE, y = i / SIDE;
        if (!reference_triangle_at(v, x, y))
            continue;
        const struct fraction f = reference_channel_at(v, color, 0, x, y);
        const wide shown = pixel_at(s, x, y) & 255;
        const wide off = 16 * (shown * f.d - f.n); /* gouraud.h: 1/2 + 1/16 */
        c->second |= !same(f, along_row(v, value, x, y));
        c->pel |= off > 9 * f.d || -off > 9 * f.d;
    }
}

enum { TEXELS = 16 };

static int texel(int u, int v)
{
    return (u * 37 + v * 101 + u * v * 13) & 255;
}

/* Four weights, (u, v) in texels, not below 0; edges repeat. */
static struct fraction by_weights(struct fraction u, struct fraction v)
{
    const wide half_u = 2 * u.n - u.d + 2 * TEXELS * u.d, du = 2 * u.d;
    const wide half_v = 2 * v.n - v.d + 2 * TEXELS * v.d, dv = 2 * v.d;
    const wide fu = half_u % du, fv = half_v % dv;
    const int i = (int)(half_u / du), k = (int)(half_v / dv);
    struct fraction sum = {0, du * dv};
    for (int n = 0; n < 4; n++)
        sum.n += (n & 1 ? fu : du - fu) * (n & 2 ? fv : dv - fv) *
                 texel((i + (n & 1)) % TEXELS, (k + (n >> 1)) % TEXELS);
    return sum;
}

/* The largest whole number not above n / d, by counting from below. */
static int count_up(wide n, wide d)
{
    int i = -1;
    while ((i + 1) * d <= n)
        i++;
    return i;
}

/* Two lines in u, then one in v. */
static struct fraction by_lines(struct fraction u, struct fraction v)
{
    const int i = count_up(2 * u.n - u.d, 2 * u.d);
    const int k = count_up(2 * v.n - v.d, 2 * v.d);
    const wide at = 2 * u.n - (2 * i + 1) * u.d;
    wide line[2];
    for (int n = 0; n < 2; n++) {
        const int row = (k + n + TEXELS) % TEXELS;
        const int left = texel((i + TEXELS) % TEXELS, row);
        const int right = texel((i + 1) % TEXELS, row);
        line[n] = 2 * left * u.d + at * (right - left);
    }
    const wide down = 2 * v.n - (2 * k + 1) * v.d;
    const struct fraction f = {2 * v.d * line[0] + down * (line[1] - line[0]),
                               4 * u.d * v.d};
    return f;
}

/* core/paint/paint_texture.h: weights to 1/256, (Du + Dv) / 512 + 1/2. The map
 * is off by 2^-14 texel. */
static bool off_by_much(struct fraction exact, int shown)
{
    const wide off = 1024 * (shown * exact.d - exact.n);
    const wide most = 1024 * exact.d * 3 / 2 + 32 * exact.d;
    return off > most || -off > most;
}

static void draw_texture(const struct sheet *s, const struct pel_point v[3],
                         const int32_t uv[2][3])
{
    static pel_color color[TEXELS * TEXELS];
    const struct pel_texels texels = {
        .colors = color, .width = TEXELS, .height = TEXELS};
    struct pel_texel_point t[3];
    struct pel_texture_map map;
    struct pel_texture paint;
    for (int i = 0; i < TEXELS * TEXELS; i++)
        color[i] = PEL_RGB(0, 0, texel(i % TEXELS, i / TEXELS));
    for (int i = 0; i < 3; i++)
        t[i] = (struct pel_texel_point){16 * uv[0][i], 16 * uv[1][i]};
    if (pel_texture_map_triangle(&map, v, t) ||
        pel_texture_init_bilinear(&paint, &texels, &map))
        method_fail("a texture is refused", "take legal texels");
    paint.wrap_u = paint.wrap_v = PEL_WRAP_REPEAT;
    pel_triangle(&s->surface, v, &paint.base.paint);
}

/* Corners in 1/16 texel: as channels of colors for the first reference. */
static void check_texture(struct random *r, struct sheet *s, struct differs *c)
{
    struct pel_point v[3];
    pel_color color[3];
    int32_t uv[2][3];
    make_triangle(r, v);
    for (int i = 0; i < 3; i++) {
        uv[0][i] = random_between(r, 0, 255);
        uv[1][i] = random_between(r, 0, 255);
        color[i] = PEL_RGB(0, uv[1][i], uv[0][i]);
    }
    draw_texture(s, v, (const int32_t(*)[3])uv);
    for (int32_t i = 0; i < SIDE * SIDE; i++) {
        const int32_t x = i % SIDE, y = i / SIDE;
        struct fraction a[2], b[2];
        if (!reference_triangle_at(v, x, y))
            continue;
        for (int k = 0; k < 2; k++) {
            a[k] = reference_channel_at(v, color, k, x, y);
            b[k] = along_row(v, uv[k], x, y);
            a[k].d *= 16;
            b[k].d *= 16;
        }
        const struct fraction first = by_weights(a[0], a[1]);
        c->second |= !same(a[0], b[0]) || !same(a[1], b[1]) ||
                     !same(by_weights(b[0], b[1]), by_lines(b[0], b[1]));
        c->pel |= off_by_much(first, (int)(pixel_at(s, x, y) & 255));
    }
}

/* floor(sqrt(v)), bit by bit. */
static int64_t root_of(int64_t v)
{
    int64_t root = 0;
    for (int64_t bit = 1 << 20; bit; bit >>= 1)
        if ((root + bit) * (root + bit) <= v)
            root += bit;
    return root;
}

static void check_circle(struct random *r, struct sheet *s, struct differs *c)
{
    const struct pel_flat flat = PEL_FLAT(PEL_RGB(255, 255, 255));
    const int32_t grain = random_between(r, 0, 1) ? 128 : 1;
    const int32_t radius = random_between(r, 0, PEL_PX(SIDE)) / grain * grain;
    const struct pel_point center = {
        random_between(r, -256, PEL_PX(SIDE + 1)) / grain * grain,
        random_between(r, -256, PEL_PX(SIDE + 1)) / grain * grain};
    pel_circle(&s->surface, center, radius, &flat.paint);
    for (int32_t i = 0; i < SIDE * SIDE; i++) {
        const int32_t x = i % SIDE, y = i / SIDE;
        const int64_t down = 256 * y + 128 - center.y;
        const int64_t left = radius * (int64_t)radius - down * down;
        const bool in = reference_disc_at(center, radius, x, y);
        const bool in_row =
            left >= 0 && abs(256 * x + 128 - center.x) <= root_of(left);
        c->second |= in != in_row;
        c->pel |= in != (pixel_at(s, x, y) != 0);
    }
}

static void check_alpha(struct random *r, struct sheet *s, struct differs *c)
{
    const int source = random_between(r, 0, 255), d = random_between(r, 0, 255);
    const int a = random_between(r, 0, 255);
    const int t = source * a + d * (255 - a), divided = (2 * t + 255) / 510;
    int nearest = 0;
    (void)s;
    while (abs(255 * (nearest + 1) - t) < abs(255 * nearest - t))
        nearest++;
    c->second |= nearest != divided;
    c->pel |= pel_blue(pel_mix((pel_color)d, (pel_color)source, (uint32_t)a)) !=
              (uint32_t)divided;
}

static const struct {
    const char *name;
    void (*check)(struct random *r, struct sheet *s, struct differs *c);
} families[] = {{"triangles", check_triangle},
                {"gradients", check_gradient},
                {"textures", check_texture},
                {"circles", check_circle},
                {"alpha", check_alpha}};

static void put_differences(struct atlas *a, const char *family,
                            const char *metric, int n)
{
    const struct figure f = figure_of(family, CASES, metric, n, "cases");
    atlas_put(a, f);
    atlas_promise(a, n == 0, &f);
}

/* The cases are fixed: neither the seed nor --quick changes them. */
void atlas_references(struct atlas *a)
{
    struct sheet s;
    sheet_open(&s, a, (struct pel_rect){0, 0, SIDE, SIDE});
    for (size_t i = 0; i < sizeof families / sizeof *families; i++) {
        struct random r = {0x9E3779B97F4A7C15u + i};
        int second = 0, pel = 0;
        for (int n = 0; n < CASES; n++) {
            struct differs c = {false, false};
            families[i].check(&r, &s, &c);
            clear(&s);
            second += c.second;
            pel += c.pel;
        }
        put_differences(a, families[i].name, "differences", second);
        put_differences(a, families[i].name, "pel_differences", pel);
    }
    sheet_close(&s);
}
