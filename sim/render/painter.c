#include "sim/render/painter.h"

#include <math.h>
#include <stdlib.h>

#include "core/raster/gouraud.h"
#include "sim/cli/message.h"

static int compare_items(const void *left, const void *right)
{
    const struct painter_item *a = left, *b = right;
    int order = mesh_depth_compare(&b->depth, &a->depth);
    if (order != 0)
        return order;
    return (a->triangle > b->triangle) - (a->triangle < b->triangle);
}

/* Texels by the rule in painter.h: coordinates times W - 1, not W. */
static double texels_of(const struct painter *painter,
                        const struct pel2d_vertex *v, int axis)
{
    const struct picture *picture = &painter->texture->picture;
    return axis ? v->v * (picture->height - 1) : v->u * (picture->width - 1);
}

static bool check_texture(const struct painter *painter)
{
    const struct pel2d_vertex *v = painter->flat->vertex;
    for (size_t i = 0; i < painter->flat->vertices; i++)
        for (int k = 0; k < 2; k++)
            if (!(fabs(texels_of(painter, &v[i], k)) < (1 << 23) - 1))
                return message_error(
                    "vertex %zu lies at u v %g %g: expected less "
                    "than 2^23 texels",
                    i, v[i].u, v[i].v);
    return true;
}

bool painter_init(struct painter *painter, const struct pel2d *flat)
{
    const size_t n = flat->triangles;
    const struct pel2d_vertex *v = flat->vertex;
    painter->flat = flat;
    if (painter->texture && !check_texture(painter))
        return false;
    painter->item = malloc((n + 1) * sizeof(*painter->item));
    if (!painter->item)
        return message_error("no memory to sort %zu triangles", n);
    for (uint32_t i = 0; i < n; i++) {
        const uint32_t *index = flat->triangle[i];
        painter->item[i].depth = mesh_depth_sum(
            &v[index[0]].depth, &v[index[1]].depth, &v[index[2]].depth);
        painter->item[i].triangle = i;
    }
    qsort(painter->item, n, sizeof(*painter->item), compare_items);
    return true;
}

void painter_free(struct painter *painter)
{
    free(painter->item);
    painter->item = NULL;
}

/* (sum + 1) / 3 is the nearest: a sum of three is never half-way. */
static uint32_t mean_of(uint32_t a, uint32_t b, uint32_t c)
{
    return (a + b + c + 1) / 3;
}

static void draw_flat(const struct painter *painter,
                      const struct pel_surface *surface,
                      const struct pel_point at[3], const pel_color color[3])
{
    const pel_color a = color[0], b = color[1], c = color[2];
    const struct pel_flat flat =
        PEL_FLAT(PEL_RGB(mean_of(pel_red(a), pel_red(b), pel_red(c)),
                         mean_of(pel_green(a), pel_green(b), pel_green(c)),
                         mean_of(pel_blue(a), pel_blue(b), pel_blue(c))));
    if (painter->lines)
        pel_triangle_or_line(surface, at, &flat.paint);
    else
        pel_triangle(surface, at, &flat.paint);
}

static void draw_textured(const struct painter *painter,
                          const struct pel_surface *surface,
                          const struct pel_point at[3],
                          const uint32_t vertex[3])
{
    const struct painter_texture *t = painter->texture;
    const struct pel_texels texels = {NULL, t->picture.pixels, t->picture.width,
                                      t->picture.height, t->opaque};
    struct pel_texel_point place[3];
    struct pel_texture_map map;
    struct pel_texture paint;
    for (int k = 0; k < 3; k++) {
        const struct pel2d_vertex *v = &painter->flat->vertex[vertex[k]];
        place[k].u = (int32_t)lround(texels_of(painter, v, 0) * 256);
        place[k].v = (int32_t)lround(texels_of(painter, v, 1) * 256);
    }
    pel_texture_map_triangle(&map, at, place);
    if (t->bilinear)
        pel_texture_init_bilinear(&paint, &texels, &map);
    else
        pel_texture_init_nearest(&paint, &texels, &map);
    paint.wrap_u = paint.wrap_v = (uint8_t)t->wrap;
    pel_triangle(surface, at, &paint.base.paint);
}

void painter_draw(struct pel_surface *surface, void *context)
{
    const struct painter *painter = context;
    const struct pel2d *flat = painter->flat;
    for (size_t i = 0; i < flat->triangles; i++) {
        const uint32_t *vertex = flat->triangle[painter->item[i].triangle];
        struct pel_point at[3];
        pel_color color[3];
        for (int k = 0; k < 3; k++) {
            at[k] = flat->vertex[vertex[k]].at;
            color[k] = flat->vertex[vertex[k]].color;
        }
        if (painter->texture && pel_triangle_area(at) != 0)
            draw_textured(painter, surface, at, vertex);
        else if (painter->shade == PAINTER_GOURAUD &&
                 pel_triangle_area(at) != 0)
            pel_triangle_gouraud(surface, at, color);
        else
            draw_flat(painter, surface, at, color);
    }
}
