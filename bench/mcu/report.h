/* What the benchmarks on a Cortex-M share. */
#ifndef BENCH_MCU_REPORT_H
#define BENCH_MCU_REPORT_H

#include <stdint.h>

/* Prints `name parameter ticks per`: ticks of all calls, and how many calls or
 * pixels they are for. */
void report(const char *name, int32_t parameter, uint32_t ticks, uint32_t per);

void hits_report(void);
void textures_report(void);

#endif
