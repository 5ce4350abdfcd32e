#define _POSIX_C_SOURCE 200809L
/* Times the 3-D pipeline: meshes in every mode, and how time grows with
 * triangles, pixels, bands, and shrinks with CPUs. Prints a table, and writes
 * it as CSV. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/scene/select.h"
#include "method.h"
#include "scene_time.h"

static const struct scene_mode modes[] = {
    {.name = "flat", .shading = &pel_shade_lit_flat},
    {.name = "gouraud", .shading = &pel_shade_lit_gouraud},
    {.name = "phong", .shading = &pel_shade_phong},
    {.name = "phong to 1 step", .shading = &pel_shade_chosen, .steps = 1},
    {.name = "phong to 2 steps", .shading = &pel_shade_chosen, .steps = 2},
    {.name = "phong to 4 steps", .shading = &pel_shade_chosen, .steps = 4},
    {"nearest affine", &pel_shade_flat, &pel_map_affine, false, 0, 0, 0},
    {"nearest perspective/16", &pel_shade_flat, &pel_map_perspective, false, 16,
     0, 0},
    {"bilinear affine", &pel_shade_flat, &pel_map_affine, true, 0, 0, 0},
    {"bilinear perspective/16", &pel_shade_flat, &pel_map_perspective, true, 16,
     0, 0},
    {"bilinear perspective", &pel_shade_flat, &pel_map_perspective, true, 1, 0,
     0},
    {"lit bilinear affine", &pel_shade_lit_gouraud, &pel_map_affine, true, 0, 0,
     0},
    {.name = "flat z32", .shading = &pel_shade_lit_flat, .depth_bits = 32},
    {.name = "gouraud z16",
     .shading = &pel_shade_lit_gouraud,
     .depth_bits = 16},
    {.name = "gouraud z32",
     .shading = &pel_shade_lit_gouraud,
     .depth_bits = 32},
    {.name = "phong z32", .shading = &pel_shade_phong, .depth_bits = 32},
    {.name = "phong to 2 steps z32",
     .shading = &pel_shade_chosen,
     .depth_bits = 32,
     .steps = 2},
};

enum { MODES = sizeof modes / sizeof *modes, SIDE = 1024 };

#define MODELS "/usr/share/assimp/models/"

static const struct bench_mesh_file files[] = {
    {"duck", "duck.dae", MODELS "Collada/duck.dae",
     "Debian package assimp-testmodels"},
    {"spot", "spot/spot_triangulated.obj", NULL, NULL},
    {"fox", "fox/Fox.glb", NULL, NULL},
    {"suzanne", "suzanne/suzanne.ply", NULL, NULL},
    {"bunny", "bunny.obj", "/usr/share/glmark2/models/bunny.obj",
     "Debian package glmark2-data"},
    {"horse", "horse.3ds", "/usr/share/glmark2/models/horse.3ds",
     "Debian package glmark2-data"},
    {"cat", "cat.3ds", "/usr/share/glmark2/models/cat.3ds",
     "Debian package glmark2-data"},
    {"asteroid", "asteroid-high.3ds",
     "/usr/share/glmark2/models/asteroid-high.3ds",
     "Debian package glmark2-data"},
    {"2CylinderEngine", "2CylinderEngine.glb",
     MODELS "glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb",
     "Debian package assimp-testmodels"},
};

static const struct scene_cut whole = {SIDE, 1, 1};

static FILE *csv;

static void row(const char *part, const struct bench_mesh *m,
                const struct scene_mode *mode, const struct scene_cut *cut)
{
    struct scene_result r;
    const double n = m->mesh.triangles;
    bench_scene_time(&r, m, mode, cut);
    printf("%-16s %8.0f %-24s %5d px %3d bands %2d threads %10.3f ms"
           " %8.2f Mtri/s %8.1f ns/px",
           m->name, n, mode->name, cut->side, cut->bands, cut->threads,
           r.ns.median / 1e6, n / r.ns.median * 1e3,
           r.pixels > 0 ? r.ns.median / r.pixels : 0);
    if (r.peer_ns.median > 0)
        printf("  OSMesa %.3f ms, %.2f times; differs by %.2f of 255, %d at"
               " most, and %d px",
               r.peer_ns.median / 1e6, r.peer_ns.median / r.ns.median,
               r.difference.mean, r.difference.most, r.difference.pixels);
    putchar('\n');
    fflush(stdout);
    fprintf(csv, "%s,%s,%.0f,%s,%d,%d,%d,%.0f,%.0f,%.0f,%.0f,%.0f,%.0f,%.0f\n",
            part, m->name, n, mode->name, cut->side, cut->bands, cut->threads,
            r.pixels, r.ns.median, r.ns.q1, r.ns.q3, r.peer_ns.median,
            r.peer_ns.q1, r.peer_ns.q3);
}

/* In flat, Gouraud, Phong. */
static void rows(const char *part, const struct bench_mesh *m,
                 const struct scene_cut *cut)
{
    for (int k = 0; k < 3; k++)
        row(part, m, &modes[k], cut);
}

static void time_files(const char *part)
{
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        struct bench_mesh m;
        if (!bench_mesh_load(&m, &files[i]))
            continue;
        for (int k = 0; k < MODES; k++)
            row(part, &m, &modes[k], &whole);
        bench_mesh_free(&m);
    }
}

static void time_triangles(const char *part)
{
    struct bench_mesh m;
    for (uint32_t n = 1000; n <= 1000000; n *= 10) {
        bench_mesh_make(&m, n);
        rows(part, &m, &whole);
        bench_mesh_free(&m);
    }
}

static void time_pixels(const char *part)
{
    struct bench_mesh m;
    bench_mesh_make(&m, 20000);
    for (int32_t side = 64; side <= 4096; side *= 2)
        rows(part, &m, &(struct scene_cut){side, 1, 1});
    bench_mesh_free(&m);
}

static void time_bands(const char *part)
{
    struct bench_mesh m;
    bench_mesh_make(&m, 20000);
    for (int32_t bands = 1; bands <= 128; bands *= 2)
        rows(part, &m, &(struct scene_cut){SIDE, bands, 1});
    bench_mesh_free(&m);
}

/* As many bands for any number of threads; on all CPUs that there are. */
static void time_cores(const char *part)
{
    const long cores = sysconf(_SC_NPROCESSORS_ONLN);
    struct bench_mesh m;
    bench_mesh_make(&m, 20000);
    for (int32_t n = 1; n <= 16 && n <= cores; n *= 2)
        rows(part, &m, &(struct scene_cut){SIDE, 16, n});
    bench_mesh_free(&m);
}

static const struct {
    const char *name;
    void (*time)(const char *part);
    bool one_cpu;
} parts[] = {
    {"cores", time_cores, false},        {"mesh", time_files, true},
    {"triangles", time_triangles, true}, {"pixels", time_pixels, true},
    {"bands", time_bands, true},
};

int main(int argc, char **argv)
{
    int n = 0;
    if (argc < 2 || argc > 3)
        method_fail("usage: pel-bench-scene CSV [PART]",
                    "PART is cores, mesh, triangles, pixels, bands");
    csv = fopen(argv[1], "w");
    if (!csv)
        method_fail(argv[1], "name a file that can be written");
    fputs("part,mesh,triangles,mode,side,bands,threads,pixels,ns,q1,q3,"
          "osmesa_ns,osmesa_q1,osmesa_q3\n",
          csv);
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++)
        if (argc == 2 || strcmp(argv[2], parts[i].name) == 0) {
            if (parts[i].one_cpu)
                timing_pin();
            parts[i].time(parts[i].name);
            n++;
        }
    if (n == 0)
        method_fail(argv[2], "name a part that there is");
    if (ferror(csv) | fclose(csv))
        method_fail(argv[1], "name a file on a disk with free space");
    return 0;
}
