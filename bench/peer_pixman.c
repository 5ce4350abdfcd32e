/* pixman: triangles through a mask of one bit a pixel, which decides at centres
 * of pixels, or of eight when they are smooth; gradients and copies of images.
 */
#include "method.h"

#include <stdlib.h>

#include <pixman.h>

struct job {
    const struct workload *workload;
    pixman_image_t *canvas;
    pixman_image_t **source; /* of each shape */
    pixman_triangle_t *triangle;
    pixman_op_t operation;
    pixman_format_code_t mask; /* of triangles */
};

static bool can_draw(const struct workload *w)
{
    switch (w->form) {
    case FORM_SCREEN:
        return w->paint != PAINT_FAN;
    case FORM_COPY:
        return w->paint != PAINT_KEYED;
    case FORM_BOX:
        return true;
    case FORM_TRIANGLE:
    case FORM_SLIVER:
        return w->paint != PAINT_GOURAUD;
    default:
        return false;
    }
}

static pixman_image_t *checked(pixman_image_t *image)
{
    if (!image)
        method_fail("pixman makes no image", "check its installation");
    return image;
}

static pixman_point_fixed_t point(double x, double y)
{
    return (pixman_point_fixed_t){pixman_double_to_fixed(x),
                                  pixman_double_to_fixed(y)};
}

/* Alpha is multiplied in. */
static pixman_color_t color_of(uint32_t color, uint32_t alpha)
{
    return (pixman_color_t){(uint16_t)((color >> 16 & 255) * alpha * 257 / 255),
                            (uint16_t)((color >> 8 & 255) * alpha * 257 / 255),
                            (uint16_t)((color & 255) * alpha * 257 / 255),
                            (uint16_t)(alpha * 257)};
}

static pixman_image_t *gradient_of(const struct workload *w,
                                   const struct shape *s)
{
    const double x = w->width / 2.0, y = w->height / 2.0;
    const pixman_point_fixed_t corner = point(0, 0), middle = point(x, y);
    const pixman_point_fixed_t end = point(s->x[2], s->y[2]);
    const bool stops =
        w->paint == PAINT_RADIAL_STOPS || w->paint == PAINT_CONIC_STOPS;
    const pixman_gradient_stop_t stop[] = {
        {0, color_of(s->color[0], 255)},
        {stops ? pixman_fixed_1 / 2 : pixman_fixed_1,
         color_of(s->color[stops ? 2 : 1], 255)},
        {pixman_fixed_1, color_of(s->color[1], 255)}};
    pixman_image_t *image;
    if (w->paint < PAINT_RADIAL)
        image =
            pixman_image_create_linear_gradient(&corner, &end, stop, 2 + stops);
    else if (w->paint < PAINT_CONIC)
        image = pixman_image_create_radial_gradient(
            &middle, &middle, 0, pixman_double_to_fixed(x), stop, 2 + stops);
    else
        image =
            pixman_image_create_conical_gradient(&middle, 0, stop, 2 + stops);
    pixman_image_set_repeat(checked(image), PIXMAN_REPEAT_PAD);
    return image;
}

static pixman_image_t *picture_of(const uint32_t *pixels, int side,
                                  pixman_format_code_t format)
{
    return checked(pixman_image_create_bits(
        format, side, side, (uint32_t *)(uintptr_t)pixels, side * 4));
}

/* The turned texture at unit scale. */
static pixman_image_t *texture_of(const struct shape *s, enum paint paint)
{
    const double dx = s->x[1] - s->x[0], dy = s->y[1] - s->y[0];
    const double du = s->u[1] - s->u[0], dv = s->v[1] - s->v[0];
    const double square = dx * dx + dy * dy;
    const double c = (dx * du + dy * dv) / square;
    const double t = (dx * dv - dy * du) / square;
    const struct pixman_f_transform to_texels = {
        {{c, -t, s->u[0] - c * s->x[0] + t * s->y[0]},
         {t, c, s->v[0] - t * s->x[0] - c * s->y[0]},
         {0, 0, 1}}};
    pixman_transform_t fixed;
    pixman_image_t *image =
        picture_of(workload_texture(), TEXTURE_SIDE, PIXMAN_x8r8g8b8);
    pixman_transform_from_pixman_f_transform(&fixed, &to_texels);
    pixman_image_set_transform(image, &fixed);
    pixman_image_set_repeat(image, PIXMAN_REPEAT_NORMAL);
    pixman_image_set_filter(image,
                            paint == PAINT_NEAREST ? PIXMAN_FILTER_NEAREST
                                                   : PIXMAN_FILTER_BILINEAR,
                            NULL, 0);
    return image;
}

/* In the format of the canvas, or with alpha multiplied in. */
static pixman_image_t *sprite_of(enum paint paint, pixman_format_code_t canvas)
{
    const uint32_t *pixels = workload_sprite(paint);
    const bool alpha = paint == PAINT_COPY_ALPHA;
    pixman_image_t *from = picture_of(pixels, SPRITE_SIDE, PIXMAN_x8r8g8b8);
    pixman_image_t *mask = picture_of(pixels, SPRITE_SIDE, PIXMAN_a8r8g8b8);
    pixman_image_t *to = checked(
        pixman_image_create_bits(alpha                    ? PIXMAN_a8r8g8b8
                                 : paint == PAINT_CONVERT ? PIXMAN_x8r8g8b8
                                                          : canvas,
                                 SPRITE_SIDE, SPRITE_SIDE, NULL, 0));
    pixman_image_composite32(PIXMAN_OP_SRC, from, mask, to, 0, 0, 0, 0, 0, 0,
                             SPRITE_SIDE, SPRITE_SIDE);
    pixman_image_unref(from);
    pixman_image_unref(mask);
    return to;
}

static pixman_image_t *source_of(const struct job *job, const struct shape *s)
{
    const struct workload *w = job->workload;
    const pixman_color_t color =
        color_of(s->color[0], w->paint == PAINT_ALPHA ? WORKLOAD_ALPHA : 255);
    if (w->form == FORM_SCREEN && w->paint != PAINT_FLAT)
        return gradient_of(w, s);
    if (w->form == FORM_COPY)
        return s == w->shape
                   ? sprite_of(w->paint, pixman_image_get_format(job->canvas))
                   : pixman_image_ref(job->source[0]);
    if (w->paint == PAINT_NEAREST || w->paint == PAINT_BILINEAR)
        return texture_of(s, w->paint);
    return checked(pixman_image_create_solid_fill(&color));
}

static void *open_job(const struct workload *w, const struct canvas *c)
{
    if (!can_draw(w))
        return NULL;
    struct job *job = method_allocate(1, sizeof *job);
    job->workload = w;
    job->canvas = checked(pixman_image_create_bits(
        c->bits == 32 ? PIXMAN_x8r8g8b8 : PIXMAN_r5g6b5, c->width, c->height,
        (uint32_t *)(void *)c->pixels, c->stride));
    if (w->paint == PAINT_DITHERED)
        pixman_image_set_dither(job->canvas, PIXMAN_DITHER_ORDERED_BAYER_8);
    job->operation = w->form == FORM_SCREEN || w->form == FORM_BOX ||
                             w->paint == PAINT_COPY || w->paint == PAINT_CONVERT
                         ? PIXMAN_OP_SRC
                         : PIXMAN_OP_OVER;
    job->mask = w->paint == PAINT_SMOOTH ? PIXMAN_a8 : PIXMAN_a1;
    job->source = method_allocate(w->count, sizeof *job->source);
    job->triangle = method_allocate(w->count, sizeof *job->triangle);
    for (int i = 0; i < w->count; i++) {
        const struct shape *s = &w->shape[i];
        job->source[i] = source_of(job, s);
        job->triangle[i] = (pixman_triangle_t){point(s->x[0], s->y[0]),
                                               point(s->x[1], s->y[1]),
                                               point(s->x[2], s->y[2])};
    }
    return job;
}

static void draw_box(const struct job *job, int i)
{
    const struct shape *s = &job->workload->shape[i];
    pixman_image_composite32(job->operation, job->source[i], NULL, job->canvas,
                             0, 0, 0, 0, s->x[0], s->y[0], s->x[1] - s->x[0],
                             s->y[1] - s->y[0]);
}

static void draw(void *data, int first, int n)
{
    const struct job *job = data;
    const enum form form = job->workload->form;
    for (int i = first; i < first + n; i++)
        if (form == FORM_SCREEN || form == FORM_COPY || form == FORM_BOX)
            draw_box(job, i);
        else
            pixman_composite_triangles(job->operation, job->source[i],
                                       job->canvas, job->mask, 0, 0, 0, 0, 1,
                                       &job->triangle[i]);
}

static void close_job(void *data)
{
    struct job *job = data;
    for (int i = 0; i < job->workload->count; i++)
        pixman_image_unref(job->source[i]);
    pixman_image_unref(job->canvas);
    free(job->source);
    free(job->triangle);
    free(job);
}

extern const struct method method_pixman;
const struct method method_pixman = {"pixman", "packaged", open_job, draw,
                                     close_job};
