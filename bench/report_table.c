#include "report.h"

static void put_ratio(FILE *out, double ns, const struct result *to)
{
    if (to)
        fprintf(out, " %8.2f", ns / to->ns.median);
    else
        fprintf(out, " %8s", "-");
}

static void put_result(FILE *out, const struct measurement *m,
                       const struct result *r)
{
    fprintf(out, "  %-9s %-12s %10.1f %10.1f %10.1f", r->method->name,
            r->method->build, r->ns.median, r->ns.q1, r->ns.q3);
    put_ratio(out, r->ns.median, measurement_find(m, "memset"));
    put_ratio(out, r->ns.median, measurement_best_peer(m));
    if (r->coverage.known)
        fprintf(out, " %8.2f %8.2f", r->coverage.more, r->coverage.wrong);
    if (r->coverage.known && m->workload->paint == PAINT_SMOOTH)
        fprintf(out, " %8d %8.2f", r->coverage.worst, r->coverage.mean);
    fputc('\n', out);
}

void report_table(FILE *out, const struct measurement *m)
{
    const struct workload *w = m->workload;
    fprintf(out, "\n%s: %d shapes, %.1f px each, %dx%d, %d bits", w->name,
            w->count, m->pixels, w->width, w->height, w->bits);
    fprintf(out, "\n  %-22s %10s %10s %10s %8s %8s %8s %8s%s\n", "method",
            "ns median", "q1", "q3", "/memset", "/peer", "more %", "wrong %",
            w->paint == PAINT_SMOOTH ? "    worst     mean of 255" : "");
    for (int i = 0; i < m->results; i++)
        if (m->result[i].method)
            put_result(out, m, &m->result[i]);
}
