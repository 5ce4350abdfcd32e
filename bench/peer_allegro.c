/* Allegro 4: triangle(), polygon(), circlefill() and line(), with drawing_mode
 * for alpha, triangle3d() with POLYTYPE_GRGB for Gouraud, sprites, and text of
 * its own font. */
#include "method.h"

#include <stdlib.h>

#include "letters.h"

#define ALLEGRO_NO_MAGIC_MAIN
#include <allegro.h>

struct item {
    int point[2 * SHAPE_VERTICES];
    int color;
    V3D v[3];
    BITMAP *texture; /* or sprite */
};

struct job {
    BITMAP *bitmap, *texture;
    struct item *item;
    int radius;
    void (*draw)(BITMAP *bitmap, struct item *item, int n, int radius);
};

static void draw_triangles(BITMAP *bitmap, struct item *item, int n, int radius)
{
    (void)radius;
    for (; n > 0; n--, item++) {
        const int *p = item->point;
        triangle(bitmap, p[0], p[1], p[2], p[3], p[4], p[5], item->color);
    }
}

static void draw_gouraud(BITMAP *bitmap, struct item *item, int n, int radius)
{
    (void)radius;
    for (; n > 0; n--, item++)
        triangle3d(bitmap, POLYTYPE_GRGB, NULL, &item->v[0], &item->v[1],
                   &item->v[2]);
}

static void draw_textured(BITMAP *bitmap, struct item *item, int n, int radius)
{
    (void)radius;
    for (; n > 0; n--, item++)
        triangle3d(bitmap, POLYTYPE_ATEX, item->texture, &item->v[0],
                   &item->v[1], &item->v[2]);
}

static void draw_circles(BITMAP *bitmap, struct item *item, int n, int radius)
{
    for (; n > 0; n--, item++)
        circlefill(bitmap, item->point[0], item->point[1], radius, item->color);
}

static void draw_polygons(BITMAP *bitmap, struct item *item, int n, int radius)
{
    (void)radius;
    for (; n > 0; n--, item++)
        polygon(bitmap, SHAPE_VERTICES, item->point, item->color);
}

static void draw_lines(BITMAP *bitmap, struct item *item, int n, int radius)
{
    (void)radius;
    for (; n > 0; n--, item++) {
        const int *p = item->point;
        line(bitmap, p[0], p[1], p[2], p[3], item->color);
    }
}

static void draw_boxes(BITMAP *bitmap, struct item *item, int n, int radius)
{
    (void)radius;
    for (; n > 0; n--, item++) {
        const int *p = item->point;
        rectfill(bitmap, p[0], p[1], p[2] - 1, p[3] - 1, item->color);
    }
}

static void draw_copies(BITMAP *bitmap, struct item *item, int n, int radius)
{
    (void)radius;
    for (; n > 0; n--, item++)
        blit(item->texture, bitmap, 0, 0, item->point[0], item->point[1],
             SPRITE_SIDE, SPRITE_SIDE);
}

static void draw_keyed(BITMAP *bitmap, struct item *item, int n, int radius)
{
    (void)radius;
    for (; n > 0; n--, item++)
        draw_sprite(bitmap, item->texture, item->point[0], item->point[1]);
}

static void draw_alpha(BITMAP *bitmap, struct item *item, int n, int radius)
{
    (void)radius;
    for (; n > 0; n--, item++)
        draw_trans_sprite(bitmap, item->texture, item->point[0],
                          item->point[1]);
}

static void draw_text(BITMAP *bitmap, struct item *item, int n, int radius)
{
    (void)radius;
    for (; n > 0; n--, item++)
        textout_ex(bitmap, font, letters_line, item->point[0], item->point[1],
                   item->color, -1);
}

static void choose(struct job *job, const struct workload *w)
{
    if (w->form == FORM_TEXT)
        job->draw = draw_text;
    else if (w->form == FORM_COPY)
        job->draw = w->paint <= PAINT_CONVERT ? draw_copies
                    : w->paint == PAINT_KEYED ? draw_keyed
                                              : draw_alpha;
    else if (w->form == FORM_BOX || w->form == FORM_SCREEN)
        job->draw = draw_boxes;
    else if (w->form == FORM_CIRCLE)
        job->draw = draw_circles;
    else if (w->form == FORM_POLYGON)
        job->draw = draw_polygons;
    else if (w->form == FORM_LINE)
        job->draw = draw_lines;
    else if (w->paint == PAINT_NEAREST)
        job->draw = draw_textured;
    else if (w->paint == PAINT_GOURAUD)
        job->draw = draw_gouraud;
    else
        job->draw = draw_triangles;
}

static struct item item_of(const struct shape *s, int depth, BITMAP *texture)
{
    struct item item = {{0}, 0, {{0}}, texture};
    for (int k = 0; k < SHAPE_VERTICES; k++) {
        item.point[2 * k] = s->x[k];
        item.point[2 * k + 1] = s->y[k];
    }
    item.color =
        makecol_depth(depth, (int)(s->color[0] >> 16 & 255),
                      (int)(s->color[0] >> 8 & 255), (int)(s->color[0] & 255));
    for (int k = 0; k < 3; k++) {
        item.v[k].x = itofix(s->x[k]);
        item.v[k].y = itofix(s->y[k]);
        item.v[k].c = (int)s->color[k];
        item.v[k].u = ftofix(s->u[k]);
        item.v[k].v = ftofix(s->v[k]);
    }
    return item;
}

/* A bitmap whose lines lie in the canvas. */
static BITMAP *bitmap_over(const struct canvas *c)
{
    BITMAP *bitmap;
    if (install_allegro(SYSTEM_NONE, &errno, NULL))
        method_fail("Allegro does not start", "check its installation");
    set_color_depth(c->bits);
    bitmap = create_bitmap_ex(c->bits, c->width, c->height);
    if (!bitmap)
        method_fail("Allegro has no memory", "free some and start again");
    for (int y = 0; y < c->height; y++)
        bitmap->line[y] = c->pixels + (ptrdiff_t)y * c->stride;
    return bitmap;
}

/* Without alpha, so that the key is Allegro's, or with it. */
static BITMAP *picture_of(const uint32_t *color, int side, int depth,
                          bool alpha)
{
    BITMAP *picture = create_bitmap_ex(depth, side, side);
    for (int i = 0; picture && i < side * side; i++)
        putpixel(picture, i % side, i / side,
                 makeacol_depth(depth, (int)(color[i] >> 16 & 255),
                                (int)(color[i] >> 8 & 255),
                                (int)(color[i] & 255),
                                alpha ? (int)(color[i] >> 24) : 0));
    if (!picture)
        method_fail("Allegro has no memory", "free some and start again");
    return picture;
}

static BITMAP *texture_of(const struct workload *w, int depth)
{
    const bool alpha = w->paint == PAINT_COPY_ALPHA;
    if (w->form != FORM_COPY)
        return picture_of(workload_texture(), TEXTURE_SIDE, depth, false);
    return picture_of(workload_sprite(w->paint), SPRITE_SIDE,
                      alpha || w->paint == PAINT_CONVERT ? 32 : depth, alpha);
}

/* No gradients but Gouraud's, and no bilinear textures. */
static bool can_draw(const struct workload *w)
{
    return w->form != FORM_ROUNDED && w->form != FORM_STROKE &&
           w->paint != PAINT_BILINEAR && w->paint < PAINT_SMOOTH &&
           (w->form != FORM_SCREEN || w->paint == PAINT_FLAT);
}

static void *open_job(const struct workload *w, const struct canvas *c)
{
    if (!can_draw(w))
        return NULL;
    struct job *job = method_allocate(1, sizeof *job);
    job->bitmap = bitmap_over(c);
    job->texture = texture_of(w, c->bits);
    job->item = method_allocate(w->count, sizeof *job->item);
    for (int i = 0; i < w->count; i++)
        job->item[i] = item_of(&w->shape[i], c->bits, job->texture);
    job->radius = w->size;
    choose(job, w);
    if (w->form == FORM_COPY)
        set_alpha_blender();
    else
        set_trans_blender(0, 0, 0, WORKLOAD_ALPHA);
    drawing_mode(w->paint == PAINT_ALPHA ? DRAW_MODE_TRANS : DRAW_MODE_SOLID,
                 NULL, 0, 0);
    return job;
}

static void draw(void *data, int first, int n)
{
    struct job *job = data;
    job->draw(job->bitmap, job->item + first, n, job->radius);
}

static void close_job(void *data)
{
    struct job *job = data;
    destroy_bitmap(job->bitmap);
    destroy_bitmap(job->texture);
    free(job->item);
    free(job);
}

extern const struct method method_allegro;
const struct method method_allegro = {"allegro4", "packaged", open_job, draw,
                                      close_job};
