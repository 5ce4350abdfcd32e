#include "exact_area.h"

/* Of the part of an edge that lies in the pixel's row, from (xa, ya) to (xb,
 * yb), pixels from its left top corner: the integral of the width right of it,
 * 0..1, which is linear between the sides of the pixel. Coordinates have 42
 * bits at most, divisions round once: 2^-40 in all. */
static long double area_in_row(long double xa, long double ya, long double xb,
                               long double yb)
{
    if (xa > xb) { /* mirrored in y: the same integral */
        const long double x = xa;
        xa = xb;
        xb = x;
    }
    const long double h = yb - ya;
    const long double l = xa < 0 ? 0 : xa > 1 ? 1 : xa;
    const long double r = xb < 0 ? 0 : xb > 1 ? 1 : xb;
    if (xb <= 0)
        return h;
    if (xa >= 1)
        return 0;
    if (xa == xb)
        return h * (1 - xa);
    const long double slope = h / (xb - xa);
    return (l - xa) * slope + (r - l) * slope * (1 - (l + r) / 2);
}

/* The part of pixel (x, y) that lies right of the edge from a to b: positive
 * when it goes down. The sum over all edges is the area, or the negative. */
static long double right_of(const struct pel_point *a,
                            const struct pel_point *b, int32_t x, int32_t y)
{
    const long double sign = a->y < b->y ? 1 : -1;
    if (a->y > b->y) {
        const struct pel_point *const t = a;
        a = b;
        b = t;
    }
    const int32_t top = pel_max(a->y, 256 * y);
    const int32_t bottom = pel_min(b->y, 256 * y + 256);
    if (top >= bottom)
        return 0;
    const long double dx = b->x - a->x, dy = b->y - a->y;
    const long double at = (a->x - 256 * x) / 256.0L;
    return sign * area_in_row(at + dx * (top - a->y) / dy / 256,
                              (top - 256 * y) / 256.0L,
                              at + dx * (bottom - a->y) / dy / 256,
                              (bottom - 256 * y) / 256.0L);
}

long double exact_area(const struct pel_point *v, int32_t n, int32_t x,
                       int32_t y, int *edges)
{
    long double area = 0;
    *edges = 0;
    for (int32_t i = 0, k = n - 1; i < n; k = i++) {
        const long double left = right_of(&v[k], &v[i], x - 1, y);
        const long double here = right_of(&v[k], &v[i], x, y);
        area += here;
        *edges += here != 0 && here != left;
    }
    return area < 0 ? -area : area;
}

enum { MOST = 16, CUTS = 2 * MOST + MOST * MOST };

struct side {
    long double x0, y0, x1, y1; /* downwards, px from the pixel's corner */
    int winding;
};

struct sides {
    struct side side[MOST];
    int n, mask; /* of the winding number */
};

static long double x_of(const struct side *s, long double y)
{
    return s->x0 + (s->x1 - s->x0) * (y - s->y0) / (s->y1 - s->y0);
}

static int cut_at(long double *cut, int n, long double y)
{
    if (y <= 0 || y >= 1)
        return n;
    int i = n;
    for (; i > 0 && cut[i - 1] > y; i--)
        cut[i] = cut[i - 1];
    cut[i] = y;
    return n + 1;
}

/* All ends and crossings inside the row, sorted; how many, with both sides. */
static int cuts_of(const struct side *side, int n, long double *cut)
{
    int count = 0;
    for (int i = 0; i < n; i++) {
        count = cut_at(cut, count, side[i].y0);
        count = cut_at(cut, count, side[i].y1);
        for (int k = 0; k < i; k++) {
            const struct side *a = &side[i], *b = &side[k];
            const long double sa = (a->x1 - a->x0) / (a->y1 - a->y0);
            const long double sb = (b->x1 - b->x0) / (b->y1 - b->y0);
            const long double y =
                (b->x0 - b->y0 * sb - a->x0 + a->y0 * sa) / (sa - sb);
            if (sa != sb && y > a->y0 && y < a->y1 && y > b->y0 && y < b->y1)
                count = cut_at(cut, count, y);
        }
    }
    cut[count] = 1;
    return count + 1;
}

static int sides_of(const struct pel_polygon_shape *p, int32_t x, int32_t y,
                    struct side *side)
{
    int n = 0;
    for (int32_t i = 0, k = p->n - 1; i < p->n; k = i++) {
        const bool up = p->v[k].y > p->v[i].y;
        const struct pel_point *const a = &p->v[up ? i : k];
        const struct pel_point *const b = &p->v[up ? k : i];
        if (b->y > 256 * y && a->y < 256 * y + 256 && a->y < b->y)
            side[n++] = (struct side){(a->x - 256 * x) / 256.0L,
                                      (a->y - 256 * y) / 256.0L,
                                      (b->x - 256 * x) / 256.0L,
                                      (b->y - 256 * y) / 256.0L, up ? -1 : 1};
    }
    return n;
}

/* Between two cuts: the sides in order of x, of which those count where the
 * rule changes. */
static long double area_of_part(const struct sides *sides, long double top,
                                long double bottom, int *pieces)
{
    const struct side *const side = sides->side;
    const int n = sides->n, mask = sides->mask;
    const struct side *live[MOST];
    const long double middle = (top + bottom) / 2;
    long double area = 0;
    int count = 0, winding = 0;
    for (int i = 0; i < n; i++) {
        int k = count;
        if (side[i].y0 > middle || side[i].y1 < middle)
            continue;
        for (; k > 0 && x_of(live[k - 1], middle) > x_of(&side[i], middle); k--)
            live[k] = live[k - 1];
        live[k] = &side[i];
        count++;
    }
    for (int i = 0; i < count; i++) {
        const bool outside = (winding & mask) == 0;
        const long double x0 = x_of(live[i], top), x1 = x_of(live[i], bottom);
        winding += live[i]->winding;
        if (outside != ((winding & mask) == 0))
            area += (outside ? 1 : -1) * area_in_row(x0, top, x1, bottom);
        *pieces += !((x0 < 0 && x1 < 0) || (x0 > 1 && x1 > 1));
    }
    return area;
}

long double exact_polygon_area(const struct pel_polygon_shape *p, int32_t x,
                               int32_t y, int *pieces)
{
    struct sides sides = {.mask = p->rule == PEL_EVEN_ODD ? 1 : -1};
    long double cut[CUTS], top = 0, area = 0;
    sides.n = sides_of(p, x, y, sides.side);
    const int cuts = cuts_of(sides.side, sides.n, cut);
    *pieces = 0;
    for (int i = 0; i < cuts; top = cut[i++])
        if (cut[i] > top)
            area += area_of_part(&sides, top, cut[i], pieces);
    return area;
}
