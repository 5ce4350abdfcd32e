/* PSF fonts of both versions; the caller has seen their first two bytes. */
#include "input.h"
#include "sim/font/font.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct font font = {.missing = -1};
    const struct font_file file = {
        .path = "fuzz.psf", .data = fuzz_text(data, size), .size = size};
    if (size >= 2)
        font_parse_psf(&font, &file);
    font_free(&font);
    free(file.data);
    return 0;
}
