/* Pel. Compiled once for each compiler together with a core of its own:
 * METHOD is the name of the object, METHOD_BUILD that of the build. */
#include "method.h"

#include <stdlib.h>

#include "core/pel.h"

enum { RAMP = 256 };

struct item {
    struct pel_point v[SHAPE_VERTICES];
    pel_color color[3];
    struct pel_texel_point texel[3];
};

struct job {
    struct pel_surface surface;
    struct item *item;
    int32_t radius; /* 1/256 px */
    void (*draw)(const struct job *job, const struct item *item, int n);
    void *scratch; /* of polygons */
    size_t scratch_size;
    const struct pel_paint *paint; /* of the whole canvas */
    struct pel_radial radial;
    struct pel_conic conic;
    pel_color ramp_color[RAMP];
    struct pel_surface texture;
};

static void draw_triangles(const struct job *job, const struct item *item,
                           int n)
{
    for (; n > 0; n--, item++) {
        const struct pel_flat flat = PEL_FLAT(item->color[0]);
        pel_triangle(&job->surface, item->v, &flat.paint);
    }
}

static void draw_gouraud(const struct job *job, const struct item *item, int n)
{
    for (; n > 0; n--, item++)
        pel_triangle_gouraud(&job->surface, item->v, item->color);
}

static void draw_circles(const struct job *job, const struct item *item, int n)
{
    for (; n > 0; n--, item++) {
        const struct pel_flat flat = PEL_FLAT(item->color[0]);
        pel_circle(&job->surface, item->v[0], job->radius, &flat.paint);
    }
}

static void draw_polygons(const struct job *job, const struct item *item, int n)
{
    for (; n > 0; n--, item++) {
        const struct pel_flat flat = PEL_FLAT(item->color[0]);
        const struct pel_polygon_shape outline = {item->v, SHAPE_VERTICES,
                                                  PEL_EVEN_ODD};
        pel_polygon(&job->surface, &outline, &flat.paint, job->scratch,
                    job->scratch_size);
    }
}

static void draw_lines(const struct job *job, const struct item *item, int n)
{
    for (; n > 0; n--, item++) {
        const struct pel_flat flat = PEL_FLAT(item->color[0]);
        pel_line(&job->surface, item->v[0], item->v[1], &flat.paint);
    }
}

static void draw_screen(const struct job *job, const struct item *item, int n)
{
    for (; n > 0; n--, item++)
        pel_rectangle(&job->surface, item->v[0], item->v[1], job->paint);
}

/* A paint for every triangle, as for a mesh. */
static void draw_textured(const struct job *job, const struct item *item, int n,
                          enum pel_status init(struct pel_texture *,
                                               const struct pel_texels *,
                                               const struct pel_texture_map *))
{
    const struct pel_texels texels = {&job->texture, NULL, 0, 0, true};
    struct pel_texture_map map;
    struct pel_texture paint;
    for (; n > 0; n--, item++) {
        pel_texture_map_triangle(&map, item->v, item->texel);
        init(&paint, &texels, &map);
        pel_triangle(&job->surface, item->v, &paint.base.paint);
    }
}

static void draw_nearest(const struct job *job, const struct item *item, int n)
{
    draw_textured(job, item, n, pel_texture_init_nearest);
}

static void draw_bilinear(const struct job *job, const struct item *item, int n)
{
    draw_textured(job, item, n, pel_texture_init_bilinear);
}

static void (*draw_of(const struct workload *w))(const struct job *,
                                                 const struct item *, int)
{
    switch (w->form) {
    case FORM_CIRCLE:
        return draw_circles;
    case FORM_POLYGON:
        return draw_polygons;
    case FORM_LINE:
        return draw_lines;
    case FORM_SCREEN:
        return draw_screen;
    case FORM_TRIANGLE:
    case FORM_SLIVER:
        break;
    }
    if (w->paint == PAINT_NEAREST)
        return draw_nearest;
    if (w->paint == PAINT_BILINEAR)
        return draw_bilinear;
    return w->paint == PAINT_GOURAUD ? draw_gouraud : draw_triangles;
}

/* Circles and lines are about pixel centres, the others about corners. */
static struct item item_of(const struct workload *w, const struct shape *s)
{
    struct item item;
    const int32_t half =
        w->form == FORM_CIRCLE || w->form == FORM_LINE ? 128 : 0;
    const uint32_t alpha = w->paint == PAINT_ALPHA ? WORKLOAD_ALPHA : 255;
    for (int k = 0; k < SHAPE_VERTICES; k++) {
        item.v[k].x = PEL_PX(s->x[k]) + half;
        item.v[k].y = PEL_PX(s->y[k]) + half;
    }
    for (int k = 0; k < 3; k++) {
        item.color[k] = s->color[k] | alpha << 24;
        item.texel[k].u = (int32_t)(s->u[k] * 256);
        item.texel[k].v = (int32_t)(s->v[k] * 256);
    }
    return item;
}

static void set_gradient(struct job *job, const struct workload *w)
{
    const pel_color *color = job->item[0].color;
    const struct pel_stop stops[3] = {
        {0, color[0]}, {32768, color[2]}, {65536, color[1]}};
    const bool mixed = w->paint == PAINT_RADIAL || w->paint == PAINT_CONIC;
    const struct pel_ramp ramp = {mixed ? color : job->ramp_color,
                                  mixed ? 2 : RAMP, PEL_PAD};
    const struct pel_rings rings = {
        {PEL_PX(w->width) / 2, PEL_PX(w->height) / 2}, PEL_PX(w->width) / 2, 0};
    if (!mixed)
        pel_ramp_fill(job->ramp_color, RAMP, stops, 3);
    if (w->paint == PAINT_RADIAL || w->paint == PAINT_RADIAL_STOPS)
        pel_radial_init(&job->radial, &rings, &ramp);
    else
        pel_conic_init(&job->conic, rings.center, 0, &ramp);
    job->paint = w->paint == PAINT_RADIAL || w->paint == PAINT_RADIAL_STOPS
                     ? &job->radial.base.paint
                     : &job->conic.base.paint;
}

/* In the canvas's own format. */
static void set_texture(struct job *job)
{
    const struct pel_format *format = job->surface.format;
    const uint32_t *texel = workload_texture();
    void *memory = method_allocate(TEXTURE_SIDE, TEXTURE_SIDE * 4);
    pel_surface_init(&job->texture, format, memory,
                     (size_t)TEXTURE_SIDE * TEXTURE_SIDE * 4,
                     &(struct pel_rect){0, 0, TEXTURE_SIDE, TEXTURE_SIDE});
    for (int y = 0; y < TEXTURE_SIDE; y++)
        format->put(&job->texture, 0, y, TEXTURE_SIDE,
                    texel + y * TEXTURE_SIDE);
}

static void *open_job(const struct workload *w, const struct canvas *c)
{
    struct job *job = method_allocate(1, sizeof *job);
    const struct pel_format *format =
        c->bits == 32 ? &pel_xrgb8888 : &pel_rgb565_le;
    if (pel_surface_init(&job->surface, format, c->pixels, canvas_bytes(c),
                         &(struct pel_rect){0, 0, c->width, c->height}))
        method_fail("Pel refuses the canvas", "check its size and alignment");
    job->item = method_allocate(w->count, sizeof *job->item);
    for (int i = 0; i < w->count; i++)
        job->item[i] = item_of(w, &w->shape[i]);
    set_gradient(job, w);
    set_texture(job);
    job->radius = PEL_PX(w->size);
    job->draw = draw_of(w);
    job->scratch_size = pel_polygon_scratch_size(SHAPE_VERTICES);
    job->scratch = method_allocate(1, job->scratch_size);
    return job;
}

static void draw(void *data, int first, int n)
{
    const struct job *job = data;
    job->draw(job, job->item + first, n);
}

static void close_job(void *data)
{
    struct job *job = data;
    free(job->texture.pixels);
    free(job->item);
    free(job->scratch);
    free(job);
}

extern const struct method METHOD;
const struct method METHOD = {"pel", METHOD_BUILD, open_job, draw, close_job};
