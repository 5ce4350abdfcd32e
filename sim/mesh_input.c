#include "mesh_input.h"

#include <stdio.h>

#include "message.h"

static bool load_pel2d(const struct mesh_input *input, struct pel2d *flat)
{
    if (input->camera.is_set)
        return message_error_at(input->path, 0,
                                "is projected already: of the camera's options "
                                "only --size and --background apply");
    if (input->texture)
        return message_error_at(input->path, 0,
                                "has its colours already: --texture is for "
                                "mesh files");
    return pel2d_load(flat, input->path);
}

static bool project(struct mesh_input *input, struct mesh *mesh,
                    struct pel2d *flat)
{
    uint32_t clipped;
    if (!mesh_paint(mesh, input->path, input->texture, true) ||
        !camera_frame(&input->camera, mesh) ||
        !mesh_project(mesh, &input->camera, flat, &clipped))
        return false;
    if (clipped > 0)
        fprintf(stderr,
                "pel: %s: %u of %u triangles reach behind the camera or far "
                "out of the picture and were clipped\n",
                input->path, clipped, mesh->triangles);
    return true;
}

bool mesh_input_load(struct mesh_input *input, struct pel2d *flat)
{
    struct mesh mesh;
    if (pel2d_is_file(input->path))
        return load_pel2d(input, flat);
    if (!mesh_load(&mesh, input->path))
        return false;
    bool done = project(input, &mesh, flat);
    mesh_free(&mesh);
    return done;
}
