/* Where an icon is placed, and what it cannot be drawn without. */
#include "core/format/formats.h"
#include "core/image/icon.h"
#include "core/path/transform.h"
#include "tests/support/check.h"

static struct pel_icon_asset asset = {.magic = PEL_ICON_MAGIC,
                                      .version = PEL_ICON_VERSION};
static struct pel_icon_shape shape = {.icon = &asset};

/* Places a box of so many units, 100 px at its longer side, around (70, 50). */
static void place(uint16_t width, uint16_t height, int32_t turn)
{
    asset.width = width;
    asset.height = height;
    assert_int_equal(pel_icon_place(&shape, PEL_PX(100), turn,
                                    (struct pel_point){PEL_PX(70), PEL_PX(50)}),
                     PEL_OK);
}

/* Is this corner of the box there? px */
static void expect_at(int32_t x, int32_t y, int32_t to_x, int32_t to_y)
{
    struct pel_point p;
    assert_true(pel_transform_point(&shape.transform, x, y, &p));
    if (pel_magnitude(p.x - PEL_PX(to_x)) > 2 ||
        pel_magnitude(p.y - PEL_PX(to_y)) > 2)
        fail_msg("(%d, %d) is at %d, %d, not at %d, %d px", x, y, p.x, p.y,
                 to_x, to_y);
}

TEST(icons_lie_around_their_middle)
{
    place(1000, 600, 0);
    expect_at(0, 0, 20, 20);
    expect_at(1000, 600, 120, 80);
    place(1000, 600, 16384);
    expect_at(0, 0, 100, 0);
    expect_at(1000, 600, 40, 100);
    place(600, 1000, 0);
    expect_at(0, 0, 40, 0);
    expect_at(600, 1000, 100, 100);
}

TEST(nothing_may_be_missing)
{
    static uint64_t scratch[PEL_ICON_SCRATCH_SIZE(9, 8) / 8];
    static uint8_t pixels[64];
    const struct pel_rect bounds = {0, 0, 8, 8};
    struct pel_surface s;
    struct pel_icon_shape wrong = shape;
    pel_surface_init(&s, &pel_gray8, pixels, sizeof pixels, &bounds);
    assert_int_equal(pel_icon(&s, NULL, scratch, sizeof scratch),
                     PEL_ERROR_NULL);
    assert_int_equal(pel_icon(&s, &wrong, scratch, sizeof scratch),
                     PEL_ERROR_NULL);
    wrong.kind = &pel_icon_smooth;
    assert_int_equal(pel_icon(&s, &wrong, scratch, sizeof scratch), PEL_OK);
    assert_int_equal(pel_icon(&s, &wrong, scratch, PEL_ICON_SIZE), PEL_OK);
    assert_int_equal(pel_icon(&s, &wrong, NULL, sizeof scratch),
                     PEL_ERROR_NULL);
    wrong.icon = NULL;
    assert_int_equal(pel_icon(&s, &wrong, scratch, sizeof scratch),
                     PEL_ERROR_NULL);
}
