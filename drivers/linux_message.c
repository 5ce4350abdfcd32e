#define _POSIX_C_SOURCE 200809L
#include "linux_message.h"

#include <errno.h>
#include <grp.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

int pel_message_set(struct pel_message *message, int error, const char *format,
                    ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message->text, sizeof(message->text), format, arguments);
    va_end(arguments);
    return error;
}

int pel_message_errno(struct pel_message *message, const char *what)
{
    return pel_message_set(message, errno, "%s: %s", what, strerror(errno));
}

static int denied(struct pel_message *message, const char *path)
{
    struct stat status;
    const struct group *group = NULL;
    if (stat(path, &status) == 0)
        group = getgrgid(status.st_gid);
    if (group && (status.st_mode & S_IRGRP) && (status.st_mode & S_IWGRP))
        return pel_message_set(
            message, EACCES,
            "cannot open %s: Permission denied; the group '%s' "
            "may: sudo usermod -aG %s $USER, then log in again",
            path, group->gr_name, group->gr_name);
    return pel_message_set(message, EACCES,
                           "cannot open %s: Permission denied; only its owner "
                           "may: run as root, or give a group access to it",
                           path);
}

int pel_message_open(struct pel_message *message, const char *path, int error,
                     const char *missing)
{
    const bool gone = error == ENOENT || error == ENODEV || error == ENXIO;
    if (error == EACCES)
        return denied(message, path);
    return pel_message_set(message, error, "cannot open %s: %s%s%s", path,
                           strerror(error), gone ? "; " : "",
                           gone ? missing : "");
}
