/* Scene scripts on standard input; those with small pictures are drawn. Names
 * of files in other folders are left out: they would be opened. */
#include "fuzz_input.h"
#include "sim/render/scene.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct scene scene;
    struct canvas canvas;
    stdin = memchr(data, '/', size) ? NULL : fuzz_stream(data, size);
    if (!stdin)
        return 0;
    if (scene_load(&scene, "-", NULL)) {
        if (scene.width <= 256 && scene.height <= 256 &&
            canvas_init(&canvas, scene.format, scene.width, scene.height)) {
            scene_draw(&scene, &canvas, -1);
            canvas_free(&canvas);
        }
        scene_free(&scene);
    }
    fclose(stdin);
    return 0;
}
