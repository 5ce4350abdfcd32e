/* Font files with any bytes changed, put in or cut off: read or refused, within
 * the limits, in lines of at most 500 bytes without controls. */
#include "fonts.h"

#include "tests/support/cases.h"

enum { MOST = 4096 };

/* A base of either kind, and its bytes. */
static size_t make_bdf(char *to)
{
    FILE *file = fopen("sim/scenes/fixed_6x13.bdf", "rb");
    assert_non_null(file);
    const size_t size = fread(to, 1, MOST - 64, file);
    fclose(file);
    return size;
}

/* PSF 2: 96 glyphs of 9 x 7, with a table that gives each its character. */
static size_t make_psf(char *to)
{
    static const char head[] =
        "\x72\xB5\x4A\x86\0\0\0\0\x20\0\0\0\1\0\0\0\x60\0\0\0\x0E\0\0\0\7\0\0\0"
        "\x09\0\0";
    size_t size = sizeof head;
    memcpy(to, head, size);
    for (int i = 0; i < 96 * 14; i++)
        to[size++] = (char)(i * 37);
    for (int i = 0; i < 96; i++) {
        to[size++] = (char)(32 + i);
        to[size++] = (char)0xFF;
    }
    return size;
}

static size_t mutate(char *bytes, size_t size, struct random *r)
{
    for (int n = random_between(r, 1, 8); n > 0; n--) {
        const size_t at = (size_t)random_between(r, 0, (int32_t)size - 1);
        switch (random_between(r, 0, 9)) {
        case 0:
            return at + 1;
        case 1:
            memmove(bytes + at + 1, bytes + at, size - at);
            size += size < MOST - 1;
            break;
        case 2:
            bytes[at] = (char)random_between(r, 0, 1) * -1;
            break;
        default:
            bytes[at] = (char)random_word(r);
        }
    }
    return size;
}

static void check_lines(const char *said)
{
    size_t length = 0;
    for (const char *c = said; *c; c++) {
        length = *c == '\n' ? 0 : length + 1;
        if (length > 500 || ((unsigned char)*c < ' ' && *c != '\n'))
            fail_msg("%s: %s", cases_replay(), said);
    }
}

TEST(mutated)
{
    struct cases cases = cases_of(400);
    while (cases_next(&cases)) {
        char bytes[MOST + 8];
        struct font font;
        struct messages m;
        const bool is_bdf = random_between(&cases.random, 0, 1);
        size_t size = is_bdf ? make_bdf(bytes) : make_psf(bytes);
        size = mutate(bytes, size, &cases.random);
        messages_begin(&m);
        const bool done = load(&font, bytes, size);
        check_lines(messages_end(&m));
        if (strstr(m.text, "crashed"))
            fail_msg("%s: %s", cases_replay(), m.text);
        assert_true(done ? font.count > 0 : !font.chars && !font.bits);
        font_free(&font);
    }
}
