/* Output files appear whole or not at all. */
#include <dirent.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "sim/cli/output.h"
#include "files.h"

static void check_file(const char *path, const char *want)
{
    char data[64];
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    const size_t n = fread(data, 1, sizeof data - 1, file);
    fclose(file);
    data[n] = '\0';
    assert_string_equal(data, want);
}

static bool write_output(const char *path, const char *text, bool commit)
{
    struct output output;
    assert_true(output_open(&output, path));
    fputs(text, output.stream);
    if (commit)
        return output_commit(&output);
    output_abandon(&output);
    return true;
}

/* What is abandoned leaves what was there; what is committed replaces it. */
TEST(file)
{
    char path[64];
    path_of("file", path, sizeof path);
    assert_true(write_output(path, "abandoned", false));
    assert_int_equal(access(path, F_OK), -1);
    assert_true(write_output(path, "first", true));
    check_file(path, "first");
    assert_true(write_output(path, "abandoned", false));
    check_file(path, "first");
    assert_true(write_output(path, "second", true));
    check_file(path, "second");
    assert_true(write_output(path, "", true));
    check_file(path, "");
}

/* New files get the mode that the umask leaves; old ones keep theirs. */
TEST(mode)
{
    char path[64];
    struct stat status;
    const mode_t kept = umask(027);
    path_of("mode", path, sizeof path);
    assert_true(write_output(path, "new", true));
    umask(kept);
    assert_int_equal(stat(path, &status), 0);
    assert_int_equal(status.st_mode & 07777, 0640);
    assert_int_equal(chmod(path, 0604), 0);
    assert_true(write_output(path, "newer", true));
    assert_int_equal(stat(path, &status), 0);
    assert_int_equal(status.st_mode & 07777, 0604);
}

TEST(link)
{
    char path[64], target[64];
    struct stat status;
    path_of("link", path, sizeof path);
    path_of("target", target, sizeof target);
    assert_true(write_output(target, "old", true));
    assert_int_equal(symlink("target", path), 0);
    assert_true(write_output(path, "new", true));
    assert_int_equal(lstat(path, &status), 0);
    assert_true(S_ISLNK(status.st_mode));
    check_file(target, "new");
}

/* A link to nothing stays a link; what it names appears. */
TEST(dangling_link)
{
    char path[64], target[64];
    path_of("link", path, sizeof path);
    path_of("target", target, sizeof target);
    unlink(target);
    assert_true(write_output(path, "new", true));
    check_file(target, "new");
}

/* The longest name that there is. */
TEST(long_name)
{
    char name[256], path[320];
    memset(name, 'n', 255);
    name[255] = '\0';
    path_of(name, path, sizeof path);
    assert_true(write_output(path, "text", true));
    assert_true(write_output(path, "again", true));
    check_file(path, "again");
    unlink(path);
}

/* When the second of two cannot be written, the first stays as it was. */
TEST(both)
{
    struct output first, second;
    char path[64], none[64];
    struct messages m;
    path_of("file", path, sizeof path);
    path_of("none/file", none, sizeof none);
    assert_true(write_output(path, "old", true));
    assert_true(output_open(&first, path));
    assert_true(output_open(&second, none));
    fputs("new", first.stream);
    messages_begin(&m);
    const bool done = output_commit_both(&first, &second);
    messages_end(&m);
    assert_false(done);
    check_file(path, "old");
}

static int files_of_directory(void)
{
    int n = 0;
    DIR *list = opendir(directory);
    assert_non_null(list);
    while (readdir(list))
        n++;
    closedir(list);
    return n;
}

/* In a child that is signalled at any time of a long write. */
static void check_signal(int number, useconds_t after, const char *text)
{
    char path[64];
    int status;
    path_of("file", path, sizeof path);
    const int before = files_of_directory();
    const pid_t child = fork();
    if (child == 0) {
        for (;;)
            write_output(path, text, true);
    }
    usleep(after);
    kill(child, number);
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_true(WIFSIGNALED(status));
    assert_int_equal(WTERMSIG(status), number);
    if (files_of_directory() != before)
        fail_msg("signal %d after %d us leaves a file", number, (int)after);
}

/* A signal that ends the program leaves nothing but the file, old or new. */
TEST(signals)
{
    static const int numbers[] = {SIGHUP,  SIGINT,  SIGTERM, SIGQUIT,
                                  SIGPIPE, SIGALRM, SIGXCPU, SIGUSR1};
    static char text[4 << 20];
    char path[64];
    memset(text, 'x', sizeof text - 1);
    path_of("file", path, sizeof path);
    assert_true(write_output(path, "old", true));
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
        for (useconds_t after = 3000; after < 60000; after += 7001)
            check_signal(numbers[i], after, text);
}

static struct stat status_of(const char *path)
{
    struct stat status;
    assert_int_equal(stat(path, &status), 0);
    return status;
}

/* What takes the place of a file has its owner and group, and not the rights
 * that setuid and setgid give. */
TEST(owner)
{
    char path[64];
    path_of("owner", path, sizeof path);
    assert_true(write_output(path, "old", true));
    const bool root = geteuid() == 0;
    assert_true(!root || chown(path, 12345, 23456) == 0);
    const struct stat old = status_of(path);
    assert_int_equal(chmod(path, 06754), 0);
    assert_true(write_output(path, "new", true));
    const struct stat new = status_of(path);
    assert_int_equal(new.st_uid, old.st_uid);
    assert_int_equal(new.st_gid, old.st_gid);
    assert_int_equal(new.st_mode & 07777, 0754);
    check_file(path, "new");
}

/* Nobody's rights, in a child: 0, or what it returns. */
static int as_nobody(int (*work)(const char *path), const char *path)
{
    int status;
    const pid_t child = fork();
    if (child == 0) {
        if (geteuid() == 0 && (setgid(65534) != 0 || setuid(65534) != 0))
            _exit(99);
        _exit(work(path));
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    return status;
}

static int write_and_tell(const char *path)
{
    struct messages m;
    messages_begin(&m);
    const bool done = write_output(path, "new", true);
    messages_end(&m);
    return !done ? 1 : !strstr(m.text, "is written in place: ") ? 2 : 0;
}

static int be_refused(const char *path)
{
    struct messages m;
    messages_begin(&m);
    const bool done = write_output(path, "newer", true);
    messages_end(&m);
    return done ? 1 : !strstr(m.text, "cannot be written: Perm") ? 2 : 0;
}

/* A file that may be written to, in a folder that may not: it stays the same
 * file. One that may not be written to stays as it is. */
TEST(in_place)
{
    char path[64], folder[64];
    path_of("closed", folder, sizeof folder);
    path_of("closed/file", path, sizeof path);
    assert_int_equal(chmod(directory, 0755), 0);
    assert_int_equal(mkdir(folder, 0755), 0);
    assert_true(write_output(path, "a longer text", true));
    assert_int_equal(chmod(path, 0666), 0);
    assert_int_equal(chmod(folder, 0555), 0);
    const struct stat old = status_of(path);
    assert_int_equal(as_nobody(write_and_tell, path), 0);
    assert_int_equal(status_of(path).st_ino, old.st_ino);
    check_file(path, "new");
    assert_int_equal(chmod(path, 0444), 0);
    assert_int_equal(as_nobody(be_refused, path), 0);
    check_file(path, "new");
    assert_int_equal(chmod(folder, 0755), 0);
    unlink(path);
    assert_int_equal(rmdir(folder), 0);
}

/* A file of somebody else's in a folder of all stays theirs. */
TEST(foreign_owner)
{
    char path[64], folder[64];
    if (geteuid() != 0)
        return;
    path_of("open", folder, sizeof folder);
    path_of("open/file", path, sizeof path);
    assert_int_equal(mkdir(folder, 0755), 0);
    assert_int_equal(chmod(folder, 0777), 0);
    assert_true(write_output(path, "old", true));
    assert_int_equal(as_nobody(be_refused, path), 0);
    check_file(path, "old");
    assert_int_equal(chmod(path, 0666), 0);
    assert_int_equal(as_nobody(write_and_tell, path), 0);
    assert_int_equal(status_of(path).st_uid, 0);
    check_file(path, "new");
    unlink(path);
    assert_int_equal(rmdir(folder), 0);
}

/* A device is written to, and stays a device. */
TEST(device)
{
    struct stat status;
    assert_true(write_output("/dev/null", "text", true));
    assert_int_equal(stat("/dev/null", &status), 0);
    assert_true(S_ISCHR(status.st_mode));
}

static void check_refused(const char *path, const char *message)
{
    struct messages m;
    messages_begin(&m);
    const bool done = write_output(path, "text", true);
    messages_end(&m);
    assert_false(done);
    assert_non_null(strstr(m.text, message));
}

/* A message, and no file anywhere. */
TEST(refused)
{
    char path[64];
    path_of("none/file", path, sizeof path);
    check_refused(path, "none/file: cannot be written: No such");
}

/* What cannot be written is closed all the same: its number is free again. */
TEST(full)
{
    const int before = dup(STDOUT_FILENO);
    close(before);
    check_refused("/dev/full", "/dev/full: cannot be written: No space");
    const int after = dup(STDOUT_FILENO);
    close(after);
    assert_int_equal(after, before);
}

int main(void)
{
    static const char *const names[] = {"file",   "mode",  "link",
                                        "target", "owner", NULL};
    if (!mkdtemp(directory))
        return 1;
    const int failed = run_all_tests();
    return remove_folder(names) || failed;
}
