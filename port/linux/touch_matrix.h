/* Touch screens that are swapped, inverted, turned or out of place: a matrix
 * between what the kernel tells and what is shown, the one that libinput has.
 *
 * Places are parts of the way from the left and the top, 0..1. A matrix
 * a b c d e f takes the place (u, v) to (a u + b v + c, d u + e v + f). */
#ifndef PEL_PORT_LINUX_TOUCH_MATRIX_H
#define PEL_PORT_LINUX_TOUCH_MATRIX_H

#include <stdbool.h>

#include "../../drivers/linux_message.h"

PEL_BEGIN_DECLS

struct pel_touch_place {
    double x, y;
};

struct pel_touch_matrix {
    double a, b, c, d, e, f;
};

#define PEL_TOUCH_SAME   \
    {                    \
        1, 0, 0, 0, 1, 0 \
    }

struct pel_touch_place pel_touch_matrix_place(
    const struct pel_touch_matrix *matrix, struct pel_touch_place place);

/* What a text says, words behind commas, done one after the other:
 *
 *     swap                 x is y
 *     invert-x invert-y    from right to left, from bottom to top
 *     rotate=90            as the picture is, clockwise: 0, 90, 180, 270
 *     range=A:B:C:D        the glass tells A..B and C..D of the kernel's 0..1
 *     /PATH                a file with a matrix: its last line that has six
 *                          numbers, of pel input --calibrate, or of libinput
 *                          (LIBINPUT_CALIBRATION_MATRIX="1 0 0 0 1 0")
 *
 * 0, or EINVAL or another errno with a message. */
int pel_touch_matrix_parse(struct pel_touch_matrix *matrix, const char *text,
                           struct pel_message *message);

/* The matrix that takes three places to where they were shown, which lie far
 * apart and not in a line. False when they do not, or when they cannot have
 * been touched there: a way of the glass that is less than a fifth of the one
 * that is shown, or more than five times as long. */
bool pel_touch_matrix_solve(struct pel_touch_matrix *matrix,
                            const struct pel_touch_place told[3],
                            const struct pel_touch_place shown[3]);
PEL_END_DECLS

#endif
