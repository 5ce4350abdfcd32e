#include "sim/image/format_names.h"

#include <string.h>

#include "core/format/formats.h"

const struct format_name format_names[] = {
    {"rgb565_le", &pel_rgb565_le},
    {"rgb565_be", &pel_rgb565_be},
    {"bgr565_le", &pel_bgr565_le},
    {"xrgb1555_le", &pel_xrgb1555_le},
    {"rgb888", &pel_rgb888},
    {"bgr888", &pel_bgr888},
    {"xrgb8888", &pel_xrgb8888},
    {"xbgr8888", &pel_xbgr8888},
    {"rgbx8888", &pel_rgbx8888},
    {"bgrx8888", &pel_bgrx8888},
    {"rgb332", &pel_rgb332},
    {"gray8", &pel_gray8},
    {"gray4", &pel_gray4},
    {"mono1", &pel_mono1},
    {"mono1_pages", &pel_mono1_pages},
    {"inks2", &pel_inks2},
    {"gray2", &pel_gray2},
    {NULL, NULL},
};

const struct pel_format *format_find(const char *name)
{
    for (const struct format_name *f = format_names; f->name; f++)
        if (strcmp(f->name, name) == 0)
            return f->format;
    return NULL;
}

const char *format_list(void)
{
    return "rgb565_le, rgb565_be, bgr565_le, xrgb1555_le, rgb888, bgr888, "
           "xrgb8888, xbgr8888, rgbx8888, bgrx8888, rgb332, gray8, gray4, "
           "mono1, mono1_pages, inks2, gray2";
}
