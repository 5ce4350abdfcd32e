#include "semihost.h"

#if defined(__xtensa__)

#include "../lx106/simcall.h"

void semihost_write(const char *text)
{
    for (; *text; text++)
        simcall(SIMCALL_WRITE, 1, (uint32_t)text, 1);
}

void semihost_exit(int status)
{
    for (;;)
        simcall(SIMCALL_EXIT, (uint32_t)status, 0, 0);
}

#else

enum { SYS_WRITE0 = 0x04, SYS_EXIT_EXTENDED = 0x20 };

/* The trap that debuggers know, and the registers of its arguments. */
#if defined(__riscv)
#define FIRST "a0"
#define SECOND "a1"
#define TRAP                                                               \
    ".option push\n.option norvc\n.balign 16\nslli x0, x0, 0x1f\nebreak\n" \
    "srai x0, x0, 7\n.option pop"
#else
#define FIRST "r0"
#define SECOND "r1"
#ifdef __thumb__
#define TRAP "bkpt 0xab"
#else
#define TRAP "svc 0x123456"
#endif
#endif

static void call(uint32_t operation, const void *argument)
{
    register uint32_t r0 __asm__(FIRST) = operation;
    register const void *r1 __asm__(SECOND) = argument;
    __asm__ volatile(TRAP : "+r"(r0) : "r"(r1) : "memory");
}

void semihost_write(const char *text)
{
    call(SYS_WRITE0, text);
}

void semihost_exit(int status)
{
    const uint32_t stopped_by_exit[2] = {0x20026, (uint32_t)status};
    for (;;)
        call(SYS_EXIT_EXTENDED, stopped_by_exit);
}

#endif

void semihost_write_number(uint32_t number)
{
    static const uint32_t power[] = {1000000000, 100000000, 10000000, 1000000,
                                     100000,     10000,     1000,     100,
                                     10,         1};
    char digits[11], *p = digits;
    for (unsigned i = 0; i < sizeof power / sizeof *power; i++) {
        *p = '0';
        for (; number >= power[i]; number -= power[i])
            ++*p;
        if (p > digits || *p > '0' || power[i] == 1)
            p++;
    }
    *p = '\0';
    semihost_write(digits);
}
