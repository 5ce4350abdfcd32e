/* Random calls of the whole drawing API, any clip, paint and number: no call
 * may touch memory that is not the surface's, compute with an overflow, or not
 * come back. */
#define _DEFAULT_SOURCE /* MAP_ANONYMOUS */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

#include <sanitizer/asan_interface.h>

#include "api.h"

enum { PAGE = 4096, MEMORY = 16 * PAGE };

static unsigned long long calls;

static void say_calls(void)
{
    fprintf(stderr, "%llu calls\n", calls);
}

static const struct pel_format *const formats[] = {
    &pel_rgb565_le,      &pel_rgb565_be, &pel_bgr565_le,   &pel_xrgb1555_le,
    &pel_rgb888,         &pel_bgr888,    &pel_xrgb8888,    &pel_xbgr8888,
    &pel_rgbx8888,       &pel_bgrx8888,  &pel_rgb332,      &pel_gray8,
    &pel_gray4,          &pel_mono1,     &pel_mono1_pages, &pel_rgb565_le_fill,
    &pel_rgb565_be_fill, &pel_argb8888,  &pel_inks2,       &pel_gray2};

/* A guard page, memory, a guard page: for each slot, made once. What is not the
 * present surface's is poisoned. */
static uint8_t *memory_of(int slot)
{
    static uint8_t *memory[API_SURFACES + 1];
    if (memory[slot])
        return memory[slot];
    uint8_t *map = mmap(NULL, MEMORY + 2 * PAGE, PROT_READ | PROT_WRITE,
                        MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (map == MAP_FAILED || mprotect(map, PAGE, PROT_NONE) ||
        mprotect(map + PAGE + MEMORY, PAGE, PROT_NONE))
        abort();
    memory[slot] = map + PAGE;
    return memory[slot];
}

static uint8_t *take_memory(int slot, size_t at, size_t size)
{
    uint8_t *memory = memory_of(slot);
    ASAN_POISON_MEMORY_REGION(memory, MEMORY);
    ASAN_UNPOISON_MEMORY_REGION(memory + at, size);
    return memory + at;
}

/* Any bounds and format, as they come: on the bytes that are there. */
static bool any_surface(struct api *a, int slot, const struct pel_format *f)
{
    const struct pel_rect bounds = api_rect(a);
    const size_t size = input_word(&a->in) % (MEMORY + 1);
    return pel_surface_init(&a->surface[slot], f,
                            take_memory(slot, MEMORY - size, size), size,
                            &bounds) == PEL_OK;
}

/* A picture of up to 64 x 64, with padding, bottom-up, anywhere; the memory
 * begins or ends at a guard page. */
void api_surface(struct api *a, int slot)
{
    const uint32_t kind = input_byte(&a->in);
    const struct pel_format *f =
        formats[input_below(&a->in, sizeof formats / sizeof *formats)];
    if (kind % 4 == 0 && any_surface(a, slot, f))
        return;
    struct pel_rect b;
    b.x0 = (int32_t)input_word(&a->in) % 32000 & ~7;
    b.y0 = (int32_t)input_word(&a->in) % 32000 & ~7;
    b.x1 = b.x0 + 1 + (int32_t)input_below(&a->in, 64);
    b.y1 = b.y0 + 1 + (int32_t)input_below(&a->in, 64);
    const bool pages = f->id == PEL_FORMAT_MONO1_PAGES;
    const int32_t lines = pages ? (b.y1 - b.y0 + 7) / 8 : b.y1 - b.y0;
    int32_t stride = pel_stride(f, b.x1 - b.x0);
    stride += f->word * (int32_t)(kind / 4 % 4);
    stride += -stride & (f->word - 1);
    const size_t size = (size_t)(stride * lines);
    uint8_t *start = take_memory(slot, kind & 32 ? MEMORY - size : 0, size);
    if (kind & 64 && !pages) {
        start += stride * (lines - 1);
        stride = -stride;
    }
    if (pel_surface_init_rect(&a->surface[slot], f, start, stride, &b))
        abort();
}

static void step(struct api *a, uint32_t what)
{
    const uint32_t which = input_byte(&a->in);
    struct pel_surface *s = &a->surface[which % API_SURFACES];
    const struct pel_paint *p = &a->paint[which / 4 % API_PAINTS].paint;
    struct pel_rect r;
    switch (what % 16) {
    case 0:
        api_surface(a, (int)(which % API_SURFACES));
        break;
    case 1:
        r = api_rect(a);
        pel_surface_clip(s, &r);
        break;
    case 2:
        pel_surface_clip(s, &s->bounds);
        break;
    case 3:
    case 4:
    case 5:
        api_paint(a);
        break;
    case 6:
    case 7:
        api_image(a, s, p);
        break;
    case 8:
        api_hit(a);
        break;
    case 9:
        api_scene(a, s);
        break;
    case 10:
        api_path(a, s, p);
        break;
    default:
        api_shape(a, s, p);
        break;
    }
    calls++;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const struct pel_flat red = PEL_FLAT(PEL_RGBA(255, 0, 0, 128));
    static struct api a;
    static bool started;
    if (!started)
        atexit(say_calls);
    started = true;
    a.in = (struct input){data, data + size};
    for (int i = 0; i <= API_SURFACES; i++)
        api_surface(&a, i);
    for (int i = 0; i < API_PAINTS; i++)
        a.paint[i].flat = red;
    for (int i = 0; i < 64; i++)
        a.ramp[i] = PEL_RGBA(i * 4, 255 - i, i * 77, 128 + i * 5);
    while (a.in.at < a.in.end)
        step(&a, input_byte(&a.in));
    return 0;
}
