#include "stack_probe.h"

#include "semihost.h"

int __real_main(void);
int __wrap_main(void);

extern uint32_t bss_end[];

enum { PAINT = 0x5A17C0DE };

static inline uint32_t *stack_pointer(void)
{
    uint32_t *sp;
#if defined(__riscv)
    __asm__ volatile("mv %0, sp" : "=r"(sp));
#elif defined(__xtensa__)
    __asm__ volatile("mov %0, a1" : "=r"(sp));
#else
    __asm__ volatile("mov %0, sp" : "=r"(sp));
#endif
    return sp;
}

static inline void paint_below(const uint32_t *sp)
{
    for (volatile uint32_t *p = bss_end; p < sp; p++)
        *p = PAINT;
}

static inline uint32_t touched_below(const uint32_t *sp)
{
    const volatile uint32_t *p = bss_end;
    while (p < sp && *p == PAINT)
        p++;
    return (uint32_t)(sp - p) * 4;
}

uint32_t stack_used(void (*call)(const void *argument), const void *argument)
{
    const uint32_t *sp = stack_pointer();
    paint_below(sp);
    call(argument);
    return touched_below(sp);
}

/* Linked with --wrap=main: runs main and prints `stack BYTES`. */
int __wrap_main(void)
{
    const uint32_t *sp = stack_pointer();
    paint_below(sp);
    const int status = __real_main();
    const uint32_t used = touched_below(sp);
    semihost_write("stack ");
    semihost_write_number(used);
    semihost_write("\n");
    return status;
}
