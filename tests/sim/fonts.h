/* Font files in memory: loaded, refused, and told. */
#ifndef TESTS_SIM_FONTS_H
#define TESTS_SIM_FONTS_H

#include "files.h"
#include "sim/font/font.h"

static const char *encoding; /* of --encoding, or NULL */

static inline bool load(struct font *font, const char *bytes, size_t size)
{
    char *path = file_with(bytes, size);
    const struct font_options options = {.encoding = encoding,
                                         .size = FONT_SIZE};
    bool done = font_load(font, path, &options);
    remove(path);
    free(path);
    return done;
}

static inline void check_refused(const char *bytes, size_t size,
                                 const char *message)
{
    struct messages m;
    struct font f;
    messages_begin(&m);
    bool done = load(&f, bytes, size);
    const char *text = messages_end(&m);
    if (done || strncmp(text, "pel: ", 5) != 0 || !strstr(text, message) ||
        !strstr(text, ": expected "))
        fail_msg("expected '%s', got '%s'", message, text);
    assert_true(f.count == 0 && !f.bits && !f.chars);
}

/* Loads it with those words, in one line; "" for none. */
static inline void check_told(struct font *f, const char *text,
                              const char *message)
{
    struct messages m;
    messages_begin(&m);
    const bool done = load(f, text, strlen(text));
    const char *said = messages_end(&m);
    if (!done || (*message ? !strstr(said, message) : *said) ||
        (*said && strchr(said, '\n')[1]))
        fail_msg("expected '%s', got '%s'", message, said);
}

#endif
