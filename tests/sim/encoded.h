/* Picture files in memory, and the pixels that they must be. */
#ifndef TESTS_SIM_ENCODED_H
#define TESTS_SIM_ENCODED_H

#include "sim/image/texture.h"
#include "files.h"

/* A file in memory. */
struct bytes {
    unsigned char at[4096];
    size_t n;
};

#define BYTES(text) text, sizeof(text) - 1

/* Colours, hexadecimal; 0 behind the last. */
static inline void read_colors(const char *text, pel_color *color, int n)
{
    for (int i = 0; i < n; i++) {
        char *end;
        color[i] = (pel_color)strtoul(text, &end, 16);
        text = end;
    }
}

static inline bool load_bytes(struct picture *picture, const void *bytes,
                              size_t size, struct messages *m)
{
    messages_begin(m);
    const bool done = texture_load_bytes(picture, "in", bytes, size);
    messages_end(m);
    return done;
}

struct expected {
    const char *what; /* the case */
    int width, height;
    const pel_color *color;
};

static inline void expect(const struct expected *e, const void *bytes,
                          size_t size)
{
    struct messages m;
    struct picture p;
    if (!load_bytes(&p, bytes, size, &m))
        fail_msg("%s: %s", e->what, m.text);
    if (p.width != e->width || p.height != e->height)
        fail_msg("%s: %d x %d pixels", e->what, p.width, p.height);
    for (int i = 0; i < p.width * p.height; i++)
        if (p.pixels[i] != e->color[i])
            fail_msg("%s: pixel %d is %08x, not %08x", e->what, i,
                     (unsigned)p.pixels[i], (unsigned)e->color[i]);
    picture_free(&p);
}

static inline void refused(const char *text, const void *bytes, size_t size)
{
    struct messages m;
    struct picture p;
    if (load_bytes(&p, bytes, size, &m))
        fail_msg("read, not refused: %s", text);
    if (!strstr(m.text, text))
        fail_msg("not '%s': %s", text, m.text);
}

#endif
