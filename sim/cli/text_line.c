#include "sim/cli/text_line.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include "sim/cli/child.h"
#include "sim/cli/list.h"
#include "sim/cli/message.h"
#include "sim/cli/milliseconds.h"

/* A file that is read within the limits of --limit. */
struct limited {
    int file;
    double end;   /* of its time, ms */
    int64_t left; /* bytes */
};

/* Waits for what a pipe has, and no longer than the limit. */
static ssize_t read_limited(void *cookie, char *to, size_t size)
{
    struct limited *from = cookie;
    struct pollfd wanted = {from->file, POLLIN, 0};
    ssize_t n = -1;
    errno = EINTR;
    while (n < 0 && (errno == EINTR || errno == EAGAIN)) {
        const double left = from->end - milliseconds();
        errno = ETIMEDOUT;
        if (left <= 0 || poll(&wanted, 1, (int)left + 1) == 0)
            break;
        n = read(from->file, to, size);
    }
    from->left -= n > 0 ? n : 0;
    if (from->left >= 0)
        return n;
    errno = EFBIG;
    return -1;
}

static int close_limited(void *cookie)
{
    struct limited *from = cookie;
    const int file = from->file;
    free(from);
    return file == STDIN_FILENO ? 0 : close(file);
}

/* A pipe that nobody writes to is opened without waiting. NULL, with errno. */
static FILE *open_limited(const char *path)
{
    static const cookie_io_functions_t functions = {.read = read_limited,
                                                    .close = close_limited};
    struct limited *from = malloc(sizeof *from);
    const int file = strcmp(path, "-") == 0
                         ? STDIN_FILENO
                         : open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    FILE *stream = NULL;
    if (from && file >= 0) {
        *from = (struct limited){file,
                                 milliseconds() + 1000.0 * child_limits.seconds,
                                 (int64_t)child_limits.megabytes << 20};
        stream = fopencookie(from, "r", functions);
    }
    if (stream) {
        setvbuf(stream, NULL, _IOFBF, 1 << 16);
        return stream;
    }
    const int error = errno;
    free(from);
    if (file > STDIN_FILENO)
        close(file);
    errno = error;
    return NULL;
}

FILE *file_open(const char *path)
{
    FILE *file = open_limited(path);
    if (!file)
        file_refuse(path);
    return file;
}

char *file_rest(FILE *file, size_t *size)
{
    char *bytes = NULL, *more;
    size_t room = 1 << 16, n = 0;
    while ((more = realloc(bytes, room))) {
        bytes = more;
        n += fread(bytes + n, 1, room - 1 - n, file);
        if (n < room - 1)
            break;
        room *= 2;
    }
    if (more && !ferror(file)) {
        bytes[n] = '\0';
        more = realloc(bytes, n + 1);
        *size = n;
        return more ? more : bytes;
    }
    const int error = more ? errno : ENOMEM;
    free(bytes);
    errno = error;
    return NULL;
}

char *file_read(const char *path, size_t *size)
{
    FILE *file = open_limited(path);
    char *bytes = file ? file_rest(file, size) : NULL;
    const int error = errno;
    if (file)
        fclose(file);
    errno = error;
    return bytes;
}

bool file_refuse(const char *path)
{
    if (errno == ETIMEDOUT)
        return message_error_at(path, 0, CHILD_LIMIT_TEXT("s"),
                                child_limits.seconds);
    if (errno == EFBIG)
        return message_error_at(path, 0, CHILD_LIMIT_TEXT("MB"),
                                child_limits.megabytes);
    return message_error_at(path, 0, "cannot be read: %s", strerror(errno));
}

enum text_line text_line_read(FILE *file, char *text, size_t size)
{
    size_t n = 0;
    int c;
    while ((c = getc(file)) != EOF && c != '\n') {
        if (c == '\0')
            return TEXT_LINE_ZERO;
        if (n == size - 1)
            return TEXT_LINE_LONG;
        text[n++] = (char)c;
    }
    text[n] = '\0';
    return c == EOF && n == 0 ? TEXT_LINE_NONE : TEXT_LINE;
}

bool text_lines_read(struct text_lines *lines, const char *path)
{
    char *text = NULL;
    size_t size = 0;
    FILE *file = file_open(path);
    *lines = (struct text_lines){NULL, 0};
    if (!file)
        return false;
    errno = 0;
    while (getline(&text, &size, file) > 0 &&
           list_add(&lines->text, &lines->count, &text, sizeof text)) {
        text[strcspn(text, "\n")] = '\0';
        text = NULL;
    }
    free(text);
    const bool whole = (feof(file) && !ferror(file)) || file_refuse(path);
    fclose(file);
    return whole;
}

void text_lines_free(struct text_lines *lines)
{
    for (size_t i = 0; i < lines->count; i++)
        free(lines->text[i]);
    free(lines->text);
}

size_t text_start(const char *path, char *text, size_t size)
{
    const int file = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    const ssize_t n = file < 0 ? -1 : read(file, text, size - 1);
    text[n > 0 ? n : 0] = '\0';
    if (file >= 0)
        close(file);
    return n > 0 ? (size_t)n : 0;
}
