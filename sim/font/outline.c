#include "sim/font/outline.h"

#include <stdlib.h>

#include "core/pel.h"
#include "sim/cli/list.h"
#include "sim/cli/message.h"

/* Straight parts of a curve: of one that is FONT_SIZE_MAX px long they are less
 * than 1/16 px off. */
enum { PARTS = 32 };

/* All contours as one: lines to and from the first point join them, and cancel
 * each other. */
struct drawing {
    struct pel_point *point;
    size_t count;
    FT_Vector at;           /* 1/64 px, as FreeType counts: y grows upwards */
    struct pel_point begin; /* of the contour */
    int left, top;          /* px of the picture's corner */
    bool failed;
};

static void add(struct drawing *d, struct pel_point p)
{
    d->failed = d->failed || !list_add(&d->point, &d->count, &p, sizeof p);
}

static struct pel_point place(const struct drawing *d, double x, double y)
{
    return (struct pel_point){
        (int32_t)(x * 4 + (x < 0 ? -.5 : .5)) - d->left * 256,
        d->top * 256 - (int32_t)(y * 4 + (y < 0 ? -.5 : .5))};
}

static void close_contour(struct drawing *d)
{
    if (d->count == 0)
        return;
    add(d, d->begin);
    if (!d->failed)
        add(d, d->point[0]);
}

static int move_to(const FT_Vector *to, void *user)
{
    struct drawing *d = user;
    close_contour(d);
    d->at = *to;
    d->begin = place(d, (double)to->x, (double)to->y);
    add(d, d->begin);
    return d->failed;
}

/* A curve from p[0] to p[order], by cutting the lines between its points. */
static int curve_to(struct drawing *d, const FT_Vector *p, int order)
{
    for (int i = 1; i <= PARTS; i++) {
        double x[4], y[4];
        for (int k = 0; k <= order; k++) {
            x[k] = (double)p[k].x;
            y[k] = (double)p[k].y;
        }
        for (int n = order; n > 0; n--)
            for (int k = 0; k < n; k++) {
                x[k] += (x[k + 1] - x[k]) * i / PARTS;
                y[k] += (y[k + 1] - y[k]) * i / PARTS;
            }
        add(d, place(d, x[0], y[0]));
    }
    d->at = p[order];
    return d->failed;
}

static int conic_to(const FT_Vector *b, const FT_Vector *to, void *user)
{
    struct drawing *d = user;
    const FT_Vector p[] = {d->at, *b, *to};
    return curve_to(d, p, 2);
}

static int cubic_to(const FT_Vector *b, const FT_Vector *c, const FT_Vector *to,
                    void *user)
{
    struct drawing *d = user;
    const FT_Vector p[] = {d->at, *b, *c, *to};
    return curve_to(d, p, 3);
}

static int line_to(const FT_Vector *to, void *user)
{
    struct drawing *d = user;
    d->at = *to;
    add(d, place(d, (double)to->x, (double)to->y));
    return d->failed;
}

static bool fill(const struct drawing *d, const struct font_char *c,
                 uint8_t *level, size_t size)
{
    const struct pel_flat white = PEL_FLAT(PEL_RGB(255, 255, 255));
    const struct pel_polygon_shape outline = {d->point, (int32_t)d->count,
                                              PEL_NON_ZERO};
    const size_t scratch_size =
        PEL_SMOOTH_POLYGON_SCRATCH_SIZE(d->count, c->width);
    void *scratch = malloc(scratch_size);
    struct pel_surface s;
    const bool done =
        scratch &&
        pel_surface_init(&s, &pel_gray8, level, size,
                         &(struct pel_rect){0, 0, c->width, c->height}) ==
            PEL_OK &&
        pel_smooth_polygon(&s, &outline, &white.paint, scratch, scratch_size) ==
            PEL_OK;
    free(scratch);
    return done;
}

uint8_t *outline_draw(FT_Outline *outline, struct font_char *c)
{
    static const FT_Outline_Funcs functions = {move_to,  line_to, conic_to,
                                               cubic_to, 0,       0};
    FT_BBox box;
    FT_Outline_Get_CBox(outline, &box);
    struct drawing d = {.left = (int)(box.xMin >> 6),
                        .top = (int)((box.yMax + 63) >> 6)};
    c->left = d.left;
    c->top = d.top;
    c->width = (int)((box.xMax + 63) >> 6) - d.left;
    c->height = d.top - (int)(box.yMin >> 6);
    const bool is_seen = c->width > 0 && c->height > 0 &&
                         c->width <= FONT_SIZE_MAX &&
                         c->height <= FONT_SIZE_MAX;
    const size_t size = is_seen ? (size_t)c->width * (size_t)c->height : 0;
    uint8_t *level = calloc(size + 1, 1);
    bool done = level != NULL;
    if (done && is_seen) {
        done = FT_Outline_Decompose(outline, &functions, &d) == 0;
        close_contour(&d);
        done = done && !d.failed && fill(&d, c, level, size);
    }
    free(d.point);
    if (done)
        return level;
    free(level);
    message_error("out of memory");
    return NULL;
}
