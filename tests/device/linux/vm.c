/* vm FOLDER SECONDS CHECK PROGRAM ARGUMENT...: runs an emulator whose serial
 * line is standard input and output, and serves what the guest asks for in
 * lines of its own:
 *
 *     @dump NAME     writes what the screen shows to FOLDER/NAME.ppm
 *     @screen NAME WORD...
 *                    does so until the shell command CHECK WORD... ends with
 *                    status 0, or too long
 *     @monitor TEXT  a command of the emulator's monitor: sendkey ctrl-alt-f2
 *     @input JSON    the events of QMP's input-send-event
 *     @done STATUS   the guest's last word: its status is ours
 *
 * Each but the last is answered by a line on the serial line, so the guest
 * waits with `read`: an empty one, or "differs" when CHECK never held.
 * Everything else is passed on to standard output. Exit: the guest's status, or
 * 2 when the emulator ended or SECONDS passed before the guest was done. */
#define _POSIX_C_SOURCE 200809L
#include <errno.h>
#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { QMP_FD = 3, MOST_ARGUMENTS = 100, LINE = 4096 };

/* The kernel may copy a picture to the screen some time after it was drawn. One
 * that is wrong for so long stays wrong; where one did, others get less time.
 */
enum { SCREEN_SECONDS = 20, SCREEN_SECONDS_LATER = 5 };

static pid_t emulator;

struct vm {
    const char *folder, *check;
    int screen_seconds;
    FILE *from_guest, *to_guest;
    FILE *from_qmp, *to_qmp;
};

static void die(const char *what)
{
    fprintf(stderr, "vm: %s: %s\n", what, strerror(errno));
    exit(2);
}

static void on_alarm(int signal_number)
{
    static const char text[] = "vm: the guest took too long\n";
    (void)signal_number;
    if (write(2, text, sizeof(text) - 1) < 0)
        _exit(3);
    kill(emulator, SIGKILL);
    _exit(2);
}

/* The emulator finds its end of the QMP socket as descriptor 3. */
static void exec_emulator(char **program, const int to[2], const int from[2],
                          int qmp)
{
    char *arguments[MOST_ARGUMENTS + 5];
    int n = 0;
    for (; program[n] && n < MOST_ARGUMENTS; n++)
        arguments[n] = program[n];
    arguments[n++] = "-chardev";
    arguments[n++] = "socket,id=qmp,fd=3";
    arguments[n++] = "-mon";
    arguments[n++] = "chardev=qmp,mode=control";
    arguments[n] = NULL;
    dup2(to[0], 0);
    dup2(from[1], 1);
    if (qmp != QMP_FD)
        dup2(qmp, QMP_FD);
    close(to[1]);
    close(from[0]);
    execvp(arguments[0], arguments);
    fprintf(stderr, "vm: %s: %s (package qemu-system-x86)\n", arguments[0],
            strerror(errno));
    _exit(2);
}

static void vm_start(struct vm *vm, char **program)
{
    int to[2], from[2], qmp[2];
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, qmp) || pipe(to) || pipe(from))
        die("pipe");
    emulator = fork();
    if (emulator < 0)
        die("fork");
    if (emulator == 0) {
        close(qmp[0]);
        exec_emulator(program, to, from, qmp[1]);
    }
    close(qmp[1]);
    close(to[0]);
    close(from[1]);
    vm->from_guest = fdopen(from[0], "r");
    vm->to_guest = fdopen(to[1], "w");
    vm->from_qmp = fdopen(qmp[0], "r");
    vm->to_qmp = fdopen(dup(qmp[0]), "w");
    if (!vm->from_guest || !vm->to_guest || !vm->from_qmp || !vm->to_qmp)
        die("fdopen");
}

/* Waits for the answer to the command just written; events in between are
 * dropped. */
static bool qmp_answer(struct vm *vm)
{
    char line[8192];
    fputc('\n', vm->to_qmp);
    fflush(vm->to_qmp);
    while (fgets(line, sizeof(line), vm->from_qmp)) {
        if (strstr(line, "\"return\""))
            return true;
        if (strstr(line, "\"error\"")) {
            fprintf(stderr, "vm: %s", line);
            return false;
        }
    }
    return false;
}

static bool dump(struct vm *vm, int length, const char *name)
{
    fprintf(vm->to_qmp,
            "{\"execute\":\"screendump\",\"arguments\":"
            "{\"filename\":\"%s/%.*s.ppm\"}}",
            vm->folder, length, name);
    return qmp_answer(vm);
}

static bool answer(struct vm *vm, const char *text)
{
    fprintf(vm->to_guest, "%s\n", text);
    return fflush(vm->to_guest) == 0;
}

/* The screen as it is when it is right, or at last. */
static bool serve_screen(struct vm *vm, const char *words)
{
    static char command[2 * LINE];
    const struct timespec pause = {.tv_nsec = 50 * 1000 * 1000};
    const int name = (int)strcspn(words, " ");
    struct timespec begun, now;
    snprintf(command, sizeof command, "set -- %s\n%s \"$@\" >/dev/null 2>&1",
             words + name, vm->check);
    clock_gettime(CLOCK_MONOTONIC, &begun);
    do {
        if (!dump(vm, name, words))
            return false;
        if (system(command) == 0)
            return answer(vm, "");
        nanosleep(&pause, NULL);
        clock_gettime(CLOCK_MONOTONIC, &now);
    } while (now.tv_sec - begun.tv_sec < vm->screen_seconds);
    vm->screen_seconds = SCREEN_SECONDS_LATER;
    return answer(vm, "differs");
}

static bool serve(struct vm *vm, const char *line)
{
    if (strncmp(line, "@dump ", 6) == 0)
        return dump(vm, LINE, line + 6) && answer(vm, "");
    if (strncmp(line, "@screen ", 8) == 0)
        return serve_screen(vm, line + 8);
    if (strncmp(line, "@monitor ", 9) == 0)
        fprintf(vm->to_qmp,
                "{\"execute\":\"human-monitor-command\",\"arguments\":"
                "{\"command-line\":\"%s\"}}",
                line + 9);
    else if (strncmp(line, "@input ", 7) == 0)
        fprintf(vm->to_qmp,
                "{\"execute\":\"input-send-event\",\"arguments\":"
                "{\"events\":%s}}",
                line + 7);
    else
        return false;
    return qmp_answer(vm) && answer(vm, "");
}

/* Passes lines on until the guest is done: its status, or 2. */
static int vm_serve(struct vm *vm)
{
    char line[LINE];
    while (fgets(line, sizeof(line), vm->from_guest)) {
        line[strcspn(line, "\r\n")] = 0;
        if (strncmp(line, "@done ", 6) == 0)
            return atoi(line + 6);
        if (line[0] != '@') {
            printf("%s\n", line);
            fflush(stdout);
        } else if (!serve(vm, line)) {
            fprintf(stderr, "vm: not served: %s\n", line);
            return 2;
        }
    }
    fprintf(stderr, "vm: the emulator ended before the guest was done\n");
    return 2;
}

int main(int argc, char **argv)
{
    struct vm vm;
    if (argc < 5) {
        fprintf(stderr, "vm FOLDER SECONDS CHECK PROGRAM ARGUMENT...\n");
        return 2;
    }
    signal(SIGPIPE, SIG_IGN);
    signal(SIGALRM, on_alarm);
    vm.folder = argv[1];
    vm.check = argv[3];
    vm.screen_seconds = SCREEN_SECONDS;
    vm_start(&vm, argv + 4);
    alarm((unsigned)atoi(argv[2]));
    int status = 2;
    fputs("{\"execute\":\"qmp_capabilities\"}", vm.to_qmp);
    if (qmp_answer(&vm))
        status = vm_serve(&vm);
    kill(emulator, SIGKILL);
    waitpid(emulator, NULL, 0);
    return status;
}
