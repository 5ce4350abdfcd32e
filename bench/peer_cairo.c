/* cairo without antialiasing but for smooth shapes: paths that are filled,
 * lines that are stroked, patterns that are painted. */
#define _DEFAULT_SOURCE
#include "method.h"

#include <math.h>
#include <stdlib.h>

#include <cairo.h>

struct job {
    const struct workload *workload;
    cairo_surface_t *surface;
    cairo_t *cairo;
    cairo_pattern_t *pattern; /* of a gradient, or NULL */
    const struct offset *gear;
    cairo_glyph_t *glyph; /* of a line at (0, 0) */
    int glyphs;
};

static bool can_draw(const struct workload *w)
{
    if (w->form == FORM_SCREEN)
        return w->paint <= PAINT_RADIAL_STOPS && w->paint != PAINT_DITHERED;
    return w->form != FORM_TEXT &&
           (w->paint < PAINT_GOURAUD || w->paint == PAINT_SMOOTH);
}

static void add_stop(cairo_pattern_t *pattern, double at, uint32_t color)
{
    cairo_pattern_add_color_stop_rgb(pattern, at, (color >> 16 & 255) / 255.0,
                                     (color >> 8 & 255) / 255.0,
                                     (color & 255) / 255.0);
}

/* A rectangle, with round corners or without. */
static void draw_box(cairo_t *cairo, const struct shape *s, bool is_rounded)
{
    const double r = ROUNDED_RADIUS;
    const double x0 = s->x[0], y0 = s->y[0], x1 = s->x[1], y1 = s->y[1];
    if (is_rounded) {
        cairo_new_sub_path(cairo);
        cairo_arc(cairo, x1 - r, y0 + r, r, -M_PI / 2, 0);
        cairo_arc(cairo, x1 - r, y1 - r, r, 0, M_PI / 2);
        cairo_arc(cairo, x0 + r, y1 - r, r, M_PI / 2, M_PI);
        cairo_arc(cairo, x0 + r, y0 + r, r, M_PI, M_PI * 3 / 2);
        cairo_close_path(cairo);
    } else {
        cairo_rectangle(cairo, x0, y0, x1 - x0, y1 - y0);
    }
    cairo_fill(cairo);
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

/* Letters where other methods have them, as pixels or as outlines. */
static void open_text(struct job *job, const struct workload *w)
{
    const struct workload_line line = workload_line(w);
    cairo_font_options_t *options = cairo_font_options_create();
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_select_font_face(job->cairo, TEXT_FAMILY, CAIRO_FONT_SLANT_NORMAL,
                           CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(job->cairo, line.em);
    cairo_set_font_options(job->cairo, options);
    cairo_font_options_destroy(options);
    cairo_scaled_font_text_to_glyphs(cairo_get_scaled_font(job->cairo), 0, 0,
                                     line.text, -1, &job->glyph, &job->glyphs,
                                     NULL, NULL, NULL);
    for (int k = 0; k < job->glyphs; k++)
        job->glyph[k].x = k * line.advance;
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
    if (w->paint != PAINT_SMOOTH)
        cairo_set_antialias(job->cairo, CAIRO_ANTIALIAS_NONE);
    job->gear = workload_gear(w);
    cairo_set_line_width(job->cairo, w->form == FORM_STROKE ? STROKE_WIDTH : 1);
    cairo_set_line_join(job->cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(job->cairo, CAIRO_LINE_CAP_SQUARE);
    if (workload_is_line(w))
        open_text(job, w);
    if (w->form == FORM_SCREEN && w->paint != PAINT_FLAT) {
        job->pattern = gradient_of(w);
        cairo_set_source(job->cairo, job->pattern);
    }
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

static void draw_gear(cairo_t *cairo, const struct shape *s,
                      const struct offset *gear, bool is_stroke)
{
    for (int k = 0; k < GEAR_SIDES; k++)
        cairo_line_to(cairo, s->x[0] + .5 + gear[k].x / 256.,
                      s->y[0] + .5 + gear[k].y / 256.);
    cairo_close_path(cairo);
    (is_stroke ? cairo_stroke : cairo_fill)(cairo);
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

static void draw_text(const struct job *job, const struct shape *s)
{
    cairo_glyph_t glyph[sizeof TEXT_LINE];
    for (int k = 0; k < job->glyphs; k++) {
        glyph[k] = job->glyph[k];
        glyph[k].x += s->x[0];
        glyph[k].y = s->y[0] + job->workload->size;
    }
    if (job->workload->form == FORM_OUTLINES) {
        cairo_glyph_path(job->cairo, glyph, job->glyphs);
        cairo_fill(job->cairo);
    } else {
        cairo_show_glyphs(job->cairo, glyph, job->glyphs);
    }
}

static void draw(void *data, int first, int n)
{
    const struct job *job = data;
    const struct workload *w = job->workload;
    const int vertices = workload_vertices(w);
    const struct shape *s = w->shape + first;
    cairo_surface_mark_dirty(job->surface);
    for (; n > 0; n--, s++) {
        if (!job->pattern)
            set_color(job, s);
        if (w->form == FORM_SCREEN)
            cairo_paint(job->cairo);
        else if (w->form == FORM_BOX || w->form == FORM_ROUNDED)
            draw_box(job->cairo, s, w->form == FORM_ROUNDED);
        else if (w->form == FORM_CIRCLE)
            draw_circle(job->cairo, s, w->size);
        else if (w->form == FORM_GEAR || w->form == FORM_STROKE)
            draw_gear(job->cairo, s, job->gear, w->form == FORM_STROKE);
        else if (w->form == FORM_LINE)
            draw_line(job->cairo, s);
        else if (job->glyph)
            draw_text(job, s);
        else
            draw_outline(job->cairo, s, vertices);
    }
    cairo_surface_flush(job->surface);
}

static void close_job(void *data)
{
    struct job *job = data;
    cairo_pattern_destroy(job->pattern);
    cairo_glyph_free(job->glyph);
    cairo_destroy(job->cairo);
    cairo_surface_destroy(job->surface);
    free(job);
}

extern const struct method method_cairo;
const struct method method_cairo = {"cairo", "packaged", open_job, draw,
                                    close_job};
