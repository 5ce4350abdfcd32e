/* The file: JSON, buffers, URIs (chapters 3.3, 3.6.1, 4). */
#include "sim/mesh/gltf.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "sim/cli/bytes.h"
#include "sim/cli/message.h"
#include "sim/mesh/mend.h"

enum { CHUNK_JSON = 0x4E4F534A, CHUNK_BIN = 0x004E4942 };

static int digit_of(int c)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                 "abcdefghijklmnopqrstuvwxyz0123456789+/";
    const char *at = c ? strchr(digits, c) : NULL;
    return at ? (int)(at - digits) : -1;
}

static bool decode_base64(const char *text, struct gltf_bytes *bytes)
{
    uint8_t *to = malloc(strlen(text) / 4 * 3 + 3);
    uint32_t bits = 0;
    int have = 0, digit;
    size_t n = 0;
    for (; to && (digit = digit_of(*text)) >= 0; text++) {
        bits = bits << 6 | (uint32_t)digit;
        have += 6;
        if (have >= 8)
            to[n++] = (uint8_t)(bits >> (have -= 8));
    }
    bytes->at = to;
    bytes->size = n;
    return to && text[strspn(text, "=")] == '\0';
}

/* A % without two digits, or of a 0, stays as it is. */
static char *decode_percent(const char *text)
{
    char *copy = strdup(text), *to = copy;
    for (const char *c = text; copy && *c; c++) {
        char byte = 0;
        if (*c == '%' && isxdigit((unsigned char)c[1]) &&
            isxdigit((unsigned char)c[2]))
            byte = (char)strtoul((char[]){c[1], c[2], '\0'}, NULL, 16);
        *to++ = byte ? byte : *c;
        c += byte ? 2 : 0;
    }
    if (copy)
        *to = '\0';
    return copy;
}

bool gltf_uri(const char *path, const char *uri, struct gltf_bytes *bytes,
              char **file)
{
    const char *data = strstr(uri, ";base64,");
    *file = NULL;
    bytes->at = NULL;
    if (strncmp(uri, "data:", 5) == 0)
        return data && decode_base64(data + 8, bytes);
    char *name = decode_percent(uri);
    *file = name ? mend_path_beside(path, name) : NULL;
    free(name);
    return *file;
}

static bool read_buffer(struct gltf *g, json_int_t index)
{
    struct gltf_bytes *b = &g->buffer[index];
    const json_t *object = gltf_at(g, "buffers", index);
    const char *uri = json_string_value(json_object_get(object, "uri"));
    const double size = gltf_size(g, object, "byteLength");
    char *path = NULL;
    if (!uri && index == 0)
        *b = g->chunk;
    else if (!uri || !gltf_uri(g->path, uri, b, &path))
        return gltf_refuse(
            g,
            "buffers[%lld] has no data: expected a uri of a file or of base64",
            (long long)index);
    struct mend file = {.path = path};
    errno = 0;
    if (path && !mend_read(&file, path))
        return gltf_refuse(g, "its buffer %.200s cannot be read: %s", path,
                           strerror(errno ? errno : ENOMEM));
    if (path)
        *b = (struct gltf_bytes){(const uint8_t *)file.text, file.size};
    if (!b->at || (double)b->size < size)
        return gltf_refuse(g, "buffers[%lld] has %zu bytes: expected %.0f",
                           (long long)index, b->size, size);
    return g->good;
}

const uint8_t *gltf_view(struct gltf *g, json_int_t view, double offset,
                         double size)
{
    const json_t *object = gltf_at(g, "bufferViews", view);
    const json_int_t buffer = gltf_index(g, object, "buffer");
    const double first = gltf_size(g, object, "byteOffset");
    const double length = gltf_size(g, object, "byteLength");
    if (!g->good || !gltf_at(g, "buffers", buffer) ||
        (!g->buffer[buffer].at && !read_buffer(g, buffer)))
        return NULL;
    if (offset < 0 || size < 0 || offset + size > length ||
        first + length > (double)g->buffer[buffer].size)
        return gltf_refuse(
            g,
            "bytes %.0f to %.0f leave bufferViews[%lld]: expected %.0f at most",
            offset, offset + size, (long long)view,
            fmax(fmin(length, (double)g->buffer[buffer].size - first), 0));
    return g->buffer[buffer].at + (size_t)(first + offset);
}

struct gltf_bytes gltf_whole_view(struct gltf *g, json_int_t view)
{
    const json_t *object = gltf_at(g, "bufferViews", view);
    const double size = gltf_size(g, object, "byteLength");
    const uint8_t *at = gltf_view(g, view, 0, size);
    return (struct gltf_bytes){at, at ? (size_t)size : 0};
}

/* Finds the chunks of a .glb; of a .gltf all is JSON. */
static bool find_chunks(struct gltf *g, const struct mend *file,
                        struct gltf_bytes *json)
{
    const uint8_t *byte = (const uint8_t *)file->text;
    *json = (struct gltf_bytes){byte, file->size};
    if (file->size < 12 || memcmp(byte, "glTF", 4) != 0)
        return true;
    g->is_old = bytes_little(byte + 4, 4) == 1;
    if (g->is_old)
        return true;
    json->at = NULL;
    for (size_t at = 12; at + 8 <= file->size;) {
        const struct gltf_bytes chunk = {byte + at + 8,
                                         bytes_little(byte + at, 4)};
        const uint32_t type = bytes_little(byte + at + 4, 4);
        if (chunk.size > file->size - at - 8)
            break;
        if (type == CHUNK_JSON && !json->at)
            *json = chunk;
        if (type == CHUNK_BIN && !g->chunk.at)
            g->chunk = chunk;
        at += 8 + (chunk.size + 3) / 4 * 4;
    }
    return json->at
               ? true
               : (bool)gltf_refuse(
                     g, "ends before its chunks do: expected a whole file");
}

/* What it needs, or what it would show with more. */
static bool check_extensions(struct gltf *g)
{
    static const char *const known[] = {"KHR_texture_transform",
                                        "KHR_mesh_quantization",
                                        "KHR_materials_unlit",
                                        "KHR_materials_emissive_strength",
                                        "KHR_materials_pbrSpecularGlossiness",
                                        NULL};
    static const char *const keys[] = {"extensionsRequired", "extensionsUsed"};
    char names[200] = "";
    for (int k = 0; k < 2; k++) {
        const json_t *list = gltf_list(g, g->root, keys[k]);
        for (size_t i = 0; i < json_array_size(list); i++) {
            const char *name = json_string_value(json_array_get(list, i));
            int n = 0;
            while (name && known[n] && strcmp(name, known[n]) != 0)
                n++;
            if (name && known[n])
                continue;
            if (!name || k == 0)
                return gltf_refuse(g,
                                   "requires the extension %.100s, which "
                                   "pel does not have",
                                   name ? name : "without a name");
            const size_t used = strlen(names);
            snprintf(names + used, sizeof(names) - used, "%s%s",
                     used ? ", " : "", name);
        }
    }
    if (*names)
        message_error_at(g->path, 0, "uses %s: left out", names);
    return g->good;
}

bool gltf_open(struct gltf *g, const char *path)
{
    struct mend file = {.path = path};
    struct gltf_bytes json;
    json_error_t error;
    *g = (struct gltf){.path = path, .good = true};
    errno = 0;
    if (!mend_read(&file, path))
        return gltf_refuse(g, "cannot be read: %s",
                           strerror(errno ? errno : ENOMEM));
    if (!find_chunks(g, &file, &json) || g->is_old)
        return g->is_old;
    g->root = json_loadb((const char *)json.at, json.size, 0, &error);
    if (!g->root)
        return gltf_refuse(g, "line %d: no JSON (%.160s)", error.line,
                           error.text);
    if (!json_is_object(g->root))
        return gltf_refuse(g, "is no glTF: expected a JSON object");
    const char *version = json_string_value(
        json_object_get(gltf_member(g, g->root, "asset"), "version"));
    g->is_old = !version || *version == '1';
    if (g->is_old)
        return true;
    if (*version != '2')
        return gltf_refuse(g, "has the version %.20s of glTF: expected 2",
                           version);
    g->buffer = calloc(json_array_size(json_object_get(g->root, "buffers")) + 1,
                       sizeof(*g->buffer));
    return (g->buffer || gltf_refuse(g, "no memory for buffers")) &&
           check_extensions(g);
}
