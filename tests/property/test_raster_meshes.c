/* Meshes of triangles, polygons and both: every pixel of the mesh is hit once,
 * and no other; opaque and with alpha, in every format. */
#include "tests/support/canvas.h"
#include "tests/support/check.h"
#include "tests/support/hits.h"
#include "tests/support/shapes.h"

enum { CELLS = 12, MESH_PX = 100 };

/* A grid of cells whose inner corners are moved by less than a quarter of a
 * cell; its outline is a rectangle. */
struct mesh {
    struct pel_point v[CELLS + 1][CELLS + 1];
    int32_t columns, rows;
    struct pel_rect outline;       /* sub-pixels */
    uint8_t cut[CELLS][CELLS + 1]; /* how each cell is made */
};

enum cut { CUT_DOWN, CUT_UP, CUT_QUAD, CUT_FAN, CUT_STRIP, CUTS };

static int32_t random_cell(struct random *r)
{
    static const int32_t size[] = {768, 384, 256, 128, 640, 1024, 1877, 2048};
    if (random_word(r) % 2)
        return size[random_word(r) % 8];
    return random_between(r, 20, 2040);
}

static void mesh_random(struct random *r, struct mesh *m)
{
    const int32_t cell = random_cell(r),
                  origin = random_between(r, -9000, 9000);
    const int32_t lattice = random_word(r) % 2 ? 128 : 1;
    const struct pel_point o = {origin / lattice * lattice,
                                random_between(r, -400, 400) / lattice *
                                    lattice};
    const int32_t shake = random_word(r) % 3 ? cell / 4 - 1 : 0;
    m->columns = random_between(r, 1, CELLS);
    m->rows = random_between(r, 1, CELLS);
    for (int32_t j = 0; j <= m->rows; j++)
        for (int32_t i = 0; i <= m->columns; i++) {
            struct pel_point *v = &m->v[j][i];
            *v = (struct pel_point){o.x + i * cell, o.y + j * cell};
            m->cut[pel_min(j, CELLS - 1)][i] = (uint8_t)(random_word(r) % CUTS);
            if (i > 0 && i < m->columns)
                v->x += random_between(r, -shake, shake) / lattice * lattice;
            if (j > 0 && j < m->rows)
                v->y += random_between(r, -shake, shake) / lattice * lattice;
        }
    m->outline = (struct pel_rect){o.x, o.y, o.x + m->columns * cell,
                                   o.y + m->rows * cell};
}

static void polygon(const struct pel_surface *s, const struct pel_point *v,
                    int32_t n, const struct pel_paint *paint)
{
    uint32_t scratch[16 * (2 * CELLS + 2)];
    const struct pel_polygon_shape outline = {
        v, n, n % 2 ? PEL_NON_ZERO : PEL_EVEN_ODD};
    assert_int_equal(pel_polygon(s, &outline, paint, scratch, sizeof scratch),
                     PEL_OK);
}

static void draw_cell(const struct mesh *m, int32_t i, int32_t j,
                      const struct pel_surface *s,
                      const struct pel_paint *paint)
{
    const struct pel_point q[4] = {m->v[j][i], m->v[j][i + 1],
                                   m->v[j + 1][i + 1], m->v[j + 1][i]};
    const struct pel_point center = {(q[0].x + q[1].x + q[2].x + q[3].x) / 4,
                                     (q[0].y + q[1].y + q[2].y + q[3].y) / 4};
    const int32_t first = m->cut[j][i] == CUT_UP;
    if (m->cut[j][i] == CUT_QUAD) {
        polygon(s, q, 4, paint);
        return;
    }
    for (int32_t k = 0; k < 4; k++) {
        const struct pel_point fan[3] = {q[k], q[(k + 1) % 4], center};
        const struct pel_point half[3] = {
            q[(k + first) % 4], q[(k + first + 1) % 4], q[(k + first + 2) % 4]};
        if (m->cut[j][i] == CUT_FAN)
            pel_triangle(s, fan, paint);
        else if (k % 2 == 0)
            pel_triangle(s, half, paint);
    }
}

/* From column i on, the longest run of cells of one polygon. */
static int32_t draw_strip(const struct mesh *m, int32_t i, int32_t j,
                          const struct pel_surface *s,
                          const struct pel_paint *paint)
{
    struct pel_point v[2 * CELLS + 2];
    int32_t n = 0, end = i;
    while (end < m->columns && m->cut[j][end] == CUT_STRIP)
        end++;
    for (int32_t k = i; k <= end; k++)
        v[n++] = m->v[j][k];
    for (int32_t k = end; k >= i; k--)
        v[n++] = m->v[j + 1][k];
    polygon(s, v, n, paint);
    return end;
}

static void mesh_draw(const struct mesh *m, const struct pel_surface *s,
                      const struct pel_paint *paint)
{
    for (int32_t j = 0; j < m->rows; j++)
        for (int32_t i = 0; i < m->columns;) {
            if (m->cut[j][i] == CUT_STRIP) {
                i = draw_strip(m, i, j, s, paint);
            } else {
                draw_cell(m, i, j, s, paint);
                i++;
            }
        }
}

static bool in_mesh(const void *mesh, int32_t x, int32_t y)
{
    const struct pel_rect *o = &((const struct mesh *)mesh)->outline;
    int32_t px = x * 256 + 128, py = y * 256 + 128;
    return o->x0 <= px && px < o->x1 && o->y0 <= py && py < o->y1;
}

static struct pel_rect bounds_of(const struct mesh *m)
{
    struct pel_rect b = {(m->outline.x0 >> 8) - 2, (m->outline.y0 >> 8) - 2,
                         (m->outline.x1 >> 8) + 2, (m->outline.y1 >> 8) + 2};
    b.x0 &= ~7;
    b.y0 &= ~7;
    return b;
}

TEST(every_pixel_is_drawn_once)
{
    static struct canvas canvas;
    static struct hits hits;
    struct mesh m;
    for (struct cases c = cases_of(20000); cases_next(&c);) {
        struct random *r = &c.random;
        const struct pel_flat flat = PEL_FLAT(
            random_word(r) % 4 ? random_word(r) : random_word(r) | 0xFF000000u);
        mesh_random(r, &m);
        const struct pel_rect b = bounds_of(&m);
        canvas_open(&canvas, layouts[random_word(r) % LAYOUT_COUNT].format, &b,
                    random_word(r) % CANVAS_STYLES);
        mesh_draw(&m, &canvas.surface, &flat.paint);
        for (int32_t j = 0; j <= m.rows; j++)
            shape_keep(m.v[j], m.columns + 1);
        hits_open(&hits, &b);
        mesh_draw(&m, &hits.surface, &hits.paint);
        hits_check(&hits, in_mesh, &m, "mesh");
        canvas_check_drawn(&canvas, &hits, canvas_flat, &flat);
    }
}
