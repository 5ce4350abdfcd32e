#define _POSIX_C_SOURCE 200809L
#include "scene_time.h"

#include <pthread.h>
#include <stdlib.h>
#include <time.h>

#include "bench/lighting.h"
#include "core/format/formats.h"
#include "core/scene/depth.h"
#include "core/scene/mapping.h"
#include "method.h"
#include "scene_osmesa.h"

enum { TEXELS = 256, TIMES_MAX = 41, THREADS_MAX = 64 };

/* A picture takes this long at most before it is timed less often. */
static const double enough_ns = 5e7;

static uint64_t counted;

static void count(const struct pel_paint *paint, const struct pel_spans *rows)
{
    (void)paint;
    for (int32_t i = 0; i < rows->n; i++)
        if (rows->span[i].x0 < rows->span[i].x1)
            counted += (uint64_t)(rows->span[i].x1 - rows->span[i].x0);
}

static const struct pel_paint *counting_paint(
    struct pel_frame *frame, const struct pel_color_paint *surface,
    const pel_color color[3])
{
    static const struct pel_paint counting = {count, NULL};
    (void)frame;
    (void)surface;
    (void)color;
    return &counting;
}

static const struct pel_shading counting = {NULL, NULL, counting_paint, 0};

/* What a picture is drawn with. */
struct stage {
    struct pel_scene scene;
    struct pel_mesh_texture texture;
    struct pel_surface surface;
    struct pel_depth depth;
    void *pixels, *scratch, *depths, *texels;
    size_t scratch_size;
    int depth_bits;
};

static pel_color *noise(void)
{
    pel_color *texels = method_allocate(TEXELS * TEXELS, sizeof *texels);
    uint32_t word = 1;
    for (int i = 0; i < TEXELS * TEXELS; i++) {
        word = word * 1664525u + 1013904223u;
        texels[i] = UINT32_C(0xFF000000) | word >> 8;
    }
    return texels;
}

static void set_scene(struct stage *s, const struct bench_mesh *m,
                      const struct scene_mode *mode, int32_t side)
{
    s->scene = (struct pel_scene){
        .mesh = &m->mesh,
        .camera = {.eye = {PEL_UNITS(1) / 2, PEL_UNITS(3) / 4,
                           PEL_UNITS(3) / 2},
                   .up = {0, 1, 0},
                   .near_plane = PEL_UNITS(1) / 64,
                   .focal = 50,
                   .sensor = {40, 40}},
        .viewport = {0, 0, side, side},
        .shading = mode->shading,
        .tolerance = mode->steps * 256,
        .lighting = &lighting,
        .sort = mode->depth_bits ? NULL : &pel_depth_sort_radix,
        .cull = PEL_CULL_BACK};
    s->texture = (struct pel_mesh_texture){
        .texels = {NULL, s->texels, TEXELS, TEXELS, true},
        .mapping = mode->mapping,
        .sampler = mode->bilinear ? pel_texture_init_bilinear
                                  : pel_texture_init_nearest,
        .wrap_u = PEL_WRAP_REPEAT,
        .wrap_v = PEL_WRAP_REPEAT,
        .span = mode->span};
    if (mode->mapping)
        s->scene.texture = &s->texture;
}

static void open_stage(struct stage *s, const struct bench_mesh *m,
                       const struct scene_mode *mode, int32_t side)
{
    const struct pel_rect all = {0, 0, side, side};
    const size_t depths = pel_depth_size(&all, mode->depth_bits);
    s->texels = noise();
    set_scene(s, m, mode, side);
    s->pixels = method_allocate(side * side, 4);
    s->depths = method_allocate(1, depths + 1);
    s->depth_bits = mode->depth_bits;
    s->scratch_size = pel_scene_scratch_size(&s->scene);
    s->scratch = method_allocate(1, s->scratch_size);
    if (pel_surface_init(&s->surface, &pel_xrgb8888, s->pixels,
                         (size_t)side * (size_t)side * 4,
                         &(struct pel_rect){0, 0, side, side}) ||
        (depths &&
         pel_depth_init(&s->depth, &all, mode->depth_bits, s->depths, depths)))
        method_fail("no such picture", "choose another size");
}

static void close_stage(struct stage *s)
{
    free(s->texels);
    free(s->pixels);
    free(s->depths);
    free(s->scratch);
}

static void prepare(struct pel_frame *frame, const struct stage *s,
                    void *scratch)
{
    if (pel_scene_prepare(frame, &s->scene, scratch, s->scratch_size))
        method_fail("a mesh was refused", "look at pel_mesh_check");
}

static void draw_band(struct pel_frame *frame, const struct stage *s, int i,
                      int n)
{
    struct pel_surface band = s->surface;
    const int32_t side = s->scene.viewport.x1;
    pel_surface_clip(
        &band, &(struct pel_rect){0, side * i / n, side, side * (i + 1) / n});
    pel_scene_draw(frame, &band);
}

/* One thread of several, which draws every n-th band. */
struct worker {
    pthread_t thread;
    const struct stage *stage;
    void *scratch;
    int first, threads, bands;
    double ns; /* its CPU time */
};

static double thread_now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec * 1e9 + (double)t.tv_nsec;
}

static void *work(void *data)
{
    struct worker *w = data;
    const double from = thread_now();
    struct pel_frame frame;
    prepare(&frame, w->stage, w->scratch);
    for (int i = w->first; i < w->bands; i += w->threads)
        draw_band(&frame, w->stage, i, w->bands);
    w->ns = thread_now() - from;
    return NULL;
}

/* The time of the longest thread. */
static double draw_threads(struct stage *s, const struct scene_cut *cut)
{
    static struct worker worker[THREADS_MAX];
    double longest = 0;
    for (int k = 0; k < cut->threads; k++) {
        worker[k] =
            (struct worker){.stage = s,
                            .scratch = method_allocate(1, s->scratch_size),
                            .first = k,
                            .threads = cut->threads,
                            .bands = cut->bands};
        if (pthread_create(&worker[k].thread, NULL, work, &worker[k]))
            method_fail("no more threads", "ask for fewer");
    }
    for (int k = 0; k < cut->threads; k++) {
        pthread_join(worker[k].thread, NULL);
        free(worker[k].scratch);
        if (worker[k].ns > longest)
            longest = worker[k].ns;
    }
    return longest;
}

static void draw(struct stage *s, const struct scene_cut *cut)
{
    struct pel_frame frame;
    prepare(&frame, s, s->scratch);
    if (s->depth_bits) {
        pel_depth_clear(&s->depth);
        pel_scene_draw_depth(&frame, &s->surface, &s->depth);
        return;
    }
    for (int i = 0; i < cut->bands; i++)
        draw_band(&frame, s, i, cut->bands);
}

static double pixels_of(struct stage *s)
{
    const struct pel_shading *shading = s->scene.shading;
    const int depth_bits = s->depth_bits;
    counted = 0;
    s->scene.shading = &counting;
    s->depth_bits = 0;
    draw(s, &(struct scene_cut){0, 1, 1});
    s->scene.shading = shading;
    s->depth_bits = depth_bits;
    return (double)counted;
}

/* A picture, and how it is cut. */
struct picture_job {
    struct stage *stage;
    const struct scene_cut *cut;
};

static double time_job(void *data)
{
    const struct picture_job *job = data;
    const double from = timing_now();
    if (job->cut->threads > 1)
        return draw_threads(job->stage, job->cut);
    draw(job->stage, job->cut);
    return timing_now() - from;
}

/* What is timed: a picture of Pel's, or OSMesa's. */
struct timed {
    double (*one)(void *);
    void *data;
    double times[TIMES_MAX];
};

/* In turns, so that what else the machine does slows all; after one that does
 * not count. Returns how many. */
static int time_in_turns(struct timed *all, int jobs)
{
    double sum = 0;
    int n = 0;
    for (int i = 0; i < jobs; i++)
        all[i].one(all[i].data);
    while (n < 3 || (n < TIMES_MAX && sum < enough_ns * jobs)) {
        for (int i = 0; i < jobs; i++)
            sum += all[i].times[n] = all[i].one(all[i].data);
        n++;
    }
    return n;
}

#ifdef BENCH_OSMESA
static double time_peer(void *peer)
{
    const double from = timing_now();
    scene_osmesa_draw(peer);
    return timing_now() - from;
}

static struct scene_difference difference(const uint32_t *a, const uint32_t *b,
                                          int32_t n)
{
    struct scene_difference d = {0, 0, 0};
    int32_t channels = 0;
    for (int32_t i = 0; i < n; i++) {
        d.pixels += a[i] >> 24 != b[i] >> 24;
        for (int k = 0; k < 24 && a[i] >> 24 && b[i] >> 24; k += 8) {
            const int32_t by =
                abs((int)(a[i] >> k & 255) - (int)(b[i] >> k & 255));
            d.most = pel_max(d.most, by);
            d.mean += by;
            channels++;
        }
    }
    d.mean /= pel_max(channels, 1);
    return d;
}

static void time_both(struct scene_result *out, struct timed all[2],
                      const struct stage *s)
{
    void *peer = scene_osmesa_open(&s->scene);
    all[1] = (struct timed){.one = time_peer, .data = peer};
    const int n = time_in_turns(all, 2);
    out->ns = timing_quartiles(all[0].times, n);
    out->peer_ns = timing_quartiles(all[1].times, n);
    out->difference = difference(s->pixels, scene_osmesa_pixels(peer),
                                 s->scene.viewport.x1 * s->scene.viewport.y1);
    scene_osmesa_close(peer);
}
#endif

void bench_scene_time(struct scene_result *out, const struct bench_mesh *m,
                      const struct scene_mode *mode,
                      const struct scene_cut *cut)
{
    struct stage s = {0};
    open_stage(&s, m, mode, cut->side);
    struct timed all[2] = {
        {.one = time_job, .data = &(struct picture_job){&s, cut}}};
    *out = (struct scene_result){.pixels = pixels_of(&s)};
#ifdef BENCH_OSMESA
    if (mode->depth_bits == 32)
        time_both(out, all, &s);
#endif
    if (out->peer_ns.median == 0)
        out->ns = timing_quartiles(all[0].times, time_in_turns(all, 1));
    close_stage(&s);
}
