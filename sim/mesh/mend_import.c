/* Hands mended files to assimp, as two files in memory. */
#include "sim/mesh/mend.h"

#include <assimp/cfileio.h>
#include <assimp/cimport.h>
#include <stdlib.h>
#include <string.h>

#include "sim/cli/message.h"
#include "sim/cli/text_line.h"
#include "sim/image/picture.h"

static size_t read_part(struct aiFile *file, char *to, size_t size, size_t n)
{
    return fread(to, size, n, (FILE *)(void *)file->UserData);
}

static size_t tell(struct aiFile *file)
{
    return (size_t)ftell((FILE *)(void *)file->UserData);
}

static size_t size_of(struct aiFile *file)
{
    FILE *stream = (FILE *)(void *)file->UserData;
    const long at = ftell(stream);
    fseek(stream, 0, SEEK_END);
    const long size = ftell(stream);
    fseek(stream, at, SEEK_SET);
    return (size_t)size;
}

static enum aiReturn seek(struct aiFile *file, size_t offset,
                          enum aiOrigin origin)
{
    const int whence = origin == aiOrigin_SET   ? SEEK_SET
                       : origin == aiOrigin_CUR ? SEEK_CUR
                                                : SEEK_END;
    return fseek((FILE *)(void *)file->UserData, (long)offset, whence) == 0
               ? aiReturn_SUCCESS
               : aiReturn_FAILURE;
}

struct texts {
    char *obj, *mtl;
    size_t obj_size, mtl_size;
};

static struct aiFile *open_text(struct aiFileIO *io, const char *name,
                                const char *mode)
{
    const struct texts *t = (const void *)io->UserData;
    const bool mtl = path_has_ending(name, " .mtl ");
    struct aiFile *file = calloc(1, sizeof(*file));
    FILE *stream = mtl ? fmemopen(t->mtl, t->mtl_size, "r")
                       : fmemopen(t->obj, t->obj_size, "r");
    (void)mode;
    if (!file || !stream)
        return NULL;
    *file = (struct aiFile){.ReadProc = read_part,
                            .TellProc = tell,
                            .FileSizeProc = size_of,
                            .SeekProc = seek,
                            .UserData = (aiUserData)stream};
    return file;
}

static void close_text(struct aiFileIO *io, struct aiFile *file)
{
    (void)io;
    fclose((FILE *)(void *)file->UserData);
    free(file);
}

/* Ends what was written with a line. False when not all of it has found room.
 */
static bool end(FILE *stream, const char *line)
{
    fputs(line, stream);
    const bool whole = !ferror(stream);
    return fclose(stream) == 0 && whole;
}

/* The texts stay: the process ends with the file. */
static const struct aiScene *import(struct mend *m,
                                    bool (*write)(struct mend *), bool *told)
{
    struct texts t;
    struct aiFileIO io = {open_text, close_text, (aiUserData)&t};
    m->obj = open_memstream(&t.obj, &t.obj_size);
    m->mtl = open_memstream(&t.mtl, &t.mtl_size);
    *told = true;
    if (!m->obj || !m->mtl)
        message_error_at(m->path, 0, "no memory to write it anew");
    else
        *told = !write(m);
    if (*told)
        return NULL;
    *told = !end(m->obj, "# what pel has written anew of a mesh file\n") ||
            !end(m->mtl, "# by pel\n");
    if (*told) {
        message_error_at(m->path, 0, "no memory to write it anew");
        return NULL;
    }
    return aiImportFileEx("pel.obj", 0, &io);
}

static bool check_text(struct mend *m)
{
    return !memchr(m->text, 0, m->size) ||
           message_error_at(m->path, 0,
                            "has a zero byte: expected lines of text");
}

static bool always(struct mend *m)
{
    return m;
}

const struct aiScene *mend_import(const char *path, bool *told)
{
    static const struct {
        const char *ending;
        bool (*read)(struct mend *m, const char *path);
        bool (*check)(struct mend *m); /* false, with a message */
        bool (*wanted)(struct mend *m);
        bool (*write)(struct mend *m);
    } kinds[] = {
        {" .obj ", mend_read_lines, check_text, always, mend_obj},
        {" .off ", mend_read_lines, check_text, always, mend_off},
        {" .ply ", mend_read, mend_ply_check, mend_ply_wanted, mend_ply},
        {" .stl ", mend_read, always, mend_stl_wanted, mend_stl},
        {" .3mf ", mend_read, always, always, mend_3mf},
        {NULL, NULL, NULL, NULL, NULL}};
    struct mend m = {.path = path};
    int i = 0;
    while (kinds[i].ending && !path_has_ending(path, kinds[i].ending))
        i++;
    *told = kinds[i].ending && !kinds[i].read(&m, path);
    if (*told)
        file_refuse(path);
    else if (kinds[i].ending)
        *told = !kinds[i].check(&m);
    if (*told)
        return NULL;
    if (kinds[i].ending && kinds[i].wanted(&m))
        return import(&m, kinds[i].write, told);
    return aiImportFile(path, 0);
}
