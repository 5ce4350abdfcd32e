/* What is said of work in a child process that ends badly. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "files.h"

#include "sim/cli/child.h"
#include "sim/cli/message.h"

/* Longer than what is kept of a line. */
static const char lengthy[] =
    "A lengthy line of a library that has much to say about what it does, and "
    "says all of it at once, in one line that goes on and on until nobody who "
    "reads it knows any more how it began.\n";

struct row {
    const char *printed[2]; /* by the library */
    const char *message;    /* of the work; NULL: it crashes */
    const char *said, *not_said;
};

static const struct row rows[] = {
    {{"first\n", "second\n\n"}, NULL, "Aborted: second\n", "first"},
    {{"a long line\n", "cut"}, NULL, "Aborted: cut\n", "line"},
    {{lengthy, "last\n"}, NULL, "Aborted: last\n", "lengthy"},
    {{lengthy}, NULL, "Aborted: A lengthy line", "began"},
    {{"terminate called: 'std::bad_alloc'\n"}, NULL, "took more than", "Abo"},
    {{NULL}, "out of memory", "took more than", "out of"},
    {{NULL}, "no mesh", "memory.obj: no mesh\n", "took"},
};

static bool work(const void *what, FILE *out)
{
    const struct row *row = what;
    (void)out;
    for (int i = 0; i < 2 && row->printed[i]; i++)
        fputs(row->printed[i], stdout);
    fflush(stdout);
    if (!row->message)
        abort();
    return message_error_at("memory.obj", 0, "%s", row->message);
}

TEST(messages)
{
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct messages m;
        messages_begin(&m);
        const FILE *const result = child_run("memory.obj", work, &rows[i]);
        const char *text = messages_end(&m);
        assert_null(result);
        if (!strstr(text, rows[i].said) || strstr(text, rows[i].not_said))
            fail_msg("row %zu: %s", i, text);
    }
}
