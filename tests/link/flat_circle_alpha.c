/* Flat triangles and circles, opaque and with alpha, in one format. */
#include "screen.h"

static const struct pel_surface screen = SCREEN(pel_rgb565_le);

int main(void)
{
    static const struct pel_flat red = PEL_FLAT(PEL_RGB(255, 0, 0));
    static const struct pel_flat glass = PEL_FLAT(PEL_RGBA(0, 0, 255, 128));
    static const struct pel_point v[3] = {PEL_AT(-9, -7), PEL_AT(90, 20),
                                          PEL_AT(10, 70)};
    static const struct pel_point center = PEL_AT(30, 30);
    pel_triangle(&screen, v, &red.paint);
    pel_circle(&screen, center, PEL_PX(40), &red.paint);
    pel_circle(&screen, center, PEL_PX(40), &glass.paint);
    return 0;
}
