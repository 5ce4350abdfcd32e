/* A flat polygon that crosses itself, by both rules. */
#include "screen.h"

static const struct pel_surface screen = SCREEN(pel_rgb565_le_fill);

int main(void)
{
    static uint32_t scratch[64];
    static const struct pel_flat red = PEL_FLAT(PEL_RGB(255, 0, 0));
    static const struct pel_point v[5] = {PEL_AT(32, -5), PEL_AT(51, 60),
                                          PEL_AT(2, 20), PEL_AT(69, 20),
                                          PEL_AT(12, 60)};
    struct pel_polygon_shape star = {v, 5, PEL_EVEN_ODD};
    enum pel_status even_odd =
        pel_polygon(&screen, &star, &red.paint, scratch, sizeof scratch);
    star.rule = PEL_NON_ZERO;
    enum pel_status non_zero =
        pel_polygon(&screen, &star, &red.paint, scratch, sizeof scratch);
    return even_odd != PEL_OK || non_zero != PEL_OK;
}
