#include <stdlib.h>

#include "sim/image/picture_file.h"

bool picture_write_ppm(const struct picture *picture, FILE *file)
{
    const size_t width = (size_t)picture->width;
    unsigned char *line = malloc(3 * width);
    if (!line)
        return false;
    fprintf(file, "P6\n%d %d\n255\n", picture->width, picture->height);
    for (int y = 0; y < picture->height; y++) {
        picture_bytes(picture, y, line);
        fwrite(line, 3, width, file);
    }
    free(line);
    return true;
}
