#include "report.h"

#include <string.h>

#include "scale.h"

static void put_header(FILE *out, const char *title)
{
    fprintf(out, "\n%s\n%-19s %-13s %9s %9s | %7s %16s %16s\n", title,
            "workload", "build of pel", "ns", "floor", "budget", "by memset",
            "by peer");
}

static void put_check(FILE *out, double ns, double limit)
{
    if (limit > 0)
        fprintf(out, " %11.1f %-4s", limit, ns <= limit ? "ok" : "OVER");
    else
        fprintf(out, " %11s %-4s", "-", "");
}

static void put_result(FILE *out, const struct measurement *m,
                       const struct budgets *all, const struct result *pel)
{
    const struct budget *b = budgets_find(all, m->workload->name);
    const struct result *floor_ns = measurement_find(m, "floor");
    const double ns = pel->ns.median, budget = scale_budget(b, pel->method);
    const int peer = scale_peer(m, all);
    fprintf(out, "%-19s %-13s %9.1f %9.1f | %7.0f", m->workload->name,
            pel->method->build, ns, floor_ns->ns.median, budget);
    put_check(out, ns, scale_by_memset(m, b, budget));
    put_check(out, ns, scale_by_peer(m, all, budget));
    fprintf(out, " %s\n", peer < 0 ? "" : all->peer[peer]);
}

static void put_builds(FILE *out, const struct measurement *m, int n,
                       const struct budgets *all, bool native)
{
    for (int i = 0; i < n; i++) {
        if (!budgets_find(all, m[i].workload->name))
            continue;
        for (int k = 0; k < m[i].results; k++) {
            const struct result *r = &m[i].result[k];
            if (r->method && method_is_pel(r->method) &&
                (strstr(r->method->build, "native") != NULL) == native)
                put_result(out, &m[i], all, r);
        }
    }
}

void report_verdict(FILE *out, const struct measurement *m, int n,
                    const struct budgets *all)
{
    fputs(
        "\nBudgets, ns. They were measured on another machine, so what counts "
        "is the budget\ntimes what memset (or the best peer with a figure "
        "there) takes here over what it\ntook there. The floor stores the "
        "same pixels and does nothing else.\n",
        out);
    put_header(out, "Baseline code:");
    put_builds(out, m, n, all, false);
    put_header(out, "For this CPU (-O3 -march=native), which wider vectors may "
                    "use:");
    put_builds(out, m, n, all, true);
}
