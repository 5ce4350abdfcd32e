/* The cases, each in a file of its name. */
#ifndef BENCH_ATLAS_CASES_H
#define BENCH_ATLAS_CASES_H

#include "atlas.h"

void atlas_damage(struct atlas *a);

#endif
