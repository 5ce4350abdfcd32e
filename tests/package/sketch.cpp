#include <pel.h>

static uint32_t pixels[16 * 16];

int main()
{
    const pel_rect all = {0, 0, 16, 16};
    const pel_flat red = PEL_FLAT(PEL_RGB(255, 0, 0));
    const pel_point center = PEL_AT(8, 8);
    pel_surface s;
    if (pel_surface_init(&s, &pel_xrgb8888, pixels, sizeof pixels, &all))
        return 1;
    pel_circle(&s, center, PEL_PX(7), &red.paint);
    return pixels[8 * 16 + 8] != 0xFFFF0000u;
}
