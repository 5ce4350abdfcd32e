/* All quadrilaterals of a 4 x 4 lattice half a pixel apart, crossed ones and
 * those without area included, by both rules, against winding numbers; each
 * pixel at most once. */
#include "tests/support/bit_picture.h"
#include "tests/support/cases.h"
#include "tests/support/check.h"
#include "tests/support/reference.h"

/* By both rules: [PEL_EVEN_ODD] and [PEL_NON_ZERO]. */
static void expected(const struct pel_polygon_shape *outline, uint64_t bits[2])
{
    bits[0] = bits[1] = 0;
    for (int32_t y = -BIT_REACH; y < BIT_REACH; y++)
        for (int32_t x = -BIT_REACH; x < BIT_REACH; x++) {
            int32_t winding = reference_winding_at(outline, x, y);
            if (winding % 2 != 0)
                bits[PEL_EVEN_ODD] |= bit_of(x, y);
            if (winding != 0)
                bits[PEL_NON_ZERO] |= bit_of(x, y);
        }
}

static struct pel_surface surface;

static void setup(void)
{
    static uint8_t nothing;
    const struct pel_rect bounds = {-BIT_REACH, -BIT_REACH, BIT_REACH,
                                    BIT_REACH};
    assert_int_equal(
        pel_surface_init_rect(&surface, &pel_gray8, &nothing, 8, &bounds),
        PEL_OK);
}

static void check_polygon(const struct pel_point *v, int32_t n)
{
    uint32_t scratch[PEL_POLYGON_SCRATCH_SIZE(8) / 4];
    struct pel_polygon_shape outline = {v, n, PEL_EVEN_ODD};
    uint64_t want[2];
    expected(&outline, want);
    for (int rule = 0; rule < 2; rule++) {
        struct bit_picture p = {{.fill = bit_picture_fill}, 0, false};
        outline.rule = (enum pel_fill_rule)rule;
        assert_int_equal(pel_polygon(&surface, &outline, &p.paint, scratch,
                                     pel_polygon_scratch_size(n)),
                         PEL_OK);
        if (p.twice || p.bits != want[rule])
            fail_msg("%d vertices from %d,%d %d,%d on, rule %d: expected %llx, "
                     "got %llx%s; %s",
                     n, v[0].x, v[0].y, v[1].x, v[1].y, rule,
                     (unsigned long long)want[rule], (unsigned long long)p.bits,
                     p.twice ? ", pixels twice" : "", cases_replay());
    }
}

/* Point i of a lattice of `side` x `side` points around zero. */
static struct pel_point point_of(int32_t i, int32_t side, int32_t step)
{
    return (struct pel_point){(i % side - side / 2) * step,
                              (i / side - side / 2) * step};
}

TEST(all_quadrilaterals)
{
    for (int32_t i = 0; i < 1 << 16; i++) {
        struct pel_point v[4];
        for (int k = 0; k < 4; k++)
            v[k] = point_of(i >> 4 * k & 15, 4, 128);
        check_polygon(v, 4);
    }
}

int main(void)
{
    setup();
    return run_all_tests();
}
