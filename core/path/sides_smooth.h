/* Sides into the sweep of areas. */
#ifndef PEL_PATH_SIDES_SMOOTH_H
#define PEL_PATH_SIDES_SMOOTH_H

#include "sides.h"

enum pel_status pel_sides_smooth(const struct pel_surface *surface,
                                 const struct pel_outline_source *source,
                                 enum pel_fill_rule rule,
                                 const struct pel_paint *paint,
                                 const struct pel_scratch *scratch);

#endif
