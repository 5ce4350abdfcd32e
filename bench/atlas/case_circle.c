/* Circles and rings against exact squares. */
#include <stdlib.h>

#include "../methods/circle.h"
#include "cases.h"
#include "sheet.h"

/* Of maps: the largest radius, px, and the most cells. */
enum { CIRCLE_SIDE = 512, CIRCLE_CELLS = 1024 };

/* floor(sqrt(v)) by bisection. */
static int root_of(int v)
{
    int low = 0, high = CIRCLE_MAX + 1;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        if (middle * middle <= v)
            low = middle;
        else
            high = middle;
    }
    return low;
}

static void exact_rows(int r, int half[CIRCLE_MAX + 1])
{
    for (int y = 0; y <= r; y++)
        half[y] = root_of(r * r - y * y);
}

static double pixels_of(const int half[], int r)
{
    double all = 2 * half[0] + 1;
    for (int y = 1; y <= r; y++)
        all += 2 * (2 * half[y] + 1);
    return all;
}

static void put_method(struct atlas *a, const struct circle_method *m, int r)
{
    int exact[CIRCLE_MAX + 1] = {0}, half[CIRCLE_MAX + 1] = {0};
    double wrong = 0;
    exact_rows(r, exact);
    m->rows(r, half);
    for (int y = 0; y <= r; y++)
        wrong += 2. * abs(half[y] - exact[y]) * (y ? 2 : 1);
    atlas_put(a, figure_of(m->name, r, "wrong_ppm",
                           1e6 * wrong / pixels_of(exact, r), "ppm"));
}

static void put_pel(struct atlas *a, int r)
{
    const struct pel_flat flat = PEL_FLAT(PEL_RGB(255, 255, 255));
    const struct pel_point center = {128, 128};
    int half[CIRCLE_MAX + 1] = {0};
    struct sheet s;
    double wrong = 0;
    sheet_open(&s, a, (struct pel_rect){-r - 1, -r - 1, r + 2, r + 2});
    exact_rows(r, half);
    pel_circle(&s.surface, center, PEL_PX(r), &flat.paint);
    const int side = 2 * r + 3;
    for (int i = 0; i < side * side; i++) {
        const int x = abs(i % side - r - 1), y = abs(i / side - r - 1);
        wrong += (s.pixels[i] != 0) != (y <= r && x <= half[y]);
    }
    const struct figure f = figure_of("pel", r, "wrong_ppm",
                                      1e6 * wrong / pixels_of(half, r), "ppm");
    atlas_put(a, f);
    atlas_promise(a, wrong == 0, &f);
    sheet_close(&s);
}

void atlas_circle(struct atlas *a)
{
    for (int r = 1; r <= CIRCLE_MAX; r += r < 32 ? 1 : r / 16) {
        put_pel(a, r);
        for (const struct circle_method *m = circle_methods; m->name; m++)
            put_method(a, m, r);
    }
}

/* The cell k of n that holds a pixel whose distance from the centre is the root
 * of `square`: k n-th parts of the radius, rounded down; by the rule of
 * paint_radial.h the first one that reaches it by k + 1 parts, of whole
 * sub-pixels. */
static int exact_cell(int64_t square, int radius, int n, bool whole)
{
    int low = -1, high = n;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        const int64_t reach = (int64_t)(middle + 1) * radius;
        const bool inside = whole ? square <= (reach / n) * (reach / n)
                                  : square * n * n < reach * reach;
        if (inside)
            high = middle;
        else
            low = middle;
    }
    return high;
}

typedef int cell_method(int x, int y, int radius, int n);

/* A quarter of a gradient of n cells, the centre on a pixel's centre: the cell
 * of every pixel inside the radius. */
struct quarter {
    int r, n;
    uint16_t cell[CIRCLE_SIDE * CIRCLE_SIDE]; /* r x r */
};

static void by_cell(struct quarter *q, cell_method *cell)
{
    for (int i = 0; i < q->r * q->r; i++)
        q->cell[i] =
            (uint16_t)cell(i % q->r * 256, i / q->r * 256, q->r * 256, q->n);
}

static void by_root(struct quarter *q)
{
    by_cell(q, cell_by_root);
}

static void by_table(struct quarter *q)
{
    by_cell(q, cell_by_table);
}

/* Filled circles of whole radii, the largest first. */
static void by_midpoint(struct quarter *q)
{
    int half[CIRCLE_MAX + 1] = {0};
    for (int k = q->n - 1; k >= 0; k--) {
        const int r = (k + 1) * q->r / q->n;
        circle_methods[0].rows(r, half);
        for (int y = 0; y <= r && y < q->r; y++)
            for (int x = 0; x <= half[y] && x < q->r; x++)
                q->cell[y * q->r + x] = (uint16_t)k;
    }
}

/* Cells as colors. */
static void by_pel(struct quarter *q)
{
    static pel_color color[CIRCLE_CELLS];
    static uint32_t pixel[CIRCLE_SIDE * CIRCLE_SIDE];
    const struct pel_ramp ramp = {color, q->n, PEL_PAD};
    const struct pel_rings rings = {{128, 128}, PEL_PX(q->r), 0};
    const struct pel_rect bounds = {0, 0, q->r, q->r};
    const struct pel_point corner[2] = {PEL_AT(0, 0),
                                        {PEL_PX(q->r), PEL_PX(q->r)}};
    struct pel_radial paint;
    struct pel_surface s;
    for (int i = 0; i < q->n; i++)
        color[i] = PEL_RGB(0, i >> 8, i);
    if (pel_surface_init(&s, &pel_xrgb8888, pixel, sizeof pixel, &bounds) ||
        pel_radial_init(&paint, &rings, &ramp))
        method_fail("a radial gradient is refused", "take legal rings");
    pel_rectangle(&s, corner[0], corner[1], &paint.base.paint);
    for (int i = 0; i < q->r * q->r; i++)
        q->cell[i] = (uint16_t)pixel[i];
}

static const struct ring_method {
    const char *name;
    void (*make)(struct quarter *q);
} ring_methods[] = {{"pel", by_pel},
                    {"float32 root", by_root},
                    {"table of 256 roots", by_table},
                    {"midpoint circles", by_midpoint}};

static void put_rings(struct atlas *a, struct quarter *q,
                      const struct ring_method *m)
{
    const bool is_pel = m == ring_methods;
    double wrong = 0, all = 0;
    m->make(q);
    for (int i = 0; i < q->r * q->r; i++) {
        const int x = i % q->r, y = i / q->r;
        const int64_t square = (int64_t)(x * x + y * y) * 65536;
        if (x * x + y * y >= q->r * q->r)
            continue;
        wrong += q->cell[i] != exact_cell(square, q->r * 256, q->n, is_pel);
        all++;
    }
    struct figure f =
        figure_of(m->name, q->r, "wrong_ppm", 1e6 * wrong / all, "ppm");
    f.y = q->n;
    f.has_y = true;
    atlas_put(a, f);
    atlas_promise(a, wrong == 0 || !is_pel, &f);
}

void atlas_map_circle(struct atlas *a)
{
    static struct quarter q;
    for (q.r = 8; q.r <= CIRCLE_SIDE; q.r *= 2)
        for (q.n = 2; q.n <= CIRCLE_CELLS; q.n *= 2)
            for (size_t i = 0; i < sizeof ring_methods / sizeof *ring_methods;
                 i++)
                put_rings(a, &q, &ring_methods[i]);
}
