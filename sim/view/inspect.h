/* What a graphics engineer wants to see of a script's picture. */
#ifndef SIM_VIEW_INSPECT_H
#define SIM_VIEW_INSPECT_H

#include "core/asset/font_asset.h"
#include "port/sdl/inspect.h"
#include "sim/script/script.h"

struct inspect {
    bool smooth, heat, bands, areas, magnifier, numbers, help;
    int format; /* of inspect_formats */
};

/* Pixel formats that the picture is shown in. */
struct inspect_format {
    const struct pel_format *format;
    bool dithered;
    const char *name;
};
enum { INSPECT_FORMATS = 5 };
extern const struct inspect_format inspect_formats[INSPECT_FORMATS];

/* Tints every other band of `rows` pixels; a pixel is `zoom` px high. */
void inspect_bands(const struct pel_surface *surface,
                   const struct pel_rect *picture, int rows, int zoom);

/* Lines of text on a dark box, in a corner of the surface's clip: the upper
 * left one, or the lower. */
void inspect_text(const struct pel_surface *surface,
                  const struct pel_font_asset *font, const char *text,
                  bool below);

/* Pixels around (x, y) of the picture, as pel_lens_draw shows them, and over
 * them the script's circles and the sides between its corners. */
void inspect_magnifier(const struct pel_surface *surface,
                       const struct pel_surface *picture,
                       const struct script *script, int x, int y);

#endif
