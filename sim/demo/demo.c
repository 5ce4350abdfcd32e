/* pel demo: draws the gallery. */
#include <ctype.h>
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "sim/cli/arguments.h"
#include "sim/cli/bytes.h"
#include "sim/cli/commands.h"
#include "sim/demo/demo.h"
#include "sim/demo/page.h"
#include "sim/cli/message.h"
#include "sim/cli/milliseconds.h"
#include "sim/cli/output.h"
#include "sim/cli/text_line.h"
#include "sim/script/script.h"

static const char about[] =
    "Draws the gallery into a directory: every demo and every script, as PPM "
    "and PNG (BMP without libpng), with index.html; and shows pictures that "
    "are there already, with what docs/PRODUCTS.md, a table, says of them.\v"
    "Prints the milliseconds that the drawing of each picture took, the best "
    "of three where it is less than 50.";

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
    {"expat", "libexpat1-dev", "reads 3MF meshes, and SVG icons"},
#endif
#ifndef HAVE_JANSSON
    {"jansson", "libjansson-dev", "reads glTF meshes"},
#endif
#ifndef HAVE_HARFBUZZ
    {"HarfBuzz", "libharfbuzz-dev", "reads pairs of fonts that stand closer"},
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

/* A script or a picture of the command line. */
struct given {
    const char *path;
    char name[96]; /* of files, and on the page */
    bool is_picture, is_shown;
};

struct gallery {
    const char *directory;
    struct given *given;
    size_t count;
    char *table; /* the text of a .md, what products take; or NULL */
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
static bool draw_best(const struct demo *demo, struct demo_result *best)
{
    bool done = demo->draw(best, demo->what);
    for (int i = 1; done && i < 3 && best->milliseconds < 50; i++) {
        struct demo_result again = {.note = ""};
        done = demo->draw(&again, demo->what);
        if (again.milliseconds < best->milliseconds)
            best->milliseconds = again.milliseconds;
        picture_free(&again.picture);
    }
    return done;
}

/* A script has its path, and its caption is text. */
static bool add_demo(const struct gallery *g, FILE *page,
                     const struct demo *demo, const char *script,
                     const char *caption)
{
    struct demo_result result = {.note = ""};
    bool done = draw_best(demo, &result);
    if (done) {
        if (caption)
            snprintf(result.note, sizeof result.note, "%s", caption);
        message_print(stdout, "%-26s %5d x %-5d %10.3f ms", demo->name,
                      result.picture.width, result.picture.height,
                      result.milliseconds);
        putchar('\n');
        fflush(stdout);
        done = save(g, demo->name, ".ppm", &result.picture) &&
               save(g, demo->name, picture_best_ending(), &result.picture) &&
               page_figure(page, demo, &result, script);
    }
    picture_free(&result.picture);
    return done;
}

static bool add_script(const struct gallery *g, FILE *page,
                       const struct given *given)
{
    struct script script;
    const struct demo demo = {given->name, "", NULL, demo_draw_script, &script};
    if (!script_load(&script, given->path, NULL))
        return false;
    const bool done = add_demo(g, page, &demo, given->path, script.caption);
    script_free(&script);
    return done;
}

/* Copies the file; its head tells the size of the picture. */
static bool copy_picture(const struct gallery *g, const struct given *given,
                         const uint8_t *bytes, size_t size)
{
    struct output output;
    char *path;
    if (size < 24 || memcmp(bytes, "\x89PNG", 4) != 0)
        return message_error_at(given->path, 0, "is no PNG: expected one");
    if (asprintf(&path, "%s/%s.png", g->directory, given->name) < 0)
        return message_error("out of memory");
    bool done = output_open(&output, path);
    if (done) {
        fwrite(bytes, 1, size, output.stream);
        done = output_commit(&output);
    }
    free(path);
    return done;
}

/* What a program has drawn, as it is. */
static bool add_picture(const struct gallery *g, FILE *page,
                        const struct given *given)
{
    size_t size;
    char *bytes = file_read(given->path, &size);
    if (!bytes)
        return file_refuse(given->path);
    const uint8_t *head = (const uint8_t *)bytes;
    const bool done = copy_picture(g, given, head, size);
    if (done)
        page_product(page, &(struct page_product){
                               given->name, (int)bytes_big(head + 16, 4),
                               (int)bytes_big(head + 20, 4), g->table});
    free(bytes);
    return done;
}

static bool add_given(const struct gallery *g, FILE *page, struct given *given)
{
    given->is_shown = true;
    return given->is_picture ? add_picture(g, page, given)
                             : add_script(g, page, given);
}

static bool add(const struct gallery *g, FILE *page, const char *name)
{
    static const struct demo *const demos[] = {demo_formats, demo_rules,
                                               demo_figures, demo_meshes};
    for (size_t i = 0; i < g->count; i++)
        if (strcmp(g->given[i].name, name) == 0)
            return add_given(g, page, &g->given[i]);
    for (size_t i = 0; i < sizeof demos / sizeof *demos; i++)
        for (const struct demo *demo = demos[i]; demo->name; demo++)
            if (strcmp(demo->name, name) == 0)
                return add_demo(g, page, demo, NULL, NULL);
    return true;
}

/* Names in a section are separated by blanks. */
static bool add_section(const struct gallery *g, FILE *page,
                        const struct page_section *section)
{
    char name[96];
    bool done = true;
    page_section_begin(page, section);
    for (const char *at = section->names; done && *at;) {
        const size_t n = strcspn(at, " ");
        snprintf(name, sizeof name, "%.*s", (int)n, at);
        done = add(g, page, name);
        at += n + strspn(at + n, " ");
    }
    page_section_end(page);
    return done;
}

/* Scripts and pictures that no section names. */
static bool add_rest(const struct gallery *g, FILE *page)
{
    static const struct page_section rest = {"more", "More", "", ""};
    bool done = true, begun = false;
    for (size_t i = 0; done && i < g->count; i++) {
        if (g->given[i].is_shown)
            continue;
        if (!begun)
            page_section_begin(page, &rest);
        begun = true;
        done = add_given(g, page, &g->given[i]);
    }
    if (begun)
        page_section_end(page);
    return done;
}

static void add_missing(FILE *page)
{
    fputs("<footer>\n", page);
    for (const struct library *l = missing; l->name; l++) {
        printf("built without %s (package %s): %s\n", l->name, l->package,
               l->adds);
        fprintf(page, "<p>Built without %s (package %s): %s.</p>\n", l->name,
                l->package, l->adds);
    }
    fputs("</footer>\n", page);
}

/* The first page ends with what no section names. */
static bool write_page(const struct gallery *g, int number)
{
    struct output output;
    char *path;
    if (asprintf(&path, "%s/%s", g->directory, page_files[number]) < 0)
        return message_error("out of memory");
    bool done = output_open(&output, path);
    if (done) {
        page_begin(output.stream, number);
        for (const struct page_section *s = page_sections[number];
             done && s->title; s++)
            done = add_section(g, output.stream, s);
        if (done && number == 0)
            done = add_rest(g, output.stream);
        if (number == 0)
            add_missing(output.stream);
        page_end(output.stream);
        if (done)
            done = output_commit(&output);
        else
            output_abandon(&output);
    }
    free(path);
    return done;
}

/* A name that goes into HTML, and names files. */
static struct given given_of(const char *path)
{
    struct given given = {.path = path};
    given.is_picture = path_has_ending(path, " .png ");
    snprintf(given.name, sizeof given.name, "%s", basename(path));
    char *dot = strrchr(given.name, '.');
    if (dot && dot > given.name)
        *dot = '\0';
    for (char *c = given.name; *c; c++)
        if (!isalnum((unsigned char)*c) && !strchr("._-", *c))
            *c = '_';
    return given;
}

static bool read_table(struct gallery *g, const char *path)
{
    size_t size;
    free(g->table);
    g->table = file_read(path, &size);
    return g->table || file_refuse(path);
}

int command_demo(int argc, char **argv)
{
    const struct command_line line = {.arguments =
                                          "DIRECTORY [SCRIPT|PICTURE|TABLE...]",
                                      .least = 1,
                                      .most = INT_MAX,
                                      .about = about};
    char **arguments = arguments_parse(&line, argc, argv);
    struct gallery g = {.directory = *arguments++};
    if (mkdir(g.directory, 0777) != 0 && errno != EEXIST) {
        message_error_at(g.directory, 0, "cannot be made: %s", strerror(errno));
        return STATUS_ERROR;
    }
    g.given = calloc((size_t)argc, sizeof *g.given);
    if (!g.given) {
        message_error("out of memory");
        return STATUS_ERROR;
    }
    bool done = true;
    for (; done && *arguments; arguments++)
        if (path_has_ending(*arguments, " .md "))
            done = read_table(&g, *arguments);
        else
            g.given[g.count++] = given_of(*arguments);
    for (int i = 0; done && i < PAGES; i++)
        done = write_page(&g, i);
    free(g.given);
    free(g.table);
    return done ? STATUS_OK : STATUS_ERROR;
}
