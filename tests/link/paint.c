/* Fills a rectangle with one paint, MAKE of makes.h. */
#include "makes.h"

static const struct pel_surface screen = SCREEN(pel_rgb565_le);

int main(void)
{
    static const struct pel_point from = PEL_AT(-9, -7), to = PEL_AT(50, 70);
    pel_rectangle(&screen, from, to, MAKE());
    return 0;
}
