/* What a graphics engineer wants to see of a picture: how often its pixels are
 * painted, where its bands are, what of it has changed, and its pixels large.
 * For the window (display_sdl.h) and for pel view; needs nothing but core. */
#ifndef PEL_PORT_SDL_INSPECT_H
#define PEL_PORT_SDL_INSPECT_H

#include <pel/pel.h>

PEL_BEGIN_DECLS

/* A format of words that count how often each pixel is painted, and are read
 * as colors: black, blue, cyan, green, yellow, red, white for 6 and more. */
extern const struct pel_format pel_heat;

/* The picture with its first pixel at (x, y) of the surface, each pixel a
 * square of zoom x zoom px, 1 to 32. */
void pel_inspect_enlarge(const struct pel_surface *surface,
                         const struct pel_surface *picture, int32_t x,
                         int32_t y, int32_t zoom);

/* Tints an area of the surface. */
void pel_inspect_tint(const struct pel_surface *surface,
                      const struct pel_rect *area);

/* A line around the pixels of an area. */
void pel_inspect_box(const struct pel_surface *surface,
                     const struct pel_rect *area, pel_color color);

/* A magnifier: the place of pixels of a picture on a surface, whose clip is
 * that place. */
enum { PEL_LENS_ZOOM = 16, PEL_LENS_PIXELS = 17 }; /* of a pixel; each way */

struct pel_lens {
    struct pel_surface surface;
    int32_t x, y;      /* px of the picture that is at */
    int32_t left, top; /* this pixel of the surface */
};

/* Draws the pixels around (x, y) of the picture, and a dot at each centre, into
 * the corner of the surface's clip that is farthest from there. */
void pel_lens_draw(struct pel_lens *lens, const struct pel_surface *surface,
                   const struct pel_surface *picture, int32_t x, int32_t y);

PEL_END_DECLS
#endif
