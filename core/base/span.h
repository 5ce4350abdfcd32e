/* Spans of pixels, as shapes hand them to paints and paints to formats. */
#ifndef PEL_BASE_SPAN_H
#define PEL_BASE_SPAN_H

#include <stdint.h>

struct pel_surface;

/* Pixels of one row, half-open; empty when x0 >= x1. */
struct pel_span {
    int32_t x0, x1; /* px, absolute */
};

/* n >= 1 spans, all inside the surface's clip, no pixel twice. Span i lies in
 * row y + i * step: step is 1 (n rows downwards) or 0 (n spans of one row). */
struct pel_spans {
    const struct pel_surface *surface;
    const struct pel_span *span;
    int32_t y;
    int32_t n, step; /* n <= PEL_BATCH_ROWS */
};

#endif
