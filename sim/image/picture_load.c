/* PPM and PGM: P6 and P5 binary, P3 and P2 text. */
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
    int channels; /* 1 or 3 */
    bool binary;
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

/* A decimal number of at most `most`, and the white space character after it;
 * the file may end there. */
static bool read_number(struct reader *r, const char *what, int most,
                        int *value)
{
    int c = skip_space(r);
    const long line = r->line;
    if (c == EOF)
        return message_error_at(r->name, line, "ends before the %s", what);
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

static bool read_magic(struct reader *r)
{
    const int p = read_char(r), digit = read_char(r);
    if (p != 'P' || digit == EOF || !memchr("2356", digit, 4))
        return message_error_at(r->name, 1,
                                "not a PPM or PGM picture: the file must begin "
                                "with P6, P5, P3 or P2");
    r->binary = digit == '6' || digit == '5';
    r->channels = digit == '6' || digit == '3' ? 3 : 1;
    const int c = read_char(r);
    if (!is_space(c) && c != '#')
        return message_error_at(r->name, 1, "white space must follow P%c",
                                digit);
    if (c == '#')
        ungetc(c, r->file);
    return true;
}

static bool read_header(struct reader *r)
{
    int maxval;
    if (!read_magic(r) ||
        !read_number(r, "width", PICTURE_SIZE_MAX, &r->width) ||
        !read_number(r, "height", PICTURE_SIZE_MAX, &r->height))
        return false;
    const long line = r->line;
    if (r->width < 1 || r->height < 1)
        return message_error_at(r->name, line,
                                "%d x %d pixels: width and height must be "
                                "at least 1",
                                r->width, r->height);
    if (!read_number(r, "maximum sample value", 65535, &maxval))
        return false;
    if (maxval != 255)
        return message_error_at(r->name, line,
                                "the maximum sample value is %d: only 255 "
                                "(8 bits a channel) is read",
                                maxval);
    return true;
}

static bool read_sample(struct reader *r, int *sample)
{
    if (!r->binary)
        return read_number(r, "sample", 255, sample);
    *sample = read_char(r);
    return *sample != EOF;
}

static bool refuse_end(const struct reader *r, int y)
{
    return ferror(r->file)
               ? message_error_at(r->name, 0, "cannot be read")
               : message_error_at(
                     r->name, 0,
                     "byte %ld: ends in row %d of %d, %d bytes a row", r->byte,
                     y + 1, r->height, r->width * r->channels);
}

static bool read_row(struct reader *r, int y, pel_color *row)
{
    for (int x = 0; x < r->width; x++) {
        int v[3];
        for (int i = 0; i < r->channels; i++)
            if (!read_sample(r, &v[i]))
                return r->binary && refuse_end(r, y);
        row[x] = PEL_RGB(v[0], v[r->channels / 2], v[r->channels - 1]);
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
        if (!grow(picture, r, y) || !read_row(r, y, picture_row(picture, y)))
            return false;
    const int c = r->binary ? read_char(r) : skip_space(r);
    return c == EOF ||
           message_error_at(r->name, r->binary ? 0 : r->line,
                            "byte %ld: the picture of %d x %d pixels should "
                            "end here, but there is more",
                            r->byte - 1, r->width, r->height);
}

bool picture_read_ppm(struct picture *picture, FILE *file, const char *name)
{
    struct reader reader = {.file = file, .name = name, .line = 1};
    const bool done = read_header(&reader) && read_rows(&reader, picture);
    if (!done)
        picture_free(picture);
    return done;
}

bool picture_load(struct picture *picture, const char *path)
{
    *picture = (struct picture){0, 0, NULL};
    FILE *file = file_open(path);
    if (!file)
        return false;
    const bool done = picture_read_ppm(picture, file, path);
    file_close(file);
    return done;
}
