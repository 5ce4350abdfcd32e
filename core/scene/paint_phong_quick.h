/* Phong without roots: the light at a pixel from polynomials.
 *
 * With n the normal, linear and scaled so that n.n = 1 - d at a pixel, V and L
 * the directions to the eye and to a light, linear between the vertices where
 * they have length 1,
 *
 *     N.L = n.L (1 + d / 2 + 3/8 d^2 + 5/16 d^3)
 *     R.V = 2 (n.L) (n.V) (1 + d + d^2 + d^3 + d^4) - L.V
 *
 * are off by less than 3/8 d^4 and 2 d^5 for |d| <= 1/4: what the series of
 * (1 - d)^(-1/2), whose next term is 35/128 d^4, and of (1 - d)^-1 leave. All
 * dot products are polynomials of degree 2 of two weights, which are linear on
 * screen. */
#ifndef PEL_SCENE_PAINT_PHONG_QUICK_H
#define PEL_SCENE_PAINT_PHONG_QUICK_H

#include "../paint/paint_colors.h"
#include "../raster/plane.h"
#include "light.h"

PEL_BEGIN_DECLS

enum {
    PEL_QUICK_LIGHTS = 3, /* no more */
    PEL_QUICK_BITS = 28   /* numbers are 2^-28 */
};

/* Of weights a and b of two vertices, 2^-28: k0 + a k1 + b k2 + a^2 k3 + a b k4
 * + b^2 k5. */
struct pel_polynomial {
    int32_t k[6];
};

/* What the light at a triangle's vertices comes from. */
struct pel_lit_corners {
    int32_t normal[3][3];   /* of any length up to 2^29 */
    int32_t position[3][3]; /* lighting units */
    uint64_t length;        /* square of a length between theirs, not 0 */
};

/* The paint. Its colors are those of `surface`, or where that is NULL linear
 * ones. */
struct pel_phong_quick {
    struct pel_color_paint base;
    const struct pel_mesh_lights *lights;
    const struct pel_color_paint *surface;
    struct pel_plane weight[2];   /* of vertices 1 and 2 */
    struct pel_polynomial d, eye; /* d, n.V */
    struct {
        struct pel_polynomial of[2]; /* n.L, L.V */
    } light[PEL_QUICK_LIGHTS];
    int32_t color[3][3]; /* blue, green, red: at vertex 0, 1/256 step, and the
                            ways to the others */
    uint8_t alpha;
    uint8_t span; /* bits of the pixels between which light is linear */
    bool dull;    /* no highlights */
    bool one_color;
    bool gray; /* all lights are: one factor serves all channels */
};

pel_colors_function pel_phong_quick_colors; /* of that paint */

struct pel_frame;

/* Sets it for frame->work->triangle, all but `span` and `dull`. Up to
 * PEL_QUICK_LIGHTS lights. */
void pel_phong_quick_init(struct pel_phong_quick *paint,
                          struct pel_frame *frame,
                          const struct pel_lit_corners *corners,
                          const struct pel_color_paint *surface,
                          const pel_color color[3]);
PEL_END_DECLS
#endif
