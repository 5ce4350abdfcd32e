/* What keys do to a view. */
#ifndef SIM_VIEW_KEYS_H
#define SIM_VIEW_KEYS_H

#include "sim/view/show.h"
#include "sim/view/view.h"

/* The keys and what they do, a line each. */
#define VIEW_KEYS_HELP                                                       \
    "  arrows, drag        turn\n"                                           \
    "  + -, wheel          closer, farther\n"                                \
    "  space, enter        stop or start the turning\n"                      \
    "  f g p               shading: flat, Gouraud, Phong\n"                  \
    "  t                   texture: none, nearest, bilinear\n"               \
    "  l                   light on or off (Phong has it always)\n"          \
    "  1 to 9              that light on or off\n"                           \
    "  a d s               ambient, diffuse, specular light on or off\n"     \
    "  e                   tolerance: 0, 1, 2, 4 or 8 steps of 255\n"        \
    "  m                   Phong's methods in colours (pel render --help)\n" \
    "  z                   painter's order or z-buffer\n"                    \
    "  r                   back to the start\n"                              \
    "  w                   write the picture to a file\n"                    \
    "  q, Escape           end\n"

/* Changes the view as the key says, of enum pel_key. A key of light on a view
 * that has none brings the light, all of it that is not switched off. */
enum view_action view_key(struct view *view, int key);

/* The first key (enum pel_key) of what a terminal has sent, *used of `count` >=
 * 1 bytes: arrows and F keys as CSI or SS3 sequences, Escape as a byte that no
 * sequence follows. */
int view_terminal_key(const char *bytes, size_t count, size_t *used);

#endif
