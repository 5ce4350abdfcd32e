/* Workloads: what every method has to draw: vertices on whole pixels, uniform
 * in a square box at a random place, kept when the area is in the range. */
#ifndef BENCH_WORKLOAD_H
#define BENCH_WORKLOAD_H

#include <stdbool.h>
#include <stdint.h>

#include "random.h"

enum { SHAPE_VERTICES = 8 };

enum form {
    FORM_TRIANGLE,
    FORM_SLIVER,
    FORM_CIRCLE,
    FORM_POLYGON,
    FORM_LINE,
    FORM_SCREEN,   /* the whole canvas */
    FORM_COPY,     /* of the sprite, to a random place */
    FORM_TEXT,     /* a line of letters there */
    FORM_OUTLINES, /* letters with an em of `size` px, each filled */
    FORM_GLYPHS, /* nearly the same from pictures, of 4 bits a pixel in Pel, */
    FORM_GLYPHS_8, /* of 8 bits */
    FORM_BOX,      /* a rectangle of whole pixels, size x size */
    FORM_ROUNDED,  /* the same, 5/3 as wide, its corners round */
    FORM_GEAR,     /* an outline of GEAR_SIDES sides around a pixel's centre */
    FORM_STROKE    /* a line along it, STROKE_WIDTH px wide, with round joins */
};

/* Linear gradients run from corner (0, 0) of the canvas to the shape's vertex
 * 2, the others are about its centre, to half its width; two colors, and the
 * _STOPS have a third in the middle. PAINT_DITHERED is the sloped one. A fan
 * has its hub in the centre. Textures show TEXTURE_SIDE^2 texels at unit scale,
 * turned; large triangles repeat them. Copies have no colors but those of the
 * sprite, which PAINT_CONVERT has as XRGB8888, whatever the canvas. */
enum paint {
    PAINT_FLAT,
    PAINT_ALPHA,
    PAINT_GOURAUD,
    PAINT_VERTICAL,
    PAINT_HORIZONTAL,
    PAINT_SLOPED,
    PAINT_DITHERED,
    PAINT_RADIAL,
    PAINT_RADIAL_STOPS,
    PAINT_CONIC,
    PAINT_CONIC_STOPS,
    PAINT_FAN,
    PAINT_NEAREST,
    PAINT_BILINEAR,
    PAINT_COPY,
    PAINT_CONVERT,
    PAINT_KEYED,
    PAINT_COPY_ALPHA,
    PAINT_SMOOTH, /* flat, white, and smooth at the edges */
    PAINT_HITS    /* of HIT_SIDE^2 pixels those that a hit test finds inside */
};

/* Radius of the corners of FORM_ROUNDED, px. */
enum { ROUNDED_RADIUS = 12 };

enum { GEAR_SIDES = 100, STROKE_WIDTH = 3 };
/* Pixels of a hit test, in a square grid over the shape's box. */
enum { HIT_SIDE = 20, HIT_STEP = 10 };
/* Base of the slivers: thin triangles, or smooth needles. */
enum { SLIVER_BASE = 1, NEEDLE_BASE = 5 };

/* Alpha of PAINT_ALPHA, of 255. */
enum { WORKLOAD_ALPHA = 128 };

/* px. A circle's centre is the centre of pixel (x[0], y[0]), a line runs
 * between two pixels; the vertices of the others are corners of pixels, of what
 * has two the first and the last. */
struct shape {
    int x[SHAPE_VERTICES], y[SHAPE_VERTICES];
    uint32_t color[3]; /* 0xRRGGBB; flat paints need the first alone. Every
                          channel is 64 or more: drawing on black changes a
                          pixel. */
    double u[3], v[3]; /* texels, inside the texture; of the first vertices */
};

struct workload {
    const char *name;
    enum form form;
    enum paint paint;
    int width, height; /* of the canvas, px */
    int bits;          /* of a pixel: 32 is XRGB8888, 16 is RGB565 */
    int size;          /* box, radius or length, px */
    int area_min, area_max;
    int count;           /* shapes in a pass */
    struct shape *shape; /* `count` of them, owned by the workload */
};

/* The table of workloads, without shapes; ends with a NULL name. */
extern const struct workload workloads[];

int workload_vertices(const struct workload *w);

/* Allocates and makes the shapes; false when memory is short. */
bool workload_open(struct workload *w);
void workload_close(struct workload *w);

enum { TEXTURE_SIDE = 256 };

/* 0xFFRRGGBB, line by line, of random colors as shapes have them. */
const uint32_t *workload_texture(void);

enum { SPRITE_SIDE = 64, SPRITE_KEY = 0xFF00FF };

/* 0xAARRGGBB, line by line, of random colors: a square; with PAINT_KEYED a
 * disc in a square of the key; with PAINT_COPY_ALPHA one with a soft rim in
 * nothing. It stays until the next call. */
const uint32_t *workload_sprite(enum paint paint);

/* GEAR_SIDES vertices of a FORM_GEAR or FORM_STROKE, in 1/256 px from its
 * centre, which is that of pixel (x[0], y[0]). They stay until the next call.
 */
struct offset {
    int x, y;
};
const struct offset *workload_gear(const struct workload *w);

/* Letters of a line of text, and the size of each, px. */
enum { TEXT_LETTERS = 24, LETTER_SIDE = 8 };

/* The first letters of TEXT_LINE are what FORM_OUTLINES to FORM_GLYPHS_8 write,
 * unhinted, of a font whose letters are equally wide, on a baseline `size` px
 * below the shape's first corner. */
#define TEXT_LINE "Hamburgefonstiv 12.5 kHz"
#define TEXT_FAMILY "DejaVu Sans Mono"
#define TEXT_FONT "/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf"

struct workload_line {
    char text[sizeof TEXT_LINE];
    int letters;
    double em;      /* px */
    double advance; /* px from letter to letter */
};
bool workload_is_line(const struct workload *w);
struct workload_line workload_line(const struct workload *w);

/* A random turn of the texture about its middle, where vertex 0 lies. */
void texture_place(struct random *r, struct shape *s);

/* One shape each: workload_*.c. */
void triangle_make(const struct workload *w, struct random *r, struct shape *s);
void sliver_make(const struct workload *w, struct random *r, struct shape *s);
void circle_make(const struct workload *w, struct random *r, struct shape *s);
void polygon_make(const struct workload *w, struct random *r, struct shape *s);
void line_make(const struct workload *w, struct random *r, struct shape *s);
void screen_make(const struct workload *w, struct random *r, struct shape *s);
void copy_make(const struct workload *w, struct random *r, struct shape *s);
void text_make(const struct workload *w, struct random *r, struct shape *s);
void box_make(const struct workload *w, struct random *r, struct shape *s);

#endif
