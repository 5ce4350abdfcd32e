/* Every direction: nearest integers, in order, symmetric. */
#include "core/base/trig.h"
#include "tests/support/check.h"
#include "tests/support/reference_shape.h"

TEST(nearest)
{
    for (uint32_t turn = 0; turn < 65536; turn++) {
        const struct pel_point d = pel_direction((uint16_t)turn);
        const struct pel_point want = reference_direction((uint16_t)turn);
        if (d.x != want.x || d.y != want.y)
            fail_msg("turn %u: expected %d, %d, got %d, %d", turn, want.x,
                     want.y, d.x, d.y);
    }
}

TEST(order)
{
    struct pel_point last = pel_direction(65535);
    for (uint32_t turn = 0; turn < 65536; turn++) {
        const struct pel_point d = pel_direction((uint16_t)turn);
        if ((int64_t)last.x * d.y - (int64_t)last.y * d.x <= 0)
            fail_msg("turn %u does not lie behind the one before", turn);
        last = d;
    }
}

TEST(symmetry)
{
    for (uint32_t turn = 0; turn < 65536; turn++) {
        const struct pel_point d = pel_direction((uint16_t)turn);
        const struct pel_point half = pel_direction((uint16_t)(turn + 32768));
        const struct pel_point down = pel_direction((uint16_t)(65536 - turn));
        const struct pel_point across = pel_direction((uint16_t)(16384 - turn));
        assert_true(half.x == -d.x && half.y == -d.y);
        assert_true(down.x == d.x && down.y == -d.y);
        assert_true(across.x == d.y && across.y == d.x);
    }
}
