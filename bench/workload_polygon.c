#include "workload.h"

/* A star: a vertex in each of eight directions, at a random distance between a
 * quarter and the whole of half the box. It does not cross itself. */
void polygon_make(const struct workload *w, struct random *r, struct shape *s)
{
    static const int direction[SHAPE_VERTICES][2] = {
        {10, 0},  {7, 7},   {0, 10},  {-7, 7},
        {-10, 0}, {-7, -7}, {0, -10}, {7, -7},
    };
    const int half = w->size / 2;
    int x = random_between(r, half, w->width - 1 - half);
    int y = random_between(r, half, w->height - 1 - half);
    for (int k = 0; k < SHAPE_VERTICES; k++) {
        int distance = random_between(r, half / 4, half);
        s->x[k] = x + direction[k][0] * distance / 10;
        s->y[k] = y + direction[k][1] * distance / 10;
    }
}
