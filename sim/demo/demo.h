/* The gallery: every demo draws one picture. */
#ifndef SIM_DEMO_DEMO_H
#define SIM_DEMO_DEMO_H

#include "sim/script/script.h"

struct demo_result {
    struct picture picture; /* made by draw, freed by its caller */
    double milliseconds;    /* of the drawing alone, without loading */
    char note[2048];    /* text, added to the caption: which mesh was taken */
    char command[1024]; /* that makes the picture; "": the demo's */
};

struct demo {
    const char *name;    /* of the files, without ending; NULL ends an array */
    const char *caption; /* one or two sentences of HTML text */
    const char *command; /* that makes the picture, or NULL */
    /* False, with a message on standard error, when it failed. */
    bool (*draw)(struct demo_result *result, const void *what);
    const void *what;
};

/* Draws onto a canvas of `size` and takes its picture and time. */
struct demo_size {
    const struct pel_format *format;
    int width, height; /* px */
};
bool demo_draw(struct demo_result *result, const struct demo_size *size,
               bool (*draw)(struct canvas *canvas, const void *context),
               const void *context);

/* The same with a struct script. */
bool demo_draw_script(struct demo_result *result, const void *script);

/* Arrays that end with a NULL name. Scripts join the gallery through the
 * command line of `pel demo`. */
extern const struct demo demo_rules[];
extern const struct demo demo_formats[];
extern const struct demo demo_figures[];
extern const struct demo demo_meshes[];

#endif
