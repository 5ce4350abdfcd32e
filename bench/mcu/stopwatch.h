/* A stopwatch that counts instructions, in an emulator: SysTick at 25 MHz on a
 * Cortex-M and the counter of 62.5 MHz on AArch64, where an instruction takes
 * 64 ns (QEMU's -icount shift=6), retired instructions on RISC-V (shift=0). It
 * stands still on other CPUs. */
#ifndef BENCH_MCU_STOPWATCH_H
#define BENCH_MCU_STOPWATCH_H

#include <stdint.h>

#if defined(__thumb__)

#define SYSTICK                                                  \
    ((volatile uint32_t *)0xE000E010u) /* control, reload, value \
                                        */

static inline void stopwatch_start(void)
{
    SYSTICK[1] = 0xFFFFFF;
    SYSTICK[2] = 0;
    SYSTICK[0] = 5; /* enabled, core clock */
}

/* SysTick counts 24 bits down. */
static inline uint32_t stopwatch_read(void)
{
    return 0 - SYSTICK[2];
}

/* Instructions between two readings, in eighths: less than 10 million on a
 * Cortex-M. */
static inline int32_t stopwatch_eighths(uint32_t from, uint32_t to)
{
    return (int32_t)((to - from) & 0xFFFFFFu) * 5;
}

#else

static inline void stopwatch_start(void)
{
}

static inline uint32_t stopwatch_read(void)
{
#ifdef __riscv
    uint32_t count;
    __asm__ volatile("csrr %0, minstret" : "=r"(count) : : "memory");
#elif !defined(__aarch64__)
    const uint32_t count = 0;
#else
    uint64_t count;
    __asm__ volatile("isb\n\tmrs %0, cntvct_el0" : "=r"(count) : : "memory");
#endif
    return (uint32_t)count;
}

static inline int32_t stopwatch_eighths(uint32_t from, uint32_t to)
{
#ifdef __riscv
    const uint32_t scale = 8;
#else
    const uint32_t scale = 2;
#endif
    return (int32_t)((to - from) * scale);
}

#endif

#endif
