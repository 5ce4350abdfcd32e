#include "sheet.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define DRAWN UINT32_C(0xFFFFFFFF)

/* ceil(n / d), d > 0. */
static int64_t ceiling(int64_t n, int64_t d)
{
    return n / d + (n % d > 0);
}

/* The centre of row y lies between the ends of an edge a, b with the weight t
 * of b, 0 <= t < 1: the first pixel on or right of it has 256 x + 128 >= a.x +
 * t (b.x - a.x). |a.x| dy + |dx| dy < 2^50. */
struct pel_span exact_row(const struct pel_point v[3], int32_t y)
{
    const int64_t center = 256 * (int64_t)y + 128;
    struct pel_span row = {INT32_MAX, INT32_MIN};
    for (int i = 0; i < 3; i++) {
        const struct pel_point *a = &v[i], *b = &v[(i + 1) % 3];
        if (a->y > b->y) {
            const struct pel_point *other = a;
            a = b;
            b = other;
        }
        if (center < a->y || center >= b->y)
            continue;
        const int64_t dy = b->y - a->y;
        const int64_t n =
            ((int64_t)a->x - 128) * dy + (center - a->y) * (b->x - a->x);
        const int32_t x = (int32_t)ceiling(n, 256 * dy);
        row.x0 = x < row.x0 ? x : row.x0;
        row.x1 = x > row.x1 ? x : row.x1;
    }
    return row;
}

void sheet_open(struct sheet *s, struct pel_rect b)
{
    const size_t size = (size_t)((b.x1 - b.x0) * (b.y1 - b.y0)) * 4;
    s->pixels = method_allocate(1, size);
    s->smallest_size = INT32_MAX;
    if (pel_surface_init(&s->surface, &pel_xrgb8888, s->pixels, size, &b))
        method_fail("a sheet is not a surface", "take legal bounds");
}

void sheet_close(struct sheet *s)
{
    free(s->pixels);
}

static int32_t size_of(const struct pel_point v[3])
{
    int32_t size = 0;
    for (int i = 0; i < 3; i++)
        size += abs(v[i].x - v[(i + 1) % 3].x) + abs(v[i].y - v[(i + 1) % 3].y);
    return size;
}

/* Keeps the triangle if it is the smallest. */
static void note_wrong(struct sheet *s, const struct pel_point v[3], int32_t x,
                       int32_t y)
{
    const int32_t size = size_of(v);
    if (size >= s->smallest_size)
        return;
    s->smallest_size = size;
    memcpy(s->smallest, v, sizeof s->smallest);
    s->wrong_x = x;
    s->wrong_y = y;
}

/* Wrong pixels of a row, which is cleared; the first one to *first. */
static int32_t row_wrong(const struct pel_surface *s, int32_t y,
                         struct pel_span exact, int32_t *first)
{
    uint32_t *line = (uint32_t *)(void *)pel_surface_line(s, y);
    int32_t wrong = 0;
    for (int32_t x = s->bounds.x0; x < s->bounds.x1; x++) {
        const bool drawn = line[x - s->bounds.x0] != 0;
        const bool is_wrong = drawn != (x >= exact.x0 && x < exact.x1);
        if (is_wrong && wrong == 0)
            *first = x;
        wrong += is_wrong;
    }
    memset(line, 0, (size_t)(s->bounds.x1 - s->bounds.x0) * 4);
    return wrong;
}

void sheet_judge(struct sheet *s, const struct fill_method *m,
                 const struct pel_point v[3], struct tally *t)
{
    const struct pel_rect *b = &s->surface.bounds;
    struct pel_point kept[3];
    double wrong = 0;
    for (int i = 0; i < 3; i++) {
        kept[i].x = (v[i].x >> (8 - m->bits)) * (1 << (8 - m->bits));
        kept[i].y = (v[i].y >> (8 - m->bits)) * (1 << (8 - m->bits));
    }
    m->draw(&s->surface, kept, DRAWN);
    for (int32_t y = b->y0; y < b->y1; y++) {
        const struct pel_span exact = exact_row(kept, y);
        const int32_t x0 = pel_max(exact.x0, b->x0);
        const int32_t x1 = pel_min(exact.x1, b->x1);
        int32_t first = 0;
        const int32_t more = row_wrong(&s->surface, y, exact, &first);
        if (more)
            note_wrong(s, kept, first, y);
        wrong += more;
        t->covered += x1 > x0 ? x1 - x0 : 0;
    }
    t->wrong += wrong;
    t->damaged += wrong > 0;
    t->triangles++;
}

/* On a canvas of its own, which shows what the sheet does. */
static void print_smallest(const struct sheet *s, const struct fill_method *m)
{
    const struct pel_point *v = s->smallest;
    const struct pel_rect box = fill_box(&s->surface, v);
    const int32_t left = box.x0 - 2, top = box.y0 - 2;
    printf(
        "# The smallest triangle of the case that is drawn wrong by: %s.\n"
        "# It fails at an offset of %d %d px; its first wrong pixel is %d %d "
        "here.\n",
        m->name, (int)left, (int)top, (int)(s->wrong_x - left),
        (int)(s->wrong_y - top));
    printf("canvas %d %d xrgb8888\nclear #000000\npaint flat #ffffff\ntriangle",
           (int)(box.x1 - left + 2), (int)(box.y1 - top + 2));
    for (int i = 0; i < 3; i++)
        printf(" %.8f %.8f", v[i].x / 256.0 - left, v[i].y / 256.0 - top);
    printf("\n");
}

void sheet_report(struct atlas *a, const struct sheet *s,
                  const struct fill_method *m, const struct tally *t,
                  struct figure f)
{
    f.method = m->name;
    f.value = t->covered > 0 ? 1e6 * t->wrong / t->covered : 0;
    f.unit = "ppm";
    atlas_put(a, f);
    if (fill_is_pel(m))
        atlas_promise(a, t->wrong == 0, &f);
    if (a->smallest && strcmp(a->smallest, m->name) == 0 &&
        s->smallest_size < INT32_MAX)
        print_smallest(s, m);
}
