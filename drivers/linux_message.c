#define _POSIX_C_SOURCE 200809L
#include "linux_message.h"

#include <errno.h>
#include <grp.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

void pel_message_set(struct pel_message *message, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message->text, sizeof(message->text), format, arguments);
    va_end(arguments);
}

void pel_message_errno(struct pel_message *message, const char *what, int error)
{
    pel_message_set(message, "%s: %s", what, strerror(error));
}

static void denied(struct pel_message *message, const char *path)
{
    struct stat status;
    const struct group *group = NULL;
    if (stat(path, &status) == 0)
        group = getgrgid(status.st_gid);
    if (group && (status.st_mode & S_IRGRP) && (status.st_mode & S_IWGRP))
        pel_message_set(message,
                        "cannot open %s: Permission denied; the group '%s' "
                        "may: sudo usermod -aG %s $USER, then log in again",
                        path, group->gr_name, group->gr_name);
    else
        pel_message_set(message,
                        "cannot open %s: Permission denied; only its owner "
                        "may: run as root, or give a group access to it",
                        path);
}

void pel_message_open(struct pel_message *message, const char *path, int error,
                      const char *missing)
{
    if (error == EACCES)
        denied(message, path);
    else if (error == ENOENT || error == ENODEV || error == ENXIO)
        pel_message_set(message, "cannot open %s: %s; %s", path,
                        strerror(error), missing);
    else
        pel_message_set(message, "cannot open %s: %s", path, strerror(error));
}
