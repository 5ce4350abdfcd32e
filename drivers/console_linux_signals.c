#ifndef _GNU_SOURCE
#define _GNU_SOURCE
#endif
#include "console_linux_signals.h"

#include <errno.h>
#include <signal.h>
#include <string.h>
#include <unistd.h>

static const int ending[] = {SIGHUP,  SIGINT,  SIGQUIT, SIGILL,  SIGTRAP,
                             SIGABRT, SIGBUS,  SIGFPE,  SIGSEGV, SIGPIPE,
                             SIGALRM, SIGTERM, SIGXCPU, SIGXFSZ, SIGSYS};
static const int stopping[] = {SIGTSTP, SIGTTIN, SIGTTOU};

enum {
    ENDING = sizeof(ending) / sizeof(ending[0]),
    STOPPING = sizeof(stopping) / sizeof(stopping[0])
};

static struct sigaction before[ENDING], before_stopping[STOPPING];
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
        if (ending[i] == number)
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
    for (int i = 0; i < ENDING; i++) {
        sigaction(ending[i], NULL, &before[i]);
        if (before[i].sa_handler != SIG_IGN)
            sigaction(ending[i], &action, NULL);
    }
    action.sa_handler = SIG_IGN;
    for (int i = 0; i < STOPPING; i++)
        sigaction(stopping[i], &action, &before_stopping[i]);
}

void pel_signals_release(void)
{
    for (int i = 0; i < ENDING; i++)
        sigaction(ending[i], &before[i], NULL);
    for (int i = 0; i < STOPPING; i++)
        sigaction(stopping[i], &before_stopping[i], NULL);
    sigaltstack(&stack_before, NULL);
}
