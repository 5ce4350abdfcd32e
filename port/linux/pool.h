/* A small pool of POSIX threads, for work that falls into independent parts.
 * Core does not use it: surfaces, paints and formats have no state, so
 * threads that draw into different bands of one surface need no locks. */
#ifndef PEL_PORT_LINUX_POOL_H
#define PEL_PORT_LINUX_POOL_H

#include <pthread.h>
#include <stdbool.h>

#include <pel/pel.h>

PEL_BEGIN_DECLS

enum { PEL_POOL_MOST = 64 };

/* Part `index` of the work. */
typedef void pel_pool_work(void *context, int index);

struct pel_pool {
    pthread_t thread[PEL_POOL_MOST];
    int threads; /* beside the caller */
    pthread_mutex_t lock;
    pthread_cond_t begin, done;
    pel_pool_work *work;
    void *context;
    int next, parts; /* parts handed out, and in all */
    int busy;        /* parts handed out that are not done */
    bool ending;
};

/* Starts jobs - 1 threads (the caller is the first), 1 <= jobs <=
 * PEL_POOL_MOST. Fewer when the system gives fewer; the pool works with none.
 * The struct stays where it is until pel_pool_end. */
void pel_pool_start(struct pel_pool *pool, int jobs);

/* work(context, 0) to work(context, parts - 1), each once, on all threads, the
 * caller's too; returns when all are done. */
void pel_pool_run(struct pel_pool *pool, int parts, pel_pool_work *work,
                  void *context);

void pel_pool_end(struct pel_pool *pool);

/* Processors that this process may use, 1 to PEL_POOL_MOST. */
int pel_pool_processors(void);
PEL_END_DECLS
#endif
