/* cairo without antialiasing: paths that are filled, lines that are stroked,
 * patterns and pictures as sources. */
#define _DEFAULT_SOURCE
#include "method.h"

#include <math.h>
#include <stdlib.h>

#include <cairo.h>

struct job {
    const struct workload *workload;
    cairo_surface_t *surface;
    cairo_t *cairo;
    cairo_pattern_t *pattern; /* of a gradient or a sprite; or NULL */
    uint32_t *sprite;         /* its pixels, premultiplied */
};

static bool can_draw(const struct workload *w)
{
    const bool pattern = w->paint >= PAINT_VERTICAL &&
                         w->paint <= PAINT_RADIAL_STOPS &&
                         w->paint != PAINT_DITHERED;
    return w->form != FORM_TEXT &&
           (w->paint < PAINT_GOURAUD || pattern || w->paint == PAINT_COPY ||
            w->paint == PAINT_COPY_ALPHA);
}

static void add_stop(cairo_pattern_t *pattern, double at, uint32_t color)
{
    cairo_pattern_add_color_stop_rgb(pattern, at, (color >> 16 & 255) / 255.0,
                                     (color >> 8 & 255) / 255.0,
                                     (color & 255) / 255.0);
}

static cairo_pattern_t *gradient_of(const struct workload *w)
{
    const struct shape *s = w->shape;
    const double x = w->width / 2.0, y = w->height / 2.0;
    cairo_pattern_t *pattern =
        w->paint < PAINT_RADIAL
            ? cairo_pattern_create_linear(0, 0, s->x[2], s->y[2])
            : cairo_pattern_create_radial(x, y, 0, x, y, x);
    add_stop(pattern, 0, s->color[0]);
    if (w->paint == PAINT_RADIAL_STOPS)
        add_stop(pattern, .5, s->color[2]);
    add_stop(pattern, 1, s->color[1]);
    return pattern;
}

/* In the format of the canvas, or with alpha. */
static cairo_pattern_t *sprite_of(struct job *job, const struct workload *w)
{
    const uint32_t *from = workload_sprite(w->paint);
    const int n = SPRITE_SIDE * SPRITE_SIDE;
    job->sprite = method_allocate(n, 4);
    for (int i = 0; i < n; i++) {
        const uint32_t a = from[i] >> 24;
        job->sprite[i] = a << 24;
        for (int k = 0; k < 24; k += 8)
            job->sprite[i] |= ((from[i] >> k & 255) * a + 127) / 255 << k;
    }
    cairo_surface_t *all = cairo_image_surface_create_for_data(
        (unsigned char *)job->sprite, CAIRO_FORMAT_ARGB32, SPRITE_SIDE,
        SPRITE_SIDE, SPRITE_SIDE * 4);
    cairo_surface_t *like = cairo_image_surface_create(
        w->paint == PAINT_COPY ? cairo_image_surface_get_format(job->surface)
                               : CAIRO_FORMAT_ARGB32,
        SPRITE_SIDE, SPRITE_SIDE);
    cairo_t *copy = cairo_create(like);
    cairo_set_source_surface(copy, all, 0, 0);
    cairo_paint(copy);
    cairo_pattern_t *pattern = cairo_pattern_create_for_surface(like);
    cairo_destroy(copy);
    cairo_surface_destroy(all);
    cairo_surface_destroy(like);
    return pattern;
}

static void *open_job(const struct workload *w, const struct canvas *c)
{
    if (!can_draw(w))
        return NULL;
    struct job *job = method_allocate(1, sizeof *job);
    job->workload = w;
    job->surface = cairo_image_surface_create_for_data(
        c->pixels, c->bits == 32 ? CAIRO_FORMAT_RGB24 : CAIRO_FORMAT_RGB16_565,
        c->width, c->height, c->stride);
    job->cairo = cairo_create(job->surface);
    if (cairo_status(job->cairo))
        method_fail(cairo_status_to_string(cairo_status(job->cairo)),
                    "check the installation of cairo");
    cairo_set_antialias(job->cairo, CAIRO_ANTIALIAS_NONE);
    cairo_set_line_width(job->cairo, 1);
    cairo_set_line_cap(job->cairo, CAIRO_LINE_CAP_SQUARE);
    if (w->form == FORM_SCREEN)
        job->pattern = gradient_of(w);
    if (w->form == FORM_COPY)
        job->pattern = sprite_of(job, w);
    if (job->pattern && w->paint != PAINT_COPY_ALPHA)
        cairo_set_operator(job->cairo, CAIRO_OPERATOR_SOURCE);
    return job;
}

static void set_color(const struct job *job, const struct shape *s)
{
    double r = (s->color[0] >> 16 & 255) / 255.0;
    double g = (s->color[0] >> 8 & 255) / 255.0;
    double b = (s->color[0] & 255) / 255.0;
    if (job->workload->paint == PAINT_ALPHA)
        cairo_set_source_rgba(job->cairo, r, g, b, WORKLOAD_ALPHA / 255.0);
    else
        cairo_set_source_rgb(job->cairo, r, g, b);
}

static void draw_outline(cairo_t *cairo, const struct shape *s, int n)
{
    cairo_move_to(cairo, s->x[0], s->y[0]);
    for (int k = 1; k < n; k++)
        cairo_line_to(cairo, s->x[k], s->y[k]);
    cairo_fill(cairo);
}

static void draw_line(cairo_t *cairo, const struct shape *s)
{
    cairo_move_to(cairo, s->x[0] + .5, s->y[0] + .5);
    cairo_line_to(cairo, s->x[1] + .5, s->y[1] + .5);
    cairo_stroke(cairo);
}

static void draw_circle(cairo_t *cairo, const struct shape *s, int radius)
{
    cairo_arc(cairo, s->x[0] + .5, s->y[0] + .5, radius, 0, 2 * M_PI);
    cairo_fill(cairo);
}

/* A pattern moves with the coordinates that are set when it becomes source. */
static void draw_rectangle(const struct job *job, const struct shape *s)
{
    cairo_identity_matrix(job->cairo);
    cairo_translate(job->cairo, s->x[0], s->y[0]);
    cairo_set_source(job->cairo, job->pattern);
    cairo_rectangle(job->cairo, 0, 0, s->x[1] - s->x[0], s->y[1] - s->y[0]);
    cairo_fill(job->cairo);
}

static void draw(void *data, int first, int n)
{
    const struct job *job = data;
    const struct workload *w = job->workload;
    const int vertices = workload_vertices(w);
    const struct shape *s = w->shape + first;
    cairo_surface_mark_dirty(job->surface);
    for (; n > 0; n--, s++) {
        if (job->pattern) {
            draw_rectangle(job, s);
            continue;
        }
        set_color(job, s);
        if (w->form == FORM_CIRCLE)
            draw_circle(job->cairo, s, w->size);
        else if (w->form == FORM_LINE)
            draw_line(job->cairo, s);
        else
            draw_outline(job->cairo, s, vertices);
    }
    cairo_surface_flush(job->surface);
}

static void close_job(void *data)
{
    struct job *job = data;
    cairo_pattern_destroy(job->pattern);
    cairo_destroy(job->cairo);
    free(job->sprite);
    cairo_surface_destroy(job->surface);
    free(job);
}

extern const struct method method_cairo;
const struct method method_cairo = {"cairo", "packaged", open_job, draw,
                                    close_job};
