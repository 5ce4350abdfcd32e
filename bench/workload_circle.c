#include "workload.h"

void circle_make(const struct workload *w, struct random *r, struct shape *s)
{
    s->x[0] = random_between(r, w->size, w->width - 1 - w->size);
    s->y[0] = random_between(r, w->size, w->height - 1 - w->size);
}
