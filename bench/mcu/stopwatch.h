/* A stopwatch that counts instructions, in an emulator. An instruction takes
 * 64 ns (QEMU's -icount shift=6) of SysTick at 25 MHz on a Cortex-M, at 20 MHz
 * on the board with an M33; of the counter of 24 MHz on a Versatile board with
 * an ARM926, of 62.5 MHz on AArch64, of 40 MHz on Xtensa. RISC-V counts
 * retired instructions (shift=0). On an x86-64 host it is a clock where POSIX
 * is asked for: ns instead of instructions. It stands still elsewhere. */
#ifndef BENCH_MCU_STOPWATCH_H
#define BENCH_MCU_STOPWATCH_H

#include <stdint.h>
#if defined(__x86_64__)
#include <time.h>
#endif

#if defined(__thumb__) && !defined(__linux__)

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
#if __ARM_ARCH >= 8
    return (int32_t)((to - from) & 0xFFFFFFu) * 25 / 4;
#else
    return (int32_t)((to - from) & 0xFFFFFFu) * 5;
#endif
}

#else

static inline void stopwatch_start(void)
{
}

static inline uint32_t stopwatch_read(void)
{
    uint64_t count = 0;
#if defined(__aarch64__) /* its compiler is one for Linux */
    __asm__ volatile("isb\n\tmrs %0, cntvct_el0" : "=r"(count) : : "memory");
#elif defined(__x86_64__) && defined(CLOCK_PROCESS_CPUTIME_ID)
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    count = (uint64_t)now.tv_sec * 1000000000u + (uint64_t)now.tv_nsec;
#elif defined(__linux__)
#elif defined(__riscv)
    uint32_t low;
    __asm__ volatile("csrr %0, minstret" : "=r"(low) : : "memory");
    count = low;
#elif defined(__xtensa__)
    uint32_t low;
    __asm__ volatile("rsr %0, ccount" : "=r"(low) : : "memory");
    count = low;
#elif defined(__arm__)
    count = *(volatile uint32_t *)0x1000005Cu;
#endif
    return (uint32_t)count;
}

static inline int32_t stopwatch_eighths(uint32_t from, uint32_t to)
{
#if defined(__riscv)
    const uint64_t scale = 8 * 24;
#elif defined(__xtensa__)
    const uint64_t scale = 75;
#elif defined(__arm__)
    const uint64_t scale = 125;
#elif defined(__x86_64__)
    const uint64_t scale = 8 * 24;
#else
    const uint64_t scale = 2 * 24;
#endif
    return (int32_t)((to - from) * scale / 24);
}

#endif

#endif
