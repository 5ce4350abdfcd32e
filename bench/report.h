/* What the measurements say: a CSV file for programs, tables for people. */
#ifndef BENCH_REPORT_H
#define BENCH_REPORT_H

#include <stdio.h>

#include "measure.h"

/* Columns: compiler, workload, method, ns, q1, q3, ratio_to_memset,
 * ratio_to_best_peer, pixels, more_percent, wrong_percent, worst_level,
 * mean_level (of smooth shapes); empty where there is
 * nothing to say. */
void report_csv_header(FILE *out);
void report_csv(FILE *out, const struct measurement *m);

/* The same for people, one block for each workload. */
void report_table(FILE *out, const struct measurement *m);

/* One line for each workload that peers draw: each build of Pel beside the best
 * of them. */
void report_verdict(FILE *out, const struct measurement *m, int n);

#endif
