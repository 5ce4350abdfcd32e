/* All triangles of a small lattice, every order of the vertices included,
 * against half planes evaluated at every pixel centre: 16 x 16 points a quarter
 * of a pixel apart, through both walks, since a clip takes the integer one, and
 * 12 x 12 points half a pixel apart; both straddle zero. The half plane of two
 * vertices is worked out once, by the reference's rule; a triangle is the
 * intersection of three. */
#include "tests/support/check.h"
#include "tests/support/bit_picture.h"
#include "tests/support/cases.h"
#include "tests/support/reference.h"

enum { SIDE_MAX = 16, POINTS_MAX = SIDE_MAX * SIDE_MAX };

struct lattice {
    int32_t side, step; /* points, sub-pixels */
    struct pel_point point[POINTS_MAX];
    uint64_t half_plane[POINTS_MAX][POINTS_MAX];
};

static struct lattice lattice;

/* Centres right of a -> b, or on it when it is a top or left edge of what lies
 * there: the third vertex of a triangle that has those pixels is right of it.
 */
static uint64_t half_plane_of(const struct pel_point *a,
                              const struct pel_point *b)
{
    bool top_left = b->y < a->y || (b->y == a->y && b->x > a->x);
    uint64_t bits = 0;
    for (int32_t y = -BIT_REACH; y < BIT_REACH; y++)
        for (int32_t x = -BIT_REACH; x < BIT_REACH; x++) {
            wide e = ((wide)b->x - a->x) * (y * 256 + 128 - a->y) -
                     ((wide)b->y - a->y) * (x * 256 + 128 - a->x);
            if (e > 0 || (e == 0 && top_left))
                bits |= bit_of(x, y);
        }
    return bits;
}

static void lattice_open(int32_t side, int32_t step)
{
    struct lattice *l = &lattice;
    l->side = side;
    l->step = step;
    for (int32_t i = 0; i < side * side; i++)
        l->point[i] = (struct pel_point){(i % side - side / 2) * step,
                                         (i / side - side / 2) * step};
    for (int32_t i = 0; i < side * side; i++)
        for (int32_t j = 0; j < side * side; j++)
            l->half_plane[i][j] = half_plane_of(&l->point[i], &l->point[j]);
}

static uint64_t expected(int32_t i, int32_t j, int32_t k)
{
    const struct pel_point *a = &lattice.point[i], *b = &lattice.point[j],
                           *c = &lattice.point[k];
    int32_t area =
        (b->x - a->x) * (c->y - a->y) - (c->x - a->x) * (b->y - a->y);
    if (area == 0)
        return 0;
    if (area < 0) {
        int32_t t = j;
        j = k;
        k = t;
    }
    return lattice.half_plane[i][j] & lattice.half_plane[j][k] &
           lattice.half_plane[k][i];
}

/* Through a clip of `clip` pixels around zero. */
static void check_all(struct bit_picture *p, int32_t clip)
{
    static uint8_t nothing;
    const struct pel_rect bounds = {-clip, -clip, clip, clip};
    const int32_t n = lattice.side * lattice.side;
    uint64_t shown = 0;
    struct pel_surface s;
    assert_int_equal(
        pel_surface_init_rect(&s, &pel_gray8, &nothing, 16, &bounds), PEL_OK);
    for (int32_t y = -clip; y < clip; y++)
        for (int32_t x = -clip; x < clip; x++)
            shown |= bit_of(x, y);
    for (int32_t i = 0; i < n; i++)
        for (int32_t j = 0; j < n; j++)
            for (int32_t k = 0; k < n; k++) {
                const struct pel_point v[3] = {
                    lattice.point[i], lattice.point[j], lattice.point[k]};
                p->bits = 0;
                pel_triangle(&s, v, &p->paint);
                if (p->twice || p->bits != (expected(i, j, k) & shown))
                    fail_msg("%d,%d %d,%d %d,%d: expected %llx, got %llx",
                             v[0].x, v[0].y, v[1].x, v[1].y, v[2].x, v[2].y,
                             (unsigned long long)(expected(i, j, k) & shown),
                             (unsigned long long)p->bits);
            }
}

TEST(quarter_pixels)
{
    struct bit_picture p = {{.fill = bit_picture_fill}, 0, false};
    lattice_open(16, 64);
    check_all(&p, BIT_REACH);
    check_all(&p, 1);
}

TEST(half_pixels)
{
    struct bit_picture p = {{.fill = bit_picture_fill}, 0, false};
    lattice_open(12, 128);
    check_all(&p, BIT_REACH);
    check_all(&p, 1);
}

/* The bits of a lattice's triangles are those of the reference. */
TEST(half_planes)
{
    lattice_open(12, 128);
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        int32_t i[3];
        uint64_t want = 0;
        for (int k = 0; k < 3; k++)
            i[k] = random_between(&c.random, 0, 143);
        const struct pel_point v[3] = {lattice.point[i[0]], lattice.point[i[1]],
                                       lattice.point[i[2]]};
        for (int32_t y = -BIT_REACH; y < BIT_REACH; y++)
            for (int32_t x = -BIT_REACH; x < BIT_REACH; x++)
                if (reference_triangle_at(v, x, y))
                    want |= bit_of(x, y);
        assert_true(want == expected(i[0], i[1], i[2]));
    }
}
