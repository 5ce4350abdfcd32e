/* What an asset takes in flash: a table on standard output, unless the asset
 * goes there. */
#ifndef SIM_ASSET_REPORT_H
#define SIM_ASSET_REPORT_H

#include "sim/asset/import.h"

/* Of a picture of that format, in runs (0: it has none), and in all others. */
void report_picture(const struct import_options *options,
                    const struct picture *picture,
                    const struct pel_format *format, size_t in_runs);

/* Of a font. */
struct pel_font_asset;
struct pel_outline_font_asset;
void report_font(const struct import_options *options,
                 const struct pel_font_asset *font);
void report_outlines(const struct import_options *options,
                     const struct pel_outline_font_asset *font);

/* What was measured of a mesh: the errors of all ways, and what was taken. */
void report_measure(const struct import_options *options);

/* Of an icon, and of pictures of it. */
struct pel_icon_asset;
void report_icon(const struct import_options *options,
                 const struct pel_icon_asset *icon);

/* Of a mesh; with its textures, in that format, unless it is NULL. */
void report_mesh(const struct import_options *options,
                 const struct model *model, const struct pel_format *format);

#endif
