#include "sim/demo/page.h"

#include <stdlib.h>
#include <string.h>

#include "sim/cli/text_line.h"
#include "sim/image/picture.h"

const char *const page_files[PAGES] = {"index.html", "lighting.html"};

static const struct page_section first[] = {
    {"products", "Products",
     "Programs of at most 150 lines, in <code>examples/</code>: to look at and "
     "to copy. What they take of a Cortex-M0+ and a Cortex-M4 stands in "
     "<code>docs/PRODUCTS.md</code>.",
     "watch thermostat scope globe badge kiosk game gauge"},
    {"shapes", "Shapes",
     "Whole pixels by an exact rule, or smooth edges by the exact area.",
     "cover smooth strokes shapes circles polygons lines rules-top-left "
     "rules-bottom-left"},
    {"paints", "Paints", "Any paint on any shape, opaque or seen through.",
     "gradients wheel dither glass blend textures figures figures-flat "
     "figures-corners figures-rings figures-sectors"},
    {"text", "Text, pictures, formats", "", "text type icons scroll formats"},
    {"meshes", "3-D",
     "Flat, Gouraud, textures, Phong. <a href=\"lighting.html\">Light term by "
     "term</a> has a page of its own.",
     "vase texture-bilinear lighting-gouraud lighting-phong meshes"},
    {NULL, NULL, NULL, NULL},
};

static const struct page_section second[] = {
    {"vertices", "Light at the vertices",
     "Gouraud: colours are interpolated over each triangle.",
     "lighting-gouraud lighting-gouraud-ambient lighting-gouraud-diffuse "
     "lighting-gouraud-specular lighting-gouraud-light1 "
     "lighting-gouraud-light2 lighting-gouraud-light3"},
    {"pixels", "Light at the pixels",
     "Phong: normals are interpolated, and every pixel is lit.",
     "lighting-phong lighting-phong-ambient lighting-phong-diffuse "
     "lighting-phong-specular lighting-phong-light1 lighting-phong-light2 "
     "lighting-phong-light3"},
    {"parts", "Texture and light apart", "",
     "lighting-texture-vertices lighting-texture-pixels "
     "lighting-gouraud-plain lighting-phong-plain duck-flat duck-gouraud "
     "texture-flat texture-nearest"},
    {NULL, NULL, NULL, NULL},
};

const struct page_section *const page_sections[PAGES] = {first, second};

#define BOARD(name)                              \
    "make board EXAMPLE=" name " BOARD=m0plus\n" \
    "make window EXAMPLE=" name
static const struct product {
    const char *name, *title, *caption, *commands;
} products[] = {
    {"watch", "Watch",
     "240 x 240, two bands of 20 lines; a second redraws what has moved.",
     BOARD("watch")},
    {"thermostat", "Thermostat",
     "320 x 240: digits of a TrueType font, icons, a slider, gradients.",
     BOARD("thermostat")},
    {"scope", "Scope",
     "480 x 320: two traces over a grid; the panel itself moves what it shows.",
     BOARD("scope")},
    {"globe", "Globe",
     "240 x 240: a textured mesh, lit, that turns in 20 KB of RAM.",
     BOARD("globe")},
    {"badge", "Badge",
     "296 x 128 in 1 bit, for e-paper: a dithered portrait, wrapped text.",
     BOARD("badge")},
    {"kiosk", "Kiosk",
     "A coffee machine on a Linux device without a desktop, by touch and keys.",
     "make device EXAMPLE=kiosk\nmake window EXAMPLE=kiosk"},
    {"vase", "Vase", "240 x 320: 220 triangles, lit, a line at a time in 8 KB.",
     "make board EXAMPLE=mesh BOARD=m0plus"},
    {"icons", "Icons",
     "SVG files, at any size and angle from one table each; some take a colour "
     "of the program's.",
     "pel run docs/pictures/icons.pel -o icons.ppm"},
    {"game", "Game",
     "240 x 240: tiles that scroll, twenty sprites, one turned and larger.",
     BOARD("game")},
    {"gauge", "Gauge",
     "240 x 240: a needle over a dithered gradient, in two bands of 8 lines.",
     BOARD("gauge")},
    {NULL, NULL, NULL, NULL},
};

static const char head[] =
    "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
    "<meta name=\"viewport\" content=\"width=device-width\">\n"
    "<title>Pel: gallery</title>\n<style>\n"
    ":root { color-scheme: light dark; --back: #f5f6f8; --card: #fff; "
    "--ink: #1c2027; --soft: #616a78; --line: #dfe3e9; --wall: #e9ecf1; "
    "--link: #0b62c4; }\n"
    "@media (prefers-color-scheme: dark) { :root { --back: #14171c; "
    "--card: #1e232b; --ink: #e8ebf0; --soft: #9aa5b4; --line: #303742; "
    "--wall: #0f1216; --link: #7db8ff; } }\n"
    "* { box-sizing: border-box; }\n"
    "body { margin: 0; background: var(--back); color: var(--ink); "
    "font: 16px/1.5 system-ui, sans-serif; }\n"
    "a { color: var(--link); }\n"
    "header, section, footer { max-width: 1360px; margin: 0 auto; "
    "padding: 0 max(1rem, 2vw); }\n"
    "header { padding-top: 2rem; }\n"
    "h1 { font-size: 2rem; line-height: 1.2; margin: 0; }\n"
    "h2 { font-size: 1.4rem; margin: 2.5rem 0 0; }\n"
    "h3 { font-size: 1rem; margin: 0; }\n"
    "p { margin: .4rem 0 0; max-width: 46rem; color: var(--soft); }\n"
    "nav { display: flex; flex-wrap: wrap; gap: .5rem; margin-top: 1rem; }\n"
    "nav a { padding: .25rem .8rem; border: 1px solid var(--line); "
    "border-radius: 1rem; background: var(--card); text-decoration: none; }\n"
    ".grid { display: grid; gap: 1rem; margin-top: 1rem; "
    "grid-template-columns: "
    "repeat(auto-fill, minmax(min(100%, 19rem), 1fr)); }\n"
    "figure { margin: 0; background: var(--card); border-radius: 12px; "
    "border: 1px solid var(--line); overflow: hidden; display: flex; "
    "flex-direction: column; transition: border-color .15s; }\n"
    "figure:hover { border-color: var(--link); }\n"
    "figure > a { display: flex; height: 15rem; background: var(--wall); }\n"
    "img { display: block; max-width: 100%; max-height: 100%; width: auto; "
    "height: auto; margin: auto; }\n"
    "figure.product > a { padding: 1rem; background: #0b0d11; }\n"
    "figcaption { padding: .8rem 1rem 1rem; font-size: .9rem; flex: 1; "
    "display: flex; flex-direction: column; }\n"
    "figcaption p { margin: .1rem 0 .6rem; color: inherit; }\n"
    "h3::first-letter { text-transform: uppercase; }\n"
    ".how { margin-top: auto; color: var(--soft); font-size: .8rem; }\n"
    "summary { cursor: pointer; }\n"
    "code, pre { font-family: ui-monospace, monospace; "
    "overflow-wrap: anywhere; }\n"
    "pre { overflow: auto; max-height: 20rem; white-space: pre-wrap; "
    "margin: .3rem 0 0; }\n"
    "footer { padding-bottom: 3rem; }\n"
    "</style>\n</head>\n<body>\n";

static void print_escaped_character(FILE *page, char c)
{
    fprintf(page, strchr("&<>\"", c) ? "&#%d;" : "%c", c);
}

static void print_escaped(FILE *page, const char *text)
{
    for (; *text; text++)
        print_escaped_character(page, *text);
}

/* What stands between two backticks is code. */
static void print_note(FILE *page, const char *text)
{
    for (int marks = 0; *text; text++)
        if (*text == '`')
            fputs(marks++ % 2 ? "</code>" : "<code>", page);
        else
            print_escaped_character(page, *text);
}

/* A name of files as words. */
static void print_title(FILE *page, const char *name)
{
    fputs("<h3>", page);
    for (; *name; name++)
        print_escaped_character(page, (char)(*name == '-' ? ' ' : *name));
    fputs("</h3>", page);
}

void page_begin(FILE *page, int number)
{
    fputs(head, page);
    fprintf(page, "<header>\n<h1>%s</h1>\n<p>%s</p>\n<nav>\n",
            number ? "Light term by term" : "Pel: gallery",
            number ? "Three lights on one mesh: all terms, each term, each "
                     "light. <a href=\"index.html\">The gallery</a>"
                   : "Drawn by this build. A picture is a link to itself at "
                     "full size; times are those of the drawing, the best of "
                     "three where it takes less than 50 ms.");
    for (const struct page_section *s = page_sections[number]; s->title; s++)
        fprintf(page, "<a href=\"#%s\">%s</a>\n", s->id, s->title);
    fputs("</nav>\n</header>\n", page);
}

void page_section_begin(FILE *page, const struct page_section *section)
{
    fprintf(page, "<section>\n<h2 id=\"%s\">%s</h2>\n", section->id,
            section->title);
    if (*section->about)
        fprintf(page, "<p>%s</p>\n", section->about);
    fputs("<div class=\"grid\">\n", page);
}

void page_section_end(FILE *page)
{
    fputs("</div>\n</section>\n", page);
}

void page_end(FILE *page)
{
    fputs("</body>\n</html>\n", page);
}

static void print_picture(FILE *page, const char *name, const char *ending,
                          int width, int height)
{
    fprintf(page,
            "<a href=\"%s%s\"><img src=\"%s%s\" width=\"%d\" height=\"%d\" "
            "alt=\"%s\" loading=\"lazy\"></a>\n<figcaption>",
            name, ending, name, ending, width, height, name);
}

/* The command that draws a script, and its text, when one wants to see it. */
static bool print_script(FILE *page, const char *path)
{
    size_t size;
    char *text = file_read(path, &size);
    if (!text)
        return file_refuse(path);
    fputs("<details><summary><code>pel run ", page);
    print_escaped(page, path);
    fputs("</code></summary><pre>", page);
    print_escaped(page, text);
    fputs("</pre></details>", page);
    free(text);
    return true;
}

/* A long one is shown when one wants to see it. */
static void print_command(FILE *page, const char *command)
{
    const bool is_long = strlen(command) > 60;
    fputs(is_long ? "<details><summary>Command</summary><pre>" : "<pre>", page);
    print_escaped(page, command);
    fputs(is_long ? "</pre></details>" : "</pre>", page);
}

/* A note that is too long for a card is shown when one wants to see it. */
static void print_caption(FILE *page, const char *caption, const char *note,
                          bool is_whole)
{
    const bool is_long = strlen(note) > 240 && !is_whole;
    fprintf(page, "<p>%s ", caption);
    if (is_long)
        fputs("</p><details><summary>What is shown</summary><p>", page);
    print_note(page, note);
    fputs(is_long ? "</p></details>" : "</p>", page);
}

bool page_figure(FILE *page, const struct demo *demo,
                 const struct demo_result *result, const char *script)
{
    const struct picture *p = &result->picture;
    const char *command = *result->command ? result->command : demo->command;
    bool done = true;
    fputs("<figure>\n", page);
    print_picture(page, demo->name, picture_best_ending(), p->width, p->height);
    print_title(page, demo->name);
    print_caption(page, demo->caption, result->note, script != NULL);
    fprintf(page,
            "<div class=\"how\">%d x %d pixels, %.3f ms, "
            "<a href=\"%s.ppm\">PPM</a>",
            p->width, p->height, result->milliseconds, demo->name);
    if (script)
        done = print_script(page, script);
    else
        print_command(page, command ? command : "pel demo FOLDER");
    fputs("</div></figcaption>\n</figure>\n", page);
    return done;
}

/* What a row of docs/PRODUCTS.md says of an example: flash, RAM, instructions
 * on a Cortex-M4. */
static void print_figures(FILE *page, const char *table, const char *name)
{
    long cell[9];
    char link[64];
    snprintf(link, sizeof link, "(../examples/%s.c) |", name);
    const char *at = table ? strstr(table, link) : NULL;
    if (!at)
        return;
    at += strlen(link);
    for (int i = 0; i < 9; i++) {
        char *end;
        cell[i] = strtol(at, &end, 10);
        at = end + strspn(end, " |");
    }
    fprintf(page,
            "On a Cortex-M4: %ld KB of flash, %ld KB of RAM and stack; "
            "%ld thousand instructions for the first frame, %ld for a step",
            (cell[1] + 500) / 1000, (cell[2] + cell[4] + 500) / 1000, cell[7],
            cell[8]);
}

void page_product(FILE *page, const struct page_product *product)
{
    const struct product *p = products;
    while (p->name && strcmp(p->name, product->name) != 0)
        p++;
    fputs("<figure class=\"product\">\n", page);
    print_picture(page, product->name, ".png", product->width, product->height);
    print_title(page, p->name ? p->title : product->name);
    fprintf(page, "<p>%s</p><div class=\"how\">", p->name ? p->caption : "");
    if (p->name) {
        print_figures(page, product->table, p->name);
        fprintf(page, "<pre>%s</pre>", p->commands);
    }
    fputs("</div></figcaption>\n</figure>\n", page);
}
