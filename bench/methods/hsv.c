#include <pel/pel.h>

#include "color.h"

static void pel(int hue, int s, int v, int rgb[3])
{
    const pel_color c = pel_hsv_degrees(hue, (uint32_t)s, (uint32_t)v);
    rgb[0] = (int)pel_red(c);
    rgb[1] = (int)pel_green(c);
    rgb[2] = (int)pel_blue(c);
}

/* Channels from the four levels of a sixth of the hues. */
static void arrange(int sixth, const int level[4], int rgb[3])
{
    enum { P, Q, T, V };
    static const int of[6][3] = {{V, T, P}, {Q, V, P}, {P, V, T},
                                 {P, Q, V}, {T, P, V}, {V, P, Q}};
    for (int i = 0; i < 3; i++)
        rgb[i] = level[of[sixth][i]];
}

/* The 8-bit code that is copied most: a turn of 256, sixths of 43 steps. */
static void steps_43(int hue, int s, int v, int rgb[3])
{
    const int h = hue * 256 / 360, sixth = h / 43, part = (h - sixth * 43) * 6;
    const int level[4] = {(v * (255 - s)) >> 8,
                          (v * (255 - ((s * part) >> 8))) >> 8,
                          (v * (255 - ((s * (255 - part)) >> 8))) >> 8, v};
    arrange(sixth, level, rgb);
}

static void in_float(int hue, int s, int v, float half, int rgb[3])
{
    const float h = (float)hue / 60.0f, sat = (float)s / 255.0f;
    const int sixth = (int)h;
    const float part = h - (float)sixth, value = (float)v;
    const int level[4] = {(int)(value * (1 - sat) + half),
                          (int)(value * (1 - sat * part) + half),
                          (int)(value * (1 - sat * (1 - part)) + half), v};
    arrange(sixth, level, rgb);
}

static void float_truncated(int hue, int s, int v, int rgb[3])
{
    in_float(hue, s, v, 0, rgb);
}

static void float_rounded(int hue, int s, int v, int rgb[3])
{
    in_float(hue, s, v, 0.5f, rgb);
}

const struct hsv_method hsv_methods[] = {
    {"pel", pel},
    {"43 steps", steps_43},
    {"float32 truncated", float_truncated},
    {"float32 rounded", float_rounded},
    {0, 0},
};
