/* The built-in meshes: a vase, a profile turned around the y axis, fine and
 * coarse. Its colors are its glaze: bands of blue and white over terracotta.
 */
#include "sim/mesh/mesh.h"

#include <math.h>
#include <string.h>

#include "sim/cli/message.h"

#define TURN 6.283185307179586

/* How fine a vase is: quads around, and per piece of the profile. */
static const struct vase {
    const char *name;
    int sides, steps;
} vases[] = {{"vase", 48, 8}, {"vase-small", 10, 1}};

/* Radius and height where the pieces of the profile meet: outside from the
 * middle of the foot to the rim, then inside down to the neck. */
static const double profile[][2] = {
    {0, 0},       {0.42, 0},    {0.40, 0.10}, {0.62, 0.42},
    {0.70, 0.78}, {0.56, 1.14}, {0.30, 1.42}, {0.26, 1.60},
    {0.40, 1.84}, {0.34, 1.83}, {0.12, 1.60}, {0, 1.52},
};

enum { PIECES = sizeof(profile) / sizeof(profile[0]) - 1 };

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

static pel_color glaze(int piece, double height)
{
    if (piece >= 9)
        return PEL_RGB(150, 84, 52);
    if ((height > 0.55 && height < 0.66) || (height > 0.92 && height < 1.03))
        return PEL_RGB(240, 236, 224);
    return height > 0.5 && height < 1.3 ? PEL_RGB(40, 84, 160)
                                        : PEL_RGB(196, 110, 68);
}

/* A ring has its first vertex again at the other end of the texture. */
static void set_ring(struct mesh *mesh, const struct vase *vase, int ring)
{
    const int steps = vase->steps, columns = vase->sides + 1;
    const int piece = ring / steps < PIECES ? ring / steps : PIECES - 1;
    const double t = (double)(ring - piece * steps) / steps;
    const double radius = fmax(spline(piece, t, 0), 0);
    const double height = fmax(spline(piece, t, 1), 0);
    for (int side = 0; side < columns; side++) {
        struct mesh_vertex *v = &mesh->vertex[ring * columns + side];
        const double angle = TURN * (side % vase->sides) / vase->sides;
        v->position[0] = radius * sin(angle);
        v->position[1] = height;
        v->position[2] = radius * cos(angle);
        v->uv[0] = (double)side / vase->sides;
        v->uv[1] = 1 - (double)ring / (PIECES * steps);
        v->color = glaze((ring - 1) / steps, height);
    }
}

/* Two triangles, counter-clockwise from outside. */
static void set_quad(struct mesh *mesh, int sides, int ring, int side)
{
    uint32_t(*to)[3] = &mesh->triangle[2 * (ring * sides + side)];
    uint32_t a = (uint32_t)(ring * (sides + 1) + side);
    uint32_t b = a + 1, c = b + (uint32_t)sides, d = c + 1;
    to[0][0] = to[1][0] = a;
    to[0][1] = b;
    to[0][2] = to[1][1] = d;
    to[1][2] = c;
}

static bool make(struct mesh *mesh, const struct vase *vase)
{
    const int quads = PIECES * vase->steps;
    if (!mesh_init(mesh, (uint32_t)((quads + 1) * (vase->sides + 1)),
                   (uint32_t)(2 * quads * vase->sides), 1))
        return false;
    for (int ring = 0; ring <= quads; ring++)
        set_ring(mesh, vase, ring);
    for (int ring = 0; ring < quads; ring++)
        for (int side = 0; side < vase->sides; side++)
            set_quad(mesh, vase->sides, ring, side);
    mesh->has_uv = true;
    return true;
}

bool mesh_load_builtin(struct mesh *mesh, const char *path)
{
    const char *name = path + sizeof(MESH_BUILTIN_PREFIX) - 1;
    for (size_t i = 0; i < sizeof(vases) / sizeof(*vases); i++)
        if (strcmp(name, vases[i].name) == 0)
            return make(mesh, &vases[i]);
    return message_error_at(path, 0,
                            "no mesh that is built in: expected " MESH_BUILTINS
                            ", or a file");
}
