// A C++ program that draws with core: exits with 0 when a pixel was painted.
#include "core/pel.h"

int main()
{
    uint32_t pixels[16 * 16] = {};
    pel_surface surface;
    const pel_rect all = {0, 0, 16, 16};
    if (pel_surface_init(&surface, &pel_xrgb8888, pixels, sizeof pixels,
                         &all) != PEL_OK)
        return 1;
    const pel_flat red = PEL_FLAT(PEL_RGB(255, 0, 0));
    const pel_point v[3] = {PEL_AT(0, 0), PEL_AT(16, 0), PEL_AT(0, 16)};
    pel_triangle(&surface, v, &red.paint);
    return pixels[0] == 0xFFFF0000u ? 0 : 1;
}
