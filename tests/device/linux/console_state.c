/* What a program must leave as it was, in one line, for tests; knows nothing of
 * Pel.
 *
 *     console_state /dev/ttyN      the state of that terminal, of standard
 *                                  input and of /dev/fb0
 *     console_state -scramble      what a bad program does: standard input no
 *                                  longer waits, its keyboard is raw
 *     console_state -default COMMAND...
 *                                  runs the command with no signal ignored (a
 *                                  shell's background jobs ignore some) */
#include <fcntl.h>
#include <linux/fb.h>
#include <linux/kd.h>
#include <linux/vt.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

static void print_terminal(int fd)
{
    int mode = -1, keyboard = -1;
    struct vt_mode vt = {0};
    struct vt_stat status = {0};
    struct termios t;
    memset(&t, 0, sizeof(t));
    ioctl(fd, KDGETMODE, &mode);
    ioctl(fd, KDGKBMODE, &keyboard);
    ioctl(fd, VT_GETMODE, &vt);
    ioctl(fd, VT_GETSTATE, &status);
    tcgetattr(fd, &t);
    printf("graphics %d keyboard %d switching %d active %d", mode, keyboard,
           vt.mode, status.v_active);
    printf(" termios %x %x %x %x", t.c_iflag, t.c_oflag, t.c_cflag, t.c_lflag);
    for (int i = 0; i < NCCS; i++)
        printf("%c%x", i ? ',' : ' ', t.c_cc[i]);
    printf(" nonblocking %d", !!(fcntl(0, F_GETFL) & O_NONBLOCK));
}

static void print_framebuffer(void)
{
    unsigned short red[256] = {0}, green[256] = {0}, blue[256] = {0};
    struct fb_cmap map = {.len = 256, .red = red, .green = green, .blue = blue};
    struct fb_var_screeninfo v;
    unsigned sum = 0;
    int fd = open("/dev/fb0", O_RDWR);
    if (fd < 0 || ioctl(fd, FBIOGET_VSCREENINFO, &v)) {
        printf(" no framebuffer\n");
        return;
    }
    if (ioctl(fd, FBIOGETCMAP, &map) == 0)
        for (unsigned i = 0; i < 256; i++)
            sum = sum * 31 + red[i] + green[i] * 3u + blue[i] * 7u;
    printf(" framebuffer %ux%u %ux%u %u,%u %u palette %08x\n", v.xres, v.yres,
           v.xres_virtual, v.yres_virtual, v.xoffset, v.yoffset,
           v.bits_per_pixel, sum);
}

static int scramble(void)
{
    return fcntl(0, F_SETFL, fcntl(0, F_GETFL) | O_NONBLOCK) ||
           ioctl(0, KDSKBMODE, K_RAW);
}

int main(int argc, char **argv)
{
    if (argc == 2 && strcmp(argv[1], "-scramble") == 0)
        return scramble();
    if (argc > 2 && strcmp(argv[1], "-default") == 0) {
        for (int i = 1; i < 32; i++)
            signal(i, SIG_DFL);
        execvp(argv[2], argv + 2);
        perror(argv[2]);
        return 2;
    }
    int fd = argc > 1 ? open(argv[1], O_RDWR | O_NOCTTY) : -1;
    if (fd < 0) {
        perror("console_state: /dev/ttyN");
        return 2;
    }
    print_terminal(fd);
    print_framebuffer();
    return 0;
}
