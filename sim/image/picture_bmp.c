/* BMP with a BITMAPINFOHEADER, 24 bits, rows from the bottom, each padded to
 * 4 bytes; all numbers little-endian. */
#include <stdlib.h>

#include "sim/image/picture_file.h"

enum {
    FILE_HEADER = 14,
    INFO_HEADER = 40,
    HEADERS = FILE_HEADER + INFO_HEADER
};

static void put32(unsigned char *to, uint32_t v)
{
    for (int i = 0; i < 4; i++)
        to[i] = (unsigned char)(v >> 8 * i & 255);
}

/* A picture at the limit has 32,767 x 98,304 bytes: below 2^32. */
static void write_headers(const struct picture *p, uint32_t line, FILE *file)
{
    unsigned char h[HEADERS] = {'B', 'M'};
    put32(h + 2, HEADERS + line * (uint32_t)p->height);
    put32(h + 10, HEADERS);
    put32(h + 14, INFO_HEADER);
    put32(h + 18, (uint32_t)p->width);
    put32(h + 22, (uint32_t)p->height);
    h[26] = 1;
    h[28] = 24;
    put32(h + 34, line * (uint32_t)p->height);
    fwrite(h, 1, sizeof h, file);
}

bool picture_write_bmp(const struct picture *picture, FILE *file)
{
    const uint32_t width = (uint32_t)picture->width;
    const uint32_t size = (3 * width + 3) / 4 * 4;
    unsigned char *line = calloc(size, 1);
    if (!line)
        return false;
    write_headers(picture, size, file);
    for (int y = picture->height - 1; y >= 0; y--) {
        const pel_color *row = picture_row(picture, y);
        for (uint32_t x = 0; x < width; x++) {
            line[3 * x] = (unsigned char)pel_blue(row[x]);
            line[3 * x + 1] = (unsigned char)pel_green(row[x]);
            line[3 * x + 2] = (unsigned char)pel_red(row[x]);
        }
        fwrite(line, 1, size, file);
    }
    free(line);
    return true;
}
