#include "sim/cli/standard.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "sim/cli/commands.h"
#include "sim/cli/message.h"

static void check_written(void)
{
    const bool lost = ferror(stdout);
    errno = 0;
    if (fclose(stdout) != 0 || lost)
        message_error("standard output cannot be written: %s",
                      errno ? strerror(errno) : "a part is lost");
    else if (!ferror(stderr))
        return;
    _exit(STATUS_ERROR);
}

void standard_watch(void)
{
    for (int i = STDIN_FILENO; i <= STDERR_FILENO; i++)
        if (fcntl(i, F_GETFD) < 0 &&
            open("/dev/null", i == STDIN_FILENO ? O_WRONLY : O_RDONLY) < 0)
            _exit(STATUS_ERROR);
    signal(SIGXFSZ, SIG_IGN); /* writing fails, then */
    atexit(check_written);
}
