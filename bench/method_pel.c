/* Pel. Compiled once for each compiler together with a core of its own:
 * METHOD is the name of the object, METHOD_BUILD that of the build. */
#include "method.h"

#include <stdlib.h>
#include <string.h>

#include "bench/letters.h"
#include "core/format/argb8888.h"
#include "core/pel.h"
#include "fonts.h"

enum { RAMP = 256, PERIMETER = 4 };

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
    void *scratch; /* of polygons and strokes */
    size_t scratch_size;
    union {
        struct pel_paint paint; /* the first member of all */
        struct pel_linear linear;
        struct pel_radial radial;
        struct pel_conic conic;
        struct pel_fan fan;
    } source; /* of the whole canvas, */
    struct pel_dither dither;
    const struct pel_paint *paint; /* which is one of the two */
    pel_color ramp_color[RAMP];
    struct pel_fan_triangle fan_triangle[PERIMETER];
    struct pel_surface texture, sprite;
    enum paint copy;
    bool smooth, bilinear;
    const struct offset *gear;
    struct workload_line line;
    const struct pel_font_asset *font;
    uint8_t wrap; /* of the texture */
    enum pel_status (*stroke)(const struct pel_surface *,
                              const struct pel_polyline_shape *,
                              const struct pel_paint *, void *, size_t);
};

static void draw_triangles(const struct job *job, const struct item *item,
                           int n)
{
    for (; n > 0; n--, item++) {
        const struct pel_flat flat = PEL_FLAT(item->color[0]);
        (job->smooth ? pel_smooth_triangle
                     : pel_triangle)(&job->surface, item->v, &flat.paint);
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
        (job->smooth ? pel_smooth_circle : pel_circle)(
            &job->surface, item->v[0], job->radius, &flat.paint);
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

static void draw_clears(const struct job *job, const struct item *item, int n)
{
    for (; n > 0; n--, item++)
        pel_clear(&job->surface, item->color[0]);
}

static void draw_boxes(const struct job *job, const struct item *item, int n)
{
    for (; n > 0; n--, item++) {
        const struct pel_flat flat = PEL_FLAT(item->color[0]);
        pel_rectangle(&job->surface, item->v[0], item->v[1], &flat.paint);
    }
}

static void draw_rounded(const struct job *job, const struct item *item, int n)
{
    struct pel_rounded_shape shape = {.radius = PEL_PX(ROUNDED_RADIUS)};
    for (; n > 0; n--, item++) {
        const struct pel_flat flat = PEL_FLAT(item->color[0]);
        shape.from = item->v[0];
        shape.to = item->v[1];
        pel_rounded_rectangle(&job->surface, &shape, &flat.paint);
    }
}

static void set_gear(struct pel_point v[GEAR_SIDES], const struct job *job,
                     struct pel_point center)
{
    for (int k = 0; k < GEAR_SIDES; k++) {
        v[k].x = center.x + job->gear[k].x;
        v[k].y = center.y + job->gear[k].y;
    }
}

static void draw_hits(const struct job *job, const struct item *item, int n)
{
    struct pel_point v[GEAR_SIDES];
    const struct pel_polygon_shape outline = {v, GEAR_SIDES, PEL_NON_ZERO};
    for (; n > 0; n--, item++) {
        const int32_t x0 = pel_pixel_of(item->v[0].x - job->radius);
        const int32_t y0 = pel_pixel_of(item->v[0].y - job->radius);
        set_gear(v, job, item->v[0]);
        for (int32_t y = y0; y < y0 + HIT_SIDE * HIT_STEP; y += HIT_STEP)
            for (int32_t x = x0; x < x0 + HIT_SIDE * HIT_STEP; x += HIT_STEP)
                if (pel_hit_polygon(&outline, x, y))
                    job->surface.format->put(&job->surface, x, y, 1,
                                             item->color);
    }
}

/* Polygons, or strokes along them. */
static void draw_gears(const struct job *job, const struct item *item, int n)
{
    struct pel_point v[GEAR_SIDES];
    const struct pel_polygon_shape outline = {v, GEAR_SIDES, PEL_NON_ZERO};
    const struct pel_polyline_shape line = {
        v, GEAR_SIDES, true, {PEL_PX(STROKE_WIDTH), .join = PEL_JOIN_ROUND}};
    for (; n > 0; n--, item++) {
        const struct pel_flat flat = PEL_FLAT(item->color[0]);
        set_gear(v, job, item->v[0]);
        if (job->stroke)
            job->stroke(&job->surface, &line, &flat.paint, job->scratch,
                        job->scratch_size);
        else
            pel_smooth_polygon(&job->surface, &outline, &flat.paint,
                               job->scratch, job->scratch_size);
    }
}

static void draw_screen(const struct job *job, const struct item *item, int n)
{
    for (; n > 0; n--, item++)
        pel_rectangle(&job->surface, item->v[0], item->v[1], job->paint);
}

static void draw_copies(const struct job *job, const struct item *item, int n)
{
    struct pel_copy_part copy = {
        &job->sprite, {0, 0, SPRITE_SIDE, SPRITE_SIDE}, 0, 0};
    for (; n > 0; n--, item++) {
        copy.x = item->v[0].x / 256;
        copy.y = item->v[0].y / 256;
        if (job->copy == PAINT_KEYED)
            pel_copy_keyed(&job->surface, &copy, SPRITE_KEY);
        else if (job->copy == PAINT_COPY_ALPHA)
            pel_copy_alpha(&job->surface, &copy, 255);
        else
            pel_copy(&job->surface, &copy);
    }
}

static void draw_text(const struct job *job, const struct item *item, int n)
{
    for (; n > 0; n--, item++) {
        const struct pel_flat flat = PEL_FLAT(item->color[0]);
        const struct pel_text_block text = {
            &letters, letters_line, item->v[0].x / 256, item->v[0].y / 256};
        pel_text(&job->surface, &text, &flat.paint);
    }
}

static void draw_glyphs(const struct job *job, const struct item *item, int n)
{
    struct pel_text_block text = {job->font, job->line.text, 0, 0};
    for (; n > 0; n--, item++) {
        const struct pel_flat flat = PEL_FLAT(item->color[0]);
        text.x = item->v[0].x / 256;
        text.y = (item->v[0].y + job->radius) / 256 - job->font->ascent;
        pel_text(&job->surface, &text, &flat.paint);
    }
}

static void draw_outlines(const struct job *job, const struct item *item, int n)
{
    struct pel_outline_text_block text = {.font = &font_outlines,
                                          .string = job->line.text};
    const int32_t size = (int32_t)(job->line.em * 256 + .5);
    for (; n > 0; n--, item++) {
        const struct pel_flat flat = PEL_FLAT(item->color[0]);
        const struct pel_point pen = {item->v[0].x, item->v[0].y + job->radius};
        text.transform = pel_outline_transform(&font_outlines, size, 0, pen);
        pel_smooth_outline_text(&job->surface, &text, &flat.paint, job->scratch,
                                job->scratch_size);
    }
}

/* A paint for every triangle, as for a mesh. */
static void draw_textured(const struct job *job, const struct item *item, int n)
{
    const struct pel_texels texels = {&job->texture, NULL, 0, 0, true};
    struct pel_texture_map map;
    struct pel_texture paint;
    for (; n > 0; n--, item++) {
        pel_texture_map_triangle(&map, item->v, item->texel);
        (job->bilinear ? pel_texture_init_bilinear
                       : pel_texture_init_nearest)(&paint, &texels, &map);
        paint.wrap_u = paint.wrap_v = job->wrap;
        pel_triangle(&job->surface, item->v, &paint.base.paint);
    }
}

typedef void draw_items(const struct job *, const struct item *, int);

static draw_items *draw_of(const struct workload *w)
{
    static draw_items *const of[] = {
        [FORM_TRIANGLE] = draw_triangles, [FORM_SLIVER] = draw_triangles,
        [FORM_CIRCLE] = draw_circles,     [FORM_POLYGON] = draw_polygons,
        [FORM_LINE] = draw_lines,         [FORM_SCREEN] = draw_clears,
        [FORM_COPY] = draw_copies,        [FORM_TEXT] = draw_text,
        [FORM_OUTLINES] = draw_outlines,  [FORM_GLYPHS] = draw_glyphs,
        [FORM_GLYPHS_8] = draw_glyphs,    [FORM_BOX] = draw_boxes,
        [FORM_ROUNDED] = draw_rounded,    [FORM_GEAR] = draw_gears,
        [FORM_STROKE] = draw_gears};
    if (w->paint == PAINT_HITS)
        return draw_hits;
    if (w->form == FORM_SCREEN && w->paint != PAINT_FLAT)
        return draw_screen;
    if (w->paint == PAINT_NEAREST || w->paint == PAINT_BILINEAR)
        return draw_textured;
    return w->paint == PAINT_GOURAUD ? draw_gouraud : of[w->form];
}

/* Circles and lines are about pixel centres, the others about corners. */
static struct item item_of(const struct workload *w, const struct shape *s)
{
    struct item item;
    const int32_t half = w->form == FORM_CIRCLE || w->form == FORM_LINE ||
                                 w->form == FORM_GEAR || w->form == FORM_STROKE
                             ? 128
                             : 0;
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

static void set_fan(struct job *job, const struct workload *w)
{
    const int32_t x = PEL_PX(w->width), y = PEL_PX(w->height);
    const struct pel_point perimeter[PERIMETER] = {
        {0, 0}, {x, 0}, {x, y}, {0, y}};
    const pel_color *c = job->item[0].color;
    const pel_color perimeter_color[PERIMETER] = {c[0], c[1], c[0], c[1]};
    const struct pel_fan_points points = {
        {x / 2, y / 2}, c[2], perimeter, perimeter_color, PERIMETER};
    pel_fan_init(&job->source.fan, &points, job->fan_triangle);
}

static void set_gradient(struct job *job, const struct workload *w)
{
    const struct item *item = &job->item[0];
    const bool stops =
        w->paint == PAINT_RADIAL_STOPS || w->paint == PAINT_CONIC_STOPS;
    const struct pel_stop stop[3] = {
        {0, item->color[0]}, {32768, item->color[2]}, {65536, item->color[1]}};
    const struct pel_ramp ramp = {stops ? job->ramp_color : item->color,
                                  stops ? RAMP : 2, PEL_PAD};
    const struct pel_rings rings = {
        {PEL_PX(w->width) / 2, PEL_PX(w->height) / 2}, PEL_PX(w->width) / 2, 0};
    pel_ramp_fill(job->ramp_color, RAMP, stop, 3);
    if (w->paint == PAINT_FAN)
        set_fan(job, w);
    else if (w->paint < PAINT_RADIAL)
        pel_linear_init(&job->source.linear, item->v[0], item->v[2], &ramp);
    else if (w->paint < PAINT_CONIC)
        pel_radial_init(&job->source.radial, &rings, &ramp);
    else
        pel_conic_init(&job->source.conic, rings.center, 0, &ramp);
    pel_dither_init(&job->dither, &job->source.paint);
    job->paint =
        w->paint == PAINT_DITHERED ? &job->dither.paint : &job->source.paint;
}

/* A square picture. */
static void set_picture(struct pel_surface *picture,
                        const struct pel_format *format, int side,
                        const uint32_t *color)
{
    void *memory = method_allocate(side, (size_t)side * 4);
    pel_surface_init(picture, format, memory, (size_t)side * (size_t)side * 4,
                     &(struct pel_rect){0, 0, side, side});
    for (int y = 0; y < side; y++)
        format->put(picture, 0, y, side, color + y * side);
}

/* In the canvas's own format, but for sprites with alpha and of other ones. */
static void set_pictures(struct job *job, const struct workload *w)
{
    const uint32_t *sprite = workload_sprite(w->paint);
    const bool alpha = w->paint == PAINT_COPY_ALPHA;
    set_picture(&job->texture, job->surface.format, TEXTURE_SIDE,
                workload_texture());
    set_picture(&job->sprite,
                alpha                       ? &pel_argb8888
                : w->paint == PAINT_CONVERT ? &pel_xrgb8888
                                            : job->surface.format,
                SPRITE_SIDE, sprite);
    if (alpha) /* what is drawn into argb8888 is opaque */
        memcpy(job->sprite.pixels, sprite, SPRITE_SIDE * SPRITE_SIDE * 4);
    job->copy = w->paint;
    job->wrap = w->size < TEXTURE_SIDE / 2 ? PEL_WRAP_CLAMP : PEL_WRAP_REPEAT;
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
    if (w->form == FORM_SCREEN && w->paint != PAINT_FLAT)
        set_gradient(job, w);
    set_pictures(job, w);
    job->radius = PEL_PX(w->size);
    job->draw = draw_of(w);
    job->smooth = w->paint == PAINT_SMOOTH;
    job->bilinear = w->paint == PAINT_BILINEAR;
    job->gear = workload_gear(w);
    if (workload_is_line(w))
        job->line = workload_line(w);
    job->font = w->form == FORM_GLYPHS_8 ? &font_8_16
                : w->size == 16          ? &font_4_16
                                         : &font_4_24;
    if (w->form == FORM_STROKE)
        job->stroke =
            w->paint == PAINT_SMOOTH ? pel_smooth_polyline : pel_polyline;
    job->scratch_size = PEL_SMOOTH_PATH_SCRATCH_SIZE(8 * GEAR_SIDES, w->width);
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
    free(job->sprite.pixels);
    free(job->item);
    free(job->scratch);
    free(job);
}

extern const struct method METHOD;
const struct method METHOD = {"pel", METHOD_BUILD, open_job, draw, close_job};
