/* The probe that tells which rule is in force: triangles all around one pixel
 * centre, of which exactly one owns it. By the top-left rule it is the one just
 * below the ray to the right, whose top edge begins there. */
#include "tests/support/check.h"
#include "tests/support/hits.h"

static struct hits hits;
static const struct pel_point center = {5 * 256 + 128, 5 * 256 + 128};

static void setup(void)
{
    const struct pel_rect bounds = {0, 0, 11, 11};
    hits_open(&hits, &bounds);
}

/* Does the triangle between two rays own the centre? */
static bool owns(const struct pel_point *a, const struct pel_point *b)
{
    const struct pel_point v[3] = {
        center,
        {center.x + a->x, center.y + a->y},
        {center.x + b->x, center.y + b->y},
    };
    const uint8_t before = hits_at(&hits, 5, 5);
    pel_triangle(&hits.surface, v, &hits.paint);
    return hits_at(&hits, 5, 5) != before;
}

/*       5  6  7
 *        \ | /       Rays, clockwise on screen; triangle k lies between ray k
 *     4 -- + -- 0    and ray k + 1.
 *        / | \
 *       3  2  1
 */
static void test_eight_triangles(void)
{
    static const struct pel_point ray[8] = {
        PEL_AT(4, 0),  PEL_AT(4, 4),   PEL_AT(0, 4),  PEL_AT(-4, 4),
        PEL_AT(-4, 0), PEL_AT(-4, -4), PEL_AT(0, -4), PEL_AT(4, -4)};
    setup();
    for (int k = 0; k < 8; k++)
        if (owns(&ray[k], &ray[(k + 1) % 8]) != (k == 0))
            fail_msg("triangle %d: expected %d", k, k == 0);
}

/* No ray to the right: the triangle that has that direction inside. */
static void test_turned_triangles(void)
{
    static const struct pel_point ray[8] = {
        {1000, 100},  {800, 801},    {-9, 1000},  {-700, 699},
        {-1000, -50}, {-600, -1000}, {11, -1001}, {999, -1000}};
    setup();
    for (int k = 0; k < 8; k++)
        if (owns(&ray[k], &ray[(k + 1) % 8]) != (k == 7))
            fail_msg("triangle %d: expected %d", k, k == 7);
}

/* Half planes: a vertical side owns its centre from the right, a horizontal one
 * from below. */
static void test_sides(void)
{
    static const struct pel_point up = PEL_AT(0, -4), down = PEL_AT(0, 4),
                                  left = PEL_AT(-4, 0), right = PEL_AT(4, 0);
    static const struct {
        const struct pel_point *from, *to; /* a side through the centre */
        struct pel_point third;
        bool owned;
    } row[] = {
        {&up, &down, PEL_AT(4, 0), true},
        {&up, &down, PEL_AT(-4, 0), false},
        {&left, &right, PEL_AT(0, 4), true},
        {&left, &right, PEL_AT(0, -4), false},
    };
    for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
        const struct pel_point v[3] = {
            {center.x + row[i].from->x, center.y + row[i].from->y},
            {center.x + row[i].to->x, center.y + row[i].to->y},
            {center.x + row[i].third.x, center.y + row[i].third.y}};
        setup();
        pel_triangle(&hits.surface, v, &hits.paint);
        if (hits_at(&hits, 5, 5) != row[i].owned)
            fail_msg("row %zu: expected %d", i, row[i].owned);
    }
}

int main(void)
{
    return RUN_TESTS(test_eight_triangles, test_turned_triangles, test_sides);
}
