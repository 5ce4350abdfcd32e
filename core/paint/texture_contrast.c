#include "texture_contrast.h"

#include "paint_texture_fetch.h"

/* Of t[0] t[1] over t[2] t[3] in a channel, 1/4 step: for every nearest one,
 * and along the two sides that meet in the first. The other sides are those of
 * other fours. Halves are rounded up, so a mix that is less is off by less. */
static int32_t quarters_of(const pel_color t[4], int shift)
{
    int32_t c[4], sum = 0;
    for (int i = 0; i < 4; i++)
        sum += c[i] = (int32_t)(t[i] >> shift & 255);
    int32_t most =
        2 * pel_max(pel_magnitude(c[1] - c[0]), pel_magnitude(c[2] - c[0]));
    for (int i = 0; i < 4; i++)
        most = pel_max(most, pel_max(sum - 4 * c[i], 4 * c[i] - sum - 1));
    return most;
}

uint8_t pel_texels_contrast(const struct pel_texels *texels)
{
    static const struct pel_texture_map none = {{0, 0, 0}, {0, 0, 0}};
    struct pel_texture p;
    int32_t most = 0;
    if (pel_texture_set(&p, texels, &none) != PEL_OK)
        return 0;
    for (int32_t v = 0; v < p.height; v++)
        for (int32_t u = 0; u < p.width; u++) {
            const int32_t right = u + 1 < p.width ? u + 1 : 0;
            const int32_t below = v + 1 < p.height ? v + 1 : 0;
            const pel_color t[4] = {pel_texel(&p, p.kind, u, v),
                                    pel_texel(&p, p.kind, right, v),
                                    pel_texel(&p, p.kind, u, below),
                                    pel_texel(&p, p.kind, right, below)};
            if (((t[0] ^ t[1]) | (t[0] ^ t[2])) >> 24)
                return 0;
            for (int k = 0; k < 24; k += 8)
                most = pel_max(most, quarters_of(t, k));
        }
    return (uint8_t)(((most + 2) >> 2) + 1);
}
