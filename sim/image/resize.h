/* Pictures of another size. */
#ifndef SIM_IMAGE_RESIZE_H
#define SIM_IMAGE_RESIZE_H

#include "sim/image/picture.h"

/* By Lanczos' filter of three lobes, whose width is that of the pixels that are
 * farther apart: patterns that the new size cannot hold become grey. Of the
 * bytes as they are, not of light; clear pixels have no part in colours. False,
 * with a message, when memory is short. */
bool picture_resize(struct picture *picture, int width, int height);

#endif
