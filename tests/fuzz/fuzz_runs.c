/* Pictures of runs: any words, in memory of just their size. */
#include "core/pel.h"
#include "input.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    enum { SIDE = 32 };
    static const pel_color colors[256] = {0x80FF0000, 0xFF00FF00};
    static const struct pel_palette palette = PEL_PALETTE(8, colors);
    static const struct pel_format *const formats[] = {
        &pel_rgb565_le, &pel_rgb888, &pel_argb8888, &palette.format,
        &pel_gray8,     &pel_gray4,  &pel_mono1,    &pel_mono1_pages};
    const struct pel_rect square = {0, 0, SIDE, SIDE};
    struct input in = {data, data + size};
    struct pel_runs_asset asset = {
        PEL_RUNS_MAGIC, PEL_RUNS_VERSION, 0, 0, 0, 0, NULL, NULL, NULL};
    struct pel_surface surface;
    uint32_t memory[SIDE * SIDE], rows[8];
    const struct pel_format *from = formats[input_below(&in, 7)];
    const struct pel_format *to = formats[input_below(&in, 8)];
    to = to->put ? to : &pel_xrgb8888;
    memset(memory, input_byte(&in), sizeof memory);
    asset.format = from->id;
    asset.width = (uint16_t)(1 + input_below(&in, 255));
    asset.height = (uint16_t)(1 + input_below(&in, 8));
    asset.rows32 = rows;
    const struct pel_runs_part part = {&asset, from,
                                       (int8_t)input_byte(&in) - 64,
                                       (int8_t)input_byte(&in) / 4};
    const uint8_t alpha = input_byte(&in);
    for (int i = 0; i < 8; i++)
        rows[i] = input_byte(&in) & 1 ? input_word(&in) : input_byte(&in);
    const size_t left = (size_t)(in.end - in.at);
    asset.size = (uint32_t)(from->bits < 8 ? left : left / (from->bits / 8u));
    void *words = malloc(left ? left : 1);
    memcpy(words, in.at, left);
    asset.words = words;
    if (pel_surface_init(&surface, to, memory, sizeof memory, &square) ==
            PEL_OK &&
        pel_runs_asset_check(&asset, from) == PEL_OK)
        pel_copy_runs(&surface, &part, alpha);
    free(words);
    return 0;
}
