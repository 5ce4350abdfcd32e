/* The page, seen from the examples in it (panel.h). */
#ifndef PAGE_PAGE_H
#define PAGE_PAGE_H

#include <pel/pel.h>

/* The pixels of a surface as R, G, B, A, until the next call. NULL when memory
 * is short. */
const uint8_t *page_bytes(const struct pel_surface *surface);

/* The page keeps a frame: of `sent` pixels that were flushed for it. */
__attribute__((import_module("page"), import_name("frame"))) void page_frame(
    const uint8_t *bytes, int width, int height, int sent);

#endif
