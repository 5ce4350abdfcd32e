/* What the parsers of the host program read, from the bytes of a fuzzer. */
#ifndef TESTS_FUZZ_INPUT_H
#define TESTS_FUZZ_INPUT_H

#define _POSIX_C_SOURCE 200809L /* fmemopen */

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

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
