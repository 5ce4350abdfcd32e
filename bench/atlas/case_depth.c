/* Which triangle is seen: painters and depth buffers against the nearest one at
 * every pixel centre, in double precision. */
#include <math.h>
#include <string.h>

#include <pel/pel.h>

#include "../methods/order.h"
#include "cases.h"
#include "scenes.h"
#include "sheet.h"

enum { PIXELS = SCENE_SIDE * SCENE_SIDE };

/* 1 + the number of the triangle that is seen, 0 where there is none, and
 * near / z there. */
struct picture {
    int32_t seen[PIXELS];
    double inverse[PIXELS];
};

/* near / z at a pixel's centre. */
static double inverse_at(const struct scene_triangle *t, int32_t x, int32_t y)
{
    const double px = 256.0 * x + 128, py = 256.0 * y + 128;
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        const struct pel_point *a = &t->v[(i + 1) % 3];
        const struct pel_point *b = &t->v[(i + 2) % 3];
        sum += ((b->x - a->x) * (py - a->y) - (b->y - a->y) * (px - a->x)) *
               (SCENE_NEAR / t->z[i]);
    }
    return sum / (double)pel_triangle_area(t->v);
}

static void look(struct picture *p, const struct scene *s)
{
    memset(p, 0, sizeof *p);
    for (int32_t i = 0; i < s->n; i++)
        for (int32_t y = 0; y < SCENE_SIDE; y++) {
            const struct pel_span row = exact_row(s->triangle[i].v, y, 8);
            const int32_t x1 = pel_min(row.x1, SCENE_SIDE);
            for (int32_t x = pel_max(row.x0, 0); x < x1; x++) {
                const int32_t at = y * SCENE_SIDE + x;
                const double inverse = inverse_at(&s->triangle[i], x, y);
                if (inverse > p->inverse[at]) {
                    p->inverse[at] = inverse;
                    p->seen[at] = i + 1;
                }
            }
        }
}

static void draw_plain(const struct pel_surface *s, const struct scene *scene,
                       int32_t i)
{
    const struct pel_flat flat = PEL_FLAT(PEL_RGB(0, 0, 0) | (unsigned)(i + 1));
    pel_triangle(s, scene->triangle[i].v, &flat.paint);
}

static void draw_sorted(const struct pel_surface *s, const struct scene *scene,
                        const struct order_method *m)
{
    static struct pel_depth_entry entry[SCENE_TRIANGLES];
    for (int32_t i = 0; i < scene->n; i++) {
        entry[i].depth = (int32_t)lround(m->key(scene->triangle[i].z) * 1e6);
        entry[i].index = (uint32_t)i;
    }
    pel_depth_sort.sort(entry, (uint32_t)scene->n, NULL);
    for (int32_t i = 0; i < scene->n; i++)
        draw_plain(s, scene, (int32_t)entry[i].index);
}

static void draw_deep(const struct pel_surface *s, const struct scene *scene,
                      const struct pel_depth *depth, int32_t i)
{
    const struct scene_triangle *t = &scene->triangle[i];
    const struct pel_flat flat = PEL_FLAT(PEL_RGB(0, 0, 0) | (unsigned)(i + 1));
    struct pel_plane_setup setup;
    struct pel_depth_paint paint;
    struct pel_plane plane;
    int32_t value[3];
    for (int k = 0; k < 3; k++)
        value[k] = (int32_t)lround(PEL_DEPTH_NEAR * (SCENE_NEAR / t->z[k]));
    pel_plane_start(&setup, t->v);
    pel_plane_set(&plane, &setup, value);
    pel_depth_paint_init(&paint, &flat.paint, depth, &plane, true);
    pel_triangle(s, t->v, &paint.base.paint);
}

static void draw_all_deep(const struct pel_surface *s,
                          const struct scene *scene, int bits)
{
    static uint32_t memory[PIXELS];
    struct pel_depth depth;
    if (pel_depth_init(&depth, &s->bounds, bits, memory, sizeof memory))
        method_fail("a depth buffer is refused", "give it memory");
    for (int32_t i = 0; i < scene->n; i++)
        draw_deep(s, scene, &depth, i);
}

static const struct pel_paint *paint_number(
    struct pel_frame *frame, const struct pel_color_paint *surface,
    const pel_color color[3])
{
    struct pel_flat *flat = &frame->work->paint.flat;
    const uint32_t number = frame->work->triangle.vertex[0] / 3 + 1;
    (void)surface;
    (void)color;
    *flat = (struct pel_flat)PEL_FLAT(PEL_RGB(0, 0, 0) | number);
    return &flat->paint;
}

/* Vertex i of the mesh is vertex i % 3 of triangle i / 3. */
static void prepare(struct pel_frame *frame, const struct scene *scene)
{
    static const struct pel_shading numbers = {NULL, NULL, paint_number, 0};
    static uint16_t corner[SCENE_TRIANGLES][3];
    static uint64_t scratch[PEL_SCENE_SCRATCH_SIZE(3 * SCENE_TRIANGLES,
                                                   SCENE_TRIANGLES, 0) /
                            8];
    static struct pel_mesh mesh;
    static struct pel_scene view;
    for (int i = 0; i < 3 * SCENE_TRIANGLES; i++)
        corner[i / 3][i % 3] = (uint16_t)i;
    mesh = (struct pel_mesh){.vertices = 3 * (uint32_t)scene->n,
                             .triangles = (uint32_t)scene->n,
                             .position = scene_unit,
                             .positions = scene->position[0],
                             .indices16 = (const uint16_t(*)[3])corner};
    view = (struct pel_scene){.mesh = &mesh,
                              .camera = scene_camera,
                              .viewport = scene_screen,
                              .shading = &numbers,
                              .sort = &pel_depth_sort};
    if (pel_scene_prepare(frame, &view, scratch, sizeof scratch))
        method_fail("a scene is refused", "take a legal one");
}

/* Painter's order, and depths where it is not proven: the share of the screen
 * that needs them. */
static double draw_certified(const struct pel_surface *s,
                             const struct scene *scene)
{
    static uint32_t
        proof[PEL_CERTIFICATE_SCRATCH_SIZE(SCENE_TRIANGLES) / 4 + 1];
    static uint32_t memory[PIXELS];
    struct pel_frame frame;
    struct pel_depth depth;
    struct pel_doubt doubt;
    prepare(&frame, scene);
    if (pel_scene_certify(&frame, proof, sizeof proof, UINT32_MAX, &doubt))
        method_fail("no certificate", "give it memory");
    const struct pel_rect *b = &doubt.bounds;
    if (!pel_rect_empty(b) &&
        pel_depth_init(&depth, b, 32, memory, sizeof memory))
        method_fail("a depth buffer is refused", "give it memory");
    pel_scene_draw_certified(&frame, s, b, &depth);
    return (double)(b->x1 - b->x0) * (b->y1 - b->y0) / PIXELS;
}

struct verdict {
    double covered, wrong;
    double gap; /* the largest near / z between what is nearest and what is
                   shown */
};

static void compare(struct verdict *v, const struct picture *p,
                    const struct scene *scene, const struct sheet *sheet)
{
    for (int32_t i = 0; i < PIXELS; i++) {
        const int32_t shown = (int32_t)(sheet->pixels[i] & 0xFFFFFF);
        v->covered += p->seen[i] != 0;
        if (shown == p->seen[i])
            continue;
        v->wrong++;
        const double inverse = shown
                                   ? inverse_at(&scene->triangle[shown - 1],
                                                i % SCENE_SIDE, i / SCENE_SIDE)
                                   : 0;
        v->gap = fmax(v->gap, p->inverse[i] - inverse);
    }
    memset(sheet->pixels, 0, PIXELS * sizeof *sheet->pixels);
}

static struct figure wrong_of(const char *method, double x,
                              const struct verdict *v)
{
    return figure_of(method, x, "wrong_ppm", 1e6 * v->wrong / v->covered,
                     "ppm");
}

static void put_order(struct atlas *a, const char *method, int scene,
                      const struct verdict *v)
{
    struct figure f = wrong_of(method, scene, v);
    f.y = scene;
    f.has_y = true;
    atlas_put(a, f);
}

/* A method that is right but where depths are nearer to each other than it
 * tells apart, near / z (depth.h). */
static void put_depth(struct atlas *a, const char *method, int bits, int scene,
                      const struct verdict *v)
{
    const double unit = bits == 16 ? 65536 : 65536.0 * 8192;
    struct figure f =
        figure_of(method, scene, "gap_max", v->gap * unit, "smallest gap");
    put_order(a, method, scene, v);
    f.y = scene;
    f.has_y = true;
    atlas_put_bound(a, f, 1);
}

enum { ORDERS = 3, DEEP_16 = ORDERS, DEEP_32, CERTIFIED, WAYS };

static void put_scene(struct atlas *a, int number, struct sheet *sheet)
{
    static struct picture picture;
    static struct scene scene;
    struct verdict v[WAYS] = {{0, 0, 0}};
    double share = 0;
    const int kinds = scene_makers[number].kinds;
    const int samples = atlas_samples(a, kinds, pel_min(kinds, 2));
    for (int n = 0; n < samples; n++) {
        struct random r = atlas_random(a, (uint32_t)(number * 1000 + n));
        scene_make(&scene, &scene_makers[number], &r);
        look(&picture, &scene);
        for (int i = 0; i < WAYS; i++) {
            if (i < ORDERS)
                draw_sorted(&sheet->surface, &scene, &order_methods[i]);
            else if (i < CERTIFIED)
                draw_all_deep(&sheet->surface, &scene, i == DEEP_16 ? 16 : 32);
            else
                share += draw_certified(&sheet->surface, &scene) / samples;
            compare(&v[i], &picture, &scene, sheet);
        }
    }
    for (int i = 0; i < ORDERS; i++)
        put_order(a, order_methods[i].name, number, &v[i]);
    put_depth(a, "zbuffer16", 16, number, &v[DEEP_16]);
    put_depth(a, "zbuffer32", 32, number, &v[DEEP_32]);
    put_depth(a, "certificate and depths", 32, number, &v[CERTIFIED]);
    atlas_put(a, figure_of("certificate and depths", number, "depths_percent",
                           100 * share, "%"));
}

static void open_screen(struct sheet *s, struct atlas *a)
{
    sheet_open(s, a, (struct pel_rect){0, 0, SCENE_SIDE, SCENE_SIDE});
}

void atlas_order(struct atlas *a)
{
    struct sheet sheet;
    open_screen(&sheet, a);
    for (int i = 0; scene_makers[i].name; i++)
        put_scene(a, i, &sheet);
    sheet_close(&sheet);
}

/* Two parallel triangles, the farther one first, `gap` times the smallest gap
 * of 16 bits apart. */
static void pair_of(struct random *r, double gap, struct scene *s)
{
    struct scene_triangle *t = s->triangle;
    const double z = SCENE_NEAR * pow(10, random_between(r, 1000, 3000) / 1e3);
    do {
        for (int k = 0; k < 3; k++) {
            t[1].v[k].x =
                random_between(r, -PEL_PX(SCENE_SIDE), 2 * PEL_PX(SCENE_SIDE));
            t[1].v[k].y =
                random_between(r, -PEL_PX(SCENE_SIDE), 2 * PEL_PX(SCENE_SIDE));
            t[1].z[k] = z * random_between(r, 900, 1100) / 1000.0;
        }
        t[0] = t[1];
    } while (pel_triangle_area(t[1].v) == 0);
    /* near / z - near / (z + dz) is `gap` steps of 2^-16. */
    for (int k = 0; k < 3; k++)
        t[0].z[k] = 1 / (1 / t[1].z[k] - gap / 65536 / SCENE_NEAR);
    s->n = 2;
}

void atlas_fighting(struct atlas *a)
{
    static struct picture picture;
    static struct scene scene;
    struct sheet sheet;
    open_screen(&sheet, a);
    for (int bits = 16; bits <= 32; bits += 16)
        for (int power = bits == 16 ? -6 : -20; power <= 2; power++) {
            const double gap = exp2(power);
            struct random r = atlas_random(a, (uint32_t)(power + 32));
            struct verdict v = {0, 0, 0};
            for (int n = atlas_samples(a, 300, 10); n > 0; n--) {
                pair_of(&r, gap, &scene);
                look(&picture, &scene);
                draw_all_deep(&sheet.surface, &scene, bits);
                compare(&v, &picture, &scene, &sheet);
            }
            const struct figure f =
                wrong_of(bits == 16 ? "zbuffer16" : "zbuffer32", gap, &v);
            atlas_put(a, f);
            if (gap > (bits == 16 ? 1 : 1. / 8192))
                atlas_promise(a, v.wrong == 0, &f);
        }
    sheet_close(&sheet);
}
