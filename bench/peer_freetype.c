/* FreeType's smooth rasterizer, as text engines use it: an outline in 1/64 px,
 * whose runs of equal coverage are mixed into the canvas; letters that it has
 * drawn before are mixed from their pictures. */
#include "method.h"

#include <stdlib.h>

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H
#include FT_GLYPH_H

/* A circle is twelve points: corners and control points of four cubic curves.
 */
enum { POINTS = GEAR_SIDES, CIRCLE_POINTS = 12 };

struct job {
    const struct workload *workload;
    const struct canvas *canvas;
    const struct offset *gear;
    FT_Library library;
    FT_Outline outline;
    FT_Vector point[POINTS];
    char tag[POINTS];
    short contour;
    struct workload_line line;
    FT_Glyph glyph[sizeof TEXT_LINE];
};

static uint32_t mix(uint32_t below, uint32_t above, uint32_t coverage)
{
    const uint32_t sum = below * (255 - coverage) + above * coverage + 128;
    return (sum + (sum >> 8)) >> 8;
}

/* White over a pixel. */
static void put(const struct canvas *c, uint8_t *p, uint32_t level)
{
    if (c->bits == 32) {
        for (int k = 0; k < 3; k++)
            p[k] = (uint8_t)mix(p[k], 255, level);
    } else {
        uint16_t *pixel = (uint16_t *)(void *)p;
        *pixel = (uint16_t)(mix(*pixel >> 11, 31, level) << 11 |
                            mix(*pixel >> 5 & 63, 63, level) << 5 |
                            mix(*pixel & 31, 31, level));
    }
}

/* FreeType counts rows from below. */
static void draw_runs(int y, int count, const FT_Span *span, void *user)
{
    const struct job *job = user;
    const struct canvas *c = job->canvas;
    for (; count > 0; count--, span++) {
        uint8_t *p = canvas_address(c, span->x, c->height - 1 - y);
        for (int i = 0; i < span->len; i++, p += c->bits / 8) {
            if (span->coverage < 255)
                put(c, p, span->coverage);
            else if (c->bits == 32)
                *(uint32_t *)(void *)p = 0xFFFFFFFFu;
            else
                *(uint16_t *)(void *)p = 0xFFFFu;
        }
    }
}

static void set_point(struct job *job, int k, double x, double y)
{
    job->point[k].x = (FT_Pos)(x * 64 + .5);
    job->point[k].y = (FT_Pos)((job->canvas->height - y) * 64 + .5);
}

static void set_circle(struct job *job, double x, double y)
{
    static const int corner[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    const double r = job->workload->size, control = r * .5522847498;
    for (int k = 0; k < 4; k++) {
        const int *from = corner[k], *to = corner[(k + 1) % 4];
        set_point(job, 3 * k, x + r * from[0], y + r * from[1]);
        set_point(job, 3 * k + 1, x + r * from[0] + control * to[0],
                  y + r * from[1] + control * to[1]);
        set_point(job, 3 * k + 2, x + r * to[0] + control * from[0],
                  y + r * to[1] + control * from[1]);
    }
}

static void set_outline(struct job *job, const struct shape *s)
{
    const double x = s->x[0] + .5, y = s->y[0] + .5;
    if (job->workload->form == FORM_CIRCLE)
        set_circle(job, x, y);
    else if (job->workload->form == FORM_GEAR)
        for (int k = 0; k < GEAR_SIDES; k++)
            set_point(job, k, x + job->gear[k].x / 256.,
                      y + job->gear[k].y / 256.);
    else
        for (int k = 0; k < 3; k++)
            set_point(job, k, s->x[k], s->y[k]);
}

static void fail_if(FT_Error error)
{
    if (error)
        method_fail("FreeType fails", "check its installation and " TEXT_FONT);
}

/* Unhinted letters, their pictures made of outlines where these are not asked
 * for. */
static void open_text(struct job *job)
{
    FT_Face face;
    job->line = workload_line(job->workload);
    fail_if(FT_New_Face(job->library, TEXT_FONT, 0, &face));
    fail_if(FT_Set_Char_Size(face, 0, (FT_F26Dot6)(job->line.em * 64 + .5), 72,
                             72));
    for (int k = 0; k < job->line.letters; k++) {
        fail_if(FT_Load_Char(face, (FT_ULong)job->line.text[k],
                             FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP));
        fail_if(FT_Get_Glyph(face->glyph, &job->glyph[k]));
        if (job->workload->form != FORM_OUTLINES)
            fail_if(FT_Glyph_To_Bitmap(&job->glyph[k], FT_RENDER_MODE_NORMAL,
                                       NULL, 1));
    }
}

static void draw_outline(const struct job *job, FT_Outline *outline)
{
    const struct canvas *c = job->canvas;
    FT_Raster_Params params = {.flags = FT_RASTER_FLAG_AA |
                                        FT_RASTER_FLAG_DIRECT |
                                        FT_RASTER_FLAG_CLIP,
                               .gray_spans = draw_runs,
                               .user = (void *)(uintptr_t)job,
                               .clip_box = {0, 0, c->width, c->height}};
    fail_if(FT_Outline_Render(job->library, outline, &params));
}

/* There and back again: translated without a copy. */
static void draw_letter(const struct job *job, int k, const struct shape *s)
{
    FT_Outline *outline = &((FT_OutlineGlyph)job->glyph[k])->outline;
    const FT_Pos x = (FT_Pos)((s->x[0] + k * job->line.advance) * 64 + .5);
    const FT_Pos y = (job->canvas->height - s->y[0] - job->workload->size) * 64;
    FT_Outline_Translate(outline, x, y);
    draw_outline(job, outline);
    FT_Outline_Translate(outline, -x, -y);
}

static void draw_picture(const struct job *job, int k, const struct shape *s)
{
    const struct canvas *c = job->canvas;
    const FT_BitmapGlyph glyph = (FT_BitmapGlyph)job->glyph[k];
    const FT_Bitmap *b = &glyph->bitmap;
    const int x = s->x[0] + k * (int)job->line.advance + glyph->left;
    const int y = s->y[0] + job->workload->size - glyph->top;
    for (int row = 0; row < (int)b->rows; row++) {
        const uint8_t *level = b->buffer + row * b->pitch;
        uint8_t *p = canvas_address(c, x, y + row);
        for (unsigned i = 0; i < b->width; i++, p += c->bits / 8)
            if (level[i])
                put(c, p, level[i]);
    }
}

static void *open_job(const struct workload *w, const struct canvas *c)
{
    if (w->paint != PAINT_SMOOTH || w->form == FORM_STROKE)
        return NULL;
    struct job *job = method_allocate(1, sizeof *job);
    const int points = w->form == FORM_CIRCLE ? CIRCLE_POINTS
                       : w->form == FORM_GEAR ? GEAR_SIDES
                                              : 3;
    job->workload = w;
    job->canvas = c;
    job->gear = workload_gear(w);
    job->contour = (short)(points - 1);
    for (int k = 0; k < points; k++)
        job->tag[k] = w->form == FORM_CIRCLE && k % 3 != 0 ? FT_CURVE_TAG_CUBIC
                                                           : FT_CURVE_TAG_ON;
    job->outline = (FT_Outline){.n_contours = 1,
                                .n_points = (short)points,
                                .points = job->point,
                                .tags = job->tag,
                                .contours = &job->contour};
    fail_if(FT_Init_FreeType(&job->library));
    if (workload_is_line(w))
        open_text(job);
    return job;
}

static void draw(void *data, int first, int n)
{
    struct job *job = data;
    for (const struct shape *s = job->workload->shape + first; n > 0;
         n--, s++) {
        for (int k = 0; k < job->line.letters; k++)
            (job->workload->form == FORM_OUTLINES ? draw_letter
                                                  : draw_picture)(job, k, s);
        if (job->line.letters == 0) {
            set_outline(job, s);
            draw_outline(job, &job->outline);
        }
    }
}

static void close_job(void *data)
{
    struct job *job = data;
    for (int k = 0; k < job->line.letters; k++)
        FT_Done_Glyph(job->glyph[k]);
    FT_Done_FreeType(job->library);
    free(job);
}

extern const struct method method_freetype;
const struct method method_freetype = {"freetype", "packaged", open_job, draw,
                                       close_job};
