#include "generate.h"

#include <math.h>

static int32_t clamp_to(int32_t v, int32_t low, int32_t edge)
{
    return pel_max(PEL_PX(low), pel_min(v, PEL_PX(low + edge)));
}

void any_triangle(struct random *r, const struct square *p,
                  struct pel_point v[3])
{
    for (int i = 0; i < 3; i++) {
        v[i].x = PEL_PX(p->x) + random_between(r, 0, PEL_PX(p->edge) - 1);
        v[i].y = PEL_PX(p->y) + random_between(r, 0, PEL_PX(p->edge) - 1);
    }
}

/* A coordinate next to or on a centre. */
static int32_t tied(struct random *r, int32_t low, int32_t edge)
{
    const int32_t center =
        pel_pixel_center(low + random_between(r, 0, edge - 1));
    return center + (random_between(r, 0, 3) ? 0 : random_between(r, -1, 1));
}

void tied_triangle(struct random *r, const struct square *p,
                   struct pel_point v[3])
{
    for (int i = 0; i < 3; i++) {
        v[i].x = tied(r, p->x, p->edge);
        v[i].y = tied(r, p->y, p->edge);
    }
    switch (random_between(r, 0, 5)) {
    case 0:
        v[1].x = v[0].x;
        break;
    case 1:
        v[1].y = v[0].y;
        break;
    case 2: /* nearly in line */
        v[2].x = (v[0].x + v[1].x) / 2 + random_between(r, -1, 1);
        v[2].y = (v[0].y + v[1].y) / 2 + random_between(r, -1, 1);
        break;
    default:
        break;
    }
}

void thin_triangle(struct random *r, const struct square *p,
                   const struct thin *thin, struct pel_point v[3])
{
    const double turn =
        random_between(r, 0, 65535) * (6.283185307179586 / 65536);
    const double dx = cos(turn), dy = sin(turn);
    const double along = random_between(r, 0, 1000) / 1000.0;
    const double length = PEL_PX(thin->length);
    const double middle = PEL_PX(p->edge) / 2.0;
    const double x = PEL_PX(p->x) + middle + random_between(r, -128, 127);
    const double y = PEL_PX(p->y) + middle + random_between(r, -128, 127);
    const double at[3] = {-.5, .5, along - .5};
    for (int i = 0; i < 3; i++) {
        const double off = i == 2 ? thin->thickness : 0;
        v[i].x = (int32_t)lround(x + dx * at[i] * length - dy * off);
        v[i].y = (int32_t)lround(y + dy * at[i] * length + dx * off);
        v[i].x = clamp_to(v[i].x, p->x, p->edge);
        v[i].y = clamp_to(v[i].y, p->y, p->edge);
    }
}

struct pel_point far_triangle(struct random *r, int32_t edge,
                              struct pel_point v[3])
{
    const struct square p = {-(edge + 1) / 2, -(edge + 1) / 2, edge};
    any_triangle(r, &p, v);
    const double t = random_between(r, 0, 1000) / 1000.0;
    const double x = v[0].x + t * (v[1].x - v[0].x);
    const double y = v[0].y + t * (v[1].y - v[0].y);
    return (struct pel_point){(int32_t)floor(x / 256), (int32_t)floor(y / 256)};
}

void grid_make(struct random *r, struct grid *g)
{
    const int32_t cell = g->square.edge / g->n;
    const int32_t most = cell / 4 < 1 ? 1 : 2 * (cell / 4); /* half pixels */
    for (int32_t i = 0; i <= g->n; i++)
        for (int32_t k = 0; k <= g->n; k++) {
            struct pel_point *p = &g->vertex[i * (g->n + 1) + k];
            p->x = PEL_PX(g->square.x + k * cell);
            p->y = PEL_PX(g->square.y + i * cell);
            if (k > 0 && k < g->n)
                p->x += 128 * random_between(r, -most, most);
            if (i > 0 && i < g->n)
                p->y += 128 * random_between(r, -most, most);
        }
}

void grid_triangle(const struct grid *g, int32_t cell, int half,
                   struct pel_point v[3])
{
    const int32_t line = g->n + 1;
    const struct pel_point *p = &g->vertex[cell / g->n * line + cell % g->n];
    const int first = (cell * 7 + half) % 3;
    v[first] = p[0];
    v[(first + 1) % 3] = p[half ? line + 1 : 1];
    v[(first + 2) % 3] = p[half ? line : line + 1];
}
