/* SysTick as a stopwatch: 24 bits at the core's clock, no interrupt. */
#ifndef PORT_CORTEX_M_SYSTICK_H
#define PORT_CORTEX_M_SYSTICK_H

#include <stdint.h>

#include "../../core/pel_config.h"

#define SYSTICK_CONTROL (*PEL_CAST_ADDRESS(volatile uint32_t *, 0xE000E010u))
#define SYSTICK_RELOAD (*PEL_CAST_ADDRESS(volatile uint32_t *, 0xE000E014u))
#define SYSTICK_VALUE (*PEL_CAST_ADDRESS(volatile uint32_t *, 0xE000E018u))

static inline void systick_start(void)
{
    SYSTICK_RELOAD = 0xFFFFFF;
    SYSTICK_VALUE = 0;
    SYSTICK_CONTROL = 5; /* enabled, core clock */
}

/* Counts down. */
static inline uint32_t systick_read(void)
{
    return SYSTICK_VALUE;
}

/* Ticks between two readings less than 2^24 ticks apart. */
static inline uint32_t systick_elapsed(uint32_t from, uint32_t to)
{
    return (from - to) & 0xFFFFFFu;
}

#endif
