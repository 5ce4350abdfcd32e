#include "sheet.h"

#include <stdlib.h>
#include <string.h>

#define DRAWN UINT32_C(0xFFFFFFFF)

/* ceil(n / d), d > 0. */
static int64_t ceiling(int64_t n, int64_t d)
{
    return n / d + (n % d > 0);
}

/* The centre of row y lies between the ends of an edge a, b with the weight t
 * of b, 0 <= t < 1: the first pixel on or right of it has x + 1/2 >= a.x + t
 * (b.x - a.x). |a.x| dy + |dx| dy < 2^53 in 2^-16 px up to 1,024 px, too. */
struct pel_span exact_row(const struct pel_point v[3], int32_t y, int bits)
{
    const int64_t one = (int64_t)1 << bits, center = one * y + one / 2;
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
            (a->x - one / 2) * dy + (center - a->y) * (b->x - a->x);
        const int32_t x = (int32_t)ceiling(n, one * dy);
        row.x0 = x < row.x0 ? x : row.x0;
        row.x1 = x > row.x1 ? x : row.x1;
    }
    return row;
}

void sheet_open(struct sheet *s, struct atlas *a, struct pel_rect b)
{
    const size_t size = (size_t)((b.x1 - b.x0) * (b.y1 - b.y0)) * 4;
    s->atlas = a;
    s->pixels = method_allocate(1, size);
    if (pel_surface_init(&s->surface, &pel_xrgb8888, s->pixels, size, &b))
        method_fail("a sheet is not a surface", "take legal bounds");
}

void sheet_move(struct sheet *s, int32_t x, int32_t y)
{
    struct pel_rect *b = &s->surface.bounds;
    b->x1 += x - b->x0;
    b->y1 += y - b->y0;
    b->x0 = x;
    b->y0 = y;
    s->surface.clip = *b;
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
static void note_wrong(const struct sheet *s, const struct pel_point v[3],
                       int32_t x, int32_t y)
{
    enum { AROUND = 2 };
    struct wrong *w = &s->atlas->wrong;
    const int32_t size = size_of(v);
    if (w->size > 0 && size >= w->size)
        return;
    w->size = size;
    memcpy(w->v, v, sizeof w->v);
    w->x = x;
    w->y = y;
    w->bounds = fill_box(&s->surface, v);
    w->bounds.x0 -= AROUND;
    w->bounds.y0 -= AROUND;
    w->bounds.x1 += AROUND;
    w->bounds.y1 += AROUND;
}

static int32_t count_drawn(const uint32_t *line, int32_t n)
{
    int32_t drawn = 0;
    for (int32_t i = 0; i < n; i++)
        drawn += line[i] != 0;
    return drawn;
}

/* The first pixel from x on that is drawn and should not be, or the other way
 * round; there is one. */
static int32_t first_wrong(const uint32_t *line, struct pel_span exact)
{
    int32_t x = 0;
    while ((line[x] != 0) == (x >= exact.x0 && x < exact.x1))
        x++;
    return x;
}

/* Wrong pixels of a row, which is cleared; the first one to *first. `exact` is
 * inside the bounds. */
static int32_t row_wrong(const struct pel_surface *s, int32_t y,
                         struct pel_span exact, int32_t *first)
{
    uint32_t *line = (uint32_t *)(void *)pel_surface_line(s, y);
    const int32_t left = s->bounds.x0, width = s->bounds.x1 - left;
    const struct pel_span span = {exact.x0 - left, exact.x1 - left};
    const int32_t length = span.x1 - span.x0;
    const int32_t drawn = count_drawn(line, width);
    const int32_t right = count_drawn(line + span.x0, length);
    const int32_t wrong = drawn - right + length - right;
    if (wrong)
        *first = left + first_wrong(line, span);
    if (drawn)
        memset(line, 0, (size_t)width * 4);
    return wrong;
}

void sheet_judge(struct sheet *s, const struct fill_method *m,
                 const struct pel_point v[3], struct tally *t)
{
    const struct pel_rect *b = &s->surface.bounds;
    struct pel_point kept[3];
    struct atlas *a = s->atlas;
    const bool asked = a->smallest && strcmp(m->name, a->smallest) == 0;
    double wrong = 0;
    a->judged |= asked;
    for (int i = 0; i < 3; i++) {
        kept[i].x = (v[i].x >> (8 - m->bits)) * (1 << (8 - m->bits));
        kept[i].y = (v[i].y >> (8 - m->bits)) * (1 << (8 - m->bits));
    }
    m->draw(&s->surface, kept, DRAWN);
    for (int32_t y = b->y0; y < b->y1; y++) {
        struct pel_span exact = exact_row(kept, y, 8);
        exact.x0 = pel_min(pel_max(exact.x0, b->x0), b->x1);
        exact.x1 = pel_max(exact.x0, pel_min(exact.x1, b->x1));
        int32_t first = 0;
        const int32_t more = row_wrong(&s->surface, y, exact, &first);
        if (more && asked)
            note_wrong(s, kept, first, y);
        wrong += more;
        t->covered += exact.x1 - exact.x0;
    }
    t->wrong += wrong;
    t->damaged += wrong > 0;
    t->triangles++;
}

void tally_put(struct atlas *a, const struct fill_method *m,
               const struct tally *t, struct figure f)
{
    f.method = m->name;
    f.value = t->covered > 0 ? 1e6 * t->wrong / t->covered : 0;
    f.unit = "ppm";
    atlas_put(a, f);
    if (fill_is_pel(m))
        atlas_promise(a, t->wrong == 0, &f);
}
