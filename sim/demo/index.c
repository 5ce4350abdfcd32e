#include "sim/demo/index.h"

#include <stdlib.h>
#include <string.h>

#include "sim/cli/libraries.h"
#include "sim/cli/message.h"

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

bool demo_index_open(struct demo_index *index, const char *directory)
{
    index->directory = directory;
    if (asprintf(&index->path, "%s/index.html", directory) < 0)
        return message_error("out of memory");
    if (!output_open(&index->output, index->path)) {
        free(index->path);
        return false;
    }
    fputs(head, index->output.stream);
    return true;
}

void demo_index_add(struct demo_index *index, const struct demo *demo,
                    const struct demo_result *result)
{
    char note[2 * sizeof result->note];
    const struct picture *p = &result->picture;
    const char *ending = picture_best_ending();
    demo_index_escape(result->note, note, sizeof note);
    fprintf(index->output.stream,
            "<figure>\n<h2>%s</h2>\n"
            "<a href=\"%s%s\"><img src=\"%s%s\" width=\"%d\" height=\"%d\" "
            "alt=\"%s\"></a>\n"
            "<figcaption>%s %s<br>\n<small>%d x %d pixels, %.3f ms, "
            "<a href=\"%s.ppm\">PPM</a></small></figcaption>\n</figure>\n",
            demo->name, demo->name, ending, demo->name, ending, p->width,
            p->height, demo->name, demo->caption, note, p->width, p->height,
            result->milliseconds, demo->name);
}

static void tell_missing(FILE *page)
{
    for (const struct library *l = libraries; l->name; l++) {
        if (l->present)
            continue;
        printf("built without %s (package %s): %s\n", l->name, l->package,
               l->adds);
        fprintf(page, "<p>Built without %s (package %s): %s.</p>\n", l->name,
                l->package, l->adds);
    }
}

bool demo_index_commit(struct demo_index *index)
{
    fputs("</main>\n", index->output.stream);
    tell_missing(index->output.stream);
    fputs("</body>\n</html>\n", index->output.stream);
    const bool done = output_commit(&index->output);
    free(index->path);
    return done;
}

void demo_index_abandon(struct demo_index *index)
{
    output_abandon(&index->output);
    free(index->path);
}

static const char *escape_of(const char *c)
{
    switch (*c) {
    case '&':
        return "&amp;";
    case '<':
        return "&lt;";
    case '>':
        return "&gt;";
    case '"':
        return "&quot;";
    default:
        return NULL;
    }
}

void demo_index_escape(const char *text, char *html, size_t size)
{
    size_t n = 0;
    for (; *text; text++) {
        const char *escape = escape_of(text);
        const size_t length = escape ? strlen(escape) : 1;
        if (n + length >= size)
            break;
        memcpy(html + n, escape ? escape : text, length);
        n += length;
    }
    html[n] = '\0';
}
