/* pel demo: draws the gallery. */
#include <ctype.h>
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "sim/cli/arguments.h"
#include "sim/cli/commands.h"
#include "sim/demo/demo.h"
#include "sim/cli/message.h"
#include "sim/cli/milliseconds.h"
#include "sim/cli/output.h"
#include "sim/script/script.h"

static const char about[] =
    "Draws the gallery into a directory: every demo and every script, as PPM "
    "and PNG (BMP without libpng), with index.html.\v"
    "Prints the milliseconds that the drawing of each picture took, the best "
    "of three where it is less than 50.";

static const char head[] =
    "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
    "<title>Pel: gallery</title>\n<style>\n"
    "body { font: 16px/1.5 sans-serif; margin: 2em; color: #222; }\n"
    "main { display: grid; gap: 2em; "
    "grid-template-columns: repeat(auto-fill, minmax(20em, 1fr)); }\n"
    "figure { margin: 0; }\n"
    "h2 { font-size: 1em; margin: 0 0 0.3em; }\n"
    "img { max-width: 100%; height: auto; border: 1px solid #ccc; }\n"
    "figcaption { font-size: 0.9em; }\n"
    "figcaption small { color: #666; }\n"
    "</style>\n</head>\n<body>\n<h1>Pel: gallery</h1>\n"
    "<p>A picture is a link to itself at full size. Times are those of the "
    "drawing, the best of three where it takes less than 50 ms.</p>\n<main>\n";

static void print_escaped(FILE *page, const char *text)
{
    for (; *text; text++)
        fprintf(page, strchr("&<>\"", *text) ? "&#%d;" : "%c", *text);
}

static void print_figure(FILE *page, const struct demo *demo,
                         const struct demo_result *result)
{
    const struct picture *p = &result->picture;
    const char *ending = picture_best_ending();
    fprintf(page,
            "<figure>\n<h2>%s</h2>\n"
            "<a href=\"%s%s\"><img src=\"%s%s\" width=\"%d\" height=\"%d\" "
            "alt=\"%s\"></a>\n<figcaption>%s ",
            demo->name, demo->name, ending, demo->name, ending, p->width,
            p->height, demo->name, demo->caption);
    print_escaped(page, result->note);
    fprintf(page,
            "<br>\n<small>%d x %d pixels, %.3f ms, "
            "<a href=\"%s.ppm\">PPM</a></small></figcaption>\n</figure>\n",
            p->width, p->height, result->milliseconds, demo->name);
}

/* The libraries that this build lacks, told on the page and on standard output.
 */
static const struct library {
    const char *name;
    const char *package; /* of Debian, that brings it */
    const char *adds;    /* what it is for */
} missing[] = {
#ifndef HAVE_PKG_CONFIG
    {"pkg-config", "pkg-config", "finds the libraries below at build time"},
#endif
#ifndef HAVE_ASSIMP
    {"assimp", "libassimp-dev", "reads meshes of any format"},
#endif
#ifndef HAVE_SDL2
    {"SDL2", "libsdl2-dev", "turns meshes in a window (pel view)"},
#endif
#ifndef HAVE_SDL2_IMAGE
    {"SDL2_image", "libsdl2-image-dev", "reads TGA and GIF pictures"},
#endif
#ifndef HAVE_LIBPNG
    {"libpng", "libpng-dev", "reads PNG, and writes it in place of BMP"},
#endif
#ifndef HAVE_LIBJPEG
    {"libjpeg", "libjpeg-dev", "reads JPEG pictures"},
#endif
#ifndef HAVE_LIBZIP
    {"libzip", "libzip-dev", "opens 3MF meshes"},
#endif
#ifndef HAVE_EXPAT
    {"expat", "libexpat1-dev", "reads 3MF meshes"},
#endif
#ifndef HAVE_JANSSON
    {"jansson", "libjansson-dev", "reads glTF meshes"},
#endif
#ifndef HAVE_FREETYPE
    {"FreeType", "libfreetype-dev", "reads TrueType, PCF and packed fonts"},
#endif
#if !defined(PEL_WITH_DRM) || !PEL_WITH_DRM
    {"libdrm", "libdrm-dev", "shows scenes on DRM devices"},
#endif
#ifndef HAVE_LIBEVDEV
    {"libevdev", "libevdev-dev", "reads keyboards, mice, touch screens"},
#endif
#ifndef HAVE_LIBGPIOD
    {"libgpiod", "libgpiod-dev", "reads buttons at GPIO lines"},
#endif
    {NULL, NULL, NULL},
};

struct gallery {
    const char *directory;
    FILE *page;
};

bool demo_draw(struct demo_result *result, const struct demo_size *size,
               bool (*draw)(struct canvas *canvas, const void *context),
               const void *context)
{
    struct canvas canvas;
    if (!canvas_init(&canvas, size->format, size->width, size->height))
        return false;
    const double start = milliseconds();
    bool done = draw(&canvas, context);
    result->milliseconds = milliseconds() - start;
    done = done && canvas_picture(&canvas, &result->picture);
    canvas_free(&canvas);
    return done;
}

static bool draw_items(struct canvas *canvas, const void *script)
{
    return script_draw(script, canvas, -1);
}

bool demo_draw_script(struct demo_result *result, const void *what)
{
    const struct script *script = what;
    const struct demo_size size = {script->format, script->width,
                                   script->height};
    return demo_draw(result, &size, draw_items, script);
}

static bool save(const struct gallery *g, const char *name, const char *ending,
                 const struct picture *picture)
{
    char *path;
    if (asprintf(&path, "%s/%s%s", g->directory, name, ending) < 0)
        return message_error("out of memory");
    const bool done = picture_save(picture, path);
    free(path);
    return done;
}

/* The first run of a short drawing pays for cold caches and fresh pages: three
 * runs, and the time of the best. */
static bool add_demo(const struct gallery *g, const struct demo *demo,
                     const char *note)
{
    struct demo_result best = {.note = ""};
    bool done = demo->draw(&best, demo->what);
    for (int i = 1; done && i < 3 && best.milliseconds < 50; i++) {
        struct demo_result again = {.note = ""};
        done = demo->draw(&again, demo->what);
        if (again.milliseconds < best.milliseconds)
            best.milliseconds = again.milliseconds;
        picture_free(&again.picture);
    }
    if (note)
        snprintf(best.note, sizeof best.note, "%s", note);
    if (done) {
        message_print(stdout, "%-26s %5d x %-5d %10.3f ms", demo->name,
                      best.picture.width, best.picture.height,
                      best.milliseconds);
        putchar('\n');
        fflush(stdout);
        print_figure(g->page, demo, &best);
        done = save(g, demo->name, ".ppm", &best.picture) &&
               save(g, demo->name, picture_best_ending(), &best.picture);
    }
    picture_free(&best.picture);
    return done;
}

static bool add_script(const struct gallery *g, const char *path)
{
    char name[128];
    struct script script;
    const struct demo demo = {name, "", demo_draw_script, &script};
    if (!script_load(&script, path, NULL))
        return false;
    snprintf(name, sizeof name, "%s", basename(path));
    char *dot = strrchr(name, '.');
    if (dot && dot > name)
        *dot = '\0';
    for (char *c = name; *c; c++) /* it goes into HTML, and names files */
        if (!isalnum((unsigned char)*c) && !strchr("._-", *c))
            *c = '_';
    const bool done = add_demo(g, &demo, script.caption);
    script_free(&script);
    return done;
}

static bool add_all(const struct gallery *g, char **scripts)
{
    static const struct demo *const demos[] = {demo_formats, demo_rules,
                                               demo_figures, demo_meshes};
    bool done = true;
    for (; done && *scripts; scripts++)
        done = add_script(g, *scripts);
    for (size_t i = 0; i < sizeof demos / sizeof *demos; i++)
        for (const struct demo *demo = demos[i]; done && demo->name; demo++)
            done = add_demo(g, demo, NULL);
    return done;
}

static bool write_page(struct output *output, const char *directory,
                       char **scripts)
{
    const struct gallery gallery = {directory, output->stream};
    fputs(head, output->stream);
    if (!add_all(&gallery, scripts)) {
        output_abandon(output);
        return false;
    }
    fputs("</main>\n", output->stream);
    for (const struct library *l = missing; l->name; l++) {
        printf("built without %s (package %s): %s\n", l->name, l->package,
               l->adds);
        fprintf(output->stream, "<p>Built without %s (package %s): %s.</p>\n",
                l->name, l->package, l->adds);
    }
    fputs("</body>\n</html>\n", output->stream);
    return output_commit(output);
}

int command_demo(int argc, char **argv)
{
    struct output output;
    char *path;
    const struct command_line line = {.arguments = "DIRECTORY [SCRIPT...]",
                                      .least = 1,
                                      .most = INT_MAX,
                                      .about = about};
    char **arguments = arguments_parse(&line, argc, argv);
    const char *directory = *arguments;
    if (mkdir(directory, 0777) != 0 && errno != EEXIST) {
        message_error_at(directory, 0, "cannot be made: %s", strerror(errno));
        return STATUS_ERROR;
    }
    if (asprintf(&path, "%s/index.html", directory) < 0) {
        message_error("out of memory");
        return STATUS_ERROR;
    }
    const bool done = output_open(&output, path) &&
                      write_page(&output, directory, arguments + 1);
    free(path);
    return done ? STATUS_OK : STATUS_ERROR;
}
