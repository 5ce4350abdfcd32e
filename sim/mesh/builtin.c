/* The built-in mesh: a vase, a profile turned around the y axis. Its colours
 * are its glaze: bands of blue and white over terracotta. */
#include "sim/mesh/mesh.h"

#include <math.h>

#define TURN 6.283185307179586

/* Around; the vertices of a ring, the first one again at the other end of the
 * texture; per piece of the profile. */
enum { SIDES = 48, COLUMNS = SIDES + 1, STEPS = 8 };

/* Radius and height where the pieces of the profile meet: outside from the
 * middle of the foot to the rim, then inside down to the neck. */
static const double profile[][2] = {
    {0, 0},       {0.42, 0},    {0.40, 0.10}, {0.62, 0.42},
    {0.70, 0.78}, {0.56, 1.14}, {0.30, 1.42}, {0.26, 1.60},
    {0.40, 1.84}, {0.34, 1.83}, {0.12, 1.60}, {0, 1.52},
};

enum {
    PIECES = sizeof(profile) / sizeof(profile[0]) - 1,
    RINGS = PIECES * STEPS + 1
};

/* Catmull-Rom through the points, so that the pieces join smoothly. */
static double spline(int piece, double t, int axis)
{
    double a = profile[piece > 0 ? piece - 1 : 0][axis];
    double b = profile[piece][axis];
    double c = profile[piece + 1][axis];
    double d = profile[piece + 1 < PIECES ? piece + 2 : PIECES][axis];
    return b +
           0.5 * t *
               (c - a +
                t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
}

static pel_color glaze(int ring, double height)
{
    if (ring > RINGS * 9 / PIECES)
        return PEL_RGB(150, 84, 52);
    if ((height > 0.55 && height < 0.66) || (height > 0.92 && height < 1.03))
        return PEL_RGB(240, 236, 224);
    return height > 0.5 && height < 1.3 ? PEL_RGB(40, 84, 160)
                                        : PEL_RGB(196, 110, 68);
}

static void set_ring(struct mesh *mesh, int ring)
{
    int piece = ring / STEPS < PIECES ? ring / STEPS : PIECES - 1;
    double t = (double)(ring - piece * STEPS) / STEPS;
    double radius = fmax(spline(piece, t, 0), 0);
    double height = fmax(spline(piece, t, 1), 0);
    for (int side = 0; side < COLUMNS; side++) {
        struct mesh_vertex *v = &mesh->vertex[ring * COLUMNS + side];
        double angle = TURN * (side % SIDES) / SIDES;
        v->position[0] = radius * sin(angle);
        v->position[1] = height;
        v->position[2] = radius * cos(angle);
        v->uv[0] = (double)side / SIDES;
        v->uv[1] = 1 - (double)ring / (RINGS - 1);
        v->color = glaze(ring, height);
    }
}

/* Two triangles, counter-clockwise from outside. */
static void set_quad(struct mesh *mesh, int ring, int side)
{
    uint32_t(*to)[3] = &mesh->triangle[2 * (ring * SIDES + side)];
    uint32_t a = (uint32_t)(ring * COLUMNS + side);
    uint32_t b = a + 1, c = a + COLUMNS, d = b + COLUMNS;
    to[0][0] = to[1][0] = a;
    to[0][1] = b;
    to[0][2] = to[1][1] = d;
    to[1][2] = c;
}

bool mesh_load_builtin(struct mesh *mesh)
{
    if (!mesh_init(mesh, RINGS * COLUMNS, 2 * (RINGS - 1) * SIDES))
        return false;
    for (int ring = 0; ring < RINGS; ring++)
        set_ring(mesh, ring);
    for (int ring = 0; ring < RINGS - 1; ring++)
        for (int side = 0; side < SIDES; side++)
            set_quad(mesh, ring, side);
    mesh->has_uv = true;
    return true;
}
