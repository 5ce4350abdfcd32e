/* gd: an image of 32-bit pixels whose rows lie in the canvas. It has no RGB565;
 * and alpha is left out, since gd keeps its own in the byte that XRGB8888 does
 * not use, where others write what they like. */
#include "method.h"

#include <stdlib.h>

#include <gd.h>

#include "letters.h"

struct item {
    gdPoint point[SHAPE_VERTICES];
    int color;
};

struct job {
    const struct workload *workload;
    gdImagePtr image, sprite;
    int **own, **row; /* rows that gd allocated, rows of the canvas */
    struct item *item;
    char glyph[LETTER_SIDE * LETTER_SIDE]; /* a pixel a byte */
    gdFont font;
};

static void open_sprite(struct job *job, enum paint paint)
{
    const uint32_t *from = workload_sprite(paint);
    job->sprite = gdImageCreateTrueColor(SPRITE_SIDE, SPRITE_SIDE);
    if (!job->sprite)
        method_fail("gd makes no image", "check its installation");
    for (int i = 0; i < SPRITE_SIDE * SPRITE_SIDE; i++)
        job->sprite->tpixels[i / SPRITE_SIDE][i % SPRITE_SIDE] =
            (int)(from[i] & 0xFFFFFFu);
    if (paint == PAINT_KEYED)
        gdImageColorTransparent(job->sprite, SPRITE_KEY);
}

static void open_image(struct job *job, const struct canvas *c)
{
    job->image = gdImageCreateTrueColor(c->width, c->height);
    if (!job->image)
        method_fail("gd makes no image", "check its installation");
    job->own = job->image->tpixels;
    job->row = method_allocate(c->height, sizeof *job->row);
    for (int y = 0; y < c->height; y++)
        job->row[y] = (int *)(void *)canvas_address(c, 0, y);
    job->image->tpixels = job->row;
    gdImageAlphaBlending(job->image, gdEffectReplace);
}

static void open_font(struct job *job)
{
    for (int i = 0; i < LETTER_SIDE * LETTER_SIDE; i++)
        job->glyph[i] = letters_bits[i / 8] >> (7 - i % 8) & 1;
    job->font =
        (gdFont){1, letters_line[0], LETTER_SIDE, LETTER_SIDE, job->glyph};
}

static struct item item_of(const struct shape *s)
{
    struct item item = {{{0, 0}}, (int)(s->color[0] & 0xFFFFFFu)};
    for (int k = 0; k < SHAPE_VERTICES; k++)
        item.point[k] = (gdPoint){s->x[k], s->y[k]};
    return item;
}

static void *open_job(const struct workload *w, const struct canvas *c)
{
    if (c->bits != 32 || w->form == FORM_SCREEN ||
        w->paint == PAINT_COPY_ALPHA ||
        (w->form != FORM_COPY && w->paint != PAINT_FLAT))
        return NULL;
    struct job *job = method_allocate(1, sizeof *job);
    job->workload = w;
    open_image(job, c);
    open_sprite(job, w->paint);
    open_font(job);
    job->item = method_allocate(w->count, sizeof *job->item);
    for (int i = 0; i < w->count; i++)
        job->item[i] = item_of(&w->shape[i]);
    return job;
}

static void draw_item(struct job *job, struct item *i)
{
    const struct workload *w = job->workload;
    const gdPoint *p = i->point;
    if (w->form == FORM_CIRCLE)
        gdImageFilledEllipse(job->image, p[0].x, p[0].y, 2 * w->size,
                             2 * w->size, i->color);
    else if (w->form == FORM_LINE)
        gdImageLine(job->image, p[0].x, p[0].y, p[1].x, p[1].y, i->color);
    else if (w->form == FORM_COPY)
        gdImageCopy(job->image, job->sprite, p[0].x, p[0].y, 0, 0, SPRITE_SIDE,
                    SPRITE_SIDE);
    else if (w->form == FORM_TEXT)
        gdImageString(job->image, &job->font, p[0].x, p[0].y,
                      (unsigned char *)(uintptr_t)letters_line, i->color);
    else
        gdImageFilledPolygon(job->image, i->point, workload_vertices(w),
                             i->color);
}

static void draw(void *data, int first, int n)
{
    struct job *job = data;
    for (struct item *i = job->item + first; n > 0; n--, i++)
        draw_item(job, i);
}

static void close_job(void *data)
{
    struct job *job = data;
    job->image->tpixels = job->own;
    gdImageDestroy(job->image);
    gdImageDestroy(job->sprite);
    free(job->row);
    free(job->item);
    free(job);
}

extern const struct method method_gd;
const struct method method_gd = {"gd", "packaged", open_job, draw, close_job};
