/* Draws every workload once with every build of Pel, for callgrind to count the
 * instructions: the same number on every run. Each dump is named
 * "build,workload,shapes"; instructions.sh reads them. */
#include <stdio.h>

#include <valgrind/callgrind.h>

#include "method.h"

static void count(const struct method *m, const struct workload *w,
                  const struct canvas *c)
{
    char name[80];
    void *job = m->open(w, c);
    snprintf(name, sizeof name, "%s,%s,%d", m->build, w->name, w->count);
    CALLGRIND_ZERO_STATS;
    CALLGRIND_TOGGLE_COLLECT;
    m->draw(job, 0, w->count);
    CALLGRIND_TOGGLE_COLLECT;
    CALLGRIND_DUMP_STATS_AT(name);
    m->close(job);
}

int main(void)
{
    if (!RUNNING_ON_VALGRIND)
        method_fail("nothing counts the instructions",
                    "start it with bench/instructions.sh");
    for (const struct workload *from = workloads; from->name; from++) {
        struct workload w = *from;
        struct canvas canvas;
        if (!workload_open(&w) ||
            !canvas_open(&canvas, w.width, w.height, w.bits))
            method_fail("out of memory", "free some and start again");
        for (const struct method *const *m = methods; *m; m++)
            count(*m, &w, &canvas);
        canvas_close(&canvas);
        workload_close(&w);
    }
    return 0;
}
