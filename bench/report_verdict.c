#include "report.h"

#include <math.h>

static void put_header(FILE *out, const struct measurement *m)
{
    fprintf(out,
            "\nNanoseconds of the best peer, and how many times as long it "
            "takes as Pel.\n%-20s %-9s %10s",
            "workload", "peer", "ns");
    for (int k = 0; k < m->results; k++)
        if (method_is_pel(methods[k]))
            fprintf(out, " %13s", methods[k]->build);
    fputc('\n', out);
}

/* Adds to the sum of logarithms of each build. */
static void put_row(FILE *out, const struct measurement *m,
                    const struct result *peer, double *sum)
{
    fprintf(out, "%-20s %-9s %10.1f", m->workload->name, peer->method->name,
            peer->ns.median);
    for (int k = 0; k < m->results; k++)
        if (method_is_pel(methods[k])) {
            const double times = peer->ns.median / m->result[k].ns.median;
            sum[k] += log(times);
            fprintf(out, " %13.2f", times);
        }
    fputc('\n', out);
}

void report_verdict(FILE *out, const struct measurement *m, int n)
{
    double sum[METHODS_MAX] = {0};
    int rows = 0;
    if (n > 0)
        put_header(out, m);
    for (int i = 0; i < n; i++) {
        const struct result *peer = measurement_best_peer(&m[i]);
        if (peer) {
            put_row(out, &m[i], peer, sum);
            rows++;
        }
    }
    if (rows == 0)
        return;
    fprintf(out, "%-41s", "geometric mean");
    for (int k = 0; k < m->results; k++)
        if (method_is_pel(methods[k]))
            fprintf(out, " %13.2f", exp(sum[k] / rows));
    fputc('\n', out);
}
