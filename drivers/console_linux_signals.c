#ifndef _GNU_SOURCE
#define _GNU_SOURCE
#endif
#include "console_linux_guardian.h"

#include <errno.h>
#include <signal.h>
#include <string.h>
#include <unistd.h>

/* Those that end the process, and behind them those that stop it. */
static const int numbers[] = {SIGHUP,  SIGINT,  SIGQUIT, SIGILL,  SIGTRAP,
                              SIGABRT, SIGBUS,  SIGFPE,  SIGSEGV, SIGPIPE,
                              SIGALRM, SIGTERM, SIGXCPU, SIGXFSZ, SIGSYS,
                              SIGTSTP, SIGTTIN, SIGTTOU};
enum { SIGNALS = sizeof(numbers) / sizeof(numbers[0]), ENDING = SIGNALS - 3 };

static struct sigaction before[SIGNALS];
static void (*restore_function)(void);
static char stack_memory[32768];
static stack_t stack_before;
static int restored;

static void on_signal(int number)
{
    static const char vanished[] =
        "pel: SIGBUS: memory vanished while it was drawn on; was the display "
        "unplugged or its driver removed?\n";
    int saved = errno;
    if (!__atomic_exchange_n(&restored, 1, __ATOMIC_SEQ_CST))
        restore_function();
    if (number == SIGBUS && write(2, vanished, sizeof(vanished) - 1) < 0)
        errno = saved;
    for (int i = 0; i < ENDING; i++)
        if (numbers[i] == number)
            sigaction(number, &before[i], NULL);
    errno = saved;
    raise(number);
}

void pel_signals_catch(void (*restore)(void))
{
    struct sigaction action;
    stack_t stack = {.ss_sp = stack_memory, .ss_size = sizeof(stack_memory)};
    memset(&action, 0, sizeof(action));
    action.sa_handler = on_signal;
    action.sa_flags = SA_ONSTACK;
    sigfillset(&action.sa_mask);
    restore_function = restore;
    restored = 0;
    sigaltstack(&stack, &stack_before);
    for (int i = 0; i < SIGNALS; i++) {
        if (i == ENDING)
            action.sa_handler = SIG_IGN;
        sigaction(numbers[i], NULL, &before[i]);
        if (i >= ENDING || before[i].sa_handler != SIG_IGN)
            sigaction(numbers[i], &action, NULL);
    }
}

void pel_signals_release(void)
{
    for (int i = 0; i < SIGNALS; i++)
        sigaction(numbers[i], &before[i], NULL);
    sigaltstack(&stack_before, NULL);
}
