/* Which commands of a script draw at a pixel. Only for sim. */
#ifndef SIM_SCRIPT_PICK_H
#define SIM_SCRIPT_PICK_H

#include "sim/script/commands.h"

/* Is the pixel (x, y) within the clip in force? */
bool script_clip_holds(const struct script_pen *pen, const int pixel[2]);

/* True when the item, a command that draws, covers the pixel (x, y) whatever
 * the clip; *color is then the color that it leaves there. `pen` holds the
 * settings before the command. */
bool script_covers(const struct script_pen *pen, const struct script_item *item,
                   const int pixel[2], pel_color *color);

/* The index of the last item, seen by the script's clip, that draws pixel
 * (x, y) of its canvas: a shape, a text, a picture, a mesh; -1: none but
 * clear. -1, with a message, when memory is short. */
long script_pick(const struct script *script, int x, int y);

#endif
