/* The budgets: what a shape may cost, measured on another machine together with
 * memset and peers, so that here their ratios count. */
#ifndef BENCH_BUDGET_H
#define BENCH_BUDGET_H

#include <stdbool.h>

enum { BUDGET_PEERS = 4, BUDGETS_MAX = 40, BUDGET_NAME = 24 };

/* ns; 0 where the table has none. */
struct budget {
    char workload[BUDGET_NAME];
    double ns;     /* of baseline code */
    double native; /* of code for wider vectors */
    double memset; /* the limit there */
    double peer[BUDGET_PEERS];
};

struct budgets {
    char peer[BUDGET_PEERS][BUDGET_NAME]; /* names of methods */
    int peers, n;
    struct budget row[BUDGETS_MAX];
};

/* Reads the CSV file: workload,budget,native,memset and then a column for each
 * peer, ns. Exits when the file is not like that. */
void budgets_read(struct budgets *b, const char *path);

/* NULL when the workload has none. */
const struct budget *budgets_find(const struct budgets *b,
                                  const char *workload);

#endif
