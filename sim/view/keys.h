/* Keys of pel view: what they are called, and what they do to a view. */
#ifndef SIM_VIEW_KEYS_H
#define SIM_VIEW_KEYS_H

#include "sim/view/view.h"

/* Keys are the characters on them; these have none. */
enum {
    VIEW_KEY_ESCAPE = 27,
    VIEW_KEY_LEFT = 256,
    VIEW_KEY_RIGHT,
    VIEW_KEY_UP,
    VIEW_KEY_DOWN,
    VIEW_KEY_UNKNOWN
};

enum view_action {
    VIEW_NOTHING, /* no such key, and nothing has changed */
    VIEW_CHANGED,
    VIEW_SAVE, /* the present picture is to be written */
    VIEW_END
};

/* The keys and what they do, a line each. */
extern const char view_keys_help[];

/* Changes the view as the key says. A key of light on a view that has none
 * brings the light, all of it that is not switched off. */
enum view_action view_key(struct view *view, int key);

/* The first key of what a terminal has sent, *used of `count` >= 1 bytes:
 * arrows as CSI or SS3 sequences, Escape as a byte that no sequence follows. */
int view_terminal_key(const char *bytes, size_t count, size_t *used);

#endif
