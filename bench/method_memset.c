/* The limit: as many bytes as the workload covers, from the start of the
 * canvas, in blocks that stay in the cache of one core. */
#include "method.h"

#include <stdlib.h>
#include <string.h>

#include "coverage.h"

enum { BLOCK = 392000 };

struct job {
    const struct canvas *canvas;
    double bytes_per_shape;
    size_t block;
};

static void *open_job(const struct workload *w, const struct canvas *c)
{
    struct job *job = method_allocate(1, sizeof *job);
    job->canvas = c;
    job->bytes_per_shape = coverage_mean(w, c) * c->bits / 8;
    job->block = canvas_bytes(c) < BLOCK ? canvas_bytes(c) : BLOCK;
    return job;
}

static void draw(void *data, int first, int n)
{
    const struct job *job = data;
    size_t bytes = (size_t)(n * job->bytes_per_shape);
    for (int value = first; bytes > 0; value++) {
        size_t part = bytes < job->block ? bytes : job->block;
        memset(job->canvas->pixels, value, part);
        bytes -= part;
    }
}

extern const struct method method_memset;
const struct method method_memset = {"memset", "packaged", open_job, draw,
                                     free};
