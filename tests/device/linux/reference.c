/* reference WIDTH HEIGHT RED GREEN BLUE [X Y ZOOM]: the picture of
 * reference.pel as a screen with so many bits a channel shows it, as PPM on
 * standard output. With X, Y and ZOOM: the part from there on, in grey, every
 * pixel a square of ZOOM. Pel's code has no part in it: every pixel asks every
 * shape. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

enum { TRIANGLES = 6 };

struct triangle {
    int64_t v[6]; /* x, y: whole px */
    unsigned color;
};

static const struct triangle triangles[TRIANGLES] = {
    {{20, 20, 300, 60, 120, 400}, 0xff8040},
    {{300, 60, 120, 400, 500, 460}, 0x2040c0},
    {{300, 60, 500, 460, 630, 10}, 0x10a060},
    {{-200, 300, 90, 250, 40, 700}, 0xe0e020},
    {{600, 470, 639, 470, 639, 200}, 0xff00ff},
    {{400, 5, 401, 470, 402, 5}, 0xffffff}};

/* Is the point, in 1/512 px, right of the edge a -> b, or on it where the edge
 * is a top or a left one? Clockwise triangles. */
static int inside_edge(const int64_t *a, const int64_t *b, int64_t x, int64_t y)
{
    int64_t dx = (b[0] - a[0]) * 512, dy = (b[1] - a[1]) * 512;
    int64_t side = dx * (y - a[1] * 512) - dy * (x - a[0] * 512);
    return side > 0 || (side == 0 && (dy < 0 || (dy == 0 && dx > 0)));
}

static int inside(const struct triangle *t, int64_t x, int64_t y)
{
    const int64_t *a = t->v, *b = t->v + 2, *c = t->v + 4;
    if ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) < 0) {
        b = t->v + 4;
        c = t->v + 2;
    }
    return inside_edge(a, b, x, y) && inside_edge(b, c, x, y) &&
           inside_edge(c, a, x, y);
}

static int in_circle(int64_t x, int64_t y, int64_t cx, int64_t cy, int64_t r)
{
    int64_t dx = x - cx * 512, dy = y - cy * 512;
    return dx * dx + dy * dy <= r * r * 512 * 512;
}

static unsigned color_at(int px, int py)
{
    int64_t x = px * 512 + 256, y = py * 512 + 256;
    unsigned color = 0x203040;
    for (int i = 0; i < TRIANGLES; i++)
        if (inside(&triangles[i], x, y))
            color = triangles[i].color;
    if (in_circle(x, y, 320, 240, 77))
        color = 0xc81e3c;
    if (in_circle(x, y, 0, 0, 40))
        color = 0x00ffff;
    if (px >= 200 && px < 260 && py >= 330 && py < 1000)
        color = 0x7f7f80;
    return color;
}

/* The upper n bits, repeated downwards. */
static int shown(unsigned c, int n)
{
    unsigned kept = c >> (8 - n), out = 0;
    for (int have = 0; have < 8; have += n)
        out |= have + n <= 8 ? kept << (8 - n - have) : kept >> (have + n - 8);
    return (int)(out & 255);
}

/* By the weights of ITU-R BT.601. */
static unsigned gray(unsigned c)
{
    return (299 * (c >> 16) + 587 * (c >> 8 & 255) + 114 * (c & 255) + 500) /
           1000 * 0x010101;
}

int main(int argc, char **argv)
{
    if (argc != 6 && argc != 9) {
        fprintf(stderr, "reference WIDTH HEIGHT RED GREEN BLUE [X Y ZOOM]\n");
        return 2;
    }
    const int part = argc == 9;
    int left = part ? atoi(argv[6]) : 0, top = part ? atoi(argv[7]) : 0;
    int zoom = part ? atoi(argv[8]) : 1;
    int width = atoi(argv[1]) * zoom, height = atoi(argv[2]) * zoom;
    printf("P6\n%d %d\n255\n", width, height);
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            unsigned c = color_at(left + x / zoom, top + y / zoom);
            c = part ? gray(c) : c;
            putchar(shown(c >> 16 & 255, atoi(argv[3])));
            putchar(shown(c >> 8 & 255, atoi(argv[4])));
            putchar(shown(c & 255, atoi(argv[5])));
        }
    return 0;
}
