/* Ways to blend a channel, to turn hues into colors, and to show 8 bits in 5.
 */
#ifndef BENCH_METHODS_COLOR_H
#define BENCH_METHODS_COLOR_H

/* Source s over d with alpha a, all 0..255. */
struct blend_method {
    const char *name;
    int (*mix)(int s, int d, int a);
};

/* Red, green and blue of a hue in degrees, 0..359; s and v 0..255. */
struct hsv_method {
    const char *name;
    void (*rgb)(int hue, int s, int v, int rgb[3]);
};

/* The 5 bits of pixel (x, y) for a channel of 8, as 8 bits again. */
struct dither_method {
    const char *name;
    int (*show)(int channel, int x, int y);
};

/* Each ends with a NULL name; Pel's come first. */
extern const struct blend_method blend_methods[];
extern const struct hsv_method hsv_methods[];
extern const struct dither_method dither_methods[];

#endif
