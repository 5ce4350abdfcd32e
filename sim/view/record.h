/* Recorded input: what the user did at which frame, a line each,
 *
 *     FRAME key|button|move|point|touch|wheel CODE up|down|again X Y
 *     FRAME size WIDTH HEIGHT
 *
 * so that a recorded run can be drawn again, frame by frame. */
#ifndef SIM_VIEW_RECORD_H
#define SIM_VIEW_RECORD_H

#include <stdbool.h>
#include <stdio.h>

#include "drivers/input.h"

/* ms from frame to frame of what is recorded, where a show has no period. */
#define RECORD_PERIOD (1000 / 30.0)

/* A new size of the window, in x and y: a kind of its own beside those of
 * drivers/input.h. */
enum { RECORD_SIZE = 200 };

struct record_entry {
    long frame;
    struct pel_input input; /* its time is 0 */
};

struct record {
    struct record_entry *entry;
    size_t count, next;
};

/* Reads a record. False, with a message that names the line. */
bool record_load(struct record *record, const char *path);
void record_free(struct record *record);

/* The next entry of a frame; NULL: no more. Frames may only go on. */
const struct pel_input *record_next(struct record *record, long frame);

/* Writes one line. */
void record_write(FILE *out, long frame, const struct pel_input *input);

#endif
