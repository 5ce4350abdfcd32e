/* A picture, turned and scaled around a point of its own: sprites, needles with
 * a texture, icons that pulse.
 *
 *     struct pel_turned_picture ship = {.texels = {&picture}};
 *     ship.pivot = (struct pel_texel_point){PEL_PX(8), PEL_PX(8)};
 *     ship.at = where;
 *     ship.turn = PEL_DEGREES(30);
 *     ship.scale = 2 * PEL_SCALE_ONE;
 *     pel_turned_picture_draw(&screen, &ship);
 *
 * Alpha of texels is seen: `pel import ship.png --format argb8888`, or palette4
 * and palette8 for pictures of few colors. */
#ifndef PEL_PAINT_TURNED_PICTURE_H
#define PEL_PAINT_TURNED_PICTURE_H

#include "paint_texture.h"

PEL_BEGIN_DECLS

#define PEL_SCALE_ONE INT32_C(65536) /* a texel is a pixel wide */

struct pel_turned_picture {
    struct pel_texels texels;
    struct pel_texel_point pivot; /* from the top left corner, 1/256 texel */
    struct pel_point at;          /* where the pivot is shown, 1/256 px */
    int32_t turn;                 /* turns / 65,536, clockwise on screen */
    int32_t scale;                /* 4,096 (1/16) to 2^24 (256 times) */
    bool bilinear;                /* false: the nearest texel */
};

/* Paints the pixels whose centre lies in the turned rectangle, each with the
 * texel that lies there: no pixel twice, as two triangles (raster/triangle.h).
 * The picture is turned by pel_direction(turn), exactly to 2^-15 texels. Its
 * corners are rounded to sub-pixels, so that pixels at the rim may show the
 * nearest texel of the picture.
 * PEL_ERROR_NULL, PEL_ERROR_SIZE, PEL_ERROR_FORMAT as of
 * pel_texture_init_nearest; PEL_ERROR_RANGE: scale, `at` or a corner is out of
 * range. Nothing is drawn then. */
enum pel_status pel_turned_picture_draw(
    const struct pel_surface *surface,
    const struct pel_turned_picture *picture);
PEL_END_DECLS
#endif
