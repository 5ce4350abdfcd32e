/* Start-up code for the CPU of an ESP8266, on QEMU's machine `sim`: main's
 * output and status go to the host by simcalls. The products and quotients are
 * those that an ESP8266 has in its ROM, and Debian's libgcc for it does not. */
#include <stdint.h>
#include <stdio.h>

extern char bss_begin[], bss_end[];
int main(void);
void start(void);

__asm__(".section .text.start, \"ax\"\n"
        ".globl _start\n"
        "_start: j 1f\n"
        ".literal_position\n"
        ".align 4\n"
        "1: movi a1, stack_end\n"
        "call0 start\n"
        ".text\n");

enum { EXIT = 1, WRITE = 4 };

static void host(int call, uint32_t a, uint32_t b, uint32_t c)
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

static char line[512];
static uint32_t held;

static int flush(FILE *file)
{
    (void)file;
    host(WRITE, 1, (uint32_t)line, held);
    held = 0;
    return 0;
}

static int put(char c, FILE *file)
{
    line[held++] = c;
    return held == sizeof line ? flush(file) : 0;
}

static FILE out = FDEV_SETUP_STREAM(put, NULL, flush, _FDEV_SETUP_WRITE);
FILE *const stdout = &out, *const stderr = &out, *const stdin = NULL;

void start(void)
{
    for (char *p = bss_begin; p < bss_end; p++)
        *p = 0;
    const int status = main();
    flush(stdout);
    for (;;)
        host(EXIT, (uint32_t)status, 0, 0);
}

static uint64_t divide(uint64_t n, uint64_t d, uint64_t *rest)
{
    uint64_t quotient = 0, r = 0;
    for (int i = n >> 32 ? 63 : 31; i >= 0; i--) {
        r = r << 1 | (n >> i & 1);
        if (r >= d) {
            r -= d;
            quotient |= UINT64_C(1) << i;
        }
    }
    *rest = r;
    return quotient;
}

uint64_t __umulsidi3(uint32_t a, uint32_t b);
uint64_t __umulsidi3(uint32_t a, uint32_t b)
{
    uint64_t sum = 0;
    for (uint64_t to = a; b; b >>= 1, to <<= 1)
        if (b & 1)
            sum += to;
    return sum;
}

uint64_t __muldi3(uint64_t a, uint64_t b);
uint64_t __muldi3(uint64_t a, uint64_t b)
{
    const uint32_t x = (uint32_t)a, y = (uint32_t)b;
    const uint32_t high = (uint32_t)(a >> 32) * y + x * (uint32_t)(b >> 32);
    return __umulsidi3(x, y) + ((uint64_t)high << 32);
}

uint64_t __udivdi3(uint64_t n, uint64_t d);
uint64_t __udivdi3(uint64_t n, uint64_t d)
{
    uint64_t rest;
    return divide(n, d, &rest);
}

uint64_t __umoddi3(uint64_t n, uint64_t d);
uint64_t __umoddi3(uint64_t n, uint64_t d)
{
    uint64_t rest;
    divide(n, d, &rest);
    return rest;
}

int64_t __divdi3(int64_t n, int64_t d);
int64_t __divdi3(int64_t n, int64_t d)
{
    const uint64_t q = __udivdi3(n < 0 ? 0 - (uint64_t)n : (uint64_t)n,
                                 d < 0 ? 0 - (uint64_t)d : (uint64_t)d);
    return (int64_t)((n ^ d) < 0 ? 0 - q : q);
}

uint32_t __udivsi3(uint32_t n, uint32_t d);
uint32_t __udivsi3(uint32_t n, uint32_t d)
{
    return (uint32_t)__udivdi3(n, d);
}

uint32_t __umodsi3(uint32_t n, uint32_t d);
uint32_t __umodsi3(uint32_t n, uint32_t d)
{
    return (uint32_t)__umoddi3(n, d);
}

int32_t __divsi3(int32_t n, int32_t d);
int32_t __divsi3(int32_t n, int32_t d)
{
    return (int32_t)__divdi3(n, d);
}
