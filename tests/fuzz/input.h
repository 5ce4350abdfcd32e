/* Bytes of a fuzzer: as numbers for the drawing API, as streams and texts for
 * the parsers of the host program. */
#ifndef TESTS_FUZZ_INPUT_H
#define TESTS_FUZZ_INPUT_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Zeros when there are no more. */
struct input {
    const uint8_t *at, *end;
};

/* What libFuzzer and replay.c call. */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static inline uint8_t input_byte(struct input *in)
{
    return in->at < in->end ? *in->at++ : 0;
}

/* 0..n - 1. */
static inline uint32_t input_below(struct input *in, uint32_t n)
{
    return input_byte(in) % n;
}

static inline uint32_t input_word(struct input *in)
{
    uint32_t v = 0;
    for (int i = 0; i < 4; i++)
        v = v << 8 | input_byte(in);
    return v;
}

static inline uint64_t input_long(struct input *in)
{
    const uint64_t high = input_word(in);
    return high << 32 | input_word(in);
}

/* Any number: mostly small, sometimes at an end of a range. */
static inline int32_t input_number(struct input *in)
{
    static const int32_t ends[] = {INT32_MIN, INT32_MIN + 1,
                                   INT32_MAX, INT32_MAX - 1,
                                   -8388609,  -8388608,
                                   8388607,   8388608,
                                   -65537,    -65536,
                                   65536,     65537,
                                   -32769,    -32768,
                                   32767,     32768,
                                   16777216,  -16777216,
                                   1 << 30,   -(1 << 30),
                                   1,         -1};
    const uint32_t kind = input_byte(in);
    const int32_t small = (int8_t)input_byte(in);
    switch (kind % 8) {
    case 0:
        return ends[kind / 8 % (sizeof ends / sizeof *ends)];
    case 1:
        return (int32_t)input_word(in);
    case 2:
        return small;
    case 3:
        return small * 128;
    case 4:
        return small * 65536;
    default:
        return small * 256 + (int32_t)(input_byte(in));
    }
}

/* The parsers' messages go nowhere; the fuzzer's own do not use this stream. */
static inline void fuzz_hush(void)
{
    static FILE *nowhere;
    if (!nowhere)
        stderr = nowhere = fopen("/dev/null", "w");
}

/* A stream of the bytes, or NULL; the caller closes it. */
static inline FILE *fuzz_stream(const uint8_t *data, size_t size)
{
    fuzz_hush();
    return size ? fmemopen((void *)(uintptr_t)data, size, "r") : NULL;
}

/* A copy with a 0 behind its last byte, as files of fonts have; freed by the
 * caller. */
static inline char *fuzz_text(const uint8_t *data, size_t size)
{
    char *text = malloc(size + 1);
    fuzz_hush();
    memcpy(text, data, size);
    text[size] = '\0';
    return text;
}

#endif
