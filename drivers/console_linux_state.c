#define _POSIX_C_SOURCE 200809L
#include "console_linux_state.h"

#include <linux/kd.h>
#include <unistd.h>

#include "linux_io.h"

static struct fb_cmap palette_of(const struct pel_console_state *state)
{
    struct fb_cmap map = {.start = 0, .len = state->palette_length};
    map.red = (uint16_t *)state->red;
    map.green = (uint16_t *)state->green;
    map.blue = (uint16_t *)state->blue;
    return map;
}

static int save_terminal(struct pel_console_state *s,
                         struct pel_message *message)
{
    struct vt_stat status;
    if (pel_linux_ioctl(s->tty, KDGETMODE, &s->kd_mode) ||
        pel_linux_ioctl(s->tty, KDGKBMODE, &s->keyboard_mode) ||
        pel_linux_ioctl(s->tty, VT_GETMODE, &s->vt_mode) ||
        pel_linux_ioctl(s->tty, VT_GETSTATE, &status))
        return pel_message_errno(message, "cannot read the console's state");
    s->active = status.v_active;
    return 0;
}

/* Only palettes and direct color get a color map of ours. */
static int save_framebuffer(struct pel_console_state *s,
                            struct pel_message *message)
{
    struct fb_cmap map;
    struct fb_fix_screeninfo fixed;
    if (pel_linux_ioctl(s->framebuffer, FBIOGET_VSCREENINFO, &s->variables) ||
        pel_linux_ioctl(s->framebuffer, FBIOGET_FSCREENINFO, &fixed))
        return pel_message_errno(message, "cannot read the framebuffer's mode");
    s->has_palette = fixed.visual == FB_VISUAL_PSEUDOCOLOR ||
                     fixed.visual == FB_VISUAL_DIRECTCOLOR;
    if (fixed.visual == FB_VISUAL_DIRECTCOLOR && s->variables.green.length < 8)
        s->palette_length = 1u << s->variables.green.length;
    map = palette_of(s);
    if (s->has_palette && pel_linux_ioctl(s->framebuffer, FBIOGETCMAP, &map))
        return pel_message_errno(message,
                                 "cannot read the colour map (FBIOGETCMAP)");
    return 0;
}

int pel_console_state_save(struct pel_console_state *state,
                           struct pel_message *message)
{
    int error = 0;
    state->has_palette = false;
    state->palette_length = PEL_PALETTE_ENTRIES;
    state->input_flags = fcntl(STDIN_FILENO, F_GETFL);
    if (state->tty >= 0)
        error = save_terminal(state, message);
    if (!error && state->input >= 0 && tcgetattr(state->input, &state->termios))
        error =
            pel_message_errno(message, "cannot read the terminal's settings");
    if (!error && state->framebuffer >= 0)
        error = save_framebuffer(state, message);
    return error;
}

bool pel_console_state_restore_framebuffer(
    const struct pel_console_state *state)
{
    struct fb_var_screeninfo variables = state->variables;
    struct fb_cmap map = palette_of(state);
    if (state->framebuffer < 0)
        return true;
    variables.activate = FB_ACTIVATE_NOW;
    bool done = pel_linux_ioctl(state->framebuffer, FBIOPUT_VSCREENINFO,
                                &variables) == 0;
    pel_linux_ioctl(state->framebuffer, FBIOPAN_DISPLAY, &variables);
    if (state->has_palette)
        done &= pel_linux_ioctl(state->framebuffer, FBIOPUTCMAP, &map) == 0;
    return done;
}

bool pel_console_is_virtual(int fd)
{
    int mode;
    return pel_linux_ioctl(fd, KDGETMODE, &mode) == 0;
}

bool pel_console_state_is_shown(const struct pel_console_state *state)
{
    struct vt_stat now;
    return state->tty < 0 || state->number < 1 ||
           pel_linux_ioctl(state->tty, VT_GETSTATE, &now) ||
           now.v_active == state->number;
}

/* Only if ours is the terminal shown does another one have to come back: who
 * switched away meant it. */
static bool restore_active(const struct pel_console_state *s)
{
    return s->number < 1 || s->active == s->number ||
           !pel_console_state_is_shown(s) ||
           pel_linux_ioctl_number(s->tty, VT_ACTIVATE,
                                  (unsigned long)s->active) == 0;
}

static bool restore_terminal(const struct pel_console_state *s)
{
    struct vt_mode vt_mode = s->vt_mode;
    bool done = pel_linux_ioctl(s->tty, VT_SETMODE, &vt_mode) == 0;
    done &= pel_linux_ioctl_number(s->tty, KDSKBMODE,
                                   (unsigned long)s->keyboard_mode) == 0;
    done &= pel_linux_ioctl_number(s->tty, KDSETMODE,
                                   (unsigned long)s->kd_mode) == 0;
    return restore_active(s) && done;
}

bool pel_console_state_restore(const struct pel_console_state *state)
{
    bool done = !pel_console_state_is_shown(state) ||
                pel_console_state_restore_framebuffer(state);
    if (state->tty >= 0)
        done &= restore_terminal(state);
    if (state->input >= 0)
        done &= tcsetattr(state->input, TCSAFLUSH, &state->termios) == 0;
    if (state->input_flags >= 0)
        done &= fcntl(STDIN_FILENO, F_SETFL, state->input_flags) == 0;
    return done;
}
