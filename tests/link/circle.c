/* Flat opaque circles in one format. */
#include "screen.h"

static const struct pel_surface screen = SCREEN(pel_rgb565_le_fill);

int main(void)
{
    static const struct pel_flat red = PEL_FLAT(PEL_RGB(255, 0, 0));
    static const struct pel_point center = PEL_AT(30, 30);
    pel_circle(&screen, center, PEL_PX(40), &red.paint);
    return 0;
}
