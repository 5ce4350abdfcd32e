/* Pictures with an alpha channel, as sources of copies and textures. */
#ifndef PEL_FORMAT_ARGB8888_H
#define PEL_FORMAT_ARGB8888_H

#include "../base/format.h"

PEL_BEGIN_DECLS

/* 32: A 31..24, R, G, B 7..0. Loads and unpacks to colors with their alpha;
 * what is drawn into it becomes opaque, as in xrgb8888. */
extern const struct pel_format pel_argb8888;
PEL_END_DECLS
#endif
