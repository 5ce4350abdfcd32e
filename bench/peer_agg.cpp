/* AGG 2.4 with hard edges: its rasteriser with coverage cut at one half, runs
 * of whole pixels; smooth shapes with its coverage; its span generators for
 * gradients, Gouraud and textures. */
#include <agg_conv_stroke.h>
#include <agg_conv_curve.h>
#include <agg_ellipse.h>
#include <agg_font_cache_manager.h>
#include <agg_font_freetype.h>
#include <agg_gamma_functions.h>
#include <agg_image_accessors.h>
#include <agg_path_storage.h>
#include <agg_pixfmt_rgb_packed.h>
#include <agg_pixfmt_rgba.h>
#include <agg_rasterizer_scanline_aa.h>
#include <agg_renderer_scanline.h>
#include <agg_rounded_rect.h>
#include <agg_scanline_bin.h>
#include <agg_scanline_u.h>
#include <agg_span_allocator.h>
#include <agg_span_gouraud_rgba.h>
#include <agg_span_gradient.h>
#include <agg_span_image_filter_rgba.h>
#include <agg_span_interpolator_linear.h>

extern "C" {
#include "method.h"
}

using color = agg::rgba8;
using interpolator = agg::span_interpolator_linear<>;

struct job {
    const struct workload *workload;
    agg::rendering_buffer canvas, texture;
    agg::rasterizer_scanline_aa<> rasterizer;
    agg::scanline_bin line;
    agg::scanline_u8 levels;
    const struct offset *gear;
    agg::span_allocator<color> colors;
    color ramp[256];
    bool is_wide;
    struct workload_line text; /* no letters: none */
    agg::font_engine_freetype_int32 engine;
    agg::font_cache_manager<agg::font_engine_freetype_int32> glyphs{engine};
};

static color color_of(uint32_t c, unsigned alpha = 255)
{
    return color(c >> 16 & 255, c >> 8 & 255, c & 255, alpha);
}

/* The colors of a ramp, as span_gradient asks for them. */
struct ramp {
    const color *at;
    static unsigned size()
    {
        return 256;
    }
    const color &operator[](unsigned i) const
    {
        return at[i];
    }
};

template <class Base, class Generator>
static void fill(struct job *job, Base &base, Generator &generator)
{
    agg::render_scanlines_bin(job->rasterizer, job->line, base, job->colors,
                              generator);
}

/* `axes` takes a pixel to the gradient's own axes, where it ends at `end`. */
template <class Function, class Base>
static void fill_gradient(struct job *job, Base &base, agg::trans_affine axes,
                          double end)
{
    interpolator along(axes);
    ramp colors = {job->ramp};
    Function function;
    agg::span_gradient<color, interpolator, Function, ramp> generator(
        along, function, colors, 0, end);
    fill(job, base, generator);
}

template <class Base>
static void fill_screen(struct job *job, Base &base, const struct shape *s)
{
    const double x = s->x[2], y = s->y[2], scale = 256 / (x * x + y * y);
    const double half = job->workload->width / 2.;
    const agg::trans_affine along(x * scale, 0, y * scale, 0, 0, 0);
    const agg::trans_affine_translation around(-half,
                                               -job->workload->height / 2.);
    if (job->workload->paint < PAINT_RADIAL)
        fill_gradient<agg::gradient_x>(job, base, along, 256);
    else if (job->workload->paint < PAINT_CONIC)
        fill_gradient<agg::gradient_radial>(job, base, around, half);
    else
        fill_gradient<agg::gradient_conic>(job, base, around, half);
}

template <class Base>
static void fill_texture(struct job *job, Base &base, const struct shape *s)
{
    using wrap = agg::wrap_mode_repeat_auto_pow2;
    using source = agg::image_accessor_wrap<agg::pixfmt_bgra32, wrap, wrap>;
    double screen[6], texels[6];
    for (int k = 0; k < 3; k++) {
        screen[2 * k] = s->x[k];
        screen[2 * k + 1] = s->y[k];
        texels[2 * k] = s->u[k];
        texels[2 * k + 1] = s->v[k];
    }
    agg::pixfmt_bgra32 pixels(job->texture);
    source picture(pixels);
    agg::trans_affine map(screen, texels);
    interpolator along(map);
    if (job->workload->paint == PAINT_NEAREST) {
        agg::span_image_filter_rgba_nn<source, interpolator> near(picture,
                                                                  along);
        fill(job, base, near);
    } else {
        agg::span_image_filter_rgba_bilinear<source, interpolator> mean(picture,
                                                                        along);
        fill(job, base, mean);
    }
}

static void set_stroke(struct job *job, const struct shape *s)
{
    agg::path_storage path;
    for (int k = 0; k < GEAR_SIDES; k++) {
        const double x = s->x[0] + .5 + job->gear[k].x / 256.;
        const double y = s->y[0] + .5 + job->gear[k].y / 256.;
        if (k == 0)
            path.move_to(x, y);
        else
            path.line_to(x, y);
    }
    path.close_polygon();
    agg::conv_stroke<agg::path_storage> stroke(path);
    stroke.width(STROKE_WIDTH);
    stroke.line_join(agg::round_join);
    job->rasterizer.add_path(stroke);
}

static void set_outline(struct job *job, const struct shape *s)
{
    const struct workload *w = job->workload;
    const int n = workload_vertices(w);
    job->rasterizer.reset();
    if (w->form == FORM_ROUNDED) {
        agg::rounded_rect box(s->x[0], s->y[0], s->x[1], s->y[1],
                              ROUNDED_RADIUS);
        job->rasterizer.add_path(box);
    } else if (w->form == FORM_CIRCLE) {
        agg::ellipse disc(s->x[0] + .5, s->y[0] + .5, w->size, w->size);
        job->rasterizer.add_path(disc);
    } else if (w->form == FORM_STROKE) {
        set_stroke(job, s);
    } else if (w->form == FORM_GEAR) {
        job->rasterizer.move_to_d(s->x[0] + .5 + job->gear[0].x / 256.,
                                  s->y[0] + .5 + job->gear[0].y / 256.);
        for (int k = 1; k < GEAR_SIDES; k++)
            job->rasterizer.line_to_d(s->x[0] + .5 + job->gear[k].x / 256.,
                                      s->y[0] + .5 + job->gear[k].y / 256.);
    } else if (w->form == FORM_SCREEN) {
        job->rasterizer.move_to_d(0, 0);
        job->rasterizer.line_to_d(s->x[1], 0);
        job->rasterizer.line_to_d(s->x[1], s->y[1]);
        job->rasterizer.line_to_d(0, s->y[1]);
    } else {
        job->rasterizer.move_to_d(s->x[0], s->y[0]);
        for (int k = 1; k < n; k++)
            job->rasterizer.line_to_d(s->x[k], s->y[k]);
    }
}

/* The outline is sorted once for all pixels. */
template <class Base>
static void draw_hits(struct job *job, Base &base, const struct shape *s)
{
    const int x0 = s->x[0] - job->workload->size;
    const int y0 = s->y[0] - job->workload->size;
    for (int y = y0; y < y0 + HIT_SIDE * HIT_STEP; y += HIT_STEP)
        for (int x = x0; x < x0 + HIT_SIDE * HIT_STEP; x += HIT_STEP)
            if (job->rasterizer.hit_test(x, y))
                base.copy_pixel(x, y, color_of(s->color[0]));
}

/* Letters as outlines or from the cache of their pictures. */
template <class Base>
static void draw_text(struct job *job, Base &base, const struct shape *s)
{
    using outline = agg::font_cache_manager<
        agg::font_engine_freetype_int32>::path_adaptor_type;
    agg::conv_curve<outline> curve(job->glyphs.path_adaptor());
    for (int k = 0; k < job->text.letters; k++) {
        const unsigned code = static_cast<unsigned>(job->text.text[k]);
        job->glyphs.init_embedded_adaptors(job->glyphs.glyph(code),
                                           s->x[0] + k * job->text.advance,
                                           s->y[0] + job->workload->size);
        if (job->workload->form == FORM_OUTLINES) {
            job->rasterizer.reset();
            job->rasterizer.add_path(curve);
            agg::render_scanlines_aa_solid(job->rasterizer, job->levels, base,
                                           color_of(s->color[0]));
        } else {
            agg::render_scanlines_aa_solid(job->glyphs.gray8_adaptor(),
                                           job->glyphs.gray8_scanline(), base,
                                           color_of(s->color[0]));
        }
    }
}

static void open_text(struct job *job)
{
    job->text = workload_line(job->workload);
    job->engine.load_font(TEXT_FONT, 0,
                          job->workload->form == FORM_OUTLINES
                              ? agg::glyph_ren_outline
                              : agg::glyph_ren_native_gray8);
    job->engine.hinting(false);
    job->engine.flip_y(true);
    job->engine.resolution(72);
    job->engine.height(job->text.em);
}

template <class Base>
static void draw_shape(struct job *job, Base &base, const struct shape *s)
{
    const struct workload *w = job->workload;
    if (w->paint == PAINT_FLAT &&
        (w->form == FORM_BOX || w->form == FORM_SCREEN)) {
        base.copy_bar(s->x[0], s->y[0], s->x[1] - 1, s->y[1] - 1,
                      color_of(s->color[0]));
        return;
    }
    if (job->text.letters > 0) {
        draw_text(job, base, s);
        return;
    }
    set_outline(job, s);
    if (w->form == FORM_SCREEN) {
        fill_screen(job, base, s);
    } else if (w->paint == PAINT_HITS) {
        draw_hits(job, base, s);
    } else if (w->paint == PAINT_SMOOTH) {
        agg::render_scanlines_aa_solid(job->rasterizer, job->levels, base,
                                       color_of(s->color[0]));
    } else if (w->paint == PAINT_GOURAUD) {
        agg::span_gouraud_rgba<color> generator(
            color_of(s->color[0]), color_of(s->color[1]), color_of(s->color[2]),
            s->x[0], s->y[0], s->x[1], s->y[1], s->x[2], s->y[2], 0);
        fill(job, base, generator);
    } else if (w->paint >= PAINT_NEAREST) {
        fill_texture(job, base, s);
    } else {
        agg::render_scanlines_bin_solid(
            job->rasterizer, job->line, base,
            color_of(s->color[0],
                     w->paint == PAINT_ALPHA ? WORKLOAD_ALPHA : 255));
    }
}

template <class Pixels> static void draw_on(struct job *job, int first, int n)
{
    Pixels pixels(job->canvas);
    agg::renderer_base<Pixels> base(pixels);
    for (int i = first; i < first + n; i++)
        draw_shape(job, base, &job->workload->shape[i]);
}

static void *open_job(const struct workload *w, const struct canvas *c)
{
    if (w->form == FORM_COPY || w->form == FORM_TEXT ||
        (w->form == FORM_CIRCLE && w->paint != PAINT_SMOOTH) ||
        w->form == FORM_LINE || w->paint == PAINT_DITHERED ||
        w->paint == PAINT_FAN || w->paint == PAINT_RADIAL_STOPS ||
        w->paint == PAINT_CONIC_STOPS)
        return nullptr;
    struct job *job = new struct job();
    const uint32_t *end = w->shape[0].color;
    job->workload = w;
    job->is_wide = c->bits == 32;
    job->canvas.attach(c->pixels, static_cast<unsigned>(c->width),
                       static_cast<unsigned>(c->height), c->stride);
    job->texture.attach(reinterpret_cast<agg::int8u *>(
                            const_cast<uint32_t *>(workload_texture())),
                        TEXTURE_SIDE, TEXTURE_SIDE, TEXTURE_SIDE * 4);
    if (w->paint != PAINT_SMOOTH)
        job->rasterizer.gamma(agg::gamma_threshold(.5));
    job->gear = workload_gear(w);
    if (workload_is_line(w))
        open_text(job);
    for (int i = 0; i < 256; i++)
        job->ramp[i] = color_of(end[0]).gradient(color_of(end[1]), i / 255.);
    return job;
}

static void draw(void *data, int first, int n)
{
    struct job *job = static_cast<struct job *>(data);
    if (job->is_wide)
        draw_on<agg::pixfmt_bgra32>(job, first, n);
    else
        draw_on<agg::pixfmt_rgb565>(job, first, n);
}

static void close_job(void *data)
{
    delete static_cast<struct job *>(data);
}

extern "C" {
extern const struct method method_agg;
const struct method method_agg = {"agg", "packaged", open_job, draw, close_job};
}
