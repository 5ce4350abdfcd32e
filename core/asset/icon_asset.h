/* Icons in flash, as `pel import ICON.svg` writes them: paths with their
 * colours, for any size and angle (image/icon.h).
 *
 * Parts are drawn one over the other. Each takes the next of the icon's verbs
 * and points, those of path/path.h. Points lie in the icon's units, y
 * downwards from the left top corner of its box. */
#ifndef PEL_ASSET_ICON_ASSET_H
#define PEL_ASSET_ICON_ASSET_H

#include "../base/color.h"
#include "../base/point.h"
#include "../base/status.h"

PEL_BEGIN_DECLS

/* "PELV", and the version of the struct. */
#define PEL_ICON_MAGIC UINT32_C(0x564C4550)
enum { PEL_ICON_VERSION = 1 };

enum pel_icon_part_kind {
    PEL_ICON_EVEN_ODD, /* fills, as enum pel_fill_rule */
    PEL_ICON_NON_ZERO,
    PEL_ICON_STROKE
};

/* In place of the index of a gradient: its own color, or the program's with the
 * alpha of its own (currentColor). */
enum { PEL_ICON_PROGRAM = 254, PEL_ICON_FLAT = 255 };

/* Beyond the ends of a gradient, as enum pel_spread. */
enum pel_icon_spread { PEL_ICON_PAD, PEL_ICON_REPEAT, PEL_ICON_REFLECT };

struct pel_icon_part {
    pel_color color;
    uint16_t verbs, points; /* counts */
    uint8_t kind;           /* enum pel_icon_part_kind */
    uint8_t gradient;       /* its index, PEL_ICON_PROGRAM or PEL_ICON_FLAT */

    /* Of a stroke, as in struct pel_stroke. */
    uint8_t cap, join;
    uint16_t width; /* units */
    uint16_t miter_limit;
};

struct pel_icon_stop {
    uint16_t at; /* 4,096ths of the way, not falling */
    pel_color color;
};

/* A pixel whose centre is frame[0] + u (frame[1] - frame[0]) + v (frame[2] -
 * frame[0]) shows the color at the place u of a linear gradient, and of a
 * radial one at sqrt(u^2 + v^2) + u focus / 65,536: so a circle becomes an
 * ellipse, and a focus beside the centre is a frame around it. */
struct pel_icon_gradient {
    struct pel_point frame[3]; /* units */
    uint16_t focus;
    uint8_t radial;       /* 0 or 1 */
    uint8_t spread;       /* enum pel_icon_spread */
    uint16_t stop, stops; /* the first, and their count, 1 or more */
};

struct pel_icon_asset;
struct pel_icon_gradients;

struct pel_icon_asset {
    uint32_t magic;                   /* PEL_ICON_MAGIC */
    uint8_t version;                  /* PEL_ICON_VERSION */
    uint8_t strokes;                  /* are some parts strokes? 0 or 1 */
    uint16_t width, height;           /* units of its box, 1..32,767,
                                         the longer one 256 or more */
    int16_t left, top, right, bottom; /* units around all that is drawn */
    uint16_t parts, gradients, stops; /* counts */
    uint32_t verbs, points;
    const struct pel_icon_part *part;
    const struct pel_icon_gradient *gradient;
    const struct pel_icon_stop *stop;
    const uint8_t *verb;                      /* enum pel_verb */
    const int16_t *point;                     /* x and y in turn */
    const struct pel_icon_gradients *painter; /* &pel_icon_gradients where
                                                 there are some, or NULL */
};

/* Checks that the program can read this asset. PEL_ERROR_NULL; PEL_ERROR_RANGE:
 * no icon, or one of another version; PEL_ERROR_SIZE: a part or a gradient that
 * takes more than there is, or a count or size of 0. Verbs are checked where
 * they are drawn. */
enum pel_status pel_icon_asset_check(const struct pel_icon_asset *icon);
PEL_END_DECLS

#endif
