/* Scene scripts on standard input; those with small pictures are drawn. Names
 * of files in other folders are left out: they would be opened. */
#include "input.h"
#include "sim/script/script.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct script script;
    struct canvas canvas;
    stdin = memchr(data, '/', size) ? NULL : fuzz_stream(data, size);
    if (!stdin)
        return 0;
    if (script_load(&script, "-", NULL)) {
        if (script.width <= 256 && script.height <= 256 &&
            canvas_init(&canvas, script.format, script.width, script.height)) {
            script_draw(&script, &canvas, -1);
            canvas_free(&canvas);
        }
        script_free(&script);
    }
    fclose(stdin);
    return 0;
}
