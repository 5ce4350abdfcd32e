/* The floor: the runs of pixels are known beforehand, and only stored. What a
 * method takes above this is its own work, about; what lies below is memory.
 * Alpha is a load, an exclusive or and a store: less than any blend does. */
#include "method.h"

#include <stdlib.h>
#include <string.h>

#include "coverage.h"

typedef uint32_t vector __attribute__((vector_size(16)));

struct run {
    uint8_t *start;
    size_t bytes;
};

struct item {
    int first; /* of its runs; they end where the next item's begin */
    vector value;
};

struct job {
    struct run *run;
    struct item *item;
    void (*put)(uint8_t *p, size_t bytes, vector value);
    int runs, room;
    bool fetches; /* into the cache, AHEAD runs before they are stored */
};

/* A canvas of more bytes does not stay in the cache of one core. */
enum { CACHED = 1 << 20 };

/* Runs from now, and bytes of a run, that are fetched. */
enum { AHEAD = 4, FETCHED = 512 };

static void put_short(uint8_t *p, size_t n, vector v)
{
    size_t part = n >= 8 ? 8 : n >= 4 ? 4 : 2;
    if (part == 8) {
        memcpy(p, &v, 8);
        memcpy(p + n - 8, &v, 8);
    } else if (part == 4) {
        memcpy(p, &v, 4);
        memcpy(p + n - 4, &v, 4);
    } else {
        memcpy(p, &v, 2);
        memcpy(p + n - 2, &v, 2);
    }
}

static void put_twice(uint8_t *p, vector v)
{
    memcpy(p, &v, 16);
    memcpy(p + 16, &v, 16);
}

/* In a cache the branches cost most: classes of length, stores that overlap. */
static void put_near(uint8_t *p, size_t n, vector v)
{
    uint8_t *end = p + n;
    if (n < 16) {
        put_short(p, n, v);
        return;
    }
    memcpy(p, &v, 16);
    memcpy(end - 16, &v, 16);
    if (n <= 32)
        return;
    memcpy(p + 16, &v, 16);
    memcpy(end - 32, &v, 16);
    if (n <= 64)
        return;
    while ((p += 32) < end - 32)
        put_twice(p, v);
}

/* Outside, the order: upwards, the middle at multiples of 16. */
static void put_far(uint8_t *p, size_t n, vector v)
{
    uint8_t *last = p + n - 16;
    if (n < 16) {
        put_short(p, n, v);
        return;
    }
    memcpy(p, &v, 16);
    p += 16 - ((uintptr_t)p & 15);
    for (; p < last - 48; p += 64)
        for (int i = 0; i < 64; i += 16)
            memcpy(p + i, &v, 16);
    for (; p < last; p += 16)
        memcpy(p, &v, 16);
    memcpy(last, &v, 16);
}

static void flip(uint8_t *p, size_t n, vector v)
{
    vector there = {0};
    memcpy(&there, p, n);
    there ^= v;
    memcpy(p, &there, n);
}

static void put_alpha(uint8_t *p, size_t n, vector v)
{
    for (; n >= 16; n -= 16, p += 16)
        flip(p, 16, v);
    if (n & 8)
        flip(p, 8, v);
    p += n & 8;
    if (n & 4)
        flip(p, 4, v);
    p += n & 4;
    if (n & 2)
        flip(p, 2, v);
}

static void add_run(struct job *job, struct run run)
{
    if (job->runs == job->room) {
        job->room = 2 * job->room + 1024;
        job->run = realloc(job->run, (size_t)job->room * sizeof *job->run);
        if (!job->run)
            method_fail("out of memory", "free some and start again");
    }
    job->run[job->runs++] = run;
}

/* The runs of one line of a mask. */
static void add_line(struct job *job, const uint8_t *mask, int n,
                     uint8_t *pixels, int pixel_bytes)
{
    for (int x = 0, from; x < n; x++) {
        if (!mask[x])
            continue;
        for (from = x; x < n && mask[x];)
            x++;
        add_run(job, (struct run){pixels + from * pixel_bytes,
                                  (size_t)((x - from) * pixel_bytes)});
    }
}

static void add_runs(struct job *job, const struct drawing *d, int i)
{
    const struct canvas *c = d->canvas;
    const struct box box = shape_box(d->workload, &d->workload->shape[i]);
    const uint8_t *mask = d->mask;
    drawing_draw(d, &box, i);
    for (int y = box.y0; y < box.y1; y++, mask += box.x1 - box.x0)
        add_line(job, mask, box.x1 - box.x0, canvas_address(c, box.x0, y),
                 c->bits / 8);
}

static void choose(struct job *job, const struct workload *w,
                   const struct canvas *c)
{
    bool far = canvas_bytes(c) > CACHED;
    job->fetches = far && w->paint != PAINT_ALPHA;
    if (w->paint == PAINT_ALPHA)
        job->put = put_alpha;
    else
        job->put = far ? put_far : put_near;
}

static void *open_job(const struct workload *w, const struct canvas *c)
{
    struct job *job = method_allocate(1, sizeof *job);
    struct drawing pel = drawing_open(methods[0], w, c);
    choose(job, w, c);
    job->item = method_allocate(w->count + 1, sizeof *job->item);
    for (int i = 0; i < w->count; i++) {
        const uint32_t color = w->shape[i].color[0];
        job->item[i].first = job->runs;
        job->item[i].value = (vector){color, color, color, color};
        add_runs(job, &pel, i);
    }
    job->item[w->count].first = job->runs;
    for (int i = 0; i < AHEAD; i++)
        add_run(job, (struct run){c->pixels, 0});
    drawing_close(&pel);
    return job;
}

static void fetch(const struct run *r)
{
    size_t n = r->bytes < FETCHED ? r->bytes : FETCHED;
    for (size_t i = 0; i < n; i += 64)
        __builtin_prefetch(r->start + i, 1);
}

static void draw(void *data, int first, int n)
{
    const struct job *job = data;
    for (const struct item *item = job->item + first; n > 0; n--, item++) {
        const struct run *end = job->run + item[1].first;
        for (const struct run *r = job->run + item->first; r < end; r++) {
            if (job->fetches)
                fetch(r + AHEAD);
            job->put(r->start, r->bytes, item->value);
        }
    }
}

static void close_job(void *data)
{
    struct job *job = data;
    free(job->run);
    free(job->item);
    free(job);
}

extern const struct method method_floor;
const struct method method_floor = {"floor", "packaged", open_job, draw,
                                    close_job};
