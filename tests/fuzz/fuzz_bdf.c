/* BDF fonts, and the assets that are made of them. */
#include "input.h"
#include "sim/font/asset.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct font font = {.missing = -1};
    struct pel_font_asset asset;
    const struct font_file file = {
        .path = "fuzz.bdf", .data = fuzz_text(data, size), .size = size};
    if (font_parse_bdf(&font, &file) && font_asset_make(&asset, &font, "fuzz"))
        font_asset_free(&asset);
    font_free(&font);
    free(file.data);
    return 0;
}
