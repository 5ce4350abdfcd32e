/* Threads of a pool: their own faults are told by the program's handlers; other
 * signals are not theirs. */
#include <pthread.h>
#include <signal.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "port/linux/pool.h"
#include "tests/support/check.h"

enum { TOLD = 77, LOST = 78, BLOCKED = 79 };

struct job {
    pthread_t caller;
    int number; /* of a signal that a thread raises; 0: it says its mask */
};

static void on_fault(int number)
{
    (void)number;
    _exit(TOLD);
}

static void work(void *context, int index)
{
    const struct job *job = context;
    sigset_t mask;
    (void)index;
    usleep(1000);
    if (pthread_equal(pthread_self(), job->caller))
        return;
    if (job->number)
        raise(job->number);
    pthread_sigmask(SIG_SETMASK, NULL, &mask);
    _exit(sigismember(&mask, SIGTERM) && sigismember(&mask, SIGINT) &&
                  sigismember(&mask, SIGWINCH)
              ? BLOCKED
              : LOST);
}

/* How a process ends whose threads do that. */
static int end_of(int number)
{
    int status;
    const pid_t child = fork();
    if (child == 0) {
        struct pel_pool pool;
        struct job job = {pthread_self(), number};
        if (number)
            signal(number, on_fault);
        pel_pool_start(&pool, 3);
        pel_pool_run(&pool, 1000, work, &job);
        _exit(LOST);
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

TEST(faults)
{
    static const int numbers[] = {SIGSEGV, SIGBUS,  SIGFPE, SIGILL,
                                  SIGTRAP, SIGABRT, SIGSYS};
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
        assert_int_equal(end_of(numbers[i]), TOLD);
}

TEST(others)
{
    assert_int_equal(end_of(0), BLOCKED);
}
