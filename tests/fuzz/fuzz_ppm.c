/* PPM and PGM pictures. */
#include "input.h"
#include "sim/image/picture.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct picture picture = {0};
    FILE *file = fuzz_stream(data, size);
    if (!file)
        return 0;
    picture_read_ppm(&picture, file, "fuzz.ppm");
    picture_free(&picture);
    fclose(file);
    return 0;
}
