/* What a child process reads of a texture. Only for texture*.c. */
#ifndef SIM_IMAGE_TEXTURE_SOURCE_H
#define SIM_IMAGE_TEXTURE_SOURCE_H

#include <stdio.h>

#include "sim/image/texture.h"

struct texture_source {
    const char *name;  /* of the file */
    const void *bytes; /* that it has, or NULL: it is still to be read */
    size_t size;
};

/* A child_work. Width and height, two int, and the pixels. */
bool texture_put(const void *source, FILE *out);

#endif
