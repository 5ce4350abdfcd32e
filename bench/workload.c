#define _DEFAULT_SOURCE
#include "workload.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define BIG 1200, 1200, 32
#define PANEL 320, 240, 16
#define CACHED 128, 128, 32 /* 64 KB, which stay in a second-level cache */

#define LARGE BIG, 1198, 80000, 120000, 40, 0
#define MEDIUM BIG, 80, 800, 1200, 2000, 0
#define SMALL BIG, 8, 6, 14, 20000, 0
#define CACHED_MEDIUM CACHED, 80, 800, 1200, 2000, 0
#define PANEL_LARGE PANEL, 238, 8000, 12000, 400, 0
#define PANEL_MEDIUM PANEL, 80, 800, 1200, 2000, 0
#define PANEL_SMALL PANEL, 8, 6, 14, 20000, 0

/* Triangles of three sizes on either canvas, medium ones in the cache. */
#define TRIANGLES(name, paint)                                       \
    {name "-large", FORM_TRIANGLE, paint, LARGE},                    \
        {name "-medium", FORM_TRIANGLE, paint, MEDIUM},              \
        {name "-small", FORM_TRIANGLE, paint, SMALL},                \
        {"565-" name "-large", FORM_TRIANGLE, paint, PANEL_LARGE},   \
        {"565-" name "-medium", FORM_TRIANGLE, paint, PANEL_MEDIUM}, \
        {"l2-" name "-medium", FORM_TRIANGLE, paint, CACHED_MEDIUM}, \
    {                                                                \
        "565-" name "-small", FORM_TRIANGLE, paint, PANEL_SMALL      \
    }

/* `count` shapes on either canvas. */
#define BOTH(name, form, paint, size, count)                  \
    {name, form, paint, BIG, size, 0, 0, count, 0},           \
    {                                                         \
        "565-" name, form, paint, PANEL, size, 0, 0, count, 0 \
    }

const struct workload workloads[] = {
    TRIANGLES("flat", PAINT_FLAT),
    TRIANGLES("alpha", PAINT_ALPHA),
    TRIANGLES("gouraud", PAINT_GOURAUD),
    TRIANGLES("nearest", PAINT_NEAREST),
    TRIANGLES("bilinear", PAINT_BILINEAR),
    {"sliver", FORM_SLIVER, PAINT_FLAT, BIG, 1000, 0, 0, 400, 0},
    BOTH("circle-5", FORM_CIRCLE, PAINT_FLAT, 5, 20000),
    BOTH("circle-50", FORM_CIRCLE, PAINT_FLAT, 50, 2000),
    {"circle-500", FORM_CIRCLE, PAINT_FLAT, BIG, 500, 0, 0, 40, 0},
    BOTH("polygon-8", FORM_POLYGON, PAINT_FLAT, 80, 2000),
    {"565-circle-110", FORM_CIRCLE, PAINT_FLAT, PANEL, 110, 0, 0, 400, 0},
    BOTH("line", FORM_LINE, PAINT_FLAT, 80, 4000),
    BOTH("line-30", FORM_LINE, PAINT_FLAT, 30, 8000),
    BOTH("line-200", FORM_LINE, PAINT_FLAT, 200, 2000),
    BOTH("clear", FORM_SCREEN, PAINT_FLAT, 0, 1),
    BOTH("box-10", FORM_BOX, PAINT_FLAT, 10, 20000),
    BOTH("box-100", FORM_BOX, PAINT_FLAT, 100, 1000),
    BOTH("rounded", FORM_ROUNDED, PAINT_FLAT, 60, 1000),
    BOTH("linear-vertical", FORM_SCREEN, PAINT_VERTICAL, 0, 1),
    BOTH("linear-horizontal", FORM_SCREEN, PAINT_HORIZONTAL, 0, 1),
    BOTH("linear-sloped", FORM_SCREEN, PAINT_SLOPED, 0, 1),
    BOTH("radial", FORM_SCREEN, PAINT_RADIAL, 0, 1),
    BOTH("radial-stops", FORM_SCREEN, PAINT_RADIAL_STOPS, 0, 1),
    BOTH("conic", FORM_SCREEN, PAINT_CONIC, 0, 1),
    BOTH("conic-stops", FORM_SCREEN, PAINT_CONIC_STOPS, 0, 1),
    BOTH("fan", FORM_SCREEN, PAINT_FAN, 0, 1),
    {"565-dithered", FORM_SCREEN, PAINT_DITHERED, PANEL, 0, 0, 0, 1, 0},
    {"565-dithered-big", FORM_SCREEN, PAINT_DITHERED, 1200, 1200, 16, 0, 0, 0,
     1, 0},
    BOTH("copy", FORM_COPY, PAINT_COPY, 0, 1000),
    {"565-copy-convert", FORM_COPY, PAINT_CONVERT, PANEL, 0, 0, 0, 1000, 0},
    BOTH("copy-keyed", FORM_COPY, PAINT_KEYED, 0, 1000),
    BOTH("copy-alpha", FORM_COPY, PAINT_COPY_ALPHA, 0, 1000),
    BOTH("text", FORM_TEXT, PAINT_FLAT, 0, 1000),
    BOTH("smooth-circle-50", FORM_CIRCLE, PAINT_SMOOTH, 50, 1000),
    BOTH("smooth-needle", FORM_SLIVER, PAINT_SMOOTH, 100, 1000),
    BOTH("smooth-polygon-100", FORM_GEAR, PAINT_SMOOTH, 100, 400),
    BOTH("stroke-100", FORM_STROKE, PAINT_FLAT, 100, 400),
    BOTH("smooth-stroke-100", FORM_STROKE, PAINT_SMOOTH, 100, 400),
    BOTH("smooth-outlines-16", FORM_OUTLINES, PAINT_SMOOTH, 16, 400),
    BOTH("smooth-outlines-24", FORM_OUTLINES, PAINT_SMOOTH, 24, 400),
    BOTH("smooth-outlines-48", FORM_OUTLINES, PAINT_SMOOTH, 48, 400),
    BOTH("smooth-text-16", FORM_GLYPHS, PAINT_SMOOTH, 16, 1000),
    BOTH("smooth-text-24", FORM_GLYPHS, PAINT_SMOOTH, 24, 1000),
    BOTH("smooth-text-16-8bit", FORM_GLYPHS_8, PAINT_SMOOTH, 16, 1000),
    {"hits-100", FORM_GEAR, PAINT_HITS, BIG, HIT_SIDE / 2 * HIT_STEP, 0, 0, 200,
     0},
    {0},
};

int workload_vertices(const struct workload *w)
{
    switch (w->form) {
    case FORM_CIRCLE:
    case FORM_GEAR:
    case FORM_STROKE:
        return 1;
    case FORM_LINE:
    case FORM_SCREEN:
    case FORM_COPY:
    case FORM_TEXT:
    case FORM_OUTLINES:
    case FORM_GLYPHS:
    case FORM_GLYPHS_8:
    case FORM_BOX:
    case FORM_ROUNDED:
        return 2;
    case FORM_POLYGON:
        return SHAPE_VERTICES;
    case FORM_TRIANGLE:
    case FORM_SLIVER:
        break;
    }
    return 3;
}

static uint32_t random_color(struct random *r)
{
    return (random_next(r) & 0xBFBFBFu) + 0x404040u;
}

const uint32_t *workload_texture(void)
{
    static uint32_t texel[TEXTURE_SIDE * TEXTURE_SIDE];
    struct random r = {88172645463325252u};
    for (int i = 0; i < TEXTURE_SIDE * TEXTURE_SIDE; i++)
        texel[i] = 0xFF000000u | random_color(&r);
    return texel;
}

/* 255 inside the disc, 128 on its rim, 0 outside. */
static uint32_t sprite_alpha(int i)
{
    const int dx = 2 * (i % SPRITE_SIDE) + 1 - SPRITE_SIDE;
    const int dy = 2 * (i / SPRITE_SIDE) + 1 - SPRITE_SIDE;
    const int square = dx * dx + dy * dy;
    return square < 60 * 60 ? 255 : square < 63 * 63 ? 128 : 0;
}

const uint32_t *workload_sprite(enum paint paint)
{
    static uint32_t pixel[SPRITE_SIDE * SPRITE_SIDE];
    struct random r = {88172645463325252u};
    for (int i = 0; i < SPRITE_SIDE * SPRITE_SIDE; i++) {
        const uint32_t alpha = sprite_alpha(i);
        pixel[i] = 0xFF000000u | random_color(&r);
        if (paint == PAINT_COPY_ALPHA)
            pixel[i] = alpha << 24 | (pixel[i] & 0xFFFFFFu);
        if (paint == PAINT_KEYED && alpha == 0)
            pixel[i] = 0xFF000000u | SPRITE_KEY;
    }
    return pixel;
}

const struct offset *workload_gear(const struct workload *w)
{
    static struct offset vertex[GEAR_SIDES];
    for (int k = 0; k < GEAR_SIDES; k++) {
        const double turn = k * (2 * M_PI / GEAR_SIDES);
        const double radius = w->size * (k % 4 < 2 ? 256 : 208);
        vertex[k].x = (int)lrint(radius * cos(turn));
        vertex[k].y = (int)lrint(radius * sin(turn));
    }
    return vertex;
}

bool workload_is_line(const struct workload *w)
{
    return w->form >= FORM_OUTLINES && w->form <= FORM_GLYPHS_8;
}

/* An em has 2,048 units. In lines of whole pixels, 19 and 29, Pel's pictures
 * are a quarter of one smaller than what has 2,384 units. */
struct workload_line workload_line(const struct workload *w)
{
    struct workload_line line = {"", 384 / w->size, w->size, 0};
    if (w->form != FORM_OUTLINES)
        line.em = (w->size == 16 ? 18.75 : 28.75) / 2384 * 2048;
    line.advance = line.em * 1233 / 2048;
    if (w->form != FORM_OUTLINES)
        line.advance = rint(line.advance);
    memcpy(line.text, TEXT_LINE, (size_t)line.letters);
    return line;
}

bool workload_open(struct workload *w)
{
    void (*const make[])(const struct workload *, struct random *,
                         struct shape *) = {
        [FORM_TRIANGLE] = triangle_make, [FORM_SLIVER] = sliver_make,
        [FORM_CIRCLE] = circle_make,     [FORM_POLYGON] = polygon_make,
        [FORM_LINE] = line_make,         [FORM_SCREEN] = screen_make,
        [FORM_COPY] = copy_make,         [FORM_TEXT] = text_make,
        [FORM_BOX] = box_make,           [FORM_ROUNDED] = box_make,
        [FORM_OUTLINES] = text_make,     [FORM_GLYPHS] = text_make,
        [FORM_GLYPHS_8] = text_make,     [FORM_GEAR] = circle_make,
        [FORM_STROKE] = circle_make,
    };
    struct random r = {88172645463325252u};
    w->shape = calloc((size_t)w->count, sizeof *w->shape);
    if (!w->shape)
        return false;
    for (int i = 0; i < w->count; i++) {
        struct shape *s = &w->shape[i];
        for (int k = 0; k < 3; k++)
            s->color[k] =
                w->paint == PAINT_SMOOTH ? 0xFFFFFFu : random_color(&r);
        make[w->form](w, &r, s);
        if (w->paint == PAINT_NEAREST || w->paint == PAINT_BILINEAR)
            texture_place(&r, s);
    }
    return true;
}

void workload_close(struct workload *w)
{
    free(w->shape);
    w->shape = NULL;
}
