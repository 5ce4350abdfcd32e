/* Three edge functions in float32 at every pixel of the box: the weights of the
 * vertices. Without a tie rule a centre on an edge belongs to both sides. */
#include "fill.h"

struct line {
    float x, y, dx, dy; /* px */
    bool owned;         /* a top or left edge */
};

/* Lines with the inside where the value is positive. */
static void lines_of(const struct pel_point v[3], struct line line[3])
{
    const bool clockwise = pel_triangle_area(v) > 0;
    for (int i = 0; i < 3; i++) {
        const struct pel_point *a = &v[clockwise ? i : (i + 1) % 3];
        const struct pel_point *b = &v[clockwise ? (i + 1) % 3 : i];
        const struct line l = {(float)a->x / 256, (float)a->y / 256,
                               (float)(b->x - a->x) / 256,
                               (float)(b->y - a->y) / 256,
                               b->y < a->y || (b->y == a->y && b->x > a->x)};
        line[i] = l;
    }
}

static PEL_ALWAYS_INLINE float value_at(const struct line *l, float x, float y)
{
    return l->dx * (y - l->y) - l->dy * (x - l->x);
}

enum kind { PLAIN, TIES, DERIVED };

static PEL_ALWAYS_INLINE bool inside(const struct line line[3], enum kind kind,
                                     float inverse, float x, float y)
{
    const float a = value_at(&line[0], x, y), b = value_at(&line[1], x, y);
    if (kind == DERIVED) {
        const float u = a * inverse, v = b * inverse;
        return u >= 0 && v >= 0 && 1 - u - v >= 0;
    }
    const float c = value_at(&line[2], x, y);
    if (kind == PLAIN)
        return a >= 0 && b >= 0 && c >= 0;
    return (a > 0 || (a == 0 && line[0].owned)) &&
           (b > 0 || (b == 0 && line[1].owned)) &&
           (c > 0 || (c == 0 && line[2].owned));
}

static PEL_ALWAYS_INLINE void draw(const struct pel_surface *s,
                                   const struct pel_point v[3], uint32_t pixel,
                                   enum kind kind)
{
    struct line line[3];
    const struct pel_rect box = fill_box(s, v);
    const int64_t area = pel_triangle_area(v);
    if (area == 0)
        return;
    const float inverse = 65536 / (float)(area < 0 ? -area : area);
    lines_of(v, line);
    for (int32_t y = box.y0; y < box.y1; y++) {
        uint32_t *row = (uint32_t *)(void *)pel_surface_line(s, y);
        row -= s->bounds.x0;
        for (int32_t x = box.x0; x < box.x1; x++)
            if (inside(line, kind, inverse, (float)x + 0.5f, (float)y + 0.5f))
                row[x] = pixel;
    }
}

static void draw_plain(const struct pel_surface *s, const struct pel_point v[3],
                       uint32_t pixel)
{
    draw(s, v, pixel, PLAIN);
}

static void draw_ties(const struct pel_surface *s, const struct pel_point v[3],
                      uint32_t pixel)
{
    draw(s, v, pixel, TIES);
}

static void draw_derived(const struct pel_surface *s,
                         const struct pel_point v[3], uint32_t pixel)
{
    draw(s, v, pixel, DERIVED);
}

const struct fill_method fill_barycentric = {"float32 barycentric", 8,
                                             draw_plain};
const struct fill_method fill_barycentric_ties = {
    "float32 barycentric with ties", 8, draw_ties};
const struct fill_method fill_barycentric_derived = {
    "float32 barycentric w2 = 1 - w0 - w1", 8, draw_derived};
