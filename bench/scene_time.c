#include "scene_time.h"

#include <stdlib.h>

#include "bench/lighting.h"
#include "core/format/formats.h"
#include "method.h"
#include "scene_osmesa.h"
#include "timing.h"

enum { TEXELS = 256, TIMES_MAX = 41 };

/* A picture takes this long at most before it is timed less often. */
static const double enough_ns = 3e8;

static uint64_t counted;

static void count(const struct pel_paint *paint, const struct pel_spans *rows)
{
    (void)paint;
    for (int32_t i = 0; i < rows->n; i++)
        if (rows->span[i].x0 < rows->span[i].x1)
            counted += (uint64_t)(rows->span[i].x1 - rows->span[i].x0);
}

static const struct pel_paint *counting_paint(
    struct pel_frame *frame, const struct pel_color_paint *surface)
{
    static const struct pel_paint counting = {count, NULL};
    (void)frame;
    (void)surface;
    return &counting;
}

static const struct pel_shading counting = {NULL, NULL, counting_paint};

static void *memory(size_t size)
{
    void *m = malloc(size);
    if (!m)
        method_fail("out of memory", "free some and start again");
    return m;
}

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
    pel_color *texels = memory(sizeof *texels * TEXELS * TEXELS);
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
        .lighting = &lighting,
        .sort = mode->depth_bits ? NULL : &pel_depth_sort,
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
    s->pixels = memory(4 * (size_t)side * (size_t)side);
    s->depths = memory(depths + 1);
    s->depth_bits = mode->depth_bits;
    s->scratch_size = pel_scene_scratch_size(&s->scene);
    s->scratch = memory(s->scratch_size);
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

static void draw(struct stage *s)
{
    struct pel_frame frame;
    if (pel_scene_prepare(&frame, &s->scene, s->scratch, s->scratch_size))
        method_fail("a mesh was refused", "look at pel_mesh_check");
    if (!s->depth_bits) {
        pel_scene_draw(&frame, &s->surface);
        return;
    }
    pel_depth_clear(&s->depth);
    pel_scene_draw_depth(&frame, &s->surface, &s->depth);
}

static double pixels_of(struct stage *s)
{
    const struct pel_shading *shading = s->scene.shading;
    const int depth_bits = s->depth_bits;
    counted = 0;
    s->scene.shading = &counting;
    s->depth_bits = 0;
    draw(s);
    s->scene.shading = shading;
    s->depth_bits = depth_bits;
    return (double)counted;
}

static void draw_stage(void *stage)
{
    draw(stage);
}

/* ns, the median; after one that is not timed. */
static double time_of(void (*draw_one)(void *), void *data)
{
    double times[TIMES_MAX], sum = 0;
    int n = 0;
    draw_one(data);
    while (n < 3 || (n < TIMES_MAX && sum < enough_ns)) {
        const double from = timing_now();
        draw_one(data);
        sum += times[n] = timing_now() - from;
        n++;
    }
    return timing_quartiles(times, n).median;
}

#ifdef BENCH_OSMESA
static double peer_time(const struct pel_scene *scene)
{
    void *peer = scene_osmesa_open(scene);
    const double ns = time_of(scene_osmesa_draw, peer);
    scene_osmesa_close(peer);
    return ns;
}
#else
static double peer_time(const struct pel_scene *scene)
{
    (void)scene;
    return 0;
}
#endif

void bench_scene_time(struct scene_result *out, const struct bench_mesh *m,
                      const struct scene_mode *mode, int32_t side)
{
    struct stage s = {0};
    open_stage(&s, m, mode, side);
    out->pixels = pixels_of(&s);
    out->ns = time_of(draw_stage, &s);
    out->peer_ns = 0;
    if (mode->depth_bits == 32)
        out->peer_ns = peer_time(&s.scene);
    close_stage(&s);
}
