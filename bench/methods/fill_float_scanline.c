/* Edges in float32, the crossing rounded by (int)(x + 0.5): computed anew for
 * every row, or stepped by an addition. */
#include "scanline.h"

static void start(struct walk *w, const struct pel_point *a,
                  const struct pel_point *b)
{
    const float ax = (float)a->x / 256, ay = (float)a->y / 256;
    const float bx = (float)b->x / 256, by = (float)b->y / 256;
    const int32_t row = pel_first_pixel(a->y);
    w->step = (bx - ax) / (by - ay);
    w->y = (float)row + 0.5f - ay;
    w->x = ax;
}

static void start_stepped(struct walk *w, const struct pel_point *a,
                          const struct pel_point *b)
{
    start(w, a, b);
    w->x += w->step * w->y;
}

static void next(struct walk *w)
{
    w->y++;
}

static void next_stepped(struct walk *w)
{
    w->x += w->step;
}

static int32_t rounded(float x)
{
    const int32_t whole = (int32_t)(x + 0.5f);
    return whole - ((float)whole > x + 0.5f);
}

static int32_t pixel_of(const struct walk *w)
{
    return rounded(w->x + w->step * w->y);
}

static int32_t pixel_stepped(const struct walk *w)
{
    return rounded(w->x);
}

static void draw(const struct pel_surface *s, const struct pel_point v[3],
                 uint32_t pixel)
{
    static const struct scanline kind = {start, next, pixel_of};
    scanline_draw(s, &kind, v, pixel);
}

static void draw_stepped(const struct pel_surface *s,
                         const struct pel_point v[3], uint32_t pixel)
{
    static const struct scanline kind = {start_stepped, next_stepped,
                                         pixel_stepped};
    scanline_draw(s, &kind, v, pixel);
}

const struct fill_method fill_float_scanline = {"float32 scanline", 8, draw};
const struct fill_method fill_float_stepped = {"float32 scanline stepped", 8,
                                               draw_stepped};
