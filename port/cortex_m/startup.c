/* From reset to main, and what main returns to the debugger. Needs no C
 * library; the symbols come from sections.ld. */
#include <stdint.h>

#include "semihost.h"

int main(void);
void reset(void);

extern uint32_t data_load[], data_begin[], data_end[];
extern uint32_t bss_begin[], bss_end[], stack_top[];

void reset(void)
{
    /* volatile: a compiler makes calls to memcpy and memset of such loops. */
    const uint32_t *from = data_load;
    for (volatile uint32_t *to = data_begin; to < data_end; to++)
        *to = *from++;
    for (volatile uint32_t *to = bss_begin; to < bss_end; to++)
        *to = 0;
    semihost_exit(main());
}

#if defined(__riscv)

/* Where the CPU begins: without a stack. */
__attribute__((naked, section(".vectors"), used)) static void begin(void)
{
    __asm__ volatile("la sp, stack_top\n\tj reset");
}

#elif defined(__xtensa__)

__asm__(".section .vectors, \"ax\"\n"
        "j 1f\n"
        ".literal_position\n"
        ".align 4\n"
        "1: movi a1, stack_top\n"
        "call0 reset\n"
        ".text\n");

#elif !defined(__thumb__)

__attribute__((naked, section(".vectors"), used)) static void begin(void)
{
    __asm__ volatile("ldr sp, =stack_top\n\tb reset");
}

#else

static void fault(void)
{
    semihost_write("fault\n");
    semihost_exit(99);
}

typedef void (*vector)(void);

struct vector_table {
    uint32_t *stack;
    vector handler[15]; /* exceptions 1 to 15 */
};

/* Exceptions 1 to 6 are reset, NMI and the faults, 11 is SVC, 14 and 15 PendSV
 * and SysTick; the rest are reserved. A program that wants one of them brings a
 * table of its own. */
__attribute__((section(".vectors"),
               used)) static const struct vector_table vectors = {
    stack_top,
    {reset, fault, fault, fault, fault, fault, 0, 0, 0, 0, fault, 0, 0, fault,
     fault},
};

#endif
