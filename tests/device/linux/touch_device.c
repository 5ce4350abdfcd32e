/* touch_device: a touch screen of the kernel's uinput, on which two fingers do
 * what guest_input.sh expects; then it is taken away.
 *
 * touch_device WIDTH HEIGHT X Y [X Y...]: one whose glass is swapped, inverted
 * and smaller than what it tells, where a finger taps on the middle of these
 * pixels. */
#include <libevdev/libevdev-uinput.h>
#include <libevdev/libevdev.h>
#include <dirent.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

enum { MOST = 9999, WAIT_MS = 20, WAITS = 30000 / WAIT_MS };

static struct libevdev_uinput *create(void)
{
    struct libevdev_uinput *screen = NULL;
    struct libevdev *device = libevdev_new();
    const struct input_absinfo place = {.maximum = MOST},
                               slots = {.maximum = 4},
                               finger = {.maximum = 65535};
    libevdev_set_name(device, "touch screen of the test");
    libevdev_enable_property(device, INPUT_PROP_DIRECT);
    libevdev_enable_event_code(device, EV_KEY, BTN_TOUCH, NULL);
    libevdev_enable_event_code(device, EV_ABS, ABS_X, &place);
    libevdev_enable_event_code(device, EV_ABS, ABS_Y, &place);
    libevdev_enable_event_code(device, EV_ABS, ABS_MT_SLOT, &slots);
    libevdev_enable_event_code(device, EV_ABS, ABS_MT_TRACKING_ID, &finger);
    libevdev_enable_event_code(device, EV_ABS, ABS_MT_POSITION_X, &place);
    libevdev_enable_event_code(device, EV_ABS, ABS_MT_POSITION_Y, &place);
    libevdev_uinput_create_from_device(device, LIBEVDEV_UINPUT_OPEN_MANAGED,
                                       &screen);
    libevdev_free(device);
    return screen;
}

/* Has the process that file open? */
static bool has_open(const char *process, const char *path)
{
    char name[600], link[600];
    const struct dirent *entry;
    bool found = false;
    snprintf(name, sizeof name, "/proc/%.20s/fd", process);
    DIR *list = opendir(name);
    while (list && !found && (entry = readdir(list))) {
        snprintf(name, sizeof name, "/proc/%.20s/fd/%s", process,
                 entry->d_name);
        const ssize_t n = readlink(name, link, sizeof link - 1);
        if (n > 0) {
            link[n] = 0;
            found = strcmp(link, path) == 0;
        }
    }
    if (list)
        closedir(list);
    return found;
}

/* Does it sleep in poll(2), number 7? Then it has read all that came. */
static bool waits(const char *process)
{
    char name[60], call[3] = "";
    snprintf(name, sizeof name, "/proc/%.20s/syscall", process);
    FILE *file = fopen(name, "r");
    if (!file)
        return false;
    const bool is_poll =
        fgets(call, sizeof call, file) && strcmp(call, "7 ") == 0;
    fclose(file);
    return is_poll;
}

static bool somebody_waits(const char *path)
{
    const struct dirent *entry;
    bool found = false;
    DIR *processes = opendir("/proc");
    while (processes && !found && (entry = readdir(processes)))
        found = atoi(entry->d_name) > 0 && has_open(entry->d_name, path) &&
                waits(entry->d_name);
    if (processes)
        closedir(processes);
    return found;
}

/* Until a program has the device open and waits for it; false: too long. */
static bool wait_reader(const char *path)
{
    const struct timespec pause = {.tv_nsec = WAIT_MS * 1000000L};
    for (int i = 0; i < WAITS; i++) {
        if (somebody_waits(path))
            return true;
        nanosleep(&pause, NULL);
    }
    fprintf(stderr, "touch_device: nobody reads %s\n", path);
    return false;
}

struct step {
    unsigned type, code;
    int value;
};

static void write_steps(struct libevdev_uinput *screen,
                        const struct step *steps, size_t n)
{
    for (; n > 0; n--, steps++)
        libevdev_uinput_write_event(screen, steps->type, steps->code,
                                    steps->value);
}

/* From the right to the left goes y, of 7 to 93 % of the way. */
static void tap(struct libevdev_uinput *screen, double u, double v)
{
    const struct step steps[] = {
        {EV_ABS, ABS_MT_SLOT, 0},
        {EV_ABS, ABS_MT_TRACKING_ID, 7},
        {EV_ABS, ABS_MT_POSITION_X, (int)(MOST * (.93 - .86 * v))},
        {EV_ABS, ABS_MT_POSITION_Y, (int)(MOST * (.05 + .9 * u))},
        {EV_KEY, BTN_TOUCH, 1},
        {EV_SYN, SYN_REPORT, 0},
        {EV_ABS, ABS_MT_TRACKING_ID, -1},
        {EV_KEY, BTN_TOUCH, 0},
        {EV_SYN, SYN_REPORT, 0}};
    write_steps(screen, steps, sizeof(steps) / sizeof(steps[0]));
}

static int tap_all(struct libevdev_uinput *screen, const char *path, int argc,
                   char **argv)
{
    for (int i = 3; i + 1 < argc; i += 2)
        tap(screen, (atoi(argv[i]) + .5) / atoi(argv[1]),
            (atoi(argv[i + 1]) + .5) / atoi(argv[2]));
    if (argc < 7 && !wait_reader(path))
        return 2;
    const struct timespec pause = {.tv_sec = 1};
    nanosleep(&pause, NULL);
    libevdev_uinput_destroy(screen);
    return 0;
}

int main(int argc, char **argv)
{
    static const struct step does[] = {
        {EV_ABS, ABS_MT_SLOT, 0},
        {EV_ABS, ABS_MT_TRACKING_ID, 7},
        {EV_ABS, ABS_MT_POSITION_X, 1000},
        {EV_ABS, ABS_MT_POSITION_Y, 1000},
        {EV_KEY, BTN_TOUCH, 1},
        {EV_SYN, SYN_REPORT, 0},
        {EV_ABS, ABS_MT_SLOT, 1},
        {EV_ABS, ABS_MT_TRACKING_ID, 8},
        {EV_ABS, ABS_MT_POSITION_X, 7500},
        {EV_ABS, ABS_MT_POSITION_Y, 5000},
        {EV_SYN, SYN_REPORT, 0},
        {EV_ABS, ABS_MT_SLOT, 0},
        {EV_ABS, ABS_MT_POSITION_X, 2000},
        {EV_SYN, SYN_REPORT, 0},
        {EV_ABS, ABS_MT_TRACKING_ID, -1},
        {EV_SYN, SYN_REPORT, 0},
    };
    struct libevdev_uinput *screen = create();
    const char *path = screen ? libevdev_uinput_get_devnode(screen) : NULL;
    if (!path || !wait_reader(path))
        return 2;
    if (argc > 1)
        return tap_all(screen, path, argc, argv);
    write_steps(screen, does, sizeof(does) / sizeof(does[0]));
    if (!wait_reader(path))
        return 2;
    libevdev_uinput_destroy(screen); /* while a finger rests */
    return 0;
}
