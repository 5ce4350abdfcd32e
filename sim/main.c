#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/pel.h"
#include "sim/cli/commands.h"
#include "sim/cli/message.h"

struct command {
    const char *name, *usage, *what;
    int (*run)(int argc, char **argv);
};

static const struct command commands[] = {
    {"run", "SCRIPT [-o OUT.ppm] [--bands ROWS]", "draw a scene script",
     command_run},
    {"render", "MESH -o OUT.ppm", "draw a mesh", command_render},
    {"view", "[MESH|SCRIPT.pel|figures]", "show it in a window or on a device",
     command_view},
    {"compare", "A B", "find the differences of two pictures", command_compare},
    {"import", "MESH|PICTURE|ICON|FONT -o ASSET.c",
     "make an asset for firmware", command_import},
    {"info", "MESH", "tell what a mesh file holds", command_info},
    {"explain", "SCRIPT X Y", "tell what a script does to a pixel, and why",
     command_explain},
    {"demo", "DIRECTORY [SCRIPT...]", "draw the gallery", command_demo},
    {"console", "--reset", "repair a console left in graphics mode",
     command_console},
    {"input", "[--buttons CHIP:LINES]", "print keys, pointers, buttons",
     command_input},
};

enum { COMMAND_COUNT = sizeof commands / sizeof commands[0] };

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

/* Before anything is opened: streams that the caller closed become ones that
 * always fail, so that no file gets their numbers; and however the program
 * ends, it ends with STATUS_ERROR, and a message, when anything that it wrote
 * there is lost. Files beyond the size limit are errors like others. */
static void watch_streams(void)
{
    for (int i = STDIN_FILENO; i <= STDERR_FILENO; i++)
        if (fcntl(i, F_GETFD) < 0 &&
            open("/dev/null", i == STDIN_FILENO ? O_WRONLY : O_RDONLY) < 0)
            _exit(STATUS_ERROR);
    signal(SIGXFSZ, SIG_IGN); /* writing fails, then */
    atexit(check_written);
}

static void print_usage(FILE *file)
{
    fprintf(file, "Usage: pel COMMAND [ARGUMENTS]\n\n");
    for (size_t i = 0; i < COMMAND_COUNT; i++)
        fprintf(file, "  %-8s %-36s %s\n", commands[i].name, commands[i].usage,
                commands[i].what);
    fprintf(file, "\n`pel COMMAND --help' tells more. A file - is standard "
                  "input or output.\n");
}

int main(int argc, char **argv)
{
    const char *name = argc > 1 ? argv[1] : "";
    char program[32];
    watch_streams();
    if (argc < 2 || strcmp(name, "--help") == 0 || strcmp(name, "-h") == 0 ||
        strcmp(name, "help") == 0) {
        print_usage(argc < 2 ? stderr : stdout);
        return argc < 2 ? STATUS_ERROR : STATUS_OK;
    }
    if (strcmp(name, "--version") == 0) {
        printf("pel %d.%d.%d\n", PEL_VERSION_MAJOR, PEL_VERSION_MINOR,
               PEL_VERSION_PATCH);
        return STATUS_OK;
    }
    for (size_t i = 0; i < COMMAND_COUNT; i++)
        if (strcmp(name, commands[i].name) == 0) {
            snprintf(program, sizeof program, "pel %s", name);
            argv[1] = program;
            return commands[i].run(argc - 1, argv + 1);
        }
    message_error("unknown command %s: expected run, render, view, compare, "
                  "import, info, explain, demo, console or input",
                  name);
    return STATUS_ERROR;
}
