/* Members of the JSON, and messages that say where they are. */
#include "sim/mesh/gltf.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "sim/cli/message.h"

/* Of a way that is longer the first part is cut off. */
struct way {
    char text[160];
};

static void put_before(struct way *way, const char *step)
{
    const struct way after = *way;
    snprintf(way->text, sizeof(way->text), "%.60s%.99s", step, after.text);
}

static void put_index_before(struct way *way, size_t i)
{
    char step[32];
    snprintf(step, sizeof(step), "[%zu]", i);
    put_before(way, step);
}

/* The way from one to another that is inside, such as ".nodes[0]". jansson has
 * refused what is more than 2,048 deep. */
static bool find_way(json_t *from, const json_t *to, struct way *way)
{
    const char *key;
    json_t *item;
    if (from == to)
        return true;
    for (size_t i = 0; i < json_array_size(from); i++)
        if (find_way(json_array_get(from, i), to, way)) {
            put_index_before(way, i);
            return true;
        }
    json_object_foreach(from, key, item) if (find_way(item, to, way))
    {
        put_before(way, key);
        put_before(way, ".");
        return true;
    }
    return false;
}

static void refuse(struct gltf *g, const json_t *object, const char *format,
                   va_list arguments)
{
    struct way way = {""};
    char text[400];
    vsnprintf(text, sizeof(text), format, arguments);
    if (object)
        find_way(g->root, object, &way);
    if (g->good)
        message_error_at(g->path, 0, "%s%s%s", way.text + (*way.text == '.'),
                         *way.text ? ": " : "", text);
    g->good = false;
}

void *gltf_refuse(struct gltf *g, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    refuse(g, NULL, format, arguments);
    va_end(arguments);
    return NULL;
}

void *gltf_refuse_in(struct gltf *g, const json_t *object, const char *format,
                     ...)
{
    va_list arguments;
    va_start(arguments, format);
    refuse(g, object, format, arguments);
    va_end(arguments);
    return NULL;
}

/* A member that is there is not what it has to be. */
static void *refuse_member(struct gltf *g, const json_t *object,
                           const char *key, const char *expected)
{
    char *is = json_dumps(json_object_get(object, key),
                          JSON_ENCODE_ANY | JSON_COMPACT);
    gltf_refuse_in(g, object, "'%s' is %.40s%s: expected %s", key,
                   is ? is : "no text", is && strlen(is) > 40 ? "..." : "",
                   expected);
    free(is);
    return NULL;
}

json_t *gltf_at(struct gltf *g, const char *array, json_int_t index)
{
    json_t *list = json_object_get(g->root, array);
    json_t *object = index >= 0 ? json_array_get(list, (size_t)index) : NULL;
    if (json_is_object(object))
        return object;
    return index < 0
               ? gltf_refuse(g, "an index of '%s' is missing: expected one",
                             array)
               : gltf_refuse(g, "%s[%lld] is not there: expected an object",
                             array, (long long)index);
}

double gltf_number(struct gltf *g, const json_t *object, const char *key,
                   double fallback)
{
    const json_t *member = json_object_get(object, key);
    if (member && !json_is_number(member))
        refuse_member(g, object, key, "a number");
    return json_is_number(member) ? json_number_value(member) : fallback;
}

json_int_t gltf_index(struct gltf *g, const json_t *object, const char *key)
{
    const json_t *member = json_object_get(object, key);
    if (member && !(json_is_integer(member) && json_integer_value(member) >= 0))
        refuse_member(g, object, key, "a whole number from 0 on");
    return json_is_integer(member) ? json_integer_value(member) : -1;
}

double gltf_size(struct gltf *g, const json_t *object, const char *key)
{
    const double size = gltf_number(g, object, key, 0);
    if (size < 0 || floor(size) != size)
        refuse_member(g, object, key, "a whole number from 0 on");
    return size;
}

bool gltf_numbers(struct gltf *g, const json_t *object, const char *key,
                  double *number, size_t n)
{
    const json_t *member = json_object_get(object, key);
    char expected[40];
    snprintf(expected, sizeof(expected), "an array of %zu numbers", n);
    if (!member)
        return false;
    if (!json_is_array(member) || json_array_size(member) != n)
        return refuse_member(g, object, key, expected);
    for (size_t i = 0; i < n; i++) {
        const json_t *item = json_array_get(member, i);
        if (!json_is_number(item))
            return refuse_member(g, object, key, expected);
        number[i] = json_number_value(item);
    }
    return true;
}

const json_t *gltf_member(struct gltf *g, const json_t *object,
                          const char *path)
{
    while (object && *path) {
        const json_t *from = object;
        const size_t n = strcspn(path, ".");
        char key[64];
        snprintf(key, sizeof(key), "%.*s", (int)n, path);
        object = json_object_get(from, key);
        if (object && !json_is_object(object))
            return refuse_member(g, from, key, "an object");
        path += n + (path[n] == '.');
    }
    return object;
}

const json_t *gltf_list(struct gltf *g, const json_t *object, const char *key)
{
    const json_t *member = json_object_get(object, key);
    if (member && !json_is_array(member))
        return refuse_member(g, object, key, "an array");
    return member;
}
