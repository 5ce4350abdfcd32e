#include "sim/render/print_camera.h"

#include <math.h>

static void print_three(FILE *out, const char *name, const int32_t value[3])
{
    fprintf(out, "    .%s = {%ld, %ld, %ld},\n", name, (long)value[0],
            (long)value[1], (long)value[2]);
}

void print_camera(FILE *out, const struct scene *scene)
{
    const struct pel_camera *camera = &scene->core.camera;
    const struct pel_rect *view = &scene->core.viewport;
    const int scale = ilogb(scene->units);
    fprintf(out,
            "/* struct pel_camera, for a viewport of %ld x %ld pixels; places "
            "in 1/65536. */\n",
            (long)(view->x1 - view->x0), (long)(view->y1 - view->y0));
    if (scale != 0)
        fprintf(out,
                "/* The mesh is too large or small as it is: after "
                "pel_mesh_of_asset, take\n   mesh.position.shift -= %d. */\n",
                scale);
    fprintf(out, "{\n");
    print_three(out, "eye", camera->eye);
    print_three(out, "target", camera->target);
    print_three(out, "up", camera->up);
    if (camera->projection == PEL_PERSPECTIVE)
        fprintf(out, "    .focal = %ld,\n", (long)camera->focal);
    fprintf(out, "    .sensor = {%ld, %ld},\n", (long)camera->sensor[0],
            (long)camera->sensor[1]);
    fprintf(out, "    .near = %ld,\n", (long)camera->near);
    fprintf(out, "    .projection = %s,\n}\n",
            camera->projection == PEL_PERSPECTIVE ? "PEL_PERSPECTIVE"
                                                  : "PEL_ORTHOGRAPHIC");
}
