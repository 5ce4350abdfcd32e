/* Every pixel format by its name in scripts: pel_format without the prefix. */
#ifndef SIM_IMAGE_FORMAT_NAMES_H
#define SIM_IMAGE_FORMAT_NAMES_H

#include "core/base/format.h"

struct format_name {
    const char *name;
    const struct pel_format *format;
};

/* All formats; the last has the name NULL. */
extern const struct format_name format_names[];

/* NULL when there is no such format. */
const struct pel_format *format_find(const char *name);

/* "rgb565_le, rgb565_be, ..." for messages. */
const char *format_list(void);

#endif
