/* faults DEVICE: draws frames on a device while the n-th call of each kind
 * fails with each errno that it may have, n = 1, 2, ... until a run has fewer
 * calls. Every run must end by itself, succeed or tell why not, leave the
 * console as it was, and no descriptor, child or mapping behind. Runs on a
 * virtual terminal (standard input). DEVICE /dev/ttyN: resets that console
 * instead; `input` reads all input devices, buttons:TEXT these buttons. */
#include <errno.h>
#include <fcntl.h>
#include <linux/fb.h>
#include <linux/kd.h>
#include <linux/vt.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include "core/pel.h"
#include "drivers/display_linux.h"
#include "fault_calls.h"
#include "port/linux/input.h"

enum { MOST_ERRORS = 7, TIMEOUT = 20 /* s */ };

/* How a run ended, as the status of its process. */
enum {
    PASSED,
    REFUSED,
    INTERRUPTED,
    NO_MESSAGE,
    LEAKED_FD,
    LEAKED_CHILD,
    LEAKED_MAP,
    END
};
enum { NOT_REACHED = 64 };

static const char *const verdicts[END] = {"passed",
                                          "refused",
                                          "refused, and all it met was EINTR",
                                          "failed without a message",
                                          "leaked a file",
                                          "left a process",
                                          "left memory mapped"};

static const int errors[FAULT_CALLS][MOST_ERRORS] = {
    [FAULT_OPEN] = {EACCES, ENOENT, EMFILE, ENODEV, EINTR, EBUSY},
    [FAULT_IOCTL] = {EINVAL, ENOTTY, EIO, EINTR, ENODEV, EPERM},
    [FAULT_MMAP] = {ENOMEM, EINVAL, EAGAIN, EACCES, ENODEV},
    [FAULT_READ] = {EIO, EINTR, EAGAIN, EBADF},
    [FAULT_WRITE] = {EIO, EINTR, EAGAIN, EPIPE},
    [FAULT_POLL] = {EINTR, ENOMEM, EINVAL},
    [FAULT_FORK] = {EAGAIN, ENOMEM},
    [FAULT_SOCKETPAIR] = {EMFILE, ENFILE, ENOMEM},
    [FAULT_SIGNALFD] = {EMFILE, ENOMEM, ENODEV},
    [FAULT_CALLOC] = {ENOMEM},
    [FAULT_EPOLL] = {EMFILE, ENOMEM},
    [FAULT_INOTIFY] = {EMFILE, ENOMEM},
    [FAULT_TIMER] = {EMFILE, ENODEV}};

struct console {
    int mode, keyboard, switching, active, input_flags;
    struct termios termios;
    struct fb_var_screeninfo variables;
    unsigned short palette[3][256];
};

static void read_console(struct console *c)
{
    struct vt_mode vt = {0};
    struct vt_stat status = {0};
    int fb = open("/dev/fb0", O_RDWR);
    memset(c, 0, sizeof(*c));
    ioctl(0, KDGETMODE, &c->mode);
    ioctl(0, KDGKBMODE, &c->keyboard);
    ioctl(0, VT_GETMODE, &vt);
    ioctl(0, VT_GETSTATE, &status);
    tcgetattr(0, &c->termios);
    c->switching = vt.mode;
    c->active = status.v_active;
    c->input_flags = fcntl(0, F_GETFL);
    ioctl(fb, FBIOGET_VSCREENINFO, &c->variables);
    struct fb_cmap map = {.len = 256,
                          .red = c->palette[0],
                          .green = c->palette[1],
                          .blue = c->palette[2]};
    ioctl(fb, FBIOGETCMAP, &map);
    close(fb);
}

static int open_files(void)
{
    int n = 0;
    for (int fd = 0; fd < 256; fd++)
        n += fcntl(fd, F_GETFD) >= 0;
    return n;
}

static int device_mappings(void)
{
    char line[512];
    int n = 0;
    FILE *maps = fopen("/proc/self/maps", "r");
    while (maps && fgets(line, sizeof(line), maps))
        n += strstr(line, "/dev/") != NULL;
    if (maps)
        fclose(maps);
    return n;
}

static enum pel_status draw_frames(struct pel_display_linux *screen)
{
    struct pel_surface surface;
    enum pel_status status = PEL_OK;
    for (int i = 0; i < 3 && status == PEL_OK; i++) {
        pel_display_linux_wait(screen, 0);
        status = pel_display_begin(&screen->display, &screen->area, &surface);
        if (status == PEL_OK) {
            pel_clear(&surface, PEL_RGB(i * 80, 0, 90));
            status = pel_display_flush(&screen->display, &surface);
        }
        if (status == PEL_OK)
            status = pel_display_flip(&screen->display);
        pel_display_linux_wait(screen, 1);
    }
    return status;
}

/* `buttons` NULL: the devices. */
static enum pel_status read_input(const char *buttons,
                                  struct pel_message *message)
{
    static struct pel_input_linux input;
    const struct pel_input_linux_options options = {
        .buttons = buttons, .no_devices = buttons, .width = 9, .height = 9};
    struct pel_input event;
    const int error = pel_input_linux_open(&input, &options);
    *message = input.message;
    while (!error && pel_input_linux_wait(&input, 20, &event))
        continue;
    pel_input_linux_close(&input);
    return error ? PEL_ERROR_DEVICE : PEL_OK;
}

/* What is tested: PEL_OK, or an error with its message. */
static enum pel_status draw_or_reset(struct pel_display_linux *screen,
                                     const char *device)
{
    if (strncmp(device, "/dev/tty", 8) == 0)
        return pel_console_reset(device, &screen->message) ? PEL_ERROR_DEVICE
                                                           : PEL_OK;
    if (strcmp(device, "input") == 0)
        return read_input(NULL, &screen->message);
    if (strncmp(device, "buttons:", 8) == 0)
        return read_input(device + 8, &screen->message);
    enum pel_status status = pel_display_linux_open(screen, device, PEL_FB_ANY);
    if (status == PEL_OK) {
        status = draw_frames(screen);
        pel_display_linux_close(screen);
    }
    return status;
}

static int session(const char *device)
{
    static struct pel_display_linux screen;
    int files = open_files();
    enum pel_status status = draw_or_reset(&screen, device);
    int happened = fault_happened();
    fault_set(FAULT_CALLS, 0, 0);
    int verdict = status == PEL_OK         ? PASSED
                  : screen.message.text[0] ? REFUSED
                                           : NO_MESSAGE;
    if (open_files() != files)
        verdict = LEAKED_FD;
    else if (waitpid(-1, NULL, WNOHANG) >= 0)
        verdict = LEAKED_CHILD;
    else if (device_mappings())
        verdict = LEAKED_MAP;
    return verdict | (happened ? 0 : NOT_REACHED);
}

/* One run in a process of its own: its status, or END for any other end. */
static int run(const char *device, enum fault_call call, int n, int error)
{
    int status;
    pid_t pid = fork();
    if (pid < 0)
        return END;
    if (pid == 0) {
        alarm(TIMEOUT);
        fault_set(call, n, error);
        _exit(session(device));
    }
    while (waitpid(pid, &status, 0) < 0 && errno == EINTR)
        continue;
    return WIFEXITED(status) ? WEXITSTATUS(status) : END;
}

/* All n for one call and errno: the runs that met the fault, or -1. */
static int all_places(const char *device, enum fault_call call, int error,
                      const struct console *before)
{
    struct console now;
    for (int n = 1;; n++) {
        int status = run(device, call, n, error);
        int verdict = status & (NOT_REACHED - 1);
        if (verdict == REFUSED && error == EINTR)
            verdict = INTERRUPTED;
        read_console(&now);
        int same = memcmp(&now, before, sizeof(now)) == 0;
        if (!same || verdict > REFUSED) {
            printf("%s number %d, %s: %s%s\n", fault_names[call], n,
                   strerror(error),
                   verdict < END ? verdicts[verdict] : "killed by a signal",
                   same ? "" : ", and the console is not as before");
            return -1;
        }
        if (status & NOT_REACHED)
            return n - 1;
    }
}

int main(int argc, char **argv)
{
    struct console before;
    int bad = 0;
    if (argc != 2) {
        fprintf(stderr, "faults DEVICE\n");
        return 2;
    }
    read_console(&before);
    for (int call = 0; call < FAULT_CALLS; call++) {
        int runs = 0, bad_before = bad;
        for (int e = 0; e < MOST_ERRORS && errors[call][e]; e++) {
            int n = all_places(argv[1], (enum fault_call)call, errors[call][e],
                               &before);
            bad += n < 0;
            runs += n > 0 ? n : 0;
        }
        if (!runs && bad == bad_before)
            continue;
        printf("%s %s: %s failed in %d places\n",
               bad == bad_before ? "PASS" : "FAIL", argv[1], fault_names[call],
               runs);
        fflush(stdout);
    }
    return bad != 0;
}
