/* screen_check EXPECTED.ppm SCREEN.ppm [DAC_BITS [ANGLE]]: is the screen the
 * expected picture, byte for byte? A smaller or larger picture is expected in
 * the middle of a black screen. DAC_BITS 6: the screen's converter has 6 bits
 * and its last one is repeated, as VGA palettes do; 5: the screen widens 5 bits
 * with zeros, 565: those of rgb565. ANGLE: the picture is turned, 90, 180 or
 * 270 degrees clockwise. Status 0 equal, 1 different, 2 error. */
#include <stdio.h>
#include <stdlib.h>

struct picture {
    int width, height;
    unsigned char *rgb;
};

static int load(const char *path, struct picture *p)
{
    FILE *file = fopen(path, "rb");
    int most = 0;
    p->rgb = NULL;
    if (!file ||
        fscanf(file, "P6 %d %d %d", &p->width, &p->height, &most) != 3 ||
        most != 255 || fgetc(file) != '\n' || p->width < 1 || p->height < 1 ||
        p->width > 32767 || p->height > 32767)
        return -1;
    size_t size = (size_t)p->width * (size_t)p->height * 3;
    p->rgb = malloc(size);
    if (!p->rgb || fread(p->rgb, 1, size, file) != size)
        return -1;
    return fclose(file);
}

/* A quarter clockwise. */
static int turn(struct picture *p)
{
    const int width = p->width, height = p->height;
    unsigned char *rgb = malloc((size_t)width * (size_t)height * 3);
    unsigned char *to = rgb;
    if (!rgb)
        return -1;
    for (int y = 0; y < width; y++)
        for (int x = 0; x < height; x++) {
            const unsigned char *from =
                p->rgb +
                ((size_t)(height - 1 - x) * (size_t)width + (size_t)y) * 3;
            for (int c = 0; c < 3; c++)
                *to++ = *from++;
        }
    free(p->rgb);
    *p = (struct picture){height, width, rgb};
    return 0;
}

static int converted(int c, int dac_bits, int channel)
{
    if (dac_bits == 565)
        return channel == 1 ? c >> 2 << 2 : c >> 3 << 3;
    if (dac_bits == 5)
        return c >> 3 << 3;
    return dac_bits == 6 ? c >> 2 << 2 | (c >> 2 & 1) * 3 : c;
}

static int expected_at(const struct picture *p, const struct picture *screen,
                       int x, int y, int channel)
{
    int px = x - (screen->width - p->width) / 2;
    int py = y - (screen->height - p->height) / 2;
    if (px < 0 || px >= p->width || py < 0 || py >= p->height)
        return 0;
    return p->rgb[((size_t)py * (size_t)p->width + (size_t)px) * 3 +
                  (size_t)channel];
}

static int compare(const struct picture *p, const struct picture *screen,
                   int dac_bits)
{
    const unsigned char *got = screen->rgb;
    long different = 0;
    for (int y = 0; y < screen->height; y++)
        for (int x = 0; x < screen->width; x++)
            for (int c = 0; c < 3; c++, got++) {
                int want =
                    converted(expected_at(p, screen, x, y, c), dac_bits, c);
                if (*got == want)
                    continue;
                if (different++ == 0)
                    printf("first difference at %d,%d channel %d: expected %d, "
                           "got %d; ",
                           x, y, c, want, *got);
            }
    if (different)
        printf("%ld bytes differ\n", different);
    return different != 0;
}

int main(int argc, char **argv)
{
    struct picture expected, screen;
    if (argc < 3 || load(argv[1], &expected) || load(argv[2], &screen)) {
        printf("screen_check: %s or %s is missing or no picture\n",
               argc > 1 ? argv[1] : "EXPECTED", argc > 2 ? argv[2] : "SCREEN");
        return 2;
    }
    for (int angle = argc > 4 ? atoi(argv[4]) : 0; angle > 0; angle -= 90)
        if (turn(&expected))
            return 2;
    return compare(&expected, &screen, argc > 3 ? atoi(argv[3]) : 8);
}
