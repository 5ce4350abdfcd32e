/* The pages of the gallery, as HTML. */
#ifndef SIM_DEMO_PAGE_H
#define SIM_DEMO_PAGE_H

#include "sim/demo/demo.h"

enum { PAGES = 2 };

struct page_section {
    const char *id, *title, *about;
    const char *names; /* of what it shows, separated by blanks */
};

extern const char *const page_files[PAGES];
extern const struct page_section *const page_sections[PAGES]; /* up to NULL */

void page_begin(FILE *page, int number);
void page_section_begin(FILE *page, const struct page_section *section);
void page_section_end(FILE *page);
void page_end(FILE *page);

/* A picture, with what made it: the text of a script, or a command. False, with
 * a message, when the script cannot be read. */
bool page_figure(FILE *page, const struct demo *demo,
                 const struct demo_result *result, const char *script);

/* A picture of a program of examples/, px, and the text of docs/PRODUCTS.md, or
 * NULL. */
struct page_product {
    const char *name;
    int width, height;
    const char *table;
};
void page_product(FILE *page, const struct page_product *product);

#endif
