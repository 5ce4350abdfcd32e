#define _DEFAULT_SOURCE
#include "workload.h"

#include <math.h>
#include <stdlib.h>

/* n vertices, uniform in the workload's box at a random place inside. */
static void place_in_box(const struct workload *w, struct random *r,
                         struct shape *s, int n)
{
    int x = random_between(r, 0, w->width - 1 - w->size);
    int y = random_between(r, 0, w->height - 1 - w->size);
    for (int k = 0; k < n; k++) {
        s->x[k] = x + random_between(r, 0, w->size);
        s->y[k] = y + random_between(r, 0, w->size);
    }
}

static int twice_area(const struct shape *s)
{
    return abs((s->x[1] - s->x[0]) * (s->y[2] - s->y[0]) -
               (s->x[2] - s->x[0]) * (s->y[1] - s->y[0]));
}

void triangle_make(const struct workload *w, struct random *r, struct shape *s)
{
    int area;
    do {
        place_in_box(w, r, s, 3);
        area = twice_area(s);
    } while (area < 2 * w->area_min || area > 2 * w->area_max);
}

/* From a random pixel in a random direction; the third vertex lies beside the
 * first, across the longer axis. */
void sliver_make(const struct workload *w, struct random *r, struct shape *s)
{
    const int base = w->paint == PAINT_SMOOTH ? NEEDLE_BASE : SLIVER_BASE;
    do {
        double turn = random_between(r, 0, 65535) * (2 * M_PI / 65536);
        double dx = cos(turn), dy = sin(turn);
        int flat = fabs(dx) > fabs(dy);
        s->x[0] = random_between(r, 0, w->width - 1 - base);
        s->y[0] = random_between(r, 0, w->height - 1 - base);
        s->x[1] = s->x[0] + (int)lrint(w->size * dx);
        s->y[1] = s->y[0] + (int)lrint(w->size * dy);
        s->x[2] = s->x[0] + !flat * base;
        s->y[2] = s->y[0] + flat * base;
    } while (s->x[1] < 0 || s->x[1] >= w->width || s->y[1] < 0 ||
             s->y[1] >= w->height);
}

void texture_place(struct random *r, struct shape *s)
{
    const double turn = random_between(r, 0, 65535) * (2 * M_PI / 65536);
    for (int k = 0; k < 3; k++) {
        const double dx = s->x[k] - s->x[0], dy = s->y[k] - s->y[0];
        s->u[k] = TEXTURE_SIDE / 2 + dx * cos(turn) - dy * sin(turn);
        s->v[k] = TEXTURE_SIDE / 2 + dx * sin(turn) + dy * cos(turn);
    }
}

void screen_make(const struct workload *w, struct random *r, struct shape *s)
{
    (void)r;
    s->x[1] = w->width;
    s->y[1] = w->height;
    s->x[2] = w->paint == PAINT_VERTICAL ? 0 : w->width;
    s->y[2] = w->paint == PAINT_HORIZONTAL ? 0 : w->height;
}

/* A rectangle at a random place inside. */
static void place_inside(const struct workload *w, struct random *r,
                         struct shape *s, int width, int height)
{
    s->x[0] = random_between(r, 0, w->width - width);
    s->y[0] = random_between(r, 0, w->height - height);
    s->x[1] = s->x[0] + width;
    s->y[1] = s->y[0] + height;
}

void copy_make(const struct workload *w, struct random *r, struct shape *s)
{
    place_inside(w, r, s, SPRITE_SIDE, SPRITE_SIDE);
}

void text_make(const struct workload *w, struct random *r, struct shape *s)
{
    if (w->form == FORM_TEXT) {
        place_inside(w, r, s, TEXT_LETTERS * LETTER_SIDE, LETTER_SIDE);
    } else {
        const struct workload_line line = workload_line(w);
        place_inside(w, r, s, (int)(line.letters * line.advance) + 1,
                     w->size * 5 / 4);
    }
}

void box_make(const struct workload *w, struct random *r, struct shape *s)
{
    const int width = w->form == FORM_ROUNDED ? w->size * 5 / 3 : w->size;
    place_inside(w, r, s, width, w->size);
}

void line_make(const struct workload *w, struct random *r, struct shape *s)
{
    place_in_box(w, r, s, 2);
}
