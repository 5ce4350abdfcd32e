/* Times the 3-D pipeline: meshes in every mode, and how time grows with
 * triangles and with pixels. Prints a table, and writes it as CSV. */
#include <stdio.h>
#include <stdlib.h>

#include "method.h"
#include "scene_time.h"
#include "timing.h"

static const struct scene_mode modes[] = {
    {"flat", &pel_shade_lit_flat, NULL, false, 0, 0},
    {"gouraud", &pel_shade_lit_gouraud, NULL, false, 0, 0},
    {"phong", &pel_shade_phong, NULL, false, 0, 0},
    {"nearest affine", &pel_shade_flat, &pel_map_affine, false, 0, 0},
    {"nearest perspective/16", &pel_shade_flat, &pel_map_perspective, false, 16,
     0},
    {"bilinear affine", &pel_shade_flat, &pel_map_affine, true, 0, 0},
    {"bilinear perspective/16", &pel_shade_flat, &pel_map_perspective, true, 16,
     0},
    {"bilinear perspective", &pel_shade_flat, &pel_map_perspective, true, 1, 0},
    {"lit bilinear affine", &pel_shade_lit_gouraud, &pel_map_affine, true, 0,
     0},
    {"flat z32", &pel_shade_lit_flat, NULL, false, 0, 32},
    {"gouraud z16", &pel_shade_lit_gouraud, NULL, false, 0, 16},
    {"gouraud z32", &pel_shade_lit_gouraud, NULL, false, 0, 32},
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

static void row(FILE *csv, const char *part, const struct bench_mesh *m,
                const struct scene_mode *mode, int32_t side)
{
    struct scene_result r;
    const double n = m->mesh.triangles;
    bench_scene_time(&r, m, mode, side);
    printf("%-16s %8.0f %-24s %5d %10.3f ms %8.2f Mtri/s %8.1f ns/px", m->name,
           n, mode->name, side, r.ns / 1e6, n / r.ns * 1e3,
           r.pixels > 0 ? r.ns / r.pixels : 0);
    if (r.peer_ns)
        printf("  OSMesa %.3f ms, %.2f times", r.peer_ns / 1e6,
               r.peer_ns / r.ns);
    putchar('\n');
    fflush(stdout);
    fprintf(csv, "%s,%s,%.0f,%s,%d,%.0f,%.0f,%.0f\n", part, m->name, n,
            mode->name, side, r.pixels, r.ns, r.peer_ns);
}

static void time_files(FILE *csv)
{
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        struct bench_mesh m;
        if (!bench_mesh_load(&m, &files[i]))
            continue;
        for (int k = 0; k < MODES; k++)
            row(csv, "mesh", &m, &modes[k], SIDE);
        bench_mesh_free(&m);
    }
}

/* In flat, Gouraud, Phong. */
static void time_growth(FILE *csv)
{
    struct bench_mesh m;
    for (uint32_t n = 1000; n <= 1000000; n *= 10) {
        bench_mesh_make(&m, n);
        for (int k = 0; k < 3; k++)
            row(csv, "triangles", &m, &modes[k], SIDE);
        bench_mesh_free(&m);
    }
    bench_mesh_make(&m, 20000);
    for (int32_t side = 64; side <= 4096; side *= 2)
        for (int k = 0; k < 3; k++)
            row(csv, "pixels", &m, &modes[k], side);
    bench_mesh_free(&m);
}

int main(int argc, char **argv)
{
    if (argc != 2)
        method_fail("usage: pel-bench-scene CSV", "name one file");
    FILE *csv = fopen(argv[1], "w");
    if (!csv)
        method_fail(argv[1], "name a file that can be written");
    fputs("part,mesh,triangles,mode,side,pixels,ns,osmesa_ns\n", csv);
    timing_pin();
    time_files(csv);
    time_growth(csv);
    if (ferror(csv) | fclose(csv))
        method_fail(argv[1], "name a file on a disk with free space");
    return 0;
}
