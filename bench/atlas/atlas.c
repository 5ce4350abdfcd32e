#include "atlas.h"

#include <stdio.h>

void atlas_put(const struct atlas *a, struct figure f)
{
    if (a->smallest)
        return;
    printf("%s,%s,%.9g,", a->name, f.method, f.x);
    if (f.has_y)
        printf("%.9g", f.y);
    printf(",%s,%.9g,", f.metric, f.value);
    if (f.has_spread)
        printf("%.9g,%.9g", f.low, f.high);
    else
        printf(",");
    printf(",%s,build/bench/pel-atlas%s --seed %u %s\n", f.unit,
           a->quick ? " --quick" : "", (unsigned)a->seed, a->name);
}

void atlas_promise(struct atlas *a, bool holds, const struct figure *f)
{
    if (holds)
        return;
    a->broken++;
    fprintf(stderr, "pel-atlas: %s: %s of %s is %.9g %s at x = %.9g", a->name,
            f->metric, f->method, f->value, f->unit, f->x);
    if (f->has_y)
        fprintf(stderr, ", y = %.9g", f->y);
    fprintf(stderr, "; that breaks a promise\n");
}

void atlas_put_bound(struct atlas *a, struct figure f, double bound)
{
    atlas_promise(a, f.value <= bound, &f);
    atlas_put(a, f);
    f.metric = "bound";
    f.value = bound;
    f.has_spread = false;
    atlas_put(a, f);
}

struct random atlas_random(const struct atlas *a, uint32_t number)
{
    const uint64_t mixed =
        ((uint64_t)a->seed << 32 | (number + 1)) * 0x9E3779B97F4A7C15u;
    struct random r = {mixed ? mixed : 1};
    for (int i = 0; i < 8; i++)
        random_next(&r);
    return r;
}
