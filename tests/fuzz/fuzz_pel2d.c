/* Projected meshes, on standard input. */
#include "input.h"
#include "sim/mesh/pel2d.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct pel2d flat;
    stdin = fuzz_stream(data, size);
    if (!stdin)
        return 0;
    pel2d_load(&flat, "-");
    pel2d_free(&flat);
    fclose(stdin);
    return 0;
}
