/* Triangles with a color per vertex, opaque and with alpha. */
#include "screen.h"

static const struct pel_surface screen = SCREEN(pel_rgb565_le);

int main(void)
{
    static const struct pel_point v[3] = {PEL_AT(-9, -7), PEL_AT(90, 20),
                                          PEL_AT(10, 70)};
    static const pel_color solid[3] = {PEL_RGB(255, 0, 0), PEL_RGB(0, 255, 0),
                                       PEL_RGB(0, 0, 255)};
    static const pel_color glass[3] = {PEL_RGBA(255, 0, 0, 255),
                                       PEL_RGBA(0, 255, 0, 128),
                                       PEL_RGBA(0, 0, 255, 0)};
    pel_triangle_gouraud(&screen, v, solid);
    pel_triangle_gouraud(&screen, v, glass);
    return 0;
}
