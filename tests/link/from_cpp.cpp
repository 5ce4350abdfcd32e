// A C++ program that draws with core: exits with 0 when a pixel was painted.
#include "core/pel.h"

int main()
{
    static uint32_t scratch[PEL_POLYGON_SCRATCH_SIZE(3) / 4];
    uint32_t pixels[16 * 16] = {};
    pel_surface surface;
    const pel_rect all = {0, 0, 16, 16};
    if (pel_surface_init(&surface, &pel_xrgb8888, pixels, sizeof pixels,
                         &all) != PEL_OK)
        return 1;
    const pel_flat red = PEL_FLAT(PEL_RGB(255, 0, 0));
    const pel_point v[3] = {PEL_AT(0, 0), PEL_AT(16, 0), PEL_AT(0, 16)};
    const pel_polygon_shape shape = {v, 3, PEL_NON_ZERO};
    const pel_texture_map map = PEL_TEXTURE_AT(pixels[0] > 0, 2);
    if (map.v.dy != UINT64_C(1) << 32 || PEL_PX(7.5) != 1920 ||
        PEL_FACTOR(50) != PEL_UNITS(1) / 2)
        return 1;
    if (pel_polygon(&surface, &shape, &red.paint, scratch, sizeof scratch) !=
        PEL_OK)
        return 1;
    return pixels[0] == 0xFFFF0000u ? 0 : 1;
}
