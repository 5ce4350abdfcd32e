#ifndef _GNU_SOURCE
#define _GNU_SOURCE
#endif
#include "pool.h"

#include <sched.h>
#include <signal.h>
#include <string.h>

/* Signals are the caller's: threads start with all of them blocked, but for
 * those of their own faults, which would end the process without a word. */
static void block_signals(sigset_t *before)
{
    static const int faults[] = {SIGSEGV, SIGBUS,  SIGFPE, SIGILL,
                                 SIGTRAP, SIGABRT, SIGSYS};
    sigset_t all;
    sigfillset(&all);
    for (size_t i = 0; i < sizeof(faults) / sizeof(*faults); i++)
        sigdelset(&all, faults[i]);
    pthread_sigmask(SIG_SETMASK, &all, before);
}

/* Takes parts until none is left; called and left with the lock held. */
static void take_parts(struct pel_pool *pool)
{
    while (pool->next < pool->parts) {
        int index = pool->next++;
        pool->busy++;
        pthread_mutex_unlock(&pool->lock);
        pool->work(pool->context, index);
        pthread_mutex_lock(&pool->lock);
        pool->busy--;
    }
    if (pool->busy == 0)
        pthread_cond_signal(&pool->done);
}

static void *thread_main(void *argument)
{
    struct pel_pool *pool = argument;
    pthread_mutex_lock(&pool->lock);
    while (!pool->ending) {
        take_parts(pool);
        pthread_cond_wait(&pool->begin, &pool->lock);
    }
    pthread_mutex_unlock(&pool->lock);
    return NULL;
}

void pel_pool_start(struct pel_pool *pool, int jobs)
{
    sigset_t before;
    memset(pool, 0, sizeof(*pool));
    pthread_mutex_init(&pool->lock, NULL);
    pthread_cond_init(&pool->begin, NULL);
    pthread_cond_init(&pool->done, NULL);
    block_signals(&before);
    while (pool->threads < jobs - 1 && pool->threads < PEL_POOL_MOST &&
           pthread_create(&pool->thread[pool->threads], NULL, thread_main,
                          pool) == 0)
        pool->threads++;
    pthread_sigmask(SIG_SETMASK, &before, NULL);
}

void pel_pool_run(struct pel_pool *pool, int parts, pel_pool_work *work,
                  void *context)
{
    pthread_mutex_lock(&pool->lock);
    pool->work = work;
    pool->context = context;
    pool->next = 0;
    pool->parts = parts;
    pthread_cond_broadcast(&pool->begin);
    take_parts(pool);
    while (pool->busy)
        pthread_cond_wait(&pool->done, &pool->lock);
    pool->next = pool->parts = 0;
    pthread_mutex_unlock(&pool->lock);
}

void pel_pool_end(struct pel_pool *pool)
{
    pthread_mutex_lock(&pool->lock);
    pool->ending = true;
    pthread_cond_broadcast(&pool->begin);
    pthread_mutex_unlock(&pool->lock);
    for (int i = 0; i < pool->threads; i++)
        pthread_join(pool->thread[i], NULL);
    pthread_cond_destroy(&pool->begin);
    pthread_cond_destroy(&pool->done);
    pthread_mutex_destroy(&pool->lock);
}

int pel_pool_processors(void)
{
    cpu_set_t set;
    int n = sched_getaffinity(0, sizeof(set), &set) ? 1 : CPU_COUNT(&set);
    return n < 1 ? 1 : n > PEL_POOL_MOST ? PEL_POOL_MOST : n;
}
