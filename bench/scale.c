#include "scale.h"

#include <string.h>

double scale_budget(const struct budget *b, const struct method *pel)
{
    return strstr(pel->build, "native") && b->native > 0 ? b->native : b->ns;
}

double scale_by_memset(const struct measurement *m, const struct budget *b,
                       double ns)
{
    const struct result *here = measurement_find(m, "memset");
    return here && b->memset > 0 ? ns * here->ns.median / b->memset : 0;
}

int scale_peer(const struct measurement *m, const struct budgets *all)
{
    const struct budget *b = budgets_find(all, m->workload->name);
    int best = -1;
    for (int i = 0; b && i < all->peers; i++)
        if (b->peer[i] > 0 && measurement_find(m, all->peer[i]) &&
            (best < 0 || b->peer[i] < b->peer[best]))
            best = i;
    return best;
}

double scale_by_peer(const struct measurement *m, const struct budgets *all,
                     double ns)
{
    int i = scale_peer(m, all);
    if (i < 0)
        return 0;
    const struct result *here = measurement_find(m, all->peer[i]);
    const struct budget *b = budgets_find(all, m->workload->name);
    return ns * here->ns.median / b->peer[i];
}
