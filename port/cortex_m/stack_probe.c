/* How much stack main uses: linked with --wrap=main, paints the free stack,
 * runs main and prints `stack BYTES`, its own frames not counted. */
#include "semihost.h"

int __real_main(void);
int __wrap_main(void);

extern uint32_t bss_end[];

enum { PAINT = 0x5A17C0DE };

static inline uint32_t *stack_pointer(void)
{
    uint32_t *sp;
    __asm__ volatile("mov %0, sp" : "=r"(sp));
    return sp;
}

int __wrap_main(void)
{
    uint32_t *sp = stack_pointer();
    for (volatile uint32_t *p = bss_end; p < sp; p++)
        *p = PAINT;
    int status = __real_main();
    const volatile uint32_t *p = bss_end;
    while (p < sp && *p == PAINT)
        p++;
    semihost_write("stack ");
    semihost_write_number((uint32_t)(sp - p) * 4);
    semihost_write("\n");
    return status;
}
