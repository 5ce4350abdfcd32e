#include "workload.h"

#include <stdlib.h>

#define BIG 1200, 1200, 32
#define PANEL 320, 240, 16

const struct workload workloads[] = {
    {"flat-large", FORM_TRIANGLE, PAINT_FLAT, BIG, 1198, 80000, 120000, 40, 0},
    {"flat-medium", FORM_TRIANGLE, PAINT_FLAT, BIG, 80, 800, 1200, 2000, 0},
    {"flat-small", FORM_TRIANGLE, PAINT_FLAT, BIG, 8, 6, 14, 20000, 0},
    {"sliver", FORM_SLIVER, PAINT_FLAT, BIG, 1000, 0, 0, 400, 0},
    {"gouraud-large", FORM_TRIANGLE, PAINT_GOURAUD, BIG, 1198, 80000, 120000,
     40, 0},
    {"gouraud-medium", FORM_TRIANGLE, PAINT_GOURAUD, BIG, 80, 800, 1200, 2000,
     0},
    {"gouraud-small", FORM_TRIANGLE, PAINT_GOURAUD, BIG, 8, 6, 14, 20000, 0},
    {"alpha-large", FORM_TRIANGLE, PAINT_ALPHA, BIG, 1198, 80000, 120000, 40,
     0},
    {"alpha-medium", FORM_TRIANGLE, PAINT_ALPHA, BIG, 80, 800, 1200, 2000, 0},
    {"circle-5", FORM_CIRCLE, PAINT_FLAT, BIG, 5, 0, 0, 20000, 0},
    {"circle-50", FORM_CIRCLE, PAINT_FLAT, BIG, 50, 0, 0, 2000, 0},
    {"circle-500", FORM_CIRCLE, PAINT_FLAT, BIG, 500, 0, 0, 40, 0},
    {"polygon-8", FORM_POLYGON, PAINT_FLAT, BIG, 80, 0, 0, 2000, 0},
    {"line", FORM_LINE, PAINT_FLAT, BIG, 80, 0, 0, 4000, 0},
    {"radial", FORM_SCREEN, PAINT_RADIAL, BIG, 0, 0, 0, 1, 0},
    {"radial-stops", FORM_SCREEN, PAINT_RADIAL_STOPS, BIG, 0, 0, 0, 1, 0},
    {"conic", FORM_SCREEN, PAINT_CONIC, BIG, 0, 0, 0, 1, 0},
    {"conic-stops", FORM_SCREEN, PAINT_CONIC_STOPS, BIG, 0, 0, 0, 1, 0},
    {"texture-nearest", FORM_TRIANGLE, PAINT_NEAREST, BIG, 80, 800, 1200, 2000,
     0},
    {"texture-bilinear", FORM_TRIANGLE, PAINT_BILINEAR, BIG, 80, 800, 1200,
     2000, 0},
    {"565-flat-large", FORM_TRIANGLE, PAINT_FLAT, PANEL, 238, 8000, 12000, 400,
     0},
    {"565-flat-medium", FORM_TRIANGLE, PAINT_FLAT, PANEL, 80, 800, 1200, 2000,
     0},
    {"565-gouraud-medium", FORM_TRIANGLE, PAINT_GOURAUD, PANEL, 80, 800, 1200,
     2000, 0},
    {"565-alpha-medium", FORM_TRIANGLE, PAINT_ALPHA, PANEL, 80, 800, 1200, 2000,
     0},
    {"565-texture", FORM_TRIANGLE, PAINT_NEAREST, PANEL, 80, 800, 1200, 2000,
     0},
    {"565-radial", FORM_SCREEN, PAINT_RADIAL, PANEL, 0, 0, 0, 1, 0},
    {"565-conic", FORM_SCREEN, PAINT_CONIC, PANEL, 0, 0, 0, 1, 0},
    {0},
};

int workload_vertices(const struct workload *w)
{
    switch (w->form) {
    case FORM_CIRCLE:
        return 1;
    case FORM_LINE:
    case FORM_SCREEN:
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

bool workload_open(struct workload *w)
{
    void (*const make[])(const struct workload *, struct random *,
                         struct shape *) = {
        [FORM_TRIANGLE] = triangle_make, [FORM_SLIVER] = sliver_make,
        [FORM_CIRCLE] = circle_make,     [FORM_POLYGON] = polygon_make,
        [FORM_LINE] = line_make,         [FORM_SCREEN] = screen_make,
    };
    struct random r = {88172645463325252u};
    w->shape = calloc((size_t)w->count, sizeof *w->shape);
    if (!w->shape)
        return false;
    for (int i = 0; i < w->count; i++) {
        struct shape *s = &w->shape[i];
        for (int k = 0; k < 3; k++)
            s->color[k] = random_color(&r);
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
