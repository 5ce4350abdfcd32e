/* Edges that pass a pixel centre as closely as an edge can: through it, or left
 * or right of it by 1 / (256 dy) px, in one row, often one of the last. Walked
 * from their first row and from a clip anywhere, by both walks: a drift that is
 * too small to be seen elsewhere is off by a pixel here. */
#include "tests/support/check.h"
#include "tests/support/shapes.h"
#include "tests/support/cases.h"
#include "tests/support/probe.h"

/* The x with t x = 1 modulo m, 0 < t < m < 2^32; 0 when there is none. */
static int64_t inverse_of(int64_t t, int64_t m)
{
    int64_t r0 = m, r1 = t, x0 = 0, x1 = 1;
    while (r1 != 0) {
        const int64_t q = r0 / r1, r2 = r0 - q * r1, x2 = x0 - q * x1;
        r0 = r1;
        r1 = r2;
        x0 = x1;
        x1 = x2;
    }
    return r0 == 1 ? (x0 % m + m) % m : 0;
}

/* An edge, and the row in which it passes closely. */
struct near_miss {
    struct pel_point a, b; /* downwards */
    int32_t row;
};

/* The edge's x in the row with the centre t below a is a.x + t dx / dy; it is
 * e / (256 dy) px right of a centre when
 *
 *     (a.x - 128) dy + t dx = e    modulo 256 dy,
 *
 * which has a solution dx for every t that is prime to 256 dy. Those of them
 * that are legal are few when dy is large. */
static bool try_edge(struct random *r, struct near_miss *m, int32_t dy)
{
    const int32_t reach = 4194304; /* the probe's bounds */
    const int64_t modulus = (int64_t)dy * 256;
    m->a.x = random_between(r, -reach, reach - 256);
    m->a.y = random_between(r, -reach, reach - 256 - dy) | 1;
    const int32_t first = pel_first_pixel(m->a.y);
    const int32_t end = pel_first_pixel(m->a.y + dy);
    if (first == end)
        return false;
    m->row = random_between(
        r, random_word(r) % 2 ? first : pel_max(first, end - 50), end - 1);
    const int64_t t = pel_pixel_center(m->row) - m->a.y;
    const int64_t inverse = inverse_of(t, modulus);
    if (inverse == 0)
        return false;
    int64_t e = random_between(r, -1, 1) - (m->a.x - 128) * (int64_t)dy;
    e = (e % modulus + modulus) % modulus;
    int64_t x = m->a.x + (e * inverse) % modulus;
    x -= (x + reach) / modulus * modulus; /* the leftmost in bounds */
    if (x + modulus < reach)
        x += random_between(r, 0, (int32_t)((reach - 256 - x) / modulus)) *
             modulus;
    m->b = (struct pel_point){(int32_t)x, m->a.y + dy};
    return x < reach - 256;
}

static void near_miss_random(struct random *r, struct near_miss *m,
                             const int32_t dy[2])
{
    while (!try_edge(r, m, random_between(r, dy[0], dy[1])))
        continue;
}

/* The edge as the long one, or as one of the short ones. */
static void draw(struct random *r, struct probe *p, const struct near_miss *m)
{
    const int32_t low = -4194304, high = 4194304 - 256;
    struct pel_point v[3] = {m->a, m->b, {0, 0}};
    v[2].x = random_between(r, low, high);
    v[2].y = random_between(r, pel_max(m->a.y - 512, low), m->b.y + 255);
    if (random_word(r) % 8 == 0) /* as thin as it gets */
        v[2] = (struct pel_point){m->b.x + (m->b.x < high ? 1 : -1), m->b.y};
    shape_keep(v, 3);
    probe_triangle(p, v);
}

static void check_edges(uint64_t count, const int32_t dy[2])
{
    struct probe p[2];
    probe_open(&p[0]);
    probe_open(&p[1]);
    for (struct cases c = cases_of(count); cases_next(&c);) {
        struct random *r = &c.random;
        struct near_miss m;
        near_miss_random(r, &m, dy);
        const struct pel_rect clip = {-16384, m.row - random_between(r, 0, 3),
                                      16383, m.row + random_between(r, 1, 3)};
        pel_surface_clip(&p[1].surface, &clip);
        draw(r, &p[0], &m);
        draw(r, &p[1], &m);
    }
    assert_true(cases_alone() || p[1].rows > 0);
}

TEST(up_to_128_rows)
{
    check_edges(100000, (const int32_t[]){1, 2000});
    check_edges(50000, (const int32_t[]){2000, 32768});
}

TEST(up_to_4094_rows)
{
    check_edges(20000, (const int32_t[]){32768, 100000});
    check_edges(2000, (const int32_t[]){100000, PEL_PX(4094)});
    check_edges(1000, (const int32_t[]){PEL_PX(4000), PEL_PX(4094)});
}

TEST(up_to_15625_rows)
{
    check_edges(1200, (const int32_t[]){PEL_PX(4094), 4000000});
}

/* The generator's promise: no edge passes more closely. */
TEST(generator)
{
    for (struct cases c = cases_of(10000); cases_next(&c);) {
        struct near_miss m;
        near_miss_random(&c.random, &m, (const int32_t[]){1, 1000000});
        shape_keep((struct pel_point[]){m.a, m.b}, 2);
        const int64_t dy = m.b.y - m.a.y, dx = m.b.x - m.a.x;
        const int64_t t = pel_pixel_center(m.row) - m.a.y;
        const int64_t rest = ((m.a.x - 128) * dy + t * dx) % (256 * dy);
        assert_true(t >= 0 && t < dy);
        assert_true(rest == 0 || rest == 1 || rest == -1 ||
                    rest == 256 * dy - 1 || rest == 1 - 256 * dy);
    }
}
