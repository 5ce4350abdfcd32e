/* PPM, PGM, PBM and PAM: P6, P5 and P4 binary, P3, P2 and P1 text, P7 binary
 * with a header of words. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sim/cli/message.h"
#include "sim/cli/text_line.h"
#include "sim/image/picture.h"

struct reader {
    FILE *file;
    const char *name;
    long line; /* of the last character, from 1 */
    long byte; /* characters read */
    int width, height;
    int channels; /* grey or colours, and perhaps alpha: 1 to 4 */
    int most;     /* of a sample */
    bool binary;
    bool bits; /* 1 is black; binary has 8 a byte */
};

static int read_char(struct reader *r)
{
    const int c = getc_unlocked(r->file);
    if (c == EOF)
        return c;
    r->byte++;
    if (c == '\n')
        r->line++;
    return c;
}

static bool is_space(int c)
{
    return c == ' ' || (c >= '\t' && c <= '\r');
}

/* The first character that is neither white space nor in a comment (# to the
 * end of the line), or EOF. */
static int skip_space(struct reader *r)
{
    int c = read_char(r);
    while (is_space(c) || c == '#') {
        if (c == '#')
            while (c != '\n' && c != EOF)
                c = read_char(r);
        else
            c = read_char(r);
    }
    return c;
}

/* The file ends, or cannot be read further. False. */
static bool refuse_early(const struct reader *r, const char *before)
{
    return ferror(r->file) ? file_refuse(r->name)
                           : message_error_at(r->name, r->line,
                                              "ends before the %s", before);
}

/* A decimal number of at most `most`, and the white space character after it;
 * the file may end there. */
static bool read_number(struct reader *r, const char *what, int most,
                        int *value)
{
    int c = skip_space(r);
    const long line = r->line;
    if (c == EOF)
        return refuse_early(r, what);
    if (c < '0' || c > '9')
        return message_error_at(r->name, line,
                                "byte %ld: the %s must be a number in 0..%d",
                                r->byte - 1, what, most);
    for (*value = 0; c >= '0' && c <= '9'; c = read_char(r)) {
        *value = *value * 10 + (c - '0');
        if (*value > most)
            return message_error_at(
                r->name, line, "the %s is too large: %d at most", what, most);
    }
    if (c != EOF && !is_space(c))
        return message_error_at(r->name, line,
                                "byte %ld: white space must follow the %s",
                                r->byte - 1, what);
    return true;
}

/* The samples and the way that they are written, as the digit says. */
static bool read_magic(struct reader *r, int *digit)
{
    const int p = read_char(r);
    *digit = read_char(r);
    if (ferror(r->file))
        return file_refuse(r->name);
    if (p != 'P' || *digit == EOF || !memchr("1234567", *digit, 7))
        return message_error_at(r->name, 1,
                                "not a PPM or PGM picture: the file must begin "
                                "with P6, P5, P3 or P2, P4 or P1, or P7");
    r->binary = *digit >= '4';
    r->channels = *digit == '6' || *digit == '3' ? 3 : 1;
    r->bits = *digit == '4' || *digit == '1';
    const int c = read_char(r);
    if (!is_space(c) && c != '#')
        return message_error_at(r->name, 1, "white space must follow P%c",
                                *digit);
    if (c == '#')
        ungetc(c, r->file);
    return true;
}

/* Words and their numbers, a line each, up to ENDHDR. What the samples are the
 * depth says: the names of TUPLTYPE tell no more. */
static bool read_words(struct reader *r)
{
    static const struct {
        const char *word;
        int most;
    } words[] = {{"WIDTH", PICTURE_SIZE_MAX},
                 {"HEIGHT", PICTURE_SIZE_MAX},
                 {"DEPTH", 4},
                 {"MAXVAL", 65535}};
    int *const numbers[] = {&r->width, &r->height, &r->channels, &r->most};
    r->channels = 0;
    for (;;) {
        char word[16];
        size_t n = 0;
        int c = skip_space(r), i = 0;
        for (; c != EOF && !is_space(c) && n < sizeof(word) - 1;
             c = read_char(r))
            word[n++] = (char)c;
        word[n] = '\0';
        if (c == EOF)
            return refuse_early(r, "line ENDHDR");
        if (strcmp(word, "ENDHDR") == 0 && c == '\r')
            return message_error_at(r->name, r->line,
                                    "ENDHDR ends in a carriage return: "
                                    "expected a line feed alone");
        if (strcmp(word, "ENDHDR") == 0 && c == '\n')
            return (r->most > 0 && r->channels > 0) ||
                   message_error_at(r->name, r->line,
                                    "a PAM ends its header: expected its "
                                    "DEPTH and MAXVAL before");
        while (i < 4 && strcmp(word, words[i].word) != 0)
            i++;
        if (i < 4 && !read_number(r, words[i].word, words[i].most, numbers[i]))
            return false;
        if (i == 4 && strcmp(word, "TUPLTYPE") != 0)
            return message_error_at(r->name, r->line,
                                    "the header of a PAM has '%s': expected "
                                    "WIDTH, HEIGHT, DEPTH, MAXVAL, TUPLTYPE or "
                                    "ENDHDR",
                                    word);
        while (i == 4 && c != '\n' && c != EOF)
            c = read_char(r);
    }
}

static bool read_header(struct reader *r)
{
    int digit;
    if (!read_magic(r, &digit))
        return false;
    if (digit == '7') {
        if (!read_words(r))
            return false;
    } else if (!read_number(r, "width", PICTURE_SIZE_MAX, &r->width) ||
               !read_number(r, "height", PICTURE_SIZE_MAX, &r->height))
        return false;
    const long line = r->line;
    if (r->width < 1 || r->height < 1)
        return message_error_at(r->name, line,
                                "%d x %d pixels: width and height must be "
                                "at least 1",
                                r->width, r->height);
    if (!picture_size_check(r->name, r->width, r->height))
        return false;
    if (r->bits)
        r->most = 1;
    else if (digit != '7' &&
             !read_number(r, "maximum sample value", 65535, &r->most))
        return false;
    return r->most > 0 ||
           message_error_at(r->name, line,
                            "the maximum sample value is 0: expected 1 to "
                            "65535");
}

/* A digit of P1 may stand right after another. */
static bool read_bit(struct reader *r, int *sample)
{
    const int c = skip_space(r);
    *sample = c == '1';
    if (c == EOF)
        return refuse_early(r, "sample");
    return c == '0' || c == '1' ||
           message_error_at(r->name, r->line,
                            "byte %ld: the sample must be 0 or 1", r->byte - 1);
}

static int row_bytes(const struct reader *r)
{
    return r->bits ? (r->width + 7) / 8
                   : r->width * r->channels * (r->most > 255 ? 2 : 1);
}

static bool refuse_end(const struct reader *r, int y)
{
    return ferror(r->file)
               ? file_refuse(r->name)
               : message_error_at(
                     r->name, 0,
                     "byte %ld: ends in row %d of %d, %d bytes a row", r->byte,
                     y + 1, r->height, row_bytes(r));
}

/* A sample of row y. False, with a message. */
static bool read_sample(struct reader *r, int y, int *sample)
{
    if (!r->binary)
        return r->bits ? read_bit(r, sample)
                       : read_number(r, "sample", r->most, sample);
    *sample = read_char(r);
    if (r->most > 255 && *sample != EOF) {
        const int low = read_char(r);
        *sample = low == EOF ? EOF : *sample << 8 | low;
    }
    if (*sample == EOF)
        return refuse_end(r, y);
    return *sample <= r->most ||
           message_error_at(r->name, 0,
                            "byte %ld: the sample is %d: %d at most", r->byte,
                            *sample, r->most);
}

/* As 0 to 255, rounded. */
static unsigned scaled(const struct reader *r, int sample)
{
    return (unsigned)((sample * 510LL + r->most) / (2 * r->most));
}

static bool read_row(struct reader *r, int y, pel_color *row)
{
    for (int x = 0; x < r->width; x++) {
        unsigned v[4] = {0, 0, 0, 255};
        for (int i = 0; i < r->channels; i++) {
            int sample;
            if (!read_sample(r, y, &sample))
                return false;
            v[i] = scaled(r, sample);
        }
        if (r->channels <= 2) {
            v[3] = r->channels == 2 ? v[1] : 255;
            v[1] = v[2] = v[0];
        }
        row[x] = PEL_RGBA(v[0], v[1], v[2], v[3]);
    }
    return true;
}

/* A row of P4 begins with a byte. 1 is black in a PBM, but not in a PAM. */
static bool read_bits(struct reader *r, int y, pel_color *row)
{
    int byte = 0;
    for (int x = 0; x < r->width; x++) {
        int bit;
        if (!r->binary && !read_bit(r, &bit))
            return false;
        if (r->binary && x % 8 == 0 && (byte = read_char(r)) == EOF)
            return refuse_end(r, y);
        if (r->binary)
            bit = byte >> (7 - x % 8) & 1;
        row[x] = bit ? PEL_RGB(0, 0, 0) : PEL_RGB(255, 255, 255);
    }
    return true;
}

/* Makes room for row y: as many rows again as there are, all in the end. */
static bool grow(struct picture *p, const struct reader *r, int y)
{
    if (y < p->height)
        return true;
    const int rows = r->height - y < y + 1 ? r->height : 2 * y + 1;
    const size_t n = (size_t)r->width * (size_t)rows;
    pel_color *pixels = realloc(p->pixels, n * sizeof *pixels);
    if (!pixels)
        return message_error_at(r->name, 0,
                                "no memory for a picture of %d x %d pixels",
                                r->width, r->height);
    p->pixels = pixels;
    p->width = r->width;
    p->height = rows;
    return true;
}

static bool read_rows(struct reader *r, struct picture *picture)
{
    for (int y = 0; y < r->height; y++)
        if (!grow(picture, r, y) ||
            !(r->bits ? read_bits : read_row)(r, y, picture_row(picture, y)))
            return false;
    int c = r->binary ? read_char(r) : skip_space(r);
    while (is_space(c)) /* editors end a file with a newline */
        c = read_char(r);
    if (ferror(r->file))
        return file_refuse(r->name);
    return c == EOF ||
           message_error_at(r->name, r->binary ? 0 : r->line,
                            "byte %ld: the picture of %d x %d pixels should "
                            "end here, but there is more",
                            r->byte - 1, r->width, r->height);
}

bool picture_read_ppm(struct picture *picture, FILE *file, const char *name)
{
    struct reader reader = {.file = file, .name = name, .line = 1};
    *picture = (struct picture){0, 0, NULL};
    const bool done = read_header(&reader) && read_rows(&reader, picture);
    if (!done)
        picture_free(picture);
    return done;
}
