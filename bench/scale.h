/* Budgets of the machine that they were measured on, brought here: times what
 * memset, or a peer, takes here over what it took there. */
#ifndef BENCH_SCALE_H
#define BENCH_SCALE_H

#include "budget.h"
#include "measure.h"

/* The budget of a build of Pel, ns there: code for wider vectors may have one
 * of its own. */
double scale_budget(const struct budget *b, const struct method *pel);

/* ns here; 0 when the row has no figure of memset there. */
double scale_by_memset(const struct measurement *m, const struct budget *b,
                       double ns);

/* The peer with the best figure there, of those that are measured here: its
 * column of the budgets; -1 without any. */
int scale_peer(const struct measurement *m, const struct budgets *all);

/* ns here; 0 without such a peer. */
double scale_by_peer(const struct measurement *m, const struct budgets *all,
                     double ns);

#endif
