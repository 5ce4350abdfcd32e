/* The loop of the copies: the visible part of an area, piece by piece. */
#ifndef PEL_IMAGE_COPY_LINES_H
#define PEL_IMAGE_COPY_LINES_H

#include "../raster/paint.h"
#include "copy.h"

/* The pixels of the destination that are copied to. false: none. */
bool pel_copy_visible(const struct pel_surface *surface,
                      const struct pel_copy_part *copy,
                      struct pel_rect *visible);

/* Copies pixels as they lie in memory, but for those of the key unless it is
 * NULL. false: the formats do not allow it; nothing is
 * done. In copy_same.c. */
bool pel_copy_same(const struct pel_surface *surface,
                   const struct pel_copy_part *copy, const pel_color *key);

/* Gives n colours of the source the alpha with which they are put. */
typedef void pel_copy_weigh(pel_color *colors, int32_t n, uint32_t option);

/* weigh NULL: the colours have it. */
void pel_copy_lines(const struct pel_surface *surface,
                    const struct pel_copy_part *copy, pel_copy_weigh *weigh,
                    uint32_t option);

#endif
