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

/* A signal that comes while a temporary file is there ends the program after
 * it is gone. */
TEST(signals)
{
    static const int signals[] = {SIGHUP, SIGINT, SIGTERM};
    static char text[64 << 20];
    char path[64];
    memset(text, 'x', sizeof text - 1);
    path_of("file", path, sizeof path);
    for (size_t i = 0; i < sizeof signals / sizeof signals[0]; i++) {
        assert_true(write_output(path, "old", true));
        const int before = files_of_directory();
        int status, files = before;
        const pid_t child = fork();
        if (child == 0) {
            write_output(path, text, true);
            pause();
        }
        while (files == before)
            files = files_of_directory();
        kill(child, signals[i]);
        assert_int_equal(waitpid(child, &status, 0), child);
        assert_true(WIFSIGNALED(status));
        assert_int_equal(WTERMSIG(status), signals[i]);
        assert_int_equal(files_of_directory(), before);
    }
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
    static const char *const names[] = {"file", "mode", "link", "target", NULL};
    if (!mkdtemp(directory))
        return 1;
    const int failed = run_all_tests();
    return remove_folder(names) || failed;
}
