/* What the benchmarks on microcontrollers share. */
#ifndef BENCH_MCU_REPORT_H
#define BENCH_MCU_REPORT_H

#include <stdbool.h>
#include <stdint.h>

/* Prints `name parameter time per`: the time of all calls (stopwatch.h), and
 * how many calls or pixels it is for. */
void report(const char *name, int32_t parameter, int32_t time, uint32_t per);

void fills_report(void);
void gradients_report(void);
void hits_report(void);
void matrix_report(void);
void paths_report(void);
void smooth_report(void);
void textures_report(void);

/* False: a bound does not hold. */
bool shapes_report(void);

#endif
