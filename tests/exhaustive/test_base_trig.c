/* Every direction: the nearest integers. */
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
