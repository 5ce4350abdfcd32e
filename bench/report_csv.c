#include "report.h"

void report_csv_header(FILE *out)
{
    fputs("compiler,workload,method,ns,q1,q3,ratio_to_memset,"
          "ratio_to_best_peer,pixels,more_percent,wrong_percent,worst_level,"
          "mean_level\n",
          out);
}

static void put_ratio(FILE *out, double ns, const struct result *to)
{
    fputc(',', out);
    if (to)
        fprintf(out, "%.4f", ns / to->ns.median);
}

static void put_result(FILE *out, const struct measurement *m,
                       const struct result *r)
{
    fprintf(out, "%s,%s,%s,%.2f,%.2f,%.2f", r->method->build, m->workload->name,
            r->method->name, r->ns.median, r->ns.q1, r->ns.q3);
    put_ratio(out, r->ns.median, measurement_find(m, "memset"));
    put_ratio(out, r->ns.median, measurement_best_peer(m));
    fprintf(out, ",%.2f,", m->pixels);
    if (r->coverage.known)
        fprintf(out, "%.4f,%.4f,", r->coverage.more, r->coverage.wrong);
    else
        fputs(",,", out);
    if (r->coverage.known && m->workload->paint == PAINT_SMOOTH)
        fprintf(out, "%d,%.3f\n", r->coverage.worst, r->coverage.mean);
    else
        fputs(",\n", out);
}

void report_csv(FILE *out, const struct measurement *m)
{
    for (int i = 0; i < m->results; i++)
        if (m->result[i].method)
            put_result(out, m, &m->result[i]);
}
