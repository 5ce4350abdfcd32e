/* The trap of Tensilica's simulator, which QEMU knows too. */
#ifndef PORT_LX106_SIMCALL_H
#define PORT_LX106_SIMCALL_H

#include <stdint.h>

enum { SIMCALL_EXIT = 1, SIMCALL_WRITE = 4 };

#ifdef __XTENSA__
static inline void simcall(int call, uint32_t a, uint32_t b, uint32_t c)
{
    register int a2 __asm__("a2") = call;
    register uint32_t a3 __asm__("a3") = a;
    register uint32_t a4 __asm__("a4") = b;
    register uint32_t a5 __asm__("a5") = c;
    __asm__ volatile("simcall"
                     : "+r"(a2), "+r"(a3)
                     : "r"(a4), "r"(a5)
                     : "memory");
}
#endif

#endif
