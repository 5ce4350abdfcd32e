/* Start-up code for the CPU of an ESP8266, on QEMU's machine `sim`: main's
 * output and status go to the host by simcalls. */
#include <stdint.h>
#include <stdio.h>

#include "simcall.h"

extern char bss_begin[], bss_end[];
int main(void);
__attribute__((used)) void start(void); /* called below by name */

__asm__(".section .text.start, \"ax\"\n"
        ".globl _start\n"
        "_start: j 1f\n"
        ".literal_position\n"
        ".align 4\n"
        "1: movi a1, stack_end\n"
        "call0 start\n"
        ".text\n");

static char line[512];
static uint32_t held;

static int flush(FILE *file)
{
    (void)file;
    simcall(SIMCALL_WRITE, 1, (uint32_t)line, held);
    held = 0;
    return 0;
}

static int put(char c, FILE *file)
{
    line[held++] = c;
    return held == sizeof line ? flush(file) : 0;
}

static FILE out = FDEV_SETUP_STREAM(put, NULL, flush, _FDEV_SETUP_WRITE);
__attribute__((used)) FILE *const stdout = &out, *const stderr = &out,
                                  *const stdin = NULL;

void start(void)
{
    for (char *p = bss_begin; p < bss_end; p++)
        *p = 0;
    const int status = main();
    flush(stdout);
    for (;;)
        simcall(SIMCALL_EXIT, (uint32_t)status, 0, 0);
}
