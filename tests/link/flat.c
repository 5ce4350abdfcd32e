/* The smallest program: flat opaque triangles in one format. */
#include "screen.h"

static const struct pel_surface screen = SCREEN(pel_rgb565_le_fill);

int main(void)
{
    static const struct pel_flat red = PEL_FLAT(PEL_RGB(255, 0, 0));
    static const struct pel_point v[3] = {PEL_AT(-9, -7), PEL_AT(90, 20),
                                          PEL_AT(10, 70)};
    pel_triangle(&screen, v, &red.paint);
    return 0;
}
