#include "sim/render/painter.h"

#include <stdlib.h>

#include "core/raster/gouraud.h"
#include "sim/cli/message.h"

struct item {
    struct mesh_depth depth; /* the sum of three */
    uint32_t triangle;
};

static int compare_items(const void *left, const void *right)
{
    const struct item *a = left, *b = right;
    int order = mesh_depth_compare(&b->depth, &a->depth);
    if (order != 0)
        return order;
    return (a->triangle > b->triangle) - (a->triangle < b->triangle);
}

static void sort(const struct pel2d *flat, struct item *item, uint32_t *order)
{
    for (uint32_t i = 0; i < flat->triangles; i++) {
        const struct pel2d_vertex *v = flat->vertex;
        const uint32_t *index = flat->triangle[i];
        item[i].depth = mesh_depth_sum(&v[index[0]].depth, &v[index[1]].depth,
                                       &v[index[2]].depth);
        item[i].triangle = i;
    }
    qsort(item, flat->triangles, sizeof(*item), compare_items);
    for (uint32_t i = 0; i < flat->triangles; i++)
        order[i] = item[i].triangle;
}

bool painter_init(struct painter *painter, const struct pel2d *flat)
{
    size_t n = flat->triangles > 0 ? flat->triangles : 1;
    struct item *item = malloc(n * sizeof(*item));
    painter->flat = flat;
    painter->order = malloc(n * sizeof(*painter->order));
    bool done = item && painter->order;
    if (done)
        sort(flat, item, painter->order);
    else
        painter_free(painter);
    free(item);
    return done || message_error("no memory to sort %zu triangles", n);
}

void painter_free(struct painter *painter)
{
    free(painter->order);
    painter->order = NULL;
}

/* (sum + 1) / 3 is the nearest: a sum of three is never half-way. */
static uint32_t mean_of(uint32_t a, uint32_t b, uint32_t c)
{
    return (a + b + c + 1) / 3;
}

static pel_color mean_color(const pel_color color[3])
{
    pel_color a = color[0], b = color[1], c = color[2];
    return PEL_RGB(mean_of(pel_red(a), pel_red(b), pel_red(c)),
                   mean_of(pel_green(a), pel_green(b), pel_green(c)),
                   mean_of(pel_blue(a), pel_blue(b), pel_blue(c)));
}

static void draw_flat(const struct painter *painter,
                      const struct pel_surface *surface,
                      const struct pel_point at[3], const pel_color color[3])
{
    const struct pel_flat flat = PEL_FLAT(mean_color(color));
    if (painter->lines)
        pel_triangle_or_line(surface, at, &flat.paint);
    else
        pel_triangle(surface, at, &flat.paint);
}

void painter_draw(struct pel_surface *surface, void *context)
{
    const struct painter *painter = context;
    const struct pel2d *flat = painter->flat;
    for (uint32_t i = 0; i < flat->triangles; i++) {
        struct pel_point at[3];
        pel_color color[3];
        for (int k = 0; k < 3; k++) {
            uint32_t vertex = flat->triangle[painter->order[i]][k];
            at[k] = flat->vertex[vertex].at;
            color[k] = flat->vertex[vertex].color;
        }
        if (painter->shade == PAINTER_GOURAUD && pel_triangle_area(at) != 0)
            pel_triangle_gouraud(surface, at, color);
        else
            draw_flat(painter, surface, at, color);
    }
}
