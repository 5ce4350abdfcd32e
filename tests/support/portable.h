/* Core built a second time, without the walk and the vectors of 64-bit CPUs,
 * beside the default one; its names begin with portable_ (tests.mk). A program
 * that uses this needs that object and so names it in tests.mk. */
#ifndef TESTS_SUPPORT_PORTABLE_H
#define TESTS_SUPPORT_PORTABLE_H

#include "items.h"
#include "layouts.h"

extern const struct core core_portable;

/* In the order of layouts[]. */
extern const struct pel_format *const portable_formats[LAYOUT_COUNT];

#endif
