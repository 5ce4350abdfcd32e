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
        const pel_color *row = picture_row(picture, y);
        for (size_t x = 0; x < width; x++) {
            line[3 * x] = (unsigned char)pel_red(row[x]);
            line[3 * x + 1] = (unsigned char)pel_green(row[x]);
            line[3 * x + 2] = (unsigned char)pel_blue(row[x]);
        }
        fwrite(line, 3, width, file);
    }
    free(line);
    return true;
}
